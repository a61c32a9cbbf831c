// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/far_places.h"

#include <algorithm>
#include <cmath>

#include "reeb/point_math.h"

namespace stratareeb {

namespace {

constexpr double kFinest = 1.0 / 300;   // of the box's diagonal, between points asked on the mesh
constexpr std::size_t kMostParts = 64;  // of a triangle's side

TriangleSoup without_fillings(const TriMesh& mesh, std::size_t first_filled) {
    TriangleSoup soup = triangle_soup(mesh);
    soup.triangles.resize(first_filled);
    return soup;
}

double diagonal(const TriangleSoup& soup) {
    Point3 low = soup.points.front(), high = low;
    for (const Point3& p : soup.points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    return magnitude(high - low);
}

GraphPlace place_at(std::uint32_t edge, double z, const std::vector<std::vector<double>>& heights) {
    const auto& own = heights[edge];
    return {edge, static_cast<std::size_t>(std::ranges::lower_bound(own, z) - own.begin())};
}

}  // namespace

FarPlaces::FarPlaces(const TriMesh& mesh, std::size_t first_filled, const ReebGraph& graph,
                     const SweepGraph& sweep)
    : graph_(graph),
      sweep_(sweep),
      mesh_(without_fillings(mesh, first_filled)),
      to_mesh_(mesh_),
      edges_(graph.arcs.size()) {
    for (std::uint32_t e = 0; e < sweep.edges.size(); ++e)
        for (const SweepSegment& segment : sweep.edges[e].segments) edges_[segment.arc].push_back(e);
}

std::vector<FarPlaces::Sample> FarPlaces::mesh_samples(double distance) const {
    const double spacing = std::max(distance, kFinest * diagonal(mesh_));
    std::vector<Sample> samples;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
        const auto& [i, j, k] = mesh_.triangles[t];
        const Point3 &a = mesh_.points[i], &b = mesh_.points[j], &c = mesh_.points[k];
        const double side = std::max({magnitude(b - a), magnitude(c - b), magnitude(a - c)});
        const auto parts = static_cast<std::size_t>(
            std::clamp(std::ceil(side / spacing), 1.0, static_cast<double>(kMostParts)));
        for (std::size_t u = 0; u <= parts; ++u)
            for (std::size_t v = 0; u + v <= parts; ++v) {
                const double p = static_cast<double>(u) / static_cast<double>(parts),
                             q = static_cast<double>(v) / static_cast<double>(parts);
                samples.push_back({a + p * (b - a) + q * (c - a), t});
            }
    }
    return samples;
}

//! A triangle has parts on the arcs through its corners and on that through its middle.
void FarPlaces::add_places_on_edges(const Sample& sample, const std::vector<std::vector<double>>& heights,
                                    std::set<GraphPlace>& places) const {
    const auto& corners = mesh_.triangles[sample.triangle];
    const double z = sample.place.z;
    for (const std::uint32_t arc : {graph_.triangle_arc[sample.triangle], graph_.vertex_arc[corners[0]],
                                    graph_.vertex_arc[corners[1]], graph_.vertex_arc[corners[2]]})
        for (const std::uint32_t e : edges_[arc]) {
            const SweepEdge& edge = sweep_.edges[e];
            if (!(sweep_.nodes[edge.lower].value <= z && z <= sweep_.nodes[edge.upper].value)) continue;
            places.insert(place_at(e, z, heights));
            return;
        }
}

std::set<GraphPlace> FarPlaces::beyond(double distance, const ConstructedSurface& surface,
                                       const std::vector<std::vector<double>>& heights) const {
    const TriangleSoup& soup = surface.soup;
    std::vector<Point3> asked = soup.points;
    for (const auto& [a, b, c] : soup.triangles)
        asked.push_back((1.0 / 3) * (soup.points[a] + soup.points[b] + soup.points[c]));
    const std::vector<double> from_surface = to_mesh_.of(asked);
    std::set<GraphPlace> places;
    for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
        if (surface.triangle_part[t] == kNoPart) continue;
        const std::size_t middle = soup.points.size() + t;
        const auto is_far = [&](std::size_t i) { return from_surface[i] > distance; };
        if (is_far(middle) || std::ranges::any_of(soup.triangles[t], is_far))
            places.insert(place_at(surface.triangle_edge[t], asked[middle].z, heights));
    }
    const std::vector<Sample> samples = mesh_samples(distance);
    std::vector<Point3> on_mesh;
    for (const Sample& sample : samples) on_mesh.push_back(sample.place);
    const std::vector<double> from_mesh = SurfaceDistance(soup).of(on_mesh);
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (from_mesh[i] > distance) add_places_on_edges(samples[i], heights, places);
    return places;
}

}  // namespace stratareeb
