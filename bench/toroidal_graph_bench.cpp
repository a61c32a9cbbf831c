// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulating between two noisy contours. Both are circles of radius 10, one unit apart in height, with five harmonics of
// random phase and about 2 % amplitude, and normal noise on each point's radius: 0.05 % of it ("smooth") or 1 % ("rough": at
// 4,000 points ten times the distance of neighbours). Arguments: points of the upper and of the lower contour.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

#include "reeb/shortest_cycle.h"
#include "reeb/toroidal_graph.h"

namespace stratareeb {
namespace {

constexpr double kRadius = 10, kHeight = 1, kHarmonic = 0.02, kSmooth = 0.0005, kRough = 0.01;

std::vector<Point3> noisy_contour(std::int64_t count, double z, double noise, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::array<double, 5> amplitude{}, phase{};
    for (std::size_t h = 0; h < amplitude.size(); ++h)
        amplitude[h] = kHarmonic * normal(random), phase[h] = 6 * normal(random);
    std::vector<Point3> points;
    for (std::int64_t i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
        double radius = 1 + noise * normal(random);
        for (std::size_t h = 0; h < amplitude.size(); ++h)
            radius += amplitude[h] * std::cos(static_cast<double>(h + 2) * angle + phase[h]);
        points.push_back({kRadius * radius * std::cos(angle), kRadius * radius * std::sin(angle), z});
    }
    return points;
}

struct Pair {
    std::vector<Point3> upper, lower;
    Pair(const benchmark::State& state, double noise)
        : upper(noisy_contour(state.range(0), kHeight, noise, 1)),
          lower(noisy_contour(state.range(1), 0, noise, 2)) {}
};

double triangle_area(const Point3& a, const Point3& b, const Point3& c) {
    const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y,
                 vz = c.z - a.z;
    const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    return std::sqrt(x * x + y * y + z * z) / 2;
}

//! What a textbook does: one table, one first span, back pointers.
double one_start_table(const std::vector<Point3>& upper, const std::vector<Point3>& lower,
                       std::vector<char>& back) {
    const std::size_t m = upper.size(), n = lower.size();
    std::vector<double> row(n + 1, 0);
    back.assign((m + 1) * (n + 1), 0);
    for (std::size_t j = 1; j <= n; ++j)
        row[j] = row[j - 1] + triangle_area(upper[0], lower[j - 1], lower[j % n]);
    for (std::size_t i = 1; i <= m; ++i)
        for (std::size_t j = 0; j <= n; ++j) {
            const double up = row[j] + triangle_area(upper[i - 1], upper[i % m], lower[j % n]);
            row[j] = up;
            back[i * (n + 1) + j] = 1;
            if (j == 0) continue;
            const double low = row[j - 1] + triangle_area(upper[i % m], lower[j - 1], lower[j % n]);
            if (low <= up) row[j] = low, back[i * (n + 1) + j] = 0;
        }
    return row[n];
}

void report(benchmark::State& state, double area) {
    state.counters["area"] = area;
}

void band(benchmark::State& state, BandMethod method, double noise) {
    const Pair pair(state, noise);
    double area = 0;
    for (auto _ : state) area = toroidal_band(pair.upper, pair.lower, {.method = method}).path.cost;
    report(state, area);
}

void exact_smooth(benchmark::State& state) {
    band(state, BandMethod::Exact, kSmooth);
}
void exact_rough(benchmark::State& state) {
    band(state, BandMethod::Exact, kRough);
}
void greedy_smooth(benchmark::State& state) {
    band(state, BandMethod::Greedy, kSmooth);
}

//! Divide and conquer over all spans, as at worst; the share of all spans that was looked at, with and without corridor.
void exact_without_corridor(benchmark::State& state) {
    const Pair pair(state, kSmooth);
    const SpanContours contours{.upper = pair.upper, .lower = pair.lower};
    const double spans = static_cast<double>(state.range(0)) * static_cast<double>(state.range(1));
    double area = 0;
    ShortestCycleWork all, narrow;
    for (auto _ : state) area = shortest_cycle(contours, {.corridor = false, .work = &all}).cost;
    shortest_cycle(contours, {.work = &narrow});
    report(state, area);
    state.counters["sweeps"] = static_cast<double>(all.spans) / spans;
    state.counters["sweeps_in_corridor"] = static_cast<double>(narrow.spans) / spans;
}

void plain_table_of_one_start(benchmark::State& state) {
    const Pair pair(state, kSmooth);
    std::vector<char> back;
    double area = 0;
    for (auto _ : state) area = one_start_table(pair.upper, pair.lower, back);
    report(state, area);
}

//! 200 contours of 1,000 points each, one above the other.
void stack_of_contours(benchmark::State& state) {
    std::vector<std::vector<Point3>> contours;
    for (std::int64_t i = 0; i < state.range(0); ++i)
        contours.push_back(
            noisy_contour(state.range(1), static_cast<double>(i), kSmooth, static_cast<unsigned>(i + 1)));
    double area = 0;
    for (auto _ : state) {
        area = 0;
        for (std::size_t i = 1; i < contours.size(); ++i)
            area += toroidal_band(contours[i], contours[i - 1]).path.cost;
    }
    report(state, area);
}

void sizes(benchmark::internal::Benchmark* benchmark) {
    benchmark->Args({100, 130})->Args({1000, 900})->Args({4000, 4000})->Unit(benchmark::kMillisecond);
}

BENCHMARK(exact_smooth)->Apply(sizes);
BENCHMARK(exact_rough)->Apply(sizes);
BENCHMARK(exact_without_corridor)->Apply(sizes);
BENCHMARK(plain_table_of_one_start)->Apply(sizes);
BENCHMARK(greedy_smooth)->Apply(sizes);
BENCHMARK(stack_of_contours)->Args({200, 1000})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stratareeb
