// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/integration_strips.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "subdivision/cad_integration.h"
#include "subdivision/strip_cells.h"

namespace stratareeb {
namespace {

constexpr std::uint32_t kNone = PlanCells::kNone;
constexpr double kRest = 0.5;          // of the error allowed, that faces left whole may add up to
constexpr double kEdgeRest = 0.25;     // the same of edges
constexpr int kMostHalvings = 6;       // of a face
constexpr std::size_t kMostCells = 4;  // times as many as there were

class Strips {
 public:
    Strips(SmoothBrep& brep, double share) : brep_(brep), share_(share) {}

    void cut() {
        const std::size_t most = kMostCells * brep_.cells.cells.size() + 100;
        std::vector<char> bodies(brep_.cells.bodies.size(), 1);
        int halvings = 0;
        while (halvings < kMostHalvings && brep_.cells.cells.size() < most) {
            measure(bodies);
            const Harmful which = harmful();
            bodies = bodies_at(which);
            if (!which.edges.empty())
                shorten(which.edges);
            else
                ++halvings;
            if (halve_cells(brep_, which.cells) == 0 && which.edges.empty()) return;
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
                    const auto ends = cad_edge_ends(brep_.edges[use.edge]);
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

    void measure(const std::vector<char>& bodies) {
        as_base_.resize(brep_.cells.cells.size());
        as_top_.resize(as_base_.size());
        at_walls_.resize(bodies.size());
        tbb::parallel_for(std::size_t{0}, bodies.size(), [&](std::size_t b) {
            if (!bodies[b]) return;
            const auto& body = brep_.cells.bodies[b];
            const Point3 middle = middle_of(body);
            const auto errors = [&](const std::vector<std::uint32_t>& cells,
                                    std::vector<IntegrationError>& result) {
                tbb::parallel_for(std::size_t{0}, cells.size(), [&](std::size_t i) {
                    result[cells[i]] = integration_error(brep_, cells[i], middle);
                });
            };
            errors(body.top, as_top_);
            errors(body.base, as_base_);
            at_walls_[b].clear();
            for (const auto& wall : body.walls)
                at_walls_[b].push_back(wall_integration_error(brep_, wall, middle));
        });
    }

    //! What is to be halved.
    struct Harmful {
        std::vector<char> cells;
        std::vector<std::uint32_t> edges;
    };

    // Of a body, edges before cells.
    Harmful harmful() const {
        Harmful which{std::vector<char>(brep_.cells.cells.size(), 0), {}};
        for (std::size_t b = 0; b < brep_.cells.bodies.size(); ++b) {
            const auto& body = brep_.cells.bodies[b];
            const double most = share_ * brep_.quality[b].mesh_volume;
            Sources cells, edges;
            double all = 0;
            const auto add = [&](const IntegrationError& error, std::uint32_t c, int sign) {
                all += sign * error.all();
                cells.emplace_back(std::abs(error.all()), c);
                std::size_t k = 0;
                for (const auto& loop : brep_.cells.cells[c].loops)
                    for (const auto& use : loop) edges.emplace_back(std::abs(error.along[k++]), use.edge);
            };
            for (const auto c : body.top) add(as_top_[c], c, 1);
            for (const auto c : body.base) add(as_base_[c], c, -1);
            for (std::size_t w = 0; w < body.walls.size(); ++w)
                for (std::size_t k = 0; k < body.walls[w].loop.size(); ++k) {
                    const double off = at_walls_[b][w][k];
                    all += off;
                    edges.emplace_back(std::abs(off), body.walls[w].loop[k].edge);
                }
            if (std::abs(all) <= most) continue;
            const auto worst_edges = worst(std::move(edges), kEdgeRest * most);
            which.edges.insert(which.edges.end(), worst_edges.begin(), worst_edges.end());
            if (worst_edges.empty())
                for (const auto c : worst(std::move(cells), kRest * most)) which.cells[c] = 1;
        }
        return which;
    }

    // Those that get another shape: also where edges are cut that they share with a face that is.
    std::vector<char> bodies_at(const Harmful& which) const {
        std::vector<char> result(brep_.cells.bodies.size(), 0);
        const auto note = [&](std::uint32_t edge) {
            for (const auto c : brep_.cells.edges[edge].cells)
                for (const auto body : {brep_.cells.cells[c].body_above, brep_.cells.cells[c].body_below})
                    if (body != kNone) result[body] = 1;
        };
        for (const auto e : which.edges) note(e);
        for (std::size_t c = 0; c < which.cells.size(); ++c) {
            if (!which.cells[c]) continue;
            for (const auto& loop : brep_.cells.cells[c].loops)
                for (const auto& use : loop) note(use.edge);
        }
        return result;
    }

    using Sources = std::vector<std::pair<double, std::uint32_t>>;  // an error and where it comes from

    // The others add up to no more than a rest.
    static std::vector<std::uint32_t> worst(Sources sources, double rest) {
        std::ranges::stable_sort(sources, std::greater{}, [](const auto& s) { return s.first; });
        double sum = 0;
        for (const auto& [off, from] : sources) sum += off;
        std::vector<std::uint32_t> result;
        for (const auto& [off, from] : sources) {
            if (sum <= rest) break;
            result.push_back(from);
            sum -= off;
        }
        return result;
    }

    void shorten(std::vector<std::uint32_t> edges) {
        std::ranges::sort(edges);
        edges.erase(std::ranges::unique(edges).begin(), edges.end());
        for (const auto e : edges) {
            auto& edge = brep_.edges[e];
            edge.cad_spans = std::max<std::size_t>(1, std::min(edge.cad_spans, edge.curve.knots.spans()) / 2);
        }
    }

    SmoothBrep& brep_;
    double share_;
    std::vector<IntegrationError> as_base_, as_top_;  // [cell] of the body above, and of the one below
    std::vector<std::vector<std::vector<double>>> at_walls_;  // [body][wall][edge of its loop]
};

}  // namespace

void cut_for_integration(SmoothBrep& brep, double share) {
    Strips(brep, share).cut();
}

}  // namespace stratareeb
