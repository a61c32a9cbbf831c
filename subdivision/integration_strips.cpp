// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/integration_strips.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "boreholes/errors.h"
#include "subdivision/cell_integrals.h"
#include "subdivision/strip_cells.h"

namespace stratareeb {
namespace {

constexpr std::uint32_t kNone = PlanCells::kNone;
constexpr double kRest = 0.5;          // of the error allowed, that faces left whole may add up to
constexpr int kMostHalvings = 6;       // of a face
constexpr std::size_t kMostCells = 4;  // times as many as there were

class Strips {
 public:
    Strips(SmoothBrep& brep, double share) : brep_(brep), share_(share) {
        for (const auto& body : brep.cells.bodies) middle_.push_back(middle_of(body));
    }

    void cut() {
        const std::size_t most = kMostCells * brep_.cells.cells.size() + 100;
        std::vector<char> stale(brep_.cells.cells.size(), 1);
        for (int round = 0; round < kMostHalvings && stale.size() < most; ++round) {
            measure(stale);
            stale = harmful();
            if (!halve(stale)) return;
            stale.resize(brep_.cells.cells.size(), 1);
        }
    }

 private:
    // What programs measure volumes from: the mean of a shape's corners.
    Point3 middle_of(const PlanCells::Body& body) const {
        Point3 sum;
        double count = 0;
        const auto add_corner = [&](const Point3& p, double times) {
            sum = {sum.x + times * p.x, sum.y + times * p.y, sum.z + times * p.z};
            count += times;
        };
        const auto add = [&](const PlanCells::Loop& loop) {
            for (const auto& use : loop) {
                const auto& edge = brep_.cells.edges[use.edge];
                const auto& curve = brep_.edges[use.edge].curve;
                if (edge.line != kNone) {
                    const auto ends = cad_edge_ends(curve.knots);
                    for (std::size_t k = 1; k + 1 < ends.size(); ++k) {
                        const double t = curve.knots.breaks()[ends[k]];
                        add_corner({curve.at(0, t), curve.at(1, t), curve.at(2, t)}, 2);  // of two edges
                    }
                }
                add_corner(brep_.corners[edge.from], 1);
                add_corner(brep_.corners[edge.to], 1);
            }
        };
        for (const auto* cells : {&body.top, &body.base})
            for (const auto c : *cells)
                for (const auto& loop : brep_.cells.cells[c].loops) add(loop);
        for (const auto& wall : body.walls) add(wall.loop);
        return {sum.x / count, sum.y / count, sum.z / count};
    }

    void measure(const std::vector<char>& stale) {
        as_base_.resize(stale.size());
        as_top_.resize(stale.size());
        tbb::parallel_for(std::size_t{0}, stale.size(), [&](std::size_t c) {
            if (!stale[c]) return;
            const auto& cell = brep_.cells.cells[c];
            const auto error = [&](std::uint32_t body) {
                return body == kNone ? 0
                                     : integration_error(brep_, static_cast<std::uint32_t>(c), middle_[body]);
            };
            as_base_[c] = -error(cell.body_above);
            as_top_[c] = error(cell.body_below);
        });
    }

    std::vector<char> harmful() const {
        std::vector<char> which(brep_.cells.cells.size(), 0);
        for (std::size_t b = 0; b < brep_.cells.bodies.size(); ++b) {
            const auto& body = brep_.cells.bodies[b];
            const double most = share_ * brep_.quality[b].mesh_volume;
            std::vector<std::pair<double, std::uint32_t>> worst;
            double all = 0, rest = 0;
            const auto add = [&](double off, std::uint32_t c) {
                worst.emplace_back(std::abs(off), c);
                all += off;
                rest += std::abs(off);
            };
            for (const auto c : body.top) add(as_top_[c], c);
            for (const auto c : body.base) add(as_base_[c], c);
            if (std::abs(all) <= most) continue;
            std::ranges::stable_sort(worst, std::greater{}, [](const auto& w) { return w.first; });
            for (const auto& [off, c] : worst) {
                if (rest <= kRest * most) break;
                which[c] = 1;
                rest -= off;
            }
        }
        return which;
    }

    // False if none can be halved: then all stays as it is.
    bool halve(const std::vector<char>& which) {
        SmoothBrep whole = brep_;
        try {
            return halve_cells(brep_, which) > 0;
        } catch (const GeometryError&) {
            brep_ = std::move(whole);
            return false;
        }
    }

    SmoothBrep& brep_;
    double share_;
    std::vector<Point3> middle_;            // [body]
    std::vector<double> as_base_, as_top_;  // [cell] what is too much in the body above, and in the one below
};

}  // namespace

void cut_for_integration(SmoothBrep& brep, double share) {
    Strips(brep, share).cut();
}

}  // namespace stratareeb
