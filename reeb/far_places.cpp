// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/far_places.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "reeb/point_math.h"

namespace stratareeb {

namespace {

constexpr double kFinest = 1.0 / 1000;  // of the box's diagonal: what is smaller is not cut further

//! A triangle, or a part of one.
struct Piece {
    std::array<Point3, 3> corners;
    std::uint32_t triangle;

    Point3 middle() const { return (1.0 / 3) * (corners[0] + corners[1] + corners[2]); }
    double radius() const {
        const Point3 m = middle();
        return std::max({magnitude(corners[0] - m), magnitude(corners[1] - m), magnitude(corners[2] - m)});
    }
};

enum class Verdict : std::uint8_t { Near, Far, Open };

//! Across the longest side: most triangles are long and low.
void halve(const Piece& piece, std::vector<Piece>& halves) {
    auto [a, b, c] = piece.corners;
    while (magnitude(b - a) < std::max(magnitude(c - b), magnitude(a - c))) {
        const Point3 first = a;
        a = b;
        b = c;
        c = first;
    }
    const Point3 middle = 0.5 * (a + b);
    halves.push_back({{a, middle, c}, piece.triangle});
    halves.push_back({{middle, b, c}, piece.triangle});
}

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
      finest_(kFinest * diagonal(mesh_)),
      edges_(graph.arcs.size()) {
    for (std::uint32_t e = 0; e < sweep.edges.size(); ++e)
        for (const SweepSegment& segment : sweep.edges[e].segments) edges_[segment.arc].push_back(e);
}

//! Distances change no faster than places: all of a piece is near enough if its middle is nearer by its radius. Else it is cut in two.
std::vector<FarPlaces::Sample> FarPlaces::far_samples(const TriangleSoup& from, const SurfaceDistance& to,
                                                      double distance, double bound) const {
    std::vector<Piece> pieces;
    for (std::uint32_t t = 0; t < from.triangles.size(); ++t) {
        const auto& [i, j, k] = from.triangles[t];
        pieces.push_back({{from.points[i], from.points[j], from.points[k]}, t});
    }
    std::vector<Sample> samples;
    while (!pieces.empty()) {
        std::vector<Verdict> verdicts(pieces.size());
        tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
            const double sure = std::min(bound - pieces[i].radius(), distance);
            const Point3 middle = pieces[i].middle();
            if (sure > 0 && to.is_within(middle, sure))
                verdicts[i] = Verdict::Near;
            else
                verdicts[i] = to.is_within(middle, distance) ? Verdict::Open : Verdict::Far;
        });
        std::vector<Piece> next;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (verdicts[i] == Verdict::Far)
                samples.push_back({pieces[i].middle(), pieces[i].triangle});
            else if (verdicts[i] == Verdict::Open && pieces[i].radius() > finest_)
                halve(pieces[i], next);
        }
        pieces = std::move(next);
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

std::set<GraphPlace> FarPlaces::beyond(double distance, double bound, const ConstructedSurface& surface,
                                       const std::vector<std::vector<double>>& heights) const {
    std::set<GraphPlace> places;
    for (const auto& [place, t] : far_samples(surface.soup, to_mesh_, distance, bound))
        if (surface.triangle_part[t] != kNoPart)
            places.insert(place_at(surface.triangle_edge[t], place.z, heights));
    for (const Sample& sample : far_samples(mesh_, SurfaceDistance(surface.soup), distance, bound))
        add_places_on_edges(sample, heights, places);
    return places;
}

}  // namespace stratareeb
