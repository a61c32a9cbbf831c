// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/normals.h"

#include <cmath>

namespace stratareeb {
namespace {

using Vector = OpenMesh::Vec3d;

// Sums this short, of vectors of length one, are rounding only: the faces cancel out.
constexpr double kCancelled = 1e-12;

Vector vector(const Point3& from, const Point3& to) {
    return {to.x - from.x, to.y - from.y, to.z - from.z};
}

// A vector scaled to length one; zero stays zero. Scaled by the largest part first, so that tiny and huge
// triangles neither vanish nor overflow.
Vector unit(Vector v) {
    const double largest = v.max_abs();
    if (!(largest > 0) || !std::isfinite(largest)) return {0, 0, 0};
    v /= largest;
    return v / v.norm();
}

double angle_between(const Vector& a, const Vector& b) {
    return std::atan2((unit(a) % unit(b)).norm(), unit(a) | unit(b));
}

}  // namespace

std::vector<Point3> vertex_normals(const TriangleSoup& soup, NormalWeight weight) {
    std::vector<Vector> sum(soup.points.size(), {0, 0, 0});
    std::vector<double> total(soup.points.size(), 0.0);
    std::vector<Vector> first(soup.points.size(), {0, 0, 0});
    for (const auto& triangle : soup.triangles) {
        for (int k = 0; k < 3; ++k) {
            const auto v = triangle[k];
            const Vector a = vector(soup.points[v], soup.points[triangle[(k + 1) % 3]]);
            const Vector b = vector(soup.points[v], soup.points[triangle[(k + 2) % 3]]);
            const Vector normal = unit(unit(a) % unit(b));
            const double w = weight == NormalWeight::Uniform ? 1.0
                             : weight == NormalWeight::Area  ? (a % b).norm()
                                                             : angle_between(a, b);
            if (normal == Vector(0, 0, 0)) continue;
            sum[v] += w * normal;
            total[v] += w;
            if (first[v] == Vector(0, 0, 0)) first[v] = normal;
        }
    }
    std::vector<Point3> normals(soup.points.size());
    for (std::size_t v = 0; v < normals.size(); ++v) {
        Vector normal = sum[v].norm() > kCancelled * total[v] ? unit(sum[v]) : first[v];
        if (normal == Vector(0, 0, 0)) normal = {0, 0, 1};
        normals[v] = {normal[0], normal[1], normal[2]};
    }
    return normals;
}

void update_vertex_normals(TriMesh& mesh, NormalWeight weight) {
    const auto normals = vertex_normals(triangle_soup(mesh), weight);
    std::size_t i = 0;
    for (const auto v : mesh.vertices()) {
        mesh.set_normal(v, {normals[i].x, normals[i].y, normals[i].z});
        ++i;
    }
}

}  // namespace stratareeb
