// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/filled_boundaries.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "boreholes/errors.h"
#include "mesh/polygon_triangulation.h"
#include "mesh/triangle_soup.h"

namespace stratareeb {

namespace {

using Halfedge = TriMesh::HalfedgeHandle;

//! Vertices of the loop that a boundary half-edge is on.
std::vector<TriMesh::VertexHandle> loop_of(const TriMesh& mesh, Halfedge first, std::vector<bool>& seen) {
    std::vector<TriMesh::VertexHandle> loop;
    for (Halfedge h = first; !seen[static_cast<std::size_t>(h.idx())]; h = mesh.next_halfedge_handle(h)) {
        seen[static_cast<std::size_t>(h.idx())] = true;
        loop.push_back(mesh.from_vertex_handle(h));
    }
    return loop;
}

[[noreturn]] void refuse(const TriMesh& mesh, TriMesh::VertexHandle v, const char* why) {
    const auto& p = mesh.point(v);
    throw InvalidInput(
        fmt::format("the mesh has a boundary at ({:.7g}, {:.7g}, {:.7g}) that {}", p[0], p[1], p[2], why));
}

void check_level(const TriMesh& mesh, const std::vector<TriMesh::VertexHandle>& loop) {
    const auto [low, high] =
        std::ranges::minmax_element(loop, {}, [&](TriMesh::VertexHandle v) { return mesh.point(v)[2]; });
    if (mesh.point(*low)[2] == mesh.point(*high)[2]) return;
    refuse(mesh, *low,
           "is not level: contours end on it, and a graph has closed ones only. Close the surface (of a "
           "horizon, "
           "`build` makes the layer's solid), sweep along a direction in which its ends are level, or cut it "
           "there at one "
           "height");
}

}  // namespace

TriMesh filled_boundaries(const TriMesh& mesh) {
    TriangleSoup soup = triangle_soup(mesh);
    std::vector<bool> seen(mesh.n_halfedges(), false);
    for (const auto h : mesh.halfedges()) {
        if (!mesh.is_boundary(h) || seen[static_cast<std::size_t>(h.idx())]) continue;
        const auto loop = loop_of(mesh, h, seen);
        check_level(mesh, loop);
        std::vector<Point2> corners;
        double twice_area = 0;
        for (const auto v : loop) corners.push_back({mesh.point(v)[0], mesh.point(v)[1]});
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point2 &a = corners[i], &b = corners[(i + 1) % corners.size()], &o = corners[0];
            twice_area += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
        }
        try {
            for (auto [a, b, c] : triangulate_polygon(corners)) {
                if (twice_area < 0) std::swap(b, c);
                const auto vertex = [&](std::uint32_t i) {
                    return static_cast<std::uint32_t>(loop[i].idx());
                };
                soup.triangles.push_back({vertex(a), vertex(b), vertex(c)});
            }
        } catch (const InvalidInput&) {
            refuse(mesh, loop.front(),
                   "crosses or touches itself in plan, so nothing says what it lies around");
        }
    }
    return half_edge_mesh(soup);
}

}  // namespace stratareeb
