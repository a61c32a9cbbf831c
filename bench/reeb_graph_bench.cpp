// SPDX-License-Identifier: GPL-3.0-or-later
// The Reeb graph beside an index sort of the mesh's vertices, in the same run: smooth, noisy, high-genus and rough meshes of
// several sizes, on one thread and on two. `ratio` is graph over sort, both at their fastest; `us_per_vertex` shows growth.
#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <numeric>

#include "bench/reeb_meshes.h"
#include "reeb/arc_index.h"
#include "reeb/reeb_graph.h"

namespace stratareeb {
namespace {

enum Kind { Smooth, Noisy, Plate, Terrain };

struct Sample {
    TriMesh mesh;
    ScalarField field;
};

TriangleSoup soup_of(Kind kind, std::uint32_t n) {
    switch (kind) {
        case Smooth:
            return bench::scan_like_blob(n);
        case Noisy:
            return bench::scan_like_blob(n, 0.3);
        case Plate:
            return bench::plate_with_holes_refined(10, n);
        default:
            return bench::fractal_terrain(n);
    }
}

//! One mesh at a time, kept between runs with other numbers of threads.
const Sample& sample(Kind kind, std::uint32_t n) {
    static std::pair<Kind, std::uint32_t> made{Smooth, 0};
    static Sample kept;
    if (made != std::pair(kind, n)) {
        kept = {};
        kept.mesh = half_edge_mesh(soup_of(kind, n));
        kept.field = height_field(kept.mesh);
        made = {kind, n};
    }
    return kept;
}

double seconds_of(const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double index_sort_seconds(const ScalarField& field) {
    return seconds_of([&] {
        std::vector<std::uint32_t> order(field.size());
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return is_below(field, a, b); });
        benchmark::DoNotOptimize(order.data());
    });
}

template <Kind kind>
void graph_beside_sort(benchmark::State& state) {
    const Sample& s = sample(kind, static_cast<std::uint32_t>(state.range(0)));
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(state.range(1)));
    double sort = std::numeric_limits<double>::max(), best = sort;
    ReebGraph graph;
    for (auto _ : state) {
        sort = std::min(sort, index_sort_seconds(s.field));
        graph = {};
        const double seconds = seconds_of([&] { graph = reeb_graph(s.mesh, s.field); });
        best = std::min(best, seconds);
        state.SetIterationTime(seconds);
    }
    state.counters["triangles"] = static_cast<double>(s.mesh.n_faces());
    state.counters["nodes"] = static_cast<double>(graph.nodes.size());
    state.counters["loops"] = static_cast<double>(graph.loops());
    state.counters["sort_ms"] = 1e3 * sort;
    state.counters["ratio"] = best / sort;
    state.counters["us_per_vertex"] = 1e6 * best / static_cast<double>(s.field.size());
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    state.counters["peak_MB"] =
        static_cast<double>(usage.ru_maxrss) / 1024;  // of the process so far, mesh and its making included
}

//! One level more, through the arcs: time beside what is returned.
template <Kind kind>
void one_level_by_arcs(benchmark::State& state) {
    const Sample& s = sample(kind, static_cast<std::uint32_t>(state.range(0)));
    const ReebGraph graph = reeb_graph(s.mesh, s.field);
    const ArcIndex index(s.mesh, s.field, graph);
    const std::vector<double> levels = even_levels(s.field, 100);
    std::size_t at = 0, points = 0, contours = 0;
    for (auto _ : state) {
        const LevelSet set = index.level_set(levels[at++ % levels.size()]);
        contours += set.contours.size();
        for (const Contour& contour : set.contours) points += contour.points.size();
    }
    const auto rounds = static_cast<double>(state.iterations());
    state.counters["triangles"] = static_cast<double>(s.mesh.n_faces());
    state.counters["points"] = static_cast<double>(points) / rounds;
    state.counters["contours"] = static_cast<double>(contours) / rounds;
    state.counters["per_point"] = benchmark::Counter(
        static_cast<double>(points), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void sizes(benchmark::internal::Benchmark* bench, std::initializer_list<int> arguments) {
    bench->ArgNames({"n", "threads"})->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(1);
    for (const int n : arguments)
        for (const int threads : {1, 2}) bench->Args({n, threads});
}

// About 0.27, 1.07 and 4.3 million triangles; the plate's 0.6 million are n = 16, the terrain's 4.0 million n = 1415.
BENCHMARK(graph_beside_sort<Smooth>)->Apply([](auto* b) { sizes(b, {116, 232, 464}); });
BENCHMARK(graph_beside_sort<Noisy>)->Apply([](auto* b) { sizes(b, {116, 232, 464}); });
BENCHMARK(graph_beside_sort<Plate>)->Apply([](auto* b) { sizes(b, {8, 16, 32}); });
BENCHMARK(graph_beside_sort<Terrain>)->Apply([](auto* b) { sizes(b, {354, 708, 1415, 2237}); });
BENCHMARK(one_level_by_arcs<Smooth>)->Arg(116)->Arg(232)->Arg(464)->Unit(benchmark::kMicrosecond);
BENCHMARK(one_level_by_arcs<Noisy>)->Arg(116)->Arg(232)->Arg(464)->Unit(benchmark::kMicrosecond);
BENCHMARK(one_level_by_arcs<Terrain>)->Arg(354)->Arg(708)->Arg(1415)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace stratareeb
