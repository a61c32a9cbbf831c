// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth surfaces through all contacts: how refine_layers grows with the number of holes (10 layers that pinch out), and what one
// field costs against OpenSubdiv, which needs a refiner for each set of creases.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>

#include "boreholes/random_survey.h"
#include "subdivision/crease_field.h"
#include "subdivision/field_subdivision.h"
#include "subdivision/refined_layers.h"

namespace stratareeb {
namespace {

constexpr double kSpacingOfHoles = 100;  // m

LayerModel control_of(std::int64_t holes) {
    RandomSurveyOptions options;
    options.holes = static_cast<std::size_t>(holes);
    options.layers = 10;
    options.extent = kSpacingOfHoles * std::sqrt(static_cast<double>(holes));
    options.pinch_outs = true;
    options.unknown_share = 0.1;
    options.cut_off_share = 0.2;
    LayerModelOptions model;
    model.spacing = kSpacingOfHoles;
    model.ring_holes = true;
    return build_layer_model(random_survey(options), model);
}

double peak_memory_mib() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

void refine_the_layers(benchmark::State& state) {
    const LayerModel control = control_of(state.range(0));
    const int levels = static_cast<int>(state.range(1));
    SmoothnessReport report;
    std::size_t triangles = 0;
    for (auto _ : state) {
        const RefinedLayers refined = refine_layers(control, {.levels = levels});
        triangles = refined.model.plan.surface.n_faces();
        report = refined.smoothness;
    }
    state.counters["control_triangles"] = static_cast<double>(control.plan.surface.n_faces());
    state.counters["plan_triangles"] = static_cast<double>(triangles);
    state.counters["straightened"] = static_cast<double>(report.straightened);
    state.counters["energy_ratio"] = report.after.bending_energy / report.before.bending_energy;
    state.counters["peak_MiB"] = peak_memory_mib();
}

std::vector<double> heights(const TriMesh& mesh) {
    std::vector<double> z;
    for (const auto v : mesh.vertices()) z.push_back(std::sin(0.01 * mesh.point(v)[0]) + mesh.point(v)[1]);
    return z;
}

void one_field(benchmark::State& state) {
    const LayerModel control = control_of(state.range(0));
    const LoopTopology topology(control.plan.surface, 2);
    const auto z = heights(control.plan.surface);
    for (auto _ : state) benchmark::DoNotOptimize(limit_values(topology, {}, z));
}

void one_field_by_opensubdiv(benchmark::State& state) {
    const LayerModel control = control_of(state.range(0));
    const auto triangles = LoopTopology(control.plan.surface, 0).finest().triangles;
    const auto z = heights(control.plan.surface);
    for (auto _ : state) {
        const FieldSubdivision field(triangles, z.size(), {}, {}, 2);
        benchmark::DoNotOptimize(field.limit(z));
    }
}

BENCHMARK(refine_the_layers)
    ->ArgsProduct({{100, 1'000, 10'000, 100'000}, {1}})
    ->Args({100, 2})
    ->Args({1'000, 2})
    ->Args({10'000, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(one_field)->Arg(1'000)->Arg(10'000)->Unit(benchmark::kMillisecond);
BENCHMARK(one_field_by_opensubdiv)->Arg(1'000)->Arg(10'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stratareeb
