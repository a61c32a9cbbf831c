// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/smooth_brep.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "mesh/compensated_sum.h"

namespace stratareeb {
namespace {

constexpr std::uint32_t kNone = PlanCells::kNone;
constexpr double kEdgeTolerance = 2e-7;  // of the size: curve from the height it follows
constexpr double kBorderShare = 0.3;     // of a patch's tolerance: what it may be off at its border
constexpr int kCloserFits = 1;           // of patches that cross, each to a quarter of the tolerance before
constexpr double kLeastTolerance =
    0.1;                             // of a patch, as a share of its own: else knots gather at thin places
constexpr int kSamplesAnEdge = 6;    // of the plan's triangles, on a patch's border
constexpr double kFinestSpan = 0.1;  // of a mean edge of the plan's triangles: shorter spans are not halved
constexpr double kEdgeSpan = 1.5;    // of the patches' spans around it
constexpr int kSamplesASpan = 10;    // of an edge, for its tolerance
constexpr std::size_t kMostEdgeSpans = 1500;

class Builder {
 public:
    Builder(const LayerModel& model, const SmoothBrepOptions& options)
        : model_(model),
          plan_(model.plan.surface),
          options_(options),
          most_functions_(options.most_functions) {}

    SmoothBrep build() {
        brep_.cells = build_plan_cells(model_, options_.cells);
        brep_.size = size();
        curves_ = build_plan_curves(plan_, brep_.cells, options_.rim_tolerance * brep_.size);
        brep_.sides = curves_.sides;
        measure_bodies();
        set_tolerances();
        draw_border_samples();
        brep_.patches.assign(cells().size(), {CubicKnots({0, 1}), CubicKnots({0, 1}), {}});
        std::vector<std::uint32_t> all(cells().size());
        for (std::uint32_t c = 0; c < all.size(); ++c) all[c] = c;
        fit_patches(all);
        auto crossing = crossing_cells();
        for (int round = 0; round < kCloserFits && !crossing.empty(); ++round) {
            for (const auto c : crossing) tolerance_[c] /= 4;
            most_functions_ = 2 * options_.most_functions;
            fit_patches(crossing);
            crossing = crossing_cells();
        }
        draw_edges();
        place_corners();
        measure_distance();
        return std::move(brep_);
    }

 private:
    const std::vector<PlanCells::Cell>& cells() const { return brep_.cells.cells; }
    const std::vector<PlanCells::Body>& bodies() const { return brep_.cells.bodies; }

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

    void measure_bodies() {
        for (const auto& body : bodies()) {
            CompensatedSum volume, in_plan;
            for (const auto f : body.faces) {
                double sum = 0;
                each_corner(f, [&](std::uint32_t v) { sum += model_.thickness(body.layer, v); });
                volume.add(area(f) * sum / 3);
                in_plan.add(area(f));
            }
            brep_.quality.push_back({.mesh_volume = volume.value()});
            thickness_.push_back(volume.value() / in_plan.value());
        }
    }

    void set_tolerances() {
        for (const auto& cell : cells()) {
            double tolerance = options_.tolerance * brep_.size;
            for (const auto body : {cell.body_above, cell.body_below})
                if (body != kNone)
                    tolerance = std::min(tolerance, options_.thickness_tolerance * thickness_[body]);
            tolerance_.push_back(tolerance);
        }
        off_.assign(cells().size(), 0);
    }

    // Heights along each edge that all its patches are to have: a curve through the model's vertices, read at them
    // and between.
    void draw_border_samples() {
        border_.resize(brep_.cells.edges.size());
        tbb::parallel_for(std::size_t{0}, border_.size(), [&](std::size_t e) {
            const auto& edge = brep_.cells.edges[e];
            if (edge.line == kNone) return;
            const auto& vertices = brep_.cells.lines[edge.line].vertices;
            const auto& line = curves_.lines[edge.line];
            std::vector<double> z, tolerance;
            for (const auto v : vertices) {
                z.push_back(model_.horizons[edge.horizon][v]);
                tolerance.push_back(INFINITY);
                for (const auto c : edge.cells)
                    tolerance.back() =
                        std::min(tolerance.back(), kBorderShare * tolerance_at(c, edge.horizon, v));
            }
            const auto height = fit_spline(
                line.parameters, {z}, {.tolerance = std::ranges::min(tolerance), .most_spans = 2 * z.size()});
            const auto add = [&](double t, double off) {
                border_[e].push_back(
                    {{line.curve.at(0, t), line.curve.at(1, t)}, height.at(0, t), 1.0 / kSamplesAnEdge, off});
            };
            for (std::size_t i = 0; i < z.size(); ++i) {
                add(line.parameters[i], tolerance[i]);
                for (int k = 1; k < kSamplesAnEdge && i + 1 < z.size(); ++k)
                    add(std::lerp(line.parameters[i], line.parameters[i + 1], k / double(kSamplesAnEdge)),
                        std::min(tolerance[i], tolerance[i + 1]));
            }
        });
    }

    // What a patch may be off at a vertex: less where a layer above or below is thin.
    double tolerance_at(std::uint32_t c, std::uint32_t horizon, std::uint32_t v) const {
        double tolerance = tolerance_[c];
        const auto consider = [&](std::size_t layer) {
            const double thickness = model_.thickness(layer, v);
            if (thickness > 0) tolerance = std::min(tolerance, options_.thin_tolerance * thickness);
            return thickness > 0;
        };
        for (std::size_t layer = horizon; layer-- > 0;)
            if (consider(layer)) break;
        for (std::size_t layer = horizon; layer < model_.units.size(); ++layer)
            if (consider(layer)) break;
        return std::max(tolerance, kLeastTolerance * tolerance_[c]);
    }

    void fit_patches(const std::vector<std::uint32_t>& which) {
        tbb::parallel_for(std::size_t{0}, which.size(), [&](std::size_t i) { fit_patch(which[i]); });
    }

    void fit_patch(std::uint32_t c) {
        const auto& cell = cells()[c];
        HeightSamples samples;
        samples.inside = samples_inside(c);
        for (const auto& loop : cell.loops)
            for (const auto& use : loop)
                samples.border.insert(samples.border.end(), border_[use.edge].begin(),
                                      border_[use.edge].end());
        double in_plan = 0;
        for (const auto f : cell.faces) {
            in_plan += area(f);
            samples.guides.push_back(centre(f, cell.horizon));
        }
        const HeightFitOptions options{
            .finest = kFinestSpan * std::sqrt(2 * in_plan / static_cast<double>(cell.faces.size())),
            .most_functions = most_functions_};
        auto fit = fit_height_patch(samples, options);
        brep_.patches[c] = std::move(fit.patch);
        off_[c] = std::max(fit.off_inside, fit.off_border);
    }

    HeightSample centre(std::uint32_t face, std::uint32_t horizon) const {
        HeightSample sample{{0, 0}, 0, area(face)};
        each_corner(face, [&](std::uint32_t v) {
            sample.at.x += point(v).x / 3, sample.at.y += point(v).y / 3;
            sample.z += model_.horizons[horizon][v] / 3;
        });
        return sample;
    }

    // The cell's vertices that are not on its border, each with the plan area it stands for.
    std::vector<HeightSample> samples_inside(std::uint32_t c) const {
        const auto& cell = cells()[c];
        std::vector<std::pair<std::uint32_t, double>> shares;
        for (const auto f : cell.faces)
            each_corner(f, [&](std::uint32_t v) { shares.emplace_back(v, area(f) / 3); });
        std::ranges::sort(shares);
        std::vector<std::uint32_t> on_border;
        for (const auto& loop : cell.loops)
            for (const auto& use : loop) {
                const auto& line = brep_.cells.lines[brep_.cells.edges[use.edge].line].vertices;
                on_border.insert(on_border.end(), line.begin(), line.end());
            }
        std::ranges::sort(on_border);
        std::vector<HeightSample> samples;
        std::uint32_t last = kNone;
        for (const auto& [v, share] : shares) {
            if (std::ranges::binary_search(on_border, v)) continue;
            if (v != last)
                samples.push_back(
                    {point(v), model_.horizons[cell.horizon][v], 0, tolerance_at(c, cell.horizon, v)});
            samples.back().weight += share;
            last = v;
        }
        return samples;
    }

    // Cells over a body's triangles, as [triangle of the body].
    std::vector<std::uint32_t> cells_over(const PlanCells::Body& body,
                                          const std::vector<std::uint32_t>& which) const {
        std::vector<std::uint32_t> result(body.faces.size(), kNone);
        for (const auto c : which)
            for (const auto f : cells()[c].faces) {
                const auto it = std::ranges::lower_bound(body.faces, f);
                if (it != body.faces.end() && *it == f)
                    result[static_cast<std::size_t>(it - body.faces.begin())] = c;
            }
        return result;
    }

    std::vector<std::uint32_t> crossing_cells() {
        std::vector<char> crosses(cells().size(), 0);
        for (std::size_t b = 0; b < bodies().size(); ++b) {
            const auto& body = bodies()[b];
            const auto top = cells_over(body, body.top), base = cells_over(body, body.base);
            double least = INFINITY;
            for (std::size_t i = 0; i < body.faces.size(); ++i)
                each_corner(body.faces[i], [&](std::uint32_t v) {
                    if (model_.regions.zero_at[v][body.layer]) return;
                    const double thickness =
                        brep_.patches[top[i]].z(point(v)) - brep_.patches[base[i]].z(point(v));
                    least = std::min(least, thickness);
                    if (thickness <= 0) crosses[top[i]] = crosses[base[i]] = 1;
                });
            brep_.quality[b].least_thickness = least;
        }
        std::vector<std::uint32_t> result;
        for (std::uint32_t c = 0; c < crosses.size(); ++c)
            if (crosses[c]) result.push_back(c);
        return result;
    }

    void draw_edges() {
        brep_.edges.resize(brep_.cells.edges.size());
        tbb::parallel_for(std::size_t{0}, brep_.edges.size(), [&](std::size_t e) {
            if (brep_.cells.edges[e].line != kNone) draw_edge(e);
        });
    }

    // An edge follows the mean of its patches: on the rim, where it has one, it lies in it.
    void draw_edge(std::size_t e) {
        const auto& edge = brep_.cells.edges[e];
        const auto& line = curves_.lines[edge.line];
        const auto patch_z = [&](std::uint32_t c, double t) {
            return brep_.patches[c].z({line.curve.at(0, t), line.curve.at(1, t)});
        };
        const auto mean = [&](double t) {
            double sum = 0;
            for (const auto c : edge.cells) sum += patch_z(c, t);
            return sum / static_cast<double>(edge.cells.size());
        };
        const auto knots = as_fine_as_patches(edge.cells, line.curve);
        auto z = approximate(knots, mean,
                             {.tolerance = kEdgeTolerance * brep_.size, .most_spans = kMostEdgeSpans});
        auto& result = brep_.edges[e];
        result.side_start = line.side_start;
        result.curve.knots = z.knots;
        for (const std::size_t k : {0, 1})
            result.curve.coefficients.push_back(
                interpolate_spline(z.knots, [&, k](double t) { return line.curve.at(k, t); }));
        result.curve.coefficients.push_back(std::move(z.coefficients[0]));
        const auto& breaks = z.knots.breaks();
        for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
            for (int k = 0; k <= kSamplesASpan; ++k)
                for (const auto c : edge.cells) {
                    const double t = std::lerp(breaks[s], breaks[s + 1], k / double(kSamplesASpan));
                    result.tolerance =
                        std::max(result.tolerance, std::abs(result.curve.at(2, t) - patch_z(c, t)));
                }
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
            look(brep_.patches[c].x, line.at(0, a), line.at(0, b));
            look(brep_.patches[c].y, line.at(1, a), line.at(1, b));
        }
        return shortest;
    }

    void place_corners() {
        struct End {
            double z;
            Point2 at;
        };
        std::vector<std::vector<End>> ends(brep_.cells.corners.size());
        for (std::size_t e = 0; e < brep_.edges.size(); ++e) {
            const auto& edge = brep_.cells.edges[e];
            if (edge.line == kNone) continue;
            const auto& c = brep_.edges[e].curve.coefficients;
            ends[edge.from].push_back({c[2].front(), {c[0].front(), c[1].front()}});
            ends[edge.to].push_back({c[2].back(), {c[0].back(), c[1].back()}});
        }
        for (const auto& here : ends) {
            SmoothBrep::Corner corner;
            double z = 0;
            for (const End& end : here) z += end.z / static_cast<double>(here.size());
            corner.at = {here[0].at.x, here[0].at.y, z};
            for (const End& end : here)
                corner.tolerance = std::max(
                    corner.tolerance, std::hypot(end.at.x - corner.at.x, end.at.y - corner.at.y, end.z - z));
            brep_.corners.push_back(corner);
        }
    }

    void measure_distance() {
        for (std::size_t b = 0; b < bodies().size(); ++b)
            for (const auto* faces : {&bodies()[b].top, &bodies()[b].base})
                for (const auto c : *faces) {
                    auto& quality = brep_.quality[b];
                    quality.off = std::max(quality.off, off_[c]);
                    for (const auto& loop : cells()[c].loops)
                        for (const auto& use : loop)
                            quality.edge_off = std::max(quality.edge_off, brep_.edges[use.edge].tolerance);
                }
    }

    const LayerModel& model_;
    const TriMesh& plan_;
    const SmoothBrepOptions& options_;
    std::size_t most_functions_;
    SmoothBrep brep_;
    PlanCurves curves_;
    std::vector<double> thickness_;                  // [body], mean
    std::vector<double> tolerance_, off_;            // [cell]
    std::vector<std::vector<HeightSample>> border_;  // [edge]
};

}  // namespace

SmoothBrep build_smooth_brep(const LayerModel& model, const SmoothBrepOptions& options) {
    return Builder(model, options).build();
}

}  // namespace stratareeb
