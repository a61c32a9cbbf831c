// SPDX-License-Identifier: GPL-3.0-or-later
// From meshes to their enhanced Reeb graphs and back, as rows of the table in docs/graph_format.md:
//   round_trip_table LEVELS[,LEVELS…] MESH…
// `volume` is relative; `distance` is the largest one of corners and middles of triangles, both ways, as a share of the box's diagonal. The
// graph is `same` if the surface's has an arc between the same two heights for each arc of the mesh's, plateaus being one node each.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <ranges>
#include <string>
#include <vector>

#include "io/read_mesh.h"
#include "mesh/analysis.h"
#include "mesh/surface_distance.h"
#include "reeb/collapse_plateaus.h"
#include "reeb/graph_of_mesh.h"
#include "reeb/surface_of_graph.h"
#include "tests/arc_heights.h"

namespace stratareeb {
namespace {

double diagonal(const TriangleSoup& soup) {
    const auto [x0, x1] = std::ranges::minmax(soup.points, {}, &Point3::x);
    const auto [y0, y1] = std::ranges::minmax(soup.points, {}, &Point3::y);
    const auto [z0, z1] = std::ranges::minmax(soup.points, {}, &Point3::z);
    return std::hypot(x1.x - x0.x, y1.y - y0.y, z1.z - z0.z);
}

double farthest(const TriangleSoup& from, const TriangleSoup& to) {
    std::vector<Point3> places = from.points;
    for (const auto& [a, b, c] : from.triangles) {
        const Point3 &p = from.points[a], &q = from.points[b], &r = from.points[c];
        places.push_back({(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3, (p.z + q.z + r.z) / 3});
    }
    return std::ranges::max(SurfaceDistance(to).of(places));
}

std::vector<std::pair<double, double>> arcs_over_height(const TriangleSoup& soup) {
    const TriMesh mesh = half_edge_mesh(soup);
    return testing::arcs_of(collapse_plateaus(reeb_graph(mesh, height_field(mesh))));
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void print_row(const std::filesystem::path& file, std::size_t levels) {
    const TriangleSoup soup = read_mesh(file);
    const TriMesh mesh = half_edge_mesh(soup);
    auto start = std::chrono::steady_clock::now();
    const EnhancedReebGraph graph = graph_of_mesh(mesh, {.levels = levels});
    const double to_graph = seconds_since(start);
    start = std::chrono::steady_clock::now();
    const ConstructedSurface surface = surface_of_graph(graph);
    const double to_surface = seconds_since(start);
    const MeshReport before = analyze(soup, {.self_intersections = false}),
                     after = analyze(surface.soup, {.self_intersections = false});
    const bool is_sound = after.closed && after.manifold && after.oriented;
    fmt::print("| {} | {} | {} | {} | {} | {:.2g} % | {:.2g} % | {} | {}{} | {:.1f} | {:.1f} |\n",
               file.stem().string(), soup.triangles.size(), after.genus.value_or(0), levels,
               graph.contours.size(), 100 * std::abs(std::abs(after.volume / before.volume) - 1),
               100 * std::max(farthest(soup, surface.soup), farthest(surface.soup, soup)) / diagonal(soup),
               surface.crossings.size(),
               arcs_over_height(soup) == arcs_over_height(surface.soup) ? "same" : "OTHER",
               is_sound && after.genus == before.genus ? "" : ", NOT SOUND", to_graph, to_surface);
    std::fflush(stdout);
}

}  // namespace
}  // namespace stratareeb

int main(int count, char** arguments) {
    if (count < 3) {
        fmt::print(stderr, "usage: round_trip_table LEVELS[,LEVELS...] MESH...\n");
        return 2;
    }
    int failed = 0;
    for (int i = 2; i < count; ++i)
        for (const auto level : std::views::split(std::string_view(arguments[1]), ',')) {
            const std::string text(level.begin(), level.end());
            try {
                stratareeb::print_row(arguments[i], std::stoul(text));
            } catch (const std::exception& error) {
                fmt::print("| {} | {} | {} |\n", arguments[i], text, error.what());
                ++failed;
            }
        }
    return failed > 0;
}
