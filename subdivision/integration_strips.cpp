// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/integration_strips.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
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
    Strips(SmoothBrep& brep, double share, double joined_share)
        : brep_(brep), share_(share), joined_share_(joined_share) {}

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
    // What programs measure volumes from: the mean of a shape's corners, as often as they are in its faces' edges.
    struct Middle {
        Point3 sum;
        double count = 0;

        // Coordinates added up, of so many corners.
        void add(const Point3& p, double corners, double times = 1) {
            sum = {sum.x + times * p.x, sum.y + times * p.y, sum.z + times * p.z};
            count += times * corners;
        }

        void add(const Middle& other, double times = 1) { add(other.sum, other.count, times); }

        Point3 at() const { return {sum.x / count, sum.y / count, sum.z / count}; }
    };

    Middle middle_of(const PlanCells::Loop& loop) const {
        Middle middle;
        for (const auto& use : loop) {
            const auto& edge = brep_.cells.edges[use.edge];
            const auto& curve = brep_.edges[use.edge].curve;
            if (edge.line != kNone) {
                const auto ends = cad_edge_ends(brep_.edges[use.edge]);
                for (std::size_t k = 1; k + 1 < ends.size(); ++k) {
                    const double t = curve.knots.breaks()[ends[k]];
                    middle.add(Point3{curve.at(0, t), curve.at(1, t), curve.at(2, t)}, 1, 2);  // of two edges
                }
            }
            middle.add(brep_.corners[edge.from], 1);
            middle.add(brep_.corners[edge.to], 1);
        }
        return middle;
    }

    Middle middle_of(std::uint32_t cell) const {
        Middle middle;
        for (const auto& loop : brep_.cells.cells[cell].loops) middle.add(middle_of(loop));
        return middle;
    }

    Middle middle_of(const PlanCells::Body& body) const {
        Middle middle;
        for (const auto* cells : {&body.top, &body.base})
            for (const auto c : *cells) middle.add(middle_of(c));
        for (const auto& wall : body.walls) middle.add(middle_of(wall.loop));
        return middle;
    }

    void measure(const std::vector<char>& bodies) {
        as_base_.resize(brep_.cells.cells.size());
        as_top_.resize(as_base_.size());
        at_walls_.resize(bodies.size());
        tbb::parallel_for(std::size_t{0}, bodies.size(), [&](std::size_t b) {
            if (!bodies[b]) return;
            const auto& body = brep_.cells.bodies[b];
            const Point3 middle = middle_of(body).at();
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

    //! A solid that a body becomes a part of, or is.
    struct Joined {
        Point3 shift;       // of the middle
        bool alone = true;  // only what is added by the shift counts otherwise
        double most = 0;    // that may be wrong
    };

    std::vector<std::vector<Joined>> all_joined() const {
        const auto& bodies = brep_.cells.bodies;
        std::vector<Middle> middles;
        std::vector<std::vector<Joined>> result(bodies.size());
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            middles.push_back(middle_of(bodies[b]));
            result[b].push_back({.most = share_ * brep_.quality[b].mesh_volume});
        }
        std::map<std::pair<std::uint32_t, std::uint32_t>, Middle> between;
        for (std::uint32_t c = 0; c < brep_.cells.cells.size(); ++c) {
            const auto& cell = brep_.cells.cells[c];
            if (cell.body_above != kNone && cell.body_below != kNone)
                between[{cell.body_above, cell.body_below}].add(middle_of(c));
        }
        for (const auto& [pair, shared] : between) {
            Middle both = middles[pair.first];
            both.add(middles[pair.second]);
            both.add(shared, -2);
            const double most =
                joined_share_ / 2 *
                (brep_.quality[pair.first].mesh_volume + brep_.quality[pair.second].mesh_volume);
            for (const auto b : {pair.first, pair.second}) {
                const Point3 to = both.at(), from = middles[b].at();
                result[b].push_back({{to.x - from.x, to.y - from.y, to.z - from.z}, false, most});
            }
        }
        return result;
    }

    // Of a body, edges before cells.
    Harmful harmful() const {
        Harmful which{std::vector<char>(brep_.cells.cells.size(), 0), {}};
        const auto joined = all_joined();
        for (std::size_t b = 0; b < joined.size(); ++b)
            for (const Joined& in : joined[b]) add_harmful(b, in, which);
        return which;
    }

    void add_harmful(std::size_t b, const Joined& in, Harmful& which) const {
        const auto& body = brep_.cells.bodies[b];
        const auto off = [&](const ConeIntegral& error) {
            return in.alone ? error.cone : error.growth(in.shift);
        };
        Sources cells, edges;
        double all = 0;
        const auto add = [&](const IntegrationError& error, std::uint32_t c, int sign) {
            all += sign * off(error.all());
            cells.emplace_back(std::abs(off(error.all())), c);
            std::size_t k = 0;
            for (const auto& loop : brep_.cells.cells[c].loops)
                for (const auto& use : loop) edges.emplace_back(std::abs(off(error.along[k++])), use.edge);
        };
        for (const auto c : body.top) add(as_top_[c], c, 1);
        for (const auto c : body.base) add(as_base_[c], c, -1);
        for (std::size_t w = 0; w < body.walls.size(); ++w)
            for (std::size_t k = 0; k < body.walls[w].loop.size(); ++k) {
                const double along = off(at_walls_[b][w][k]);
                all += along;
                edges.emplace_back(std::abs(along), body.walls[w].loop[k].edge);
            }
        if (std::abs(all) <= in.most) return;
        const auto worst_edges = worst(std::move(edges), kEdgeRest * in.most);
        which.edges.insert(which.edges.end(), worst_edges.begin(), worst_edges.end());
        if (worst_edges.empty())
            for (const auto c : worst(std::move(cells), kRest * in.most)) which.cells[c] = 1;
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
    double share_, joined_share_;
    std::vector<IntegrationError> as_base_, as_top_;  // [cell] of the body above, and of the one below
    std::vector<std::vector<std::vector<ConeIntegral>>> at_walls_;  // [body][wall][edge of its loop]
};

}  // namespace

void cut_for_integration(SmoothBrep& brep, double share, double joined_share) {
    Strips(brep, share, joined_share).cut();
}

}  // namespace stratareeb
