// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/polygon_mesh.h"

#include <algorithm>

namespace stratareeb {
namespace {

double squared_distance(const Point3& a, const Point3& b) {
    const double x = b.x - a.x, y = b.y - a.y, z = b.z - a.z;
    return x * x + y * y + z * z;
}

}  // namespace

TriangleSoup triangle_fans(const PolygonMesh& mesh) {
    TriangleSoup soup{mesh.points, {}};
    soup.triangles.reserve(mesh.corners.size() - 2 * mesh.face_count());
    for_each_face(mesh, [&](std::size_t, std::span<const std::uint32_t> corners) {
        for (std::size_t i = 2; i < corners.size(); ++i)
            soup.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    });
    return soup;
}

PolygonMesh polygon_mesh(const TriangleSoup& soup) {
    PolygonMesh mesh{soup.points, {}, {}};
    mesh.corners.reserve(3 * soup.triangles.size());
    for (const auto& t : soup.triangles) mesh.corners.insert(mesh.corners.end(), t.begin(), t.end());
    return mesh;
}

void start_at_short_diagonals(PolygonMesh& mesh) {
    auto corner = mesh.corners.begin();
    for (const auto size : mesh.sizes) {
        if (size == 4 && squared_distance(mesh.points[corner[1]], mesh.points[corner[3]]) <
                             squared_distance(mesh.points[corner[0]], mesh.points[corner[2]]))
            std::rotate(corner, corner + 1, corner + 4);
        corner += size;
    }
}

}  // namespace stratareeb
