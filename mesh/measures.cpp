// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/analysis.h"
#include "mesh/compensated_sum.h"

namespace stratareeb {
namespace {

using Vector = OpenMesh::Vec3d;

Vector vector(const Point3& from, const Point3& to) {
    return {to.x - from.x, to.y - from.y, to.z - from.z};
}

struct Sides {
    std::array<Vector, 3> side;  // side k runs from corner k to the next
    std::array<double, 3> length;
};

Sides sides_of(const TriangleSoup& soup, std::uint32_t t) {
    Sides s;
    for (int k = 0; k < 3; ++k) {
        const auto& triangle = soup.triangles[t];
        s.side[k] = vector(soup.points[triangle[k]], soup.points[triangle[(k + 1) % 3]]);
        s.length[k] = s.side[k].norm();
    }
    return s;
}

}  // namespace

BoundingBox bounding_box(std::span<const Point3> points) {
    if (points.empty()) return {};
    BoundingBox box{points[0], points[0]};
    for (const auto& p : points) {
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
    }
    return box;
}

double six_volumes(const TriangleSoup& soup, std::uint32_t triangle, const Point3& from) {
    const auto& [a, b, c] = soup.triangles[triangle];
    return vector(from, soup.points[a]) | (vector(from, soup.points[b]) % vector(from, soup.points[c]));
}

double triangle_area(const TriangleSoup& soup, std::uint32_t triangle) {
    const auto& [a, b, c] = soup.triangles[triangle];
    return (vector(soup.points[a], soup.points[b]) % vector(soup.points[a], soup.points[c])).norm() / 2;
}

TriangleQuality triangle_quality(const TriangleSoup& soup) {
    TriangleQuality quality;
    quality.worst_aspect_ratio = -1;
    for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
        const auto s = sides_of(soup, t);
        const double twice_area = (s.side[0] % s.side[1]).norm();
        const double longest = *std::max_element(s.length.begin(), s.length.end());
        const double ratio =
            twice_area > 0 ? longest / (twice_area / longest) : std::numeric_limits<double>::infinity();
        if (ratio > quality.worst_aspect_ratio) {
            quality.worst_aspect_ratio = ratio;
            quality.worst_triangle = t;
        }
        for (int k = 0; k < 3; ++k) {
            quality.min_edge = std::min(quality.min_edge, s.length[k]);
            quality.max_edge = std::max(quality.max_edge, s.length[k]);
            const double angle =
                std::atan2(twice_area, -(s.side[k] | s.side[(k + 2) % 3])) * 180 / std::numbers::pi;
            quality.min_angle = std::min(quality.min_angle, angle);
            quality.max_angle = std::max(quality.max_angle, angle);
        }
    }
    return quality;
}

double volume(const TriangleSoup& soup) {
    const auto centre = bounding_box(soup.points).centre();
    CompensatedSum sum;
    for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) sum.add(six_volumes(soup, t, centre));
    return sum.value() / 6;
}

double area(const TriangleSoup& soup) {
    CompensatedSum sum;
    for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) sum.add(triangle_area(soup, t));
    return sum.value();
}

double volume(const TriMesh& mesh) {
    return volume(triangle_soup(mesh));
}
double area(const TriMesh& mesh) {
    return area(triangle_soup(mesh));
}

}  // namespace stratareeb
