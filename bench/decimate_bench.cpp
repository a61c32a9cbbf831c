// SPDX-License-Identifier: GPL-3.0-or-later
// How decimation grows: layer models of 10,000 to 1,000,000 plan triangles down to a tenth, and a bumpy terrain by number of
// triangles and by error.
#include <benchmark/benchmark.h>

#include <cmath>

#include "boreholes/random_survey.h"
#include "mesh/decimate_layers.h"
#include "mesh/decimate_mesh.h"
#include "mesh/triangle_soup.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

void report(benchmark::State& state, std::size_t before, std::size_t after) {
    state.SetComplexityN(static_cast<std::int64_t>(before));
    state.counters["triangles"] = static_cast<double>(before);
    state.counters["left"] = static_cast<double>(after);
    state.counters["us_per_triangle"] =
        benchmark::Counter(1e-6 * static_cast<double>(before),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

//! Five layers that pinch out; about nine holes to a thousand triangles.
const LayerModel& layers(std::int64_t triangles) {
    static std::int64_t made = 0;
    static LayerModel model;
    if (made == triangles) return model;
    RandomSurveyOptions survey;
    survey.holes = static_cast<std::size_t>(triangles) / 110;
    survey.layers = 5;
    survey.extent = 100 * std::sqrt(static_cast<double>(survey.holes));
    survey.pinch_outs = true;
    LayerModelOptions options;
    options.spacing = 18;
    model = build_layer_model(random_survey(survey), options);
    made = triangles;
    return model;
}

void decimate_layers_to_a_tenth(benchmark::State& state) {
    const LayerModel& model = layers(state.range(0));
    const std::size_t before = model.plan.surface.n_faces();
    std::size_t after = 0;
    for (auto _ : state)
        after = decimate_layers(model, {.triangles = before / 10}).model.plan.surface.n_faces();
    report(state, before, after);
}

void decimate_layers_by_error(benchmark::State& state) {
    const LayerModel& model = layers(state.range(0));
    std::size_t after = 0;
    for (auto _ : state) after = decimate_layers(model, {.max_error = 0.5}).model.plan.surface.n_faces();
    report(state, model.plan.surface.n_faces(), after);
}

TriMesh terrain(std::int64_t triangles) {
    const auto n = static_cast<shapes::Index>(std::sqrt(static_cast<double>(triangles) / 2));
    return half_edge_mesh(shapes::terrain(n, [](double x, double y) {
        return 3 * std::sin(0.05 * x) * std::cos(0.07 * y) + 0.1 * std::sin(0.6 * x + y);
    }));
}

void decimate_mesh_to_a_tenth(benchmark::State& state) {
    const TriMesh mesh = terrain(state.range(0));
    std::size_t after = 0;
    for (auto _ : state) after = decimate_mesh(mesh, {.triangles = mesh.n_faces() / 10}).mesh.n_faces();
    report(state, mesh.n_faces(), after);
}

void decimate_mesh_by_error(benchmark::State& state) {
    const TriMesh mesh = terrain(state.range(0));
    std::size_t after = 0;
    for (auto _ : state) after = decimate_mesh(mesh, {.max_error = 0.2}).mesh.n_faces();
    report(state, mesh.n_faces(), after);
}

#define SIZES \
    RangeMultiplier(10)->Range(10'000, 1'000'000)->Unit(benchmark::kMillisecond)->Iterations(1)->Complexity()
BENCHMARK(decimate_layers_to_a_tenth)->SIZES;
BENCHMARK(decimate_layers_by_error)->SIZES;
BENCHMARK(decimate_mesh_to_a_tenth)->SIZES;
BENCHMARK(decimate_mesh_by_error)->SIZES;

}  // namespace
}  // namespace stratareeb
