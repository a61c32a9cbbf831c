// SPDX-License-Identifier: GPL-3.0-or-later
// Each interpolator over the number of holes: five fields (layers) predicted at ten places a hole, or at a million at most, the
// fit of models included. Counters: holes, places, and microseconds for each place and field.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "boreholes/choose_interpolator.h"
#include "boreholes/fit_variogram.h"
#include "boreholes/interpolator.h"
#include "boreholes/random_survey.h"

namespace stratareeb {
namespace {

constexpr std::size_t kFields = 5;

std::vector<Point2> random_places(std::uint64_t seed, std::size_t count) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> anywhere(0, 1000);
    std::vector<Point2> at(count);
    for (Point2& p : at) p = {anywhere(random), anywhere(random)};
    return at;
}

double rolling(const Point2& p, std::size_t field) {
    const double k = 0.01 + 0.004 * static_cast<double>(field);
    return 20 + 5 * std::sin(k * p.x) * std::cos(1.3 * k * p.y) + 0.5 * std::sin(0.3 * p.x + 0.2 * p.y);
}

void interpolate(benchmark::State& state, InterpolatorKind kind) {
    const auto count = static_cast<std::size_t>(state.range(0));
    const auto places = std::min<std::size_t>(10 * count, 1'000'000);
    const auto holes = std::make_shared<HoleTriangulation>(random_places(1, count));
    const auto where = random_places(2, places);
    std::vector<std::vector<double>> value(kFields);
    std::vector<SiteField> fields;
    for (std::size_t f = 0; f < kFields; ++f) {
        for (const Point2& p : holes->sites()) value[f].push_back(rolling(p, f));
        fields.push_back({value[f], {}});
    }
    for (auto _ : state)
        benchmark::DoNotOptimize(make_interpolator(kind, holes)->predict_layers(where, {fields}));
    state.counters["places"] = static_cast<double>(places);
    state.counters["us_per_place_field"] =
        benchmark::Counter(static_cast<double>(places * kFields) / 1e6,
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void fit(benchmark::State& state) {
    const auto at = random_places(1, static_cast<std::size_t>(state.range(0)));
    std::vector<double> value;
    for (const Point2& p : at) value.push_back(rolling(p, 0));
    std::vector<Point2> local(at);
    for (Point2& p : local) p = {p.x / 1024, p.y / 1024};
    for (auto _ : state) benchmark::DoNotOptimize(fit_variogram(local, value));
}
BENCHMARK(fit)->RangeMultiplier(10)->Range(100, 100'000)->Unit(benchmark::kMillisecond)->UseRealTime();

void choose(benchmark::State& state) {
    const Survey survey =
        random_survey({.holes = static_cast<std::size_t>(state.range(0)), .layers = 5, .extent = 1000});
    for (auto _ : state) benchmark::DoNotOptimize(choose_interpolator(survey));
}
BENCHMARK(choose)
    ->RangeMultiplier(10)
    ->Range(100, 100'000)
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->Iterations(1);

#define INTERPOLATOR_BENCH(name, kind)                           \
    BENCHMARK_CAPTURE(interpolate, name, InterpolatorKind::kind) \
        ->RangeMultiplier(10)                                    \
        ->Range(100, 100'000)                                    \
        ->Unit(benchmark::kSecond)                               \
        ->UseRealTime()                                          \
        ->Iterations(1)
INTERPOLATOR_BENCH(linear, Linear);
INTERPOLATOR_BENCH(natural, NaturalNeighbour);
INTERPOLATOR_BENCH(sibson_c0, SibsonC0);
INTERPOLATOR_BENCH(inverse_distance, InverseDistance);
INTERPOLATOR_BENCH(spline, Spline);
INTERPOLATOR_BENCH(minimum_curvature, MinimumCurvature);
INTERPOLATOR_BENCH(kriging, Kriging);
INTERPOLATOR_BENCH(kriging_linear, KrigingLinear);
INTERPOLATOR_BENCH(kriging_quadratic, KrigingQuadratic);

}  // namespace
}  // namespace stratareeb
