// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/feature_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

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

// Sides are put into a bucket for each lower vertex, which holds a few, and sorted there: several times faster than sorting them all.
FeatureEdges::FeatureEdges(const PolygonMesh& mesh) : mesh_(mesh) {
    const auto for_each_side = [&](auto visit) {
        for_each_face(mesh, [&](std::size_t face, std::span<const std::uint32_t> corners) {
            for (std::size_t i = 0; i < corners.size(); ++i)
                visit(corners[i], corners[i + 1 < corners.size() ? i + 1 : 0],
                      static_cast<std::uint32_t>(face));
        });
    };
    first_.assign(mesh.points.size() + 1, 0);
    for_each_side(
        [&](std::uint32_t from, std::uint32_t to, std::uint32_t) { ++first_[std::min(from, to) + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    sides_.resize(mesh.corners.size());
    auto next = first_;
    for_each_side([&](std::uint32_t from, std::uint32_t to, std::uint32_t face) {
        sides_[next[std::min(from, to)]++] = {std::max(from, to), face};
    });
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
        std::sort(sides_.begin() + first_[v], sides_.begin() + first_[v + 1]);
}

template <class Visit>
void FeatureEdges::for_each_edge(Visit visit) const {
    const std::span<const Side> sides = sides_;
    for (std::uint32_t low = 0; low + 1 < first_.size(); ++low)
        for (std::size_t begin = first_[low], end = begin; begin < first_[low + 1]; begin = end) {
            while (end < first_[low + 1] && sides[end].high == sides[begin].high) ++end;
            visit(low, sides.subspan(begin, end - begin));
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
    for_each_edge([&](std::uint32_t low, std::span<const Side> sides) {
        if (sides.size() == 2 && angle_between(normals[sides[0].face], normals[sides[1].face]) > angle_deg)
            creases.push_back({low, sides[0].high});
    });
    return creases;
}

std::vector<SharpCorner> FeatureEdges::outline_corners(double angle_deg) const {
    // The outline edges at each vertex, as their ends in turn.
    std::vector<std::array<std::uint32_t, 2>> ends;
    for_each_edge([&](std::uint32_t low, std::span<const Side> sides) {
        if (sides.size() != 1) return;
        ends.push_back({low, sides[0].high});
        ends.push_back({sides[0].high, low});
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
    for_each_edge([&](std::uint32_t low, std::span<const Side> sides) {
        if (sides.size() == 1) vertices.insert(vertices.end(), {low, sides[0].high});
    });
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::vector<SharpCorner> corners;
    for (const auto v : vertices) corners.push_back({v});
    return corners;
}

}  // namespace stratareeb
