// SPDX-License-Identifier: GPL-3.0-or-later
// From boreholes to solids: how each step of `build` grows with the number of holes (10 layers that pinch out, about five
// million solid triangles for 100,000 holes and the spacing used here).
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>
#include <filesystem>
#include <memory>

#include "boreholes/complete_columns.h"
#include "boreholes/random_survey.h"
#include "boreholes/thickness_field.h"
#include "io/write_mesh.h"
#include "mesh/analysis.h"
#include "mesh/layer_model.h"

namespace stratareeb {
namespace {

constexpr std::size_t kLayers = 10;
constexpr double kSpacingOfHoles = 100;  // m

Survey survey_of(std::int64_t holes) {
    RandomSurveyOptions options;
    options.holes = static_cast<std::size_t>(holes);
    options.layers = kLayers;
    options.extent = kSpacingOfHoles * std::sqrt(static_cast<double>(holes));
    options.pinch_outs = true;
    options.unknown_share = 0.1;
    options.cut_off_share = 0.2;
    return random_survey(options);
}

LayerModelOptions model_options() {
    LayerModelOptions options;
    options.spacing = kSpacingOfHoles;
    return options;
}

double peak_memory_mib() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

void report(benchmark::State& state, std::size_t plan_triangles, std::size_t solid_triangles) {
    state.SetComplexityN(state.range(0));
    state.counters["plan_triangles"] = static_cast<double>(plan_triangles);
    state.counters["solid_triangles"] = static_cast<double>(solid_triangles);
    state.counters["peak_MiB"] = peak_memory_mib();
}

void complete_the_columns(benchmark::State& state) {
    const Survey survey = survey_of(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(complete_columns(survey));
    report(state, 0, 0);
}

void build_the_model(benchmark::State& state) {
    const Survey survey = survey_of(state.range(0));
    std::size_t triangles = 0;
    for (auto _ : state) triangles = build_layer_model(survey, model_options()).plan.surface.n_faces();
    report(state, triangles, 0);
}

void build_the_solids(benchmark::State& state) {
    const LayerModel model = build_layer_model(survey_of(state.range(0)), model_options());
    std::size_t triangles = 0;
    for (auto _ : state) {
        triangles = 0;
        for (std::size_t i = 0; i < kLayers; ++i) triangles += build_layer_solid(model, i).surface.n_faces();
    }
    report(state, model.plan.surface.n_faces(), triangles);
}

void check_the_solids(benchmark::State& state) {
    const LayerModel model = build_layer_model(survey_of(state.range(0)), model_options());
    std::vector<LayerSolid> solids;
    for (std::size_t i = 0; i < kLayers; ++i) solids.push_back(build_layer_solid(model, i));
    std::size_t triangles = 0;
    for (auto _ : state) {
        triangles = 0;
        for (const auto& solid : solids) triangles += analyze(solid.surface).triangles;
    }
    report(state, model.plan.surface.n_faces(), triangles);
}

void write_the_solids(benchmark::State& state) {
    const LayerModel model = build_layer_model(survey_of(state.range(0)), model_options());
    std::vector<LayerSolid> solids;
    for (std::size_t i = 0; i < kLayers; ++i) solids.push_back(build_layer_solid(model, i));
    const auto file = std::filesystem::temp_directory_path() / "stratareeb_bench.ply";
    std::size_t triangles = 0;
    for (auto _ : state) {
        triangles = 0;
        for (const auto& solid : solids) {
            write_mesh(file, {solid.unit.name, solid.unit.color, &solid.surface});
            triangles += solid.surface.n_faces();
        }
    }
    std::filesystem::remove(file);
    report(state, model.plan.surface.n_faces(), triangles);
}

#define SIZES                           \
    RangeMultiplier(10)                 \
        ->Range(100, 100'000)           \
        ->Unit(benchmark::kMillisecond) \
        ->Complexity()                  \
        ->MeasureProcessCPUTime()       \
        ->UseRealTime()
BENCHMARK(complete_the_columns)->SIZES;
BENCHMARK(build_the_model)->SIZES;
BENCHMARK(build_the_solids)->SIZES;
BENCHMARK(check_the_solids)->SIZES;
BENCHMARK(write_the_solids)->SIZES;

}  // namespace
}  // namespace stratareeb
