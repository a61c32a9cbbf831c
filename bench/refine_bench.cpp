// SPDX-License-Identifier: GPL-3.0-or-later
// What refine costs beside OpenSubdiv called with nothing around it, and how both grow with levels and size. Argument: triangles of
// the result, in thousands; the control mesh is a torus two levels coarser, unless said otherwise.
#include <benchmark/benchmark.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <array>
#include <cmath>
#include <memory>

#include "subdivision/field_subdivision.h"
#include "subdivision/refine.h"
#include "tests/shapes.h"

namespace {

namespace Far = OpenSubdiv::Far;
using namespace stratareeb;

constexpr int kLevels = 2;

PolygonMesh control(const benchmark::State& state, int levels) {
    const double triangles = static_cast<double>(state.range(0)) * 1000 / std::pow(4.0, levels);
    const auto tube = static_cast<std::uint32_t>(std::sqrt(triangles / 4));
    return polygon_mesh(shapes::torus(3, 1, 2 * tube, tube));
}

struct Value {
    double x = 0, y = 0, z = 0;
    void Clear() { x = y = z = 0; }
    void AddWithWeight(const Value& other, double weight) {
        x += weight * other.x;
        y += weight * other.y;
        z += weight * other.z;
    }
};

std::unique_ptr<Far::TopologyRefiner> bare_topology(const PolygonMesh& mesh, int levels, bool limit) {
    const std::vector<int> sizes(mesh.face_count(), 3);
    Far::TopologyDescriptor description;
    description.numVertices = static_cast<int>(mesh.points.size());
    description.numFaces = static_cast<int>(sizes.size());
    description.numVertsPerFace = sizes.data();
    description.vertIndicesPerFace = reinterpret_cast<const int*>(mesh.corners.data());
    OpenSubdiv::Sdc::Options options;
    options.SetVtxBoundaryInterpolation(OpenSubdiv::Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    std::unique_ptr<Far::TopologyRefiner> refiner(
        Factory::Create(description, Factory::Options(OpenSubdiv::Sdc::SCHEME_LOOP, options)));
    Far::TopologyRefiner::UniformOptions uniform(levels);
    uniform.fullTopologyInLastLevel = limit;
    refiner->RefineUniform(uniform);
    return refiner;
}

std::vector<Value> interpolated(const Far::TopologyRefiner& topology, const PolygonMesh& mesh) {
    std::vector<Value> values, next;
    for (const auto& p : mesh.points) values.push_back({p.x, p.y, p.z});
    const Far::PrimvarRefinerReal<double> refiner(topology);
    for (int level = 1; level <= topology.GetMaxLevel(); ++level) {
        next.resize(topology.GetLevel(level).GetNumVertices());
        auto* to = next.data();
        refiner.Interpolate(level, values.data(), to);
        std::swap(values, next);
    }
    return values;
}

// What anyone who wants triangles and normals has to do with OpenSubdiv: points, limits, tangents, normals, faces.
void bare_limit(const PolygonMesh& mesh, int levels) {
    const auto topology = bare_topology(mesh, levels, true);
    const auto values = interpolated(*topology, mesh);
    std::vector<Value> points(values.size()), u(values.size()), v(values.size()), normals(values.size());
    auto *to = points.data(), *to_u = u.data(), *to_v = v.data();
    Far::PrimvarRefinerReal<double>(*topology).Limit(values.data(), to, to_u, to_v);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Value n{u[i].y * v[i].z - u[i].z * v[i].y, u[i].z * v[i].x - u[i].x * v[i].z,
                      u[i].x * v[i].y - u[i].y * v[i].x};
        const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
        normals[i] = {n.x / length, n.y / length, n.z / length};
    }
    const auto& last = topology->GetLevel(levels);
    std::vector<std::array<int, 3>> triangles;
    triangles.reserve(last.GetNumFaces());
    for (int f = 0; f < last.GetNumFaces(); ++f) {
        const auto corners = last.GetFaceVertices(f);
        triangles.push_back({corners[0], corners[1], corners[2]});
    }
    benchmark::DoNotOptimize(triangles.data());
    benchmark::DoNotOptimize(normals.data());
}

void count_triangles(benchmark::State& state, const PolygonMesh& mesh, int levels) {
    const double triangles = static_cast<double>(mesh.face_count()) * std::pow(4.0, levels);
    state.counters["triangles"] = triangles;
    state.SetItemsProcessed(static_cast<std::int64_t>(triangles * static_cast<double>(state.iterations())));
}

void BM_bare_opensubdiv_limit(benchmark::State& state) {
    const auto mesh = control(state, kLevels);
    for (auto _ : state) bare_limit(mesh, kLevels);
    count_triangles(state, mesh, kLevels);
}

void BM_refine_limit(benchmark::State& state) {
    const auto mesh = control(state, kLevels);
    for (auto _ : state) benchmark::DoNotOptimize(refine(mesh, {.levels = kLevels}));
    count_triangles(state, mesh, kLevels);
}

void BM_bare_opensubdiv_points(benchmark::State& state) {
    const auto mesh = control(state, kLevels);
    for (auto _ : state) {
        const auto topology = bare_topology(mesh, kLevels, false);
        benchmark::DoNotOptimize(interpolated(*topology, mesh));
    }
    count_triangles(state, mesh, kLevels);
}

void BM_refine_points(benchmark::State& state) {
    const auto mesh = control(state, kLevels);
    for (auto _ : state) benchmark::DoNotOptimize(refine(mesh, {.levels = kLevels, .limit = false}));
    count_triangles(state, mesh, kLevels);
}

// Growth with the level from one control mesh; the argument is the level.
void BM_refine_levels(benchmark::State& state) {
    const auto mesh = polygon_mesh(shapes::torus(3, 1, 64, 32));
    const int levels = static_cast<int>(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(refine(mesh, {.levels = levels}));
    count_triangles(state, mesh, levels);
}

// One field more over a topology that is there: ours, OpenSubdiv's, and a bare stencil table's.
void BM_field(benchmark::State& state) {
    const auto mesh = control(state, kLevels);
    const FieldSubdivision field(triangle_fans(mesh).triangles, mesh.points.size(), {}, {}, kLevels);
    std::vector<double> heights;
    for (const auto& p : mesh.points) heights.push_back(p.z);
    for (auto _ : state) benchmark::DoNotOptimize(field.refined(heights));
    count_triangles(state, mesh, kLevels);
}

struct Height {
    double value = 0;
    void Clear() { value = 0; }
    void AddWithWeight(const Height& other, double weight) { value += weight * other.value; }
};

// The same by stencils, and what they cost first.
void BM_stencils_field(benchmark::State& state) {
    const auto mesh = control(state, kLevels);
    const FieldSubdivision field(triangle_fans(mesh).triangles, mesh.points.size(), {}, {}, kLevels);
    const SparseRows rows = field.stencils();
    std::vector<double> heights;
    for (const auto& p : mesh.points) heights.push_back(p.z);
    for (auto _ : state) benchmark::DoNotOptimize(row_sums(rows, heights));
    count_triangles(state, mesh, kLevels);
}

void BM_stencils(benchmark::State& state) {
    const auto mesh = control(state, kLevels);
    const FieldSubdivision field(triangle_fans(mesh).triangles, mesh.points.size(), {}, {}, kLevels);
    for (auto _ : state) benchmark::DoNotOptimize(field.stencils());
    count_triangles(state, mesh, kLevels);
}

void BM_bare_opensubdiv_field(benchmark::State& state) {
    const auto mesh = control(state, kLevels);
    const auto topology = bare_topology(mesh, kLevels, false);
    for (auto _ : state) {
        std::vector<Height> values, next;
        for (const auto& p : mesh.points) values.push_back({p.z});
        for (int level = 1; level <= kLevels; ++level) {
            next.resize(topology->GetLevel(level).GetNumVertices());
            auto* to = next.data();
            Far::PrimvarRefinerReal<double>(*topology).Interpolate(level, values.data(), to);
            std::swap(values, next);
        }
        benchmark::DoNotOptimize(values.data());
    }
    count_triangles(state, mesh, kLevels);
}

void BM_bare_stencils_field(benchmark::State& state) {
    const auto mesh = control(state, kLevels);
    const auto topology = bare_topology(mesh, kLevels, false);
    using Factory = Far::StencilTableFactoryReal<double>;
    Factory::Options options;
    options.generateIntermediateLevels = false;
    const std::unique_ptr<const Far::StencilTableReal<double>> table(Factory::Create(*topology, options));
    std::vector<Height> control_values;
    for (const auto& p : mesh.points) control_values.push_back({p.z});
    for (auto _ : state) {
        std::vector<Height> values(table->GetNumStencils());
        table->UpdateValues(control_values.data(), values.data());
        benchmark::DoNotOptimize(values.data());
    }
    count_triangles(state, mesh, kLevels);
}

#define SIZES ->Arg(160)->Arg(640)->Arg(2560)->Arg(10240)->Unit(benchmark::kMillisecond)
BENCHMARK(BM_bare_opensubdiv_limit) SIZES;
BENCHMARK(BM_refine_limit) SIZES;
BENCHMARK(BM_bare_opensubdiv_points) SIZES;
BENCHMARK(BM_refine_points) SIZES;
BENCHMARK(BM_refine_levels)->DenseRange(1, 6)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_bare_opensubdiv_field) SIZES;
BENCHMARK(BM_bare_stencils_field) SIZES;
BENCHMARK(BM_field) SIZES;
BENCHMARK(BM_stencils_field) SIZES;
BENCHMARK(BM_stencils) SIZES;

}  // namespace
