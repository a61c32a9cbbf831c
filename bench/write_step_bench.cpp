// SPDX-License-Identifier: GPL-3.0-or-later
// STEP solids of random surveys, smooth and faceted; arguments: boreholes, layers (bodies).
#include <benchmark/benchmark.h>

#include <filesystem>

#include "boreholes/random_survey.h"
#include "io/write_step.h"
#include "mesh/layer_model.h"
#include "subdivision/refined_layers.h"

namespace stratareeb {
namespace {

LayerModel refined_model(const benchmark::State& state) {
    RandomSurveyOptions options;
    options.holes = static_cast<std::size_t>(state.range(0));
    options.layers = static_cast<std::size_t>(state.range(1));
    LayerModelOptions model;
    model.ring_holes = true;
    return refine_layers(build_layer_model(random_survey(options), model), {.levels = 1}).model;
}

void count(benchmark::State& state, const std::filesystem::path& file, const StepReport& report) {
    state.counters["solids"] = static_cast<double>(report.solids);
    state.counters["faces"] = static_cast<double>(report.faces);
    state.counters["MB"] = static_cast<double>(std::filesystem::file_size(file)) / 1e6;
    std::filesystem::remove(file);
}

void smooth(benchmark::State& state) {
    const LayerModel model = refined_model(state);
    const auto file = std::filesystem::temp_directory_path() / "write_step_bench_smooth.step";
    StepReport report;
    for (auto _ : state) report = write_smooth_step(file, model);
    state.counters["in facets"] = static_cast<double>(report.notes.size());
    count(state, file, report);
}

void faceted(benchmark::State& state) {
    const LayerModel model = refined_model(state);
    std::vector<LayerSolid> solids;
    for (std::size_t layer = 0; layer < model.units.size(); ++layer)
        solids.push_back(build_layer_solid(model, layer));
    const auto file = std::filesystem::temp_directory_path() / "write_step_bench_faceted.step";
    StepReport report;
    for (auto _ : state) report = write_step(file, solids);
    count(state, file, report);
}

BENCHMARK(smooth)->ArgsProduct({{20, 80}, {3, 6}})->Unit(benchmark::kMillisecond);
BENCHMARK(faceted)->ArgsProduct({{20, 80}, {3, 6}})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stratareeb
