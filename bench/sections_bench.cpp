// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of a finished model, as its plan grows to a million triangles under ten layers: sections against what they
// return, columns one by one and as a raster, volumes, cells.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "boreholes/random_survey.h"
#include "mesh/cell_quality.h"
#include "mesh/horizontal_section.h"
#include "mesh/model_column.h"
#include "mesh/model_grid.h"
#include "mesh/vertical_section.h"
#include "mesh/volume_between.h"
#include "mesh/volume_mesh.h"
#include "mesh/voxel_block.h"

namespace stratareeb {
namespace {

constexpr double kExtent = 10'000;
constexpr std::size_t kLayers = 10;

//! About so many plan triangles; made once.
const LayerModel& model_of(std::int64_t triangles) {
    static std::map<std::int64_t, LayerModel> models;
    auto found = models.find(triangles);
    if (found == models.end()) {
        const Survey survey =
            random_survey({.holes = 300, .layers = kLayers, .extent = kExtent, .pinch_outs = true});
        const double spacing = 1.75 * kExtent / std::sqrt(static_cast<double>(triangles));
        LayerModelOptions options;
        options.interpolator = InterpolatorKind::Linear;
        options.spacing = spacing;
        found = models.emplace(triangles, build_layer_model(survey, options)).first;
    }
    return found->second;
}

void report(benchmark::State& state, const LayerModel& model) {
    state.counters["plan_triangles"] = static_cast<double>(model.plan.surface.n_faces());
}

//! Across the whole model, the locator made before: time against the corners of the polygons.
void cut_upright(benchmark::State& state) {
    const LayerModel& model = model_of(state.range(0));
    const PlanLocator locator(model.plan.surface);
    const std::vector<Point2> line{{model.origin.x + 1, model.origin.y + 10},
                                   {model.origin.x + 9000, model.origin.y + 9500}};
    std::size_t corners = 0;
    for (auto _ : state) {
        corners = 0;
        for (const SectionPolygon& polygon : section_polygons(vertical_section(model, locator, line)))
            corners += polygon.outline.size();
    }
    report(state, model);
    state.counters["corners"] = static_cast<double>(corners);
}

void cut_level(benchmark::State& state) {
    const LayerModel& model = model_of(state.range(0));
    std::size_t corners = 0;
    for (auto _ : state) {
        corners = 0;
        for (const LevelPolygon& polygon : horizontal_section(model, 40))
            for (const auto& ring : polygon.rings) corners += ring.size();
    }
    report(state, model);
    state.counters["corners"] = static_cast<double>(corners);
}

void make_the_locator(benchmark::State& state) {
    const LayerModel& model = model_of(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(PlanLocator(model.plan.surface));
    report(state, model);
}

void ask_a_million_columns(benchmark::State& state) {
    const LayerModel& model = model_of(state.range(0));
    const ColumnQuery query(model);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> place(0, kExtent);
    std::vector<Point2> places(1'000'000);
    for (Point2& p : places) p = {place(random), place(random)};
    for (auto _ : state)
        for (const Point2& p : places) benchmark::DoNotOptimize(query.column(p));
    report(state, model);
}

void raster_all_horizons(benchmark::State& state) {
    const LayerModel& model = model_of(state.range(0));
    const PlanGrid grid = grid_over(model, kExtent / 2000);
    std::vector<const std::vector<double>*> fields;
    for (const auto& horizon : model.horizons) fields.push_back(&horizon);
    for (auto _ : state) benchmark::DoNotOptimize(rasterized(model, grid, fields));
    report(state, model);
    state.counters["cells"] = static_cast<double>(grid.columns * grid.rows);
}

void volumes_in_a_polygon_between_levels(benchmark::State& state) {
    const LayerModel& model = model_of(state.range(0));
    std::vector<Point2> ring;
    for (int k = 0; k < 1000; ++k) {
        const double angle = 2 * M_PI * k / 1000, r = 4000 + 500 * std::sin(17 * angle);
        ring.push_back({5000 + r * std::cos(angle), 5000 + r * std::sin(angle)});
    }
    for (auto _ : state)
        benchmark::DoNotOptimize(volumes_between(model, {.elevations = {{0, 60}}, .areas = {ring}}));
    report(state, model);
}

void fill_with_cells(benchmark::State& state) {
    const LayerModel& model = model_of(state.range(0));
    std::size_t cells = 0;
    for (auto _ : state) {
        const VolumeMesh mesh = volume_mesh(model);
        cells = mesh.cells.size();
        benchmark::DoNotOptimize(cell_qualities(mesh));
    }
    report(state, model);
    state.counters["cells"] = static_cast<double>(cells);
}

void fill_with_voxels(benchmark::State& state) {
    const LayerModel& model = model_of(state.range(0));
    std::size_t cells = 0;
    for (auto _ : state) cells = voxel_block(model, 20, 2).units.size();
    report(state, model);
    state.counters["cells"] = static_cast<double>(cells);
}

#define SIZES RangeMultiplier(10)->Range(10'000, 1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime()
BENCHMARK(cut_upright)->SIZES;
BENCHMARK(cut_level)->SIZES;
BENCHMARK(make_the_locator)->SIZES;
BENCHMARK(ask_a_million_columns)->SIZES;
BENCHMARK(raster_all_horizons)->SIZES;
BENCHMARK(volumes_in_a_polygon_between_levels)->SIZES;
BENCHMARK(fill_with_cells)->SIZES;
BENCHMARK(fill_with_voxels)->SIZES;

}  // namespace
}  // namespace stratareeb
