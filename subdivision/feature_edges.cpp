// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/feature_edges.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

namespace stratareeb {
namespace {

Point3 difference(const Point3& a, const Point3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

double dot(const Point3& a, const Point3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

// Angle between two vectors in degrees, none if one has no length.
double angle_between(const Point3& a, const Point3& b) {
    const double lengths = std::sqrt(dot(a, a) * dot(b, b));
    if (!(lengths > 0)) return 0;
    return std::acos(std::clamp(dot(a, b) / lengths, -1.0, 1.0)) * 180 / std::numbers::pi;
}

// Twice the area vector of a polygon, around its first corner: exact for planar ones, the mean for others.
Point3 area_vector(const std::vector<Point3>& points, std::span<const std::uint32_t> corners) {
    Point3 sum;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const Point3 u = difference(points[corners[i - 1]], points[corners[0]]);
        const Point3 v = difference(points[corners[i]], points[corners[0]]);
        sum.x += u.y * v.z - u.z * v.y;
        sum.y += u.z * v.x - u.x * v.z;
        sum.z += u.x * v.y - u.y * v.x;
    }
    return sum;
}

}  // namespace

FeatureEdges::FeatureEdges(const PolygonMesh& mesh) : mesh_(mesh) {
    sides_.reserve(mesh.corners.size());
    for_each_face(mesh, [&](std::size_t face, std::span<const std::uint32_t> corners) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto from = corners[i], to = corners[i + 1 < corners.size() ? i + 1 : 0];
            sides_.push_back(
                {std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(face), from < to});
        }
    });
    tbb::parallel_sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
        return std::tie(a.low, a.high, a.face, a.is_forward) < std::tie(b.low, b.high, b.face, b.is_forward);
    });
}

template <class Visit>
void FeatureEdges::for_each_edge(Visit visit) const {
    const std::span<const Side> sides = sides_;
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
        while (end < sides.size() && sides[end].low == sides[begin].low &&
               sides[end].high == sides[begin].high)
            ++end;
        visit(sides.subspan(begin, end - begin));
    }
}

std::vector<Point3> FeatureEdges::face_normals() const {
    std::vector<Point3> normals(mesh_.face_count());
    for_each_face(mesh_, [&](std::size_t face, std::span<const std::uint32_t> corners) {
        normals[face] = area_vector(mesh_.points, corners);
    });
    return normals;
}

std::vector<Crease> FeatureEdges::creases(double angle_deg) const {
    const auto normals = face_normals();
    std::vector<Crease> creases;
    for_each_edge([&](std::span<const Side> sides) {
        if (sides.size() == 2 && angle_between(normals[sides[0].face], normals[sides[1].face]) > angle_deg)
            creases.push_back({sides[0].low, sides[0].high});
    });
    return creases;
}

std::vector<SharpCorner> FeatureEdges::outline_corners(double angle_deg) const {
    // The outline edges at each vertex, as their ends in turn.
    std::vector<std::array<std::uint32_t, 2>> ends;
    for_each_edge([&](std::span<const Side> sides) {
        if (sides.size() != 1) return;
        ends.push_back({sides[0].low, sides[0].high});
        ends.push_back({sides[0].high, sides[0].low});
    });
    std::sort(ends.begin(), ends.end());
    std::vector<SharpCorner> corners;
    for (std::size_t begin = 0, end = 0; begin < ends.size(); begin = end) {
        while (end < ends.size() && ends[end][0] == ends[begin][0]) ++end;
        const auto at = [&](std::uint32_t v) { return mesh_.points[v]; };
        const auto vertex = ends[begin][0];
        const bool turns =
            end - begin != 2 || angle_between(difference(at(vertex), at(ends[begin][1])),
                                              difference(at(ends[begin + 1][1]), at(vertex))) > angle_deg;
        if (turns) corners.push_back({vertex});
    }
    return corners;
}

std::vector<SharpCorner> FeatureEdges::outline_vertices() const {
    std::vector<std::uint32_t> vertices;
    for_each_edge([&](std::span<const Side> sides) {
        if (sides.size() == 1) vertices.insert(vertices.end(), {sides[0].low, sides[0].high});
    });
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::vector<SharpCorner> corners;
    for (const auto v : vertices) corners.push_back({v});
    return corners;
}

}  // namespace stratareeb
