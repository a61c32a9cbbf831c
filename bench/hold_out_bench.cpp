// SPDX-License-Identifier: GPL-3.0-or-later
// How hold-out validation grows with the number of holes (5 layers that pinch out): ten folds predicted, then everything that is
// made of their errors.
#include <benchmark/benchmark.h>

#include <cmath>

#include "boreholes/hold_out.h"
#include "boreholes/prediction_intervals.h"
#include "boreholes/random_survey.h"
#include "boreholes/validation.h"

namespace stratareeb {
namespace {

Survey survey_of(std::int64_t holes) {
    RandomSurveyOptions options;
    options.holes = static_cast<std::size_t>(holes);
    options.layers = 5;
    options.extent = 100 * std::sqrt(static_cast<double>(holes));
    options.pinch_outs = true;
    return random_survey(options);
}

void hold_out_ten_folds(benchmark::State& state, InterpolatorKind kind) {
    const Survey survey = survey_of(state.range(0));
    const auto draws = fold_draws(survey.holes.size(), 10, 1);
    HoldOutOptions options;
    options.prediction.interpolator = kind;
    for (auto _ : state) benchmark::DoNotOptimize(hold_out(survey, draws, options));
    state.SetComplexityN(state.range(0));
}

void validate_ten_folds(benchmark::State& state) {
    const Survey survey = survey_of(state.range(0));
    const auto draws = fold_draws(survey.holes.size(), 10, 1);
    for (auto _ : state) benchmark::DoNotOptimize(validate(survey, draws));
    state.SetComplexityN(state.range(0));
}

void leave_one_out(benchmark::State& state) {
    const Survey survey = survey_of(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(hold_out(survey, single_draws(survey.holes.size())));
    state.SetComplexityN(state.range(0));
}

#define SIZES(least, most)              \
    RangeMultiplier(10)                 \
        ->Range(least, most)            \
        ->Unit(benchmark::kMillisecond) \
        ->Complexity()                  \
        ->UseRealTime()                 \
        ->MeasureProcessCPUTime()
BENCHMARK_CAPTURE(hold_out_ten_folds, linear, InterpolatorKind::Linear)->SIZES(100, 100'000);
BENCHMARK_CAPTURE(hold_out_ten_folds, natural, InterpolatorKind::NaturalNeighbour)->SIZES(100, 100'000);
BENCHMARK_CAPTURE(hold_out_ten_folds, sibson_c0, InterpolatorKind::SibsonC0)->SIZES(100, 100'000);
BENCHMARK_CAPTURE(hold_out_ten_folds, inverse_distance, InterpolatorKind::InverseDistance)
    ->SIZES(100, 100'000);
BENCHMARK_CAPTURE(hold_out_ten_folds, spline, InterpolatorKind::Spline)->SIZES(100, 100'000);
BENCHMARK_CAPTURE(hold_out_ten_folds, kriging, InterpolatorKind::Kriging)->SIZES(100, 100'000);
BENCHMARK_CAPTURE(hold_out_ten_folds, kriging_linear, InterpolatorKind::KrigingLinear)->SIZES(100, 100'000);
BENCHMARK_CAPTURE(hold_out_ten_folds, kriging_quadratic, InterpolatorKind::KrigingQuadratic)
    ->SIZES(100, 100'000);
BENCHMARK_CAPTURE(hold_out_ten_folds, minimum_curvature, InterpolatorKind::MinimumCurvature)
    ->SIZES(100, 100'000);
BENCHMARK(validate_ten_folds)->SIZES(100, 100'000);
BENCHMARK(leave_one_out)->SIZES(100, 1'000);

}  // namespace
}  // namespace stratareeb
