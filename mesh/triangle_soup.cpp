// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangle_soup.h"

#include <fmt/format.h>

#include <string>

#include "boreholes/errors.h"
#include "mesh/soup_topology.h"

namespace stratareeb {
namespace {

using HalfedgeHandle = OpenMesh::HalfedgeHandle;

std::string place(const Point3& p) {
    return fmt::format("({}, {}, {})", p.x, p.y, p.z);
}

[[noreturn]] void refuse_edge(const TriangleSoup& soup, std::uint32_t side, const char* what) {
    const auto a = vertex_at(soup, side), b = vertex_at(soup, next_corner(side));
    throw InvalidInput(
        fmt::format("edge {}-{} from {} to {} {}", a, b, place(soup.points[a]), place(soup.points[b]), what));
}

void require_sound_triangles(const TriangleSoup& soup) {
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        for (const auto v : soup.triangles[t])
            if (v >= soup.points.size())
                throw InvalidInput(
                    fmt::format("triangle {} names vertex {} of {}", t, v, soup.points.size()));
        if (names_a_vertex_twice(soup.triangles[t]))
            throw InvalidInput(fmt::format("triangle {} names a vertex twice", t));
    }
}

void require_manifold(const TriangleSoup& soup, const SoupTopology& topology) {
    for (std::size_t e = 0; e < topology.edge_count(); ++e) {
        const auto sides = topology.sides_of(e);
        if (sides.size() > 2) refuse_edge(soup, sides[0], "has more than two triangles (not a manifold)");
        if (sides.size() == 2 && vertex_at(soup, sides[0]) == vertex_at(soup, sides[1]))
            refuse_edge(soup, sides[0], "has triangles that are wound against each other");
    }
    const auto further = corners_in_further_fans(soup, topology);
    if (further.empty()) return;
    const std::uint32_t v = vertex_at(soup, further.front());
    throw InvalidInput(fmt::format("vertex {} at {} has more than one fan of triangles (not a manifold)", v,
                                   place(soup.points[v])));
}

// Half-edges straight from the edge table, several times faster than add_face one by one, which searches each
// vertex's surroundings. Half-edge 2e runs along the first side of edge e.
void link_half_edges(const TriangleSoup& soup, const SoupTopology& topology, TriMesh& mesh) {
    const auto half_edge = [&](std::uint32_t side) {
        const auto e = topology.edge_of_side[side];
        return HalfedgeHandle(static_cast<int>(2 * e + (topology.sides_of(e)[0] == side ? 0 : 1)));
    };
    for (std::size_t e = 0; e < topology.edge_count(); ++e) {
        const auto side = topology.sides_of(e)[0];
        mesh.new_edge(TriMesh::VertexHandle(static_cast<int>(vertex_at(soup, side))),
                      TriMesh::VertexHandle(static_cast<int>(vertex_at(soup, next_corner(side)))));
    }
    for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
        const auto face = mesh.new_face();
        for (std::uint32_t side = 3 * t; side < 3 * t + 3; ++side) {
            const auto h = half_edge(side);
            mesh.set_face_handle(h, face);
            mesh.set_next_halfedge_handle(h, half_edge(next_corner(side)));
            mesh.set_halfedge_handle(TriMesh::VertexHandle(static_cast<int>(vertex_at(soup, side))), h);
        }
        mesh.set_halfedge_handle(face, half_edge(3 * t));
    }
}

// A boundary vertex points at its one half-edge without a face; those are chained into loops.
void link_boundary(TriMesh& mesh) {
    for (int h = 0; h < static_cast<int>(mesh.n_halfedges()); ++h)
        if (mesh.is_boundary(HalfedgeHandle(h)))
            mesh.set_halfedge_handle(mesh.from_vertex_handle(HalfedgeHandle(h)), HalfedgeHandle(h));
    for (int h = 0; h < static_cast<int>(mesh.n_halfedges()); ++h)
        if (mesh.is_boundary(HalfedgeHandle(h)))
            mesh.set_next_halfedge_handle(HalfedgeHandle(h),
                                          mesh.halfedge_handle(mesh.to_vertex_handle(HalfedgeHandle(h))));
}

}  // namespace

TriangleSoup triangle_soup(const TriMesh& mesh) {
    TriangleSoup soup;
    soup.points.reserve(mesh.n_vertices());
    soup.triangles.reserve(mesh.n_faces());
    std::vector<std::uint32_t> number(mesh.n_vertices(), 0);
    for (const auto v : mesh.vertices()) {
        number[v.idx()] = static_cast<std::uint32_t>(soup.points.size());
        const auto& p = mesh.point(v);
        soup.points.push_back({p[0], p[1], p[2]});
    }
    for (const auto f : mesh.faces()) {
        const auto h = mesh.halfedge_handle(f);
        const auto next = mesh.next_halfedge_handle(h);
        soup.triangles.push_back({number[mesh.from_vertex_handle(h).idx()],
                                  number[mesh.to_vertex_handle(h).idx()],
                                  number[mesh.to_vertex_handle(next).idx()]});
    }
    return soup;
}

TriMesh half_edge_mesh(const TriangleSoup& soup) {
    require_sound_triangles(soup);
    const auto topology = soup_topology(soup);
    require_manifold(soup, topology);
    TriMesh mesh;
    mesh.reserve(soup.points.size(), topology.edge_count(), soup.triangles.size());
    for (const auto& p : soup.points) mesh.set_normal(mesh.add_vertex({p.x, p.y, p.z}), {0, 0, 0});
    link_half_edges(soup, topology, mesh);
    link_boundary(mesh);
    return mesh;
}

}  // namespace stratareeb
