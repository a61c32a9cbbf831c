// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_soup.h"

namespace stratareeb {

//! Indexed polygons of any size, sound or not, counter-clockwise seen from outside.
struct PolygonMesh {
    std::vector<Point3> points;
    std::vector<std::uint32_t> corners;  // of face after face
    std::vector<std::uint32_t> sizes;    // corners of each face; empty = all triangles

    std::size_t face_count() const { return sizes.empty() ? corners.size() / 3 : sizes.size(); }
};

//! Call `visit(face, corners)` for each face in turn.
template <class Visit>
void for_each_face(const PolygonMesh& mesh, Visit visit) {
    const std::span<const std::uint32_t> corners = mesh.corners;
    std::size_t begin = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::size_t size = mesh.sizes.empty() ? 3 : mesh.sizes[f];
        visit(f, corners.subspan(begin, size));
        begin += size;
    }
}

//! Fans of triangles around each face's first corner.
TriangleSoup triangle_fans(const PolygonMesh& mesh);

//! The same triangles, as polygons of three corners.
PolygonMesh polygon_mesh(const TriangleSoup& soup);

//! Let each quad begin at an end of its shorter diagonal, so that its fan is cut there.
void start_at_short_diagonals(PolygonMesh& mesh);

}  // namespace stratareeb
