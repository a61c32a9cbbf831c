// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/smooth_brep.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "boreholes/length_unit.h"
#include "mesh/compensated_sum.h"
#include "subdivision/body_ends.h"
#include "subdivision/cell_integrals.h"
#include "subdivision/crossed_lines.h"
#include "subdivision/edge_distance.h"
#include "subdivision/followed_lines.h"
#include "subdivision/open_ends.h"
#include "subdivision/sheet_gaps.h"
#include "subdivision/snapped_lines.h"

namespace stratareeb {
namespace {

constexpr std::uint32_t kNone = PlanCells::kNone;
constexpr double kEdgeTolerance = 2e-7;  // of the size: curve from the height it follows
// CAD programs look anew for the place in a face of each edge that is more than a millimetre from it, which takes long: curves
// keep to this many metres, in models of up to that size.
constexpr double kCloseEdge = 3e-4, kMostCloseSize = 2e4;
constexpr double kCloseSheets = 2e-4;  // of the size: an edge in one sheet may be off others
constexpr double kLeastGap = 1e-6;     // of the size: between edges of a wall
constexpr int kOrderRounds = 4;        // of halving spans of edges of a wall that are not in order
constexpr int kUncrossRounds = 5;      // of taking moves of lines back
constexpr double kEdgeSpan = 1.5;      // of the patches' spans around it
constexpr std::size_t kMostEdgeSpans = 1500;
// Programs measure volumes from the mean of a body's corners: among slits, these had better be all around.
constexpr std::size_t kShortEdge = 12;

class Builder {
 public:
    Builder(const LayerModel& model, const SmoothBrepOptions& options)
        : model_(model), plan_(model.plan.surface), options_(options) {}

    SmoothBrep build(const HorizonSheets* sheets = nullptr) {
        brep_.cells = build_plan_cells(model_, options_.cells);
        brep_.size = size();
        curves_ = build_plan_curves(plan_, brep_.cells, options_.rim_tolerance * brep_.size);
        brep_.sides = curves_.sides;
        brep_.horizons =
            sheets ? *sheets : fit_horizon_sheets(model_, brep_.cells, curves_, brep_.size, options_.sheets);
        const bool apart = has_gaps(brep_.horizons);
        if (options_.snap_lines) {
            move_lines(snapped_lines(plan_, brep_.cells, curves_, brep_.horizons, brep_.size));
            brep_.sides = curves_.sides;
            if (apart) follow_gaps();
        }
        if (apart) open_body_ends(brep_.horizons, model_, brep_.cells, curves_);
        draw_edges();
        place_corners();
        order_edges_on_rim();
        measure_bodies();
        measure_edges(brep_);
        return std::move(brep_);
    }

 private:
    const std::vector<PlanCells::Cell>& cells() const { return brep_.cells.cells; }
    const std::vector<PlanCells::Body>& bodies() const { return brep_.cells.bodies; }

    double edge_tolerance(bool only_meet) const {
        const double tolerance = kEdgeTolerance * brep_.size, unit = metres_per(model_.length_unit);
        const bool too_large = brep_.size * unit > kMostCloseSize;
        return too_large || only_meet ? tolerance : std::min(tolerance, kCloseEdge / unit);
    }

    // Where bodies end without a gap, sheets are further than that from each other anyway.
    bool do_sheets_only_meet() const {
        return !has_gaps(brep_.horizons) &&
               std::ranges::any_of(body_ends(brep_.cells, brep_.horizons.of_cell),
                                   [](const auto& ends) { return !ends.empty(); });
    }

    // Lines that would cross others stay, and are drawn more closely.
    void move_lines(LineMoves moves) {
        for (int round = 0;; ++round) {
            curves_ = build_plan_curves(plan_, brep_.cells, options_.rim_tolerance * brep_.size, moves);
            const auto crossed = crossed_lines(brep_.cells, curves_);
            if (crossed.empty() || round == kUncrossRounds) return;
            for (const auto l : crossed) {
                if (round > 0) ++moves.closer[l];
                for (const auto v : brep_.cells.lines[l].vertices) moves.inner.erase(v);
            }
        }
    }

    void follow_gaps() {
        auto lines = followed_lines(brep_.cells, curves_, brep_.horizons, brep_.size);
        for (std::size_t l = 0; l < lines.size(); ++l) std::swap(curves_.lines[l].curve, lines[l]);
        for (int round = 0; round < kUncrossRounds; ++round) {
            const auto crossed = crossed_lines(brep_.cells, curves_);
            if (crossed.empty()) return;
            for (const auto l : crossed) curves_.lines[l].curve = lines[l];
        }
    }

    Point2 point(std::size_t v) const {
        const auto& p = plan_.point(TriMesh::VertexHandle(static_cast<int>(v)));
        return {p[0], p[1]};
    }

    double size() const {
        double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
        for (const auto v : plan_.vertices()) {
            const auto i = static_cast<std::size_t>(v.idx());
            const double p[3] = {point(i).x, point(i).y, model_.horizons.front()[i]};
            for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
            low[2] = std::min(low[2], model_.horizons.back()[i]);
        }
        return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    }

    template <typename Visit>
    void each_corner(std::uint32_t face, const Visit& visit) const {
        for (const auto v : plan_.fv_range(plan_.face_handle(face)))
            visit(static_cast<std::uint32_t>(v.idx()));
    }

    double area(std::uint32_t face) const { return plan_.calc_face_area(plan_.face_handle(face)); }

    void draw_edges() {
        const bool only_meet = do_sheets_only_meet();
        const double tolerance = edge_tolerance(only_meet);
        SmoothBrep::Edge undrawn;
        if (only_meet) undrawn.cad_spans = kShortEdge;
        brep_.edges.resize(brep_.cells.edges.size(), undrawn);
        tbb::parallel_for(std::size_t{0}, brep_.edges.size(), [&](std::size_t e) {
            if (brep_.cells.edges[e].line != kNone) draw_edge(e, tolerance);
        });
    }

    // The sheet that most faces at an edge are parts of, if the others come close to it all along: in these the edge is its
    // curve in plan, which CAD programs need not look for again. kNone if there is none.
    std::uint32_t main_sheet(const PlanCells::Edge& edge, const SplineCurve& line,
                             const CubicKnots& knots) const {
        std::vector<std::uint32_t> sheets;
        for (const auto c : edge.cells) sheets.push_back(brep_.horizons.of_cell[c]);
        std::ranges::sort(sheets);
        const std::uint32_t main = sheets[sheets.size() / 2];
        if (2 * static_cast<std::size_t>(std::ranges::count(sheets, main)) <= sheets.size()) return kNone;
        for (const double a : knots.breaks()) {
            const Point2 p{line.at(0, a), line.at(1, a)};
            const double z = brep_.horizons.sheets[main].z(p);
            for (const auto s : sheets)
                if (std::abs(brep_.horizons.sheets[s].z(p) - z) > kCloseSheets * brep_.size) return kNone;
        }
        return main;
    }

    // An edge lies in the sheet of most of its faces, or midway between its sheets.
    void draw_edge(std::size_t e, double tolerance) {
        const auto& edge = brep_.cells.edges[e];
        const auto& line = curves_.lines[edge.line];
        const auto knots = as_fine_as_patches(edge.cells, line.curve);
        const std::uint32_t main = main_sheet(edge, line.curve, knots);
        const auto height = [&](double t) {
            const Point2 p{line.curve.at(0, t), line.curve.at(1, t)};
            if (main != kNone) return brep_.horizons.sheets[main].z(p);
            double low = INFINITY, high = -INFINITY;
            for (const auto c : edge.cells) {
                const double z = brep_.sheet(c).z(p);
                low = std::min(low, z), high = std::max(high, z);
            }
            return std::midpoint(low, high);
        };
        auto z = approximate(knots, height, {.tolerance = tolerance, .most_spans = kMostEdgeSpans});
        auto& result = brep_.edges[e];
        result.side_start = line.side_start;
        result.curve.knots = z.knots;
        for (const std::size_t k : {0, 1})
            result.curve.coefficients.push_back(
                interpolate_spline(z.knots, [&, k](double t) { return line.curve.at(k, t); }));
        result.curve.coefficients.push_back(std::move(z.coefficients[0]));
    }

    // A line's spans, halved until they are no longer than the patches' where it runs: programs integrate along edges
    // span by span, and take what is below for smooth.
    CubicKnots as_fine_as_patches(const std::vector<std::uint32_t>& which, const SplineCurve& line) const {
        CubicKnots knots = line.knots;
        while (true) {
            std::vector<char> halve(knots.spans(), 0);
            for (std::size_t s = 0; s < knots.spans(); ++s) {
                const double a = knots.breaks()[s], b = knots.breaks()[s + 1];
                halve[s] = b - a > kEdgeSpan * shortest_span(which, line, a, b);
            }
            const auto more = static_cast<std::size_t>(std::ranges::count(halve, 1));
            if (more == 0 || knots.spans() + more > kMostEdgeSpans) return knots;
            knots = knots.refined(halve);
        }
    }

    // Of the patches' spans between two places of a line.
    double shortest_span(const std::vector<std::uint32_t>& which, const SplineCurve& line, double a,
                         double b) const {
        double shortest = INFINITY;
        const auto look = [&](const CubicKnots& knots, double from, double to) {
            const auto [low, high] = std::minmax(from, to);
            for (std::size_t s = knots.span(low); s <= knots.span(high); ++s)
                shortest = std::min(shortest, knots.breaks()[s + 1] - knots.breaks()[s]);
        };
        for (const auto c : which) {
            look(brep_.sheet(c).x, line.at(0, a), line.at(0, b));
            look(brep_.sheet(c).y, line.at(1, a), line.at(1, b));
        }
        return shortest;
    }

    // Where sheets end at a corner at different heights, edges are bent, in their last span, to meet midway.
    void place_corners() {
        std::vector<std::vector<double>> heights(brep_.cells.corners.size());
        brep_.corners.resize(heights.size());
        const auto each_end = [&](const auto& visit) {
            for (std::size_t e = 0; e < brep_.edges.size(); ++e) {
                const auto& edge = brep_.cells.edges[e];
                if (edge.line == kNone) continue;
                auto& c = brep_.edges[e].curve.coefficients;
                visit(edge.from, c[0].front(), c[1].front(), c[2].front());
                visit(edge.to, c[0].back(), c[1].back(), c[2].back());
            }
        };
        each_end([&](std::uint32_t corner, double x, double y, double z) {
            heights[corner].push_back(z);
            brep_.corners[corner] = {x, y, 0};
        });
        for (std::size_t i = 0; i < heights.size(); ++i) {
            const auto [low, high] = std::ranges::minmax(heights[i]);
            brep_.corners[i].z = std::midpoint(low, high);
        }
        each_end([&](std::uint32_t corner, double, double, double& z) { z = brep_.corners[corner].z; });
    }

    // On a wall, top and base of a thin layer must not cross on their way to where it ends, by however little: with the same
    // knots, curves are in order where their coefficients are.
    void order_edges_on_rim() {
        std::vector<std::vector<std::uint32_t>> stacks(brep_.cells.lines.size());
        for (std::uint32_t e = 0; e < brep_.edges.size(); ++e) {
            const std::uint32_t line = brep_.cells.edges[e].line;
            if (line != kNone && brep_.cells.lines[line].side != kNone) stacks[line].push_back(e);
        }
        for (auto& stack : stacks) {
            std::ranges::sort(stack, {}, [&](std::uint32_t e) { return brep_.cells.edges[e].horizon; });
            if (stack.size() > 1) order_edges(stack);
        }
    }

    void order_edges(const std::vector<std::uint32_t>& stack) {
        std::vector<double> breaks;
        for (const auto e : stack) {
            std::vector<double> both;
            std::ranges::set_union(breaks, brep_.edges[e].curve.knots.breaks(), std::back_inserter(both));
            breaks = std::move(both);
        }
        CubicKnots knots(breaks);
        std::vector<SplineCurve> originals;
        for (const auto e : stack) originals.push_back(brep_.edges[e].curve);
        for (int round = 0;; ++round) {
            for (std::size_t i = 0; i < stack.size(); ++i)
                brep_.edges[stack[i]].curve = with_knots(originals[i], knots);
            const auto halve = out_of_order(stack, knots);
            if (round == kOrderRounds || std::ranges::count(halve, 1) == 0) break;
            knots = knots.refined(halve);
        }
        for (std::size_t i = 1; i < stack.size(); ++i) {
            const auto& upper = brep_.edges[stack[i - 1]].curve.coefficients[2];
            auto& lower = brep_.edges[stack[i]].curve.coefficients[2];
            for (std::size_t k = 1; k + 1 < lower.size(); ++k)
                lower[k] = std::min(lower[k], upper[k] - kLeastGap * brep_.size);
        }
    }

    static SplineCurve with_knots(const SplineCurve& curve, const CubicKnots& knots) {
        SplineCurve same{knots, {}};
        for (std::size_t k = 0; k < 3; ++k)
            same.coefficients.push_back(interpolate_spline(knots, [&](double t) { return curve.at(k, t); }));
        return same;
    }

    // Spans whose coefficients are not in order: finer ones follow the curves more closely.
    std::vector<char> out_of_order(const std::vector<std::uint32_t>& stack, const CubicKnots& knots) const {
        std::vector<char> halve(knots.spans(), 0);
        for (std::size_t i = 1; i < stack.size(); ++i) {
            const auto& upper = brep_.edges[stack[i - 1]].curve.coefficients[2];
            const auto& lower = brep_.edges[stack[i]].curve.coefficients[2];
            for (std::size_t k = 1; k + 1 < lower.size(); ++k)
                if (lower[k] > upper[k] - kLeastGap * brep_.size)
                    for (std::size_t s = k < 3 ? 0 : k - 3; s <= k && s < halve.size(); ++s) halve[s] = 1;
        }
        return halve;
    }

    void measure_bodies() {
        for (std::size_t b = 0; b < bodies().size(); ++b) {
            const auto& body = bodies()[b];
            SmoothBrep::BodyQuality quality;
            CompensatedSum volume;
            for (const auto f : body.faces) {
                double sum = 0;
                each_corner(f, [&](std::uint32_t v) { sum += model_.thickness(body.layer, v); });
                volume.add(area(f) * sum / 3);
            }
            quality.mesh_volume = volume.value();
            quality.least_thickness = brep_.horizons.least_thickness[b];
            quality.volume = body_volume(brep_, body);
            for (const auto* faces : {&body.top, &body.base})
                for (const auto c : *faces) {
                    const std::uint32_t sheet = brep_.horizons.of_cell[c];
                    quality.off = std::max(quality.off, brep_.horizons.off[sheet]);
                    quality.usual_off = std::max(quality.usual_off, brep_.horizons.usual_off[sheet]);
                }
            brep_.quality.push_back(quality);
        }
    }

    const LayerModel& model_;
    const TriMesh& plan_;
    const SmoothBrepOptions& options_;
    SmoothBrep brep_;
    PlanCurves curves_;
};

void measure_edge(SmoothBrep& brep, std::size_t e) {
    auto& edge = brep.edges[e];
    edge.tolerances.assign(edge.curve.knots.spans(), 0);
    for (std::size_t s = 0; s < edge.tolerances.size(); ++s)
        for (const auto c : brep.cells.edges[e].cells)
            edge.tolerances[s] =
                std::max(edge.tolerances[s], distance_within_span(edge.curve, s, brep.sheet(c)));
}

}  // namespace

std::vector<std::size_t> cad_edge_ends(const SmoothBrep::Edge& edge) {
    const std::size_t spans = edge.curve.knots.spans(), count = (spans + edge.cad_spans - 1) / edge.cad_spans;
    std::vector<std::size_t> ends;
    for (std::size_t k = 0; k <= count; ++k) ends.push_back(k * spans / count);
    return ends;
}

void measure_edges(SmoothBrep& brep) {
    tbb::parallel_for(std::size_t{0}, brep.edges.size(), [&](std::size_t e) {
        if (brep.cells.edges[e].line != kNone) measure_edge(brep, e);
    });
    for (std::size_t b = 0; b < brep.quality.size(); ++b) {
        double& off = brep.quality[b].edge_off = 0;
        for (const auto* faces : {&brep.cells.bodies[b].top, &brep.cells.bodies[b].base})
            for (const auto c : *faces)
                for (const auto& loop : brep.cells.cells[c].loops)
                    for (const auto& use : loop)
                        for (const double t : brep.edges[use.edge].tolerances) off = std::max(off, t);
    }
}

SmoothBrep build_smooth_brep(const LayerModel& model, const SmoothBrepOptions& options) {
    return Builder(model, options).build();
}

SmoothBrep rebuild_smooth_brep(const LayerModel& model, const HorizonSheets& sheets,
                               const SmoothBrepOptions& options) {
    return Builder(model, options).build(&sheets);
}

}  // namespace stratareeb
