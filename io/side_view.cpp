// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/side_view.h"

#include <algorithm>
#include <cmath>

namespace stratareeb {

namespace {

using Vec = OpenMesh::Vec3d;

//! A horizontal direction to start from: x where it is square to `up`, or what is nearest to it; y for x itself.
Vec any_right(const Vec& up) {
    const Vec axis = std::abs(up[0]) < 0.9 ? Vec(1, 0, 0) : Vec(0, 1, 0);
    return (axis - dot(axis, up) * up).normalized();
}

//! The angle from `right` towards `toward` along which the vertices scatter most (their principal axis).
double broad_angle(const TriMesh& mesh, const Vec& right, const Vec& toward) {
    Vec middle(0, 0, 0);
    for (const auto v : mesh.vertices()) middle += mesh.point(v) / static_cast<double>(mesh.n_vertices());
    double aa = 0, ab = 0, bb = 0;
    for (const auto v : mesh.vertices()) {
        const Vec p = mesh.point(v) - middle;
        const double a = dot(p, right), b = dot(p, toward);
        aa += a * a;
        ab += a * b;
        bb += b * b;
    }
    if (std::abs(aa - bb) + std::abs(ab) < 1e-6 * (aa + bb)) return 0;  // as broad any way
    return 0.5 * std::atan2(2 * ab, aa - bb);
}

Point3 as_point(const Vec& v) {
    return {v[0], v[1], v[2]};
}

}  // namespace

SideView side_view(const TriMesh& mesh, const std::optional<Point3>& up) {
    const Vec height = (up ? Vec(up->x, up->y, up->z) : Vec(0, 0, 1)).normalized();
    const Vec start = any_right(height), start_toward = cross(start, height);
    const double angle = broad_angle(mesh, start, start_toward);
    const Vec right = std::cos(angle) * start + std::sin(angle) * start_toward;
    SideView view{.right = as_point(right), .toward = as_point(cross(right, height))};
    bool first = true;
    for (const auto v : mesh.vertices()) {
        const double a = view.across(as_point(mesh.point(v))), b = view.depth(as_point(mesh.point(v)));
        view.right_min = first ? a : std::min(view.right_min, a);
        view.right_max = first ? a : std::max(view.right_max, a);
        view.toward_min = first ? b : std::min(view.toward_min, b);
        view.toward_max = first ? b : std::max(view.toward_max, b);
        first = false;
    }
    return view;
}

}  // namespace stratareeb
