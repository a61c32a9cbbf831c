// SPDX-License-Identifier: GPL-3.0-or-later
// From a mesh to its enhanced Reeb graph and back: how far the surface is off with more and more levels. `volume_error` is relative;
// `hausdorff` is the largest distance of a vertex of either surface from the other, as a share of the box's diagonal. docs/reconstruct.md has the table.
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "bench/reeb_meshes.h"
#include "mesh/analysis.h"
#include "reeb/graph_of_mesh.h"
#include "reeb/surface_of_graph.h"

namespace stratareeb {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Surface>>>;

Kernel::Point_3 point(const Point3& p) {
    return {p.x, p.y, p.z};
}

double farthest(const TriangleSoup& from, const TriangleSoup& to) {
    Surface surface;
    for (const Point3& p : to.points) surface.add_vertex(point(p));
    for (const auto& [a, b, c] : to.triangles)
        surface.add_face(Surface::Vertex_index(a), Surface::Vertex_index(b), Surface::Vertex_index(c));
    Tree tree(faces(surface).first, faces(surface).second, surface);
    double square = 0;
    for (const Point3& p : from.points) square = std::max(square, tree.squared_distance(point(p)));
    return std::sqrt(square);
}

double diagonal(const TriangleSoup& soup) {
    const auto [x0, x1] = std::ranges::minmax(soup.points, {}, &Point3::x);
    const auto [y0, y1] = std::ranges::minmax(soup.points, {}, &Point3::y);
    const auto [z0, z1] = std::ranges::minmax(soup.points, {}, &Point3::z);
    return std::hypot(x1.x - x0.x, y1.y - y0.y, z1.z - z0.z);
}

//! Turned a little, so that no two critical points have one height.
TriangleSoup tilted(TriangleSoup soup) {
    for (Point3& p : soup.points)
        p = {p.x + 0.0077 * p.z, p.y - 0.0123 * p.z, p.z - 0.0077 * p.x + 0.0123 * p.y};
    return soup;
}

void round_trip(benchmark::State& state, const TriangleSoup& soup) {
    const TriMesh mesh = half_edge_mesh(soup);
    ConstructedSurface surface;
    std::size_t contours = 0;
    for (auto _ : state) {
        const auto graph = graph_of_mesh(mesh, {.levels = static_cast<std::size_t>(state.range(0))});
        surface = surface_of_graph(graph);
        contours = graph.contours.size();
    }
    const double volume = analyze(soup, {.self_intersections = false}).volume,
                 rebuilt = analyze(surface.soup, {.self_intersections = false}).volume;
    state.counters["contours"] = static_cast<double>(contours);
    state.counters["triangles"] = static_cast<double>(surface.soup.triangles.size());
    state.counters["volume_error"] = std::abs(rebuilt / volume - 1);
    state.counters["hausdorff"] =
        std::max(farthest(soup, surface.soup), farthest(surface.soup, soup)) / diagonal(soup);
    state.counters["crossings"] = static_cast<double>(surface.crossings.size());
}

void sphere(benchmark::State& state) {
    round_trip(state, tilted(shapes::uv_sphere(1, 120, 240)));
}
void upright_torus(benchmark::State& state) {
    TriangleSoup torus = shapes::torus(3, 1, 240, 120);
    for (Point3& p : torus.points) p = {p.y, p.z, p.x};
    round_trip(state, tilted(torus));
}
void scan_like(benchmark::State& state) {
    round_trip(state, tilted(bench::scan_like_blob(40)));
}

void levels(benchmark::internal::Benchmark* bench) {
    bench->ArgName("levels")->Unit(benchmark::kMillisecond)->Iterations(1);
    for (const int n : {5, 10, 20, 40, 80}) bench->Arg(n);
}

BENCHMARK(sphere)->Apply(levels);
BENCHMARK(upright_torus)->Apply(levels);
BENCHMARK(scan_like)->Apply(levels);

}  // namespace
}  // namespace stratareeb
