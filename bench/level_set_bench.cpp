// SPDX-License-Identifier: GPL-3.0-or-later
// A hundred levels of meshes of several sizes as joined polylines, and nested, beside a floor measured in the same run: the
// least that such a program must do, over flat arrays made for it. The counter `ratio` is the time over the floor's.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "bench/reeb_meshes.h"
#include "reeb/contour_nesting.h"
#include "reeb/level_set.h"

namespace stratareeb {
namespace {

constexpr std::size_t kLevels = 100;

//! Half-edges 2e and 2e + 1 of edge e, in arrays.
struct FlatMesh {
    std::vector<std::uint32_t> to, next;  // by half-edge
    std::vector<double> value;            // by vertex
    std::vector<Point3> place;
};

FlatMesh flat_mesh(const TriMesh& mesh, const ScalarField& field) {
    FlatMesh flat{.to = {}, .next = {}, .value = field, .place = {}};
    for (int h = 0; h < static_cast<int>(mesh.n_halfedges()); ++h) {
        const TriMesh::HalfedgeHandle handle(h);
        flat.to.push_back(static_cast<std::uint32_t>(mesh.to_vertex_handle(handle).idx()));
        flat.next.push_back(static_cast<std::uint32_t>(mesh.next_halfedge_handle(handle).idx()));
    }
    flat.place = triangle_soup(mesh).points;
    return flat;
}

//! Points of all contours in one array, and where each contour ends. Evenly spaced levels and a closed mesh only.
struct FlatContours {
    std::vector<Point3> points;
    std::vector<std::size_t> ends;
};

//! Buckets by level, walks across edges, nothing else.
FlatContours floor_of(const FlatMesh& mesh, double first_level, double step) {
    const std::size_t edges = mesh.to.size() / 2;
    std::vector<std::uint8_t> reached(mesh.value.size());
    for (std::size_t v = 0; v < reached.size(); ++v)
        reached[v] = static_cast<std::uint8_t>(
            std::clamp(std::floor((mesh.value[v] - first_level) / step) + 1, 0.0, double(kLevels)));
    std::vector<std::vector<std::uint32_t>> bucket(kLevels);
    for (std::uint32_t e = 0; e < edges; ++e) {
        const auto [low, high] = std::minmax(reached[mesh.to[2 * e]], reached[mesh.to[2 * e + 1]]);
        for (std::size_t k = low; k < high; ++k) bucket[k].push_back(e);
    }
    std::vector<std::uint8_t> seen(edges, 0);
    FlatContours contours;
    for (std::size_t k = 0; k < kLevels; ++k) {
        const double level = first_level + step * double(k);
        for (const auto e : bucket[k]) {
            if (seen[e]) continue;
            const std::uint32_t start = reached[mesh.to[2 * e + 1]] > k ? 2 * e : 2 * e + 1;
            std::uint32_t h = start, above = mesh.to[h ^ 1], below = mesh.to[h];
            do {
                seen[h / 2] = 1;
                const double share = (mesh.value[above] - level) / (mesh.value[above] - mesh.value[below]);
                const Point3 &a = mesh.place[above], &b = mesh.place[below];
                contours.points.push_back(
                    {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)});
                h = mesh.next[h];
                const auto apex = mesh.to[h];
                if (reached[apex] > k)
                    above = apex;
                else
                    below = apex, h = mesh.next[h];
                h ^= 1;
            } while (h != start);
            contours.ends.push_back(contours.points.size());
        }
        for (const auto e : bucket[k]) seen[e] = 0;
    }
    return contours;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Subject {
    TriMesh mesh;
    ScalarField field;
    std::vector<double> levels;
};

Subject subject_of(const TriangleSoup& soup) {
    Subject subject{.mesh = half_edge_mesh(soup), .field = {}, .levels = {}};
    subject.field = height_field(subject.mesh);
    subject.levels = even_levels(subject.field, kLevels);
    return subject;
}

//! Time for range(0) threads; with a floor (closed meshes) both are run in turn and the fastest runs compared.
template <class Work>
void measure(benchmark::State& state, const Subject& subject, bool with_floor, Work work) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(state.range(0)));
    const FlatMesh flat = with_floor ? flat_mesh(subject.mesh, subject.field) : FlatMesh{};
    double best = std::numeric_limits<double>::infinity(), floor = best;
    std::vector<LevelSet> sets;
    for (auto _ : state) {
        sets.clear();
        if (with_floor) {
            const auto start = std::chrono::steady_clock::now();
            benchmark::DoNotOptimize(
                floor_of(flat, subject.levels[0], subject.levels[1] - subject.levels[0]));
            floor = std::min(floor, seconds_since(start));
        }
        const auto start = std::chrono::steady_clock::now();
        sets = work(subject);
        const double time = seconds_since(start);
        best = std::min(best, time);
        state.SetIterationTime(time);
    }
    double points = 0, contours = 0;
    for (const auto& set : sets)
        for (const auto& contour : set.contours) points += double(contour.points.size()), ++contours;
    state.counters["triangles"] = double(subject.mesh.n_faces());
    state.counters["points"] = points;
    state.counters["contours"] = contours;
    state.counters["best_ms"] = 1e3 * best;
    if (with_floor) {
        state.counters["floor_ms"] = 1e3 * floor;
        state.counters["ratio"] = best / floor;
    }
}

std::vector<LevelSet> joined(const Subject& subject) {
    return level_sets(subject.mesh, subject.field, subject.levels);
}

std::vector<LevelSet> joined_and_nested(const Subject& subject) {
    auto sets = joined(subject);
    for (const auto& set : sets) benchmark::DoNotOptimize(nest_contours(set));
    return sets;
}

Subject noisy_scan(const benchmark::State& state) {
    return subject_of(bench::scan_like_blob(static_cast<bench::Index>(state.range(1)), bench::kScanNoise));
}

void contours_of_a_noisy_scan(benchmark::State& state) {
    measure(state, noisy_scan(state), true, joined);
}

void nested_contours_of_a_noisy_scan(benchmark::State& state) {
    measure(state, noisy_scan(state), true, joined_and_nested);
}

void contours_of_a_plate_with_100_holes(benchmark::State& state) {
    measure(state, subject_of(bench::plate_with_holes_refined(10, static_cast<bench::Index>(state.range(1)))),
            true, joined);
}

Subject terrain(const benchmark::State& state) {
    return subject_of(bench::fractal_terrain(static_cast<bench::Index>(state.range(1))));
}

void contours_of_a_terrain(benchmark::State& state) {
    measure(state, terrain(state), false, joined);
}

void nested_contours_of_a_terrain(benchmark::State& state) {
    measure(state, terrain(state), false, joined_and_nested);
}

// {threads, size}: triangles grow fourfold with each doubling.
#define SIZES(...) ArgsProduct({{1, 2}, {__VA_ARGS__}})->UseManualTime()->Unit(benchmark::kMillisecond)
BENCHMARK(contours_of_a_noisy_scan)->SIZES(58, 116, 232, 464);
BENCHMARK(nested_contours_of_a_noisy_scan)->SIZES(58, 116, 232, 464);
BENCHMARK(contours_of_a_plate_with_100_holes)->SIZES(4, 8, 16, 32);
BENCHMARK(contours_of_a_terrain)->SIZES(177, 354, 708, 1415);
BENCHMARK(nested_contours_of_a_terrain)->SIZES(177, 354, 708, 1415);

}  // namespace
}  // namespace stratareeb
