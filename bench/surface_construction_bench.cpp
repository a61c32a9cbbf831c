// SPDX-License-Identifier: GPL-3.0-or-later
// A surface from a stack of noisy contours, with six steps between two given ones: how it grows with contours and points, with and
// without looking for crossings.
#include "reeb/surface_construction.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "bench/reeb_meshes.h"

namespace stratareeb {
namespace {

EnhancedReebGraph stack(std::size_t contours, std::size_t points) {
    EnhancedReebGraph graph;
    graph.nodes.resize(2);
    graph.nodes[0].id = "bottom";
    graph.nodes[1].id = "top";
    graph.nodes[1].position.z = static_cast<double>(contours + 1);
    graph.edges.push_back({.from = 0, .to = 1, .curve = {}, .contours = {}, .homotopy = {}});
    for (std::size_t k = 0; k < contours; ++k) {
        Curve curve;
        curve.closed = true;
        const double z = static_cast<double>(k + 1);
        for (std::size_t i = 0; i < points; ++i) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
            const double radius = 40 + 5 * std::sin(0.05 * z) + 4 * std::cos(3 * angle + 0.1 * z) +
                                  0.1 * bench::random_at(k, i);
            curve.points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
        }
        graph.edges[0].contours.push_back(static_cast<std::uint32_t>(k));
        graph.contours.emplace_back().id = static_cast<std::int64_t>(k);
        graph.contours.back().curve = std::move(curve);
    }
    return graph;
}

void surface_of_stack(benchmark::State& state) {
    const EnhancedReebGraph graph =
        stack(static_cast<std::size_t>(state.range(0)), static_cast<std::size_t>(state.range(1)));
    std::size_t triangles = 0;
    for (auto _ : state)
        triangles = construct_surface(graph, {.avoid_crossings = state.range(2) != 0}).soup.triangles.size();
    state.counters["triangles"] = static_cast<double>(triangles);
    state.counters["per_triangle"] =
        benchmark::Counter(static_cast<double>(triangles) * static_cast<double>(state.iterations()),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

BENCHMARK(surface_of_stack)
    ->ArgNames({"contours", "points", "crossings"})
    ->ArgsProduct({{50, 200}, {250, 1000}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stratareeb
