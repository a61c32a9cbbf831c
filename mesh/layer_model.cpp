// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/layer_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "boreholes/column_field.h"
#include "boreholes/errors.h"
#include "mesh/compensated_sum.h"
#include "mesh/cut_layers.h"

namespace stratareeb {

namespace {

constexpr double kBareOpening = 0.02, kSpacedOpening = 0.25;

void report(const LayerModelOptions& options, const char* step, double share) {
    if (options.progress) options.progress(step, share);
}

//! A round number below the low end of a range, or 0 where coordinates are small.
double round_origin(double low, double high) {
    if (std::max(std::abs(low), std::abs(high)) < kFarFromOrigin) return 0;
    const double step = std::pow(10, std::floor(std::log10(std::max(high - low, 1.0))));
    return std::floor(low / step) * step;
}

Footprint shifted(Footprint footprint, const Point3& origin) {
    for (auto& ring : footprint)
        for (Point2& p : ring) p = {p.x - origin.x, p.y - origin.y};
    return footprint;
}

std::vector<Point2> plan_points(const TriMesh& mesh) {
    std::vector<Point2> points;
    points.reserve(mesh.n_vertices());
    for (const auto v : mesh.vertices()) points.push_back({mesh.point(v)[0], mesh.point(v)[1]});
    return points;
}

//! Lines out of the hull reach across the footprint, wherever it lies.
double reach_beyond_hull(const Footprint& footprint, const std::vector<Point2>& holes) {
    double reach = 0;
    for (const auto& ring : footprint)
        for (const Point2& p : ring) reach = std::max(reach, std::hypot(p.x - holes[0].x, p.y - holes[0].y));
    double extent = 0;
    for (const Point2& p : holes) extent = std::max(extent, std::hypot(p.x - holes[0].x, p.y - holes[0].y));
    return 2 * (reach + extent);
}

//! Pieces of both, each once: clipped at the outline from two ends, one piece would end in two places but for
//! rounding.
PlanLines merged(PlanLines a, const PlanLines& b) {
    std::map<std::pair<double, double>, std::uint32_t> known;
    std::set<std::pair<std::uint32_t, std::uint32_t>> joined;
    for (std::uint32_t i = 0; i < a.points.size(); ++i)
        known.emplace(std::pair(a.points[i].x, a.points[i].y), i);
    for (const auto& [i, j] : a.segments) joined.insert(std::minmax(i, j));
    std::vector<std::uint32_t> number;
    for (const Point2& p : b.points) {
        const auto next = static_cast<std::uint32_t>(a.points.size());
        const auto [it, fresh] = known.emplace(std::pair(p.x, p.y), next);
        if (fresh) a.points.push_back(p);
        number.push_back(it->second);
    }
    for (const auto& [i, j] : b.segments)
        if (joined.insert(std::minmax(number[i], number[j])).second)
            a.segments.push_back({number[i], number[j]});
    return a;
}

//! Equilateral triangles of three quarters of the spacing, and some around each hole and line.
double expected_triangles(const Footprint& footprint, double spacing, std::size_t features) {
    constexpr double kPerFeature = 6;
    const double even =
        spacing > 0 ? 4 / std::numbers::sqrt3 * area(footprint) / (0.75 * 0.75 * spacing * spacing) : 0;
    return even + kPerFeature * static_cast<double>(features);
}

void set_horizons(LayerModel& model, std::vector<double> ground, std::vector<std::vector<double>> thickness,
                  double thinnest) {
    const std::size_t layers = thickness.size(), vertices = ground.size();
    for (std::size_t i = 0; i < layers; ++i)
        for (std::size_t v = 0; v < vertices; ++v)
            thickness[i][v] = model.regions.zero_at[v][i] ? 0.0 : std::max(thickness[i][v], thinnest);
    for (std::size_t h = 0; h < model.plan.hole_vertex.size(); ++h) {
        const auto v = model.plan.hole_vertex[h];
        if (v == PlanMesh::kNoVertex) continue;
        ground[v] = model.columns.ground[h];
        for (std::size_t i = 0; i < layers; ++i) {
            const double measured = model.columns.thickness[i][h];
            if ((measured > 0) == static_cast<bool>(model.regions.zero_at[v][i]))
                throw GeometryError(fmt::format(
                    "layer '{}' can't end between hole {} and its neighbours: they stand too close together",
                    model.units[i].code, h + 1));
            if (measured > 0) thickness[i][v] = std::max(measured, thinnest);
        }
    }
    model.horizons.assign(layers + 1, ground);
    for (std::size_t i = 0; i < layers; ++i)
        for (std::size_t v = 0; v < vertices; ++v)
            model.horizons[i + 1][v] = model.horizons[i][v] - thickness[i][v];
}

}  // namespace

Point3 suitable_origin(const std::vector<Point2>& sites, const std::vector<double>& ground) {
    const auto [x0, x1] = std::ranges::minmax(sites, {}, &Point2::x);
    const auto [y0, y1] = std::ranges::minmax(sites, {}, &Point2::y);
    const auto [z0, z1] = std::ranges::minmax(ground);
    return {round_origin(x0.x, x1.x), round_origin(y0.y, y1.y), round_origin(z0, z1)};
}

LayerModel build_layer_model(const Survey& survey, const LayerModelOptions& options) {
    LayerModel model;
    model.units = survey.units;
    model.length_unit = survey.length_unit;
    report(options, "completing the holes' columns", 0);
    ColumnField columns(survey, {options.interpolator, options.pinch_out, options.terrain, options.rules});
    model.notes = columns.columns().notes;
    model.origin =
        options.origin.value_or(suitable_origin(columns.columns().sites, columns.columns().ground));
    columns.move_origin(model.origin);
    const Footprint footprint =
        checked_footprint(options.footprint ? shifted(*options.footprint, model.origin)
                                            : hull_footprint(HoleTriangulation(columns.columns().sites)));
    model.spacing =
        options.spacing.value_or(options.spacing_factor * suitable_spacing(footprint, survey.holes.size()));
    const bool bare = model.spacing == 0;
    columns.prepare(std::sqrt(area(footprint)), bare);
    model.columns = columns.columns();
    const ThicknessField& field = columns.thickness();
    const bool beyond_hull = options.footprint || !bare;
    PlanLines lines = pinch_lines(field, beyond_hull ? reach_beyond_hull(footprint, model.columns.sites) : 0);
    if (bare) lines = merged(std::move(lines), cut_triangulation_edges(field));
    const double triangles =
        expected_triangles(footprint, model.spacing, survey.holes.size() + lines.segments.size());
    if (options.before_meshing) options.before_meshing(triangles);
    PlanMeshOptions plan_options{.spacing = model.spacing, .ring_holes = options.ring_holes};
    plan_options.progress = [&](std::size_t vertices) {
        report(options, "meshing the plan", std::min(0.99, 2 * static_cast<double>(vertices) / triangles));
    };
    report(options, "meshing the plan", 0);
    model.plan = build_plan_mesh(footprint, model.columns.sites, lines, plan_options);
    report(options, "finding the layers' regions", 0);
    const double opening = bare ? kBareOpening : kSpacedOpening;
    model.regions = build_layer_regions(model.plan, field, {.opening = opening});

    report(options, "predicting horizons", 0);
    const std::vector<Point2> where = plan_points(model.plan.surface);
    std::vector<double> ground = columns.ground(where);
    if (columns.is_ruled())
        cut_layers(model, columns.rules().sequences, options.rules, columns.uncut(where, ground),
                   columns.thinnest(), opening);
    else
        set_horizons(model, std::move(ground), field.predict(where), columns.thinnest());
    report(options, "predicting horizons", 1);
    return model;
}

double envelope_volume(const LayerModel& model) {
    CompensatedSum volume;
    const auto& mesh = model.plan.surface;
    for (const auto f : mesh.faces()) {
        double depth = 0;
        for (const auto v : mesh.fv_range(f)) {
            const auto i = static_cast<std::size_t>(v.idx());
            depth += model.horizons.front()[i] - model.horizons.back()[i];
        }
        volume.add(mesh.calc_face_area(f) * depth / 3);
    }
    return volume.value();
}

}  // namespace stratareeb
