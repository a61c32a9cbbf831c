// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangle_soup.h"

#include <gtest/gtest.h>

#include "boreholes/errors.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

// Everything that half-edge connectivity promises.
void expect_consistent(const TriMesh& mesh) {
    for (int i = 0; i < static_cast<int>(mesh.n_halfedges()); ++i) {
        const TriMesh::HalfedgeHandle h(i);
        EXPECT_EQ(mesh.prev_halfedge_handle(mesh.next_halfedge_handle(h)), h);
        EXPECT_EQ(mesh.to_vertex_handle(h), mesh.from_vertex_handle(mesh.next_halfedge_handle(h)));
        EXPECT_EQ(mesh.to_vertex_handle(h), mesh.from_vertex_handle(mesh.opposite_halfedge_handle(h)));
        EXPECT_EQ(mesh.face_handle(h), mesh.face_handle(mesh.next_halfedge_handle(h)));
    }
    for (const auto v : mesh.vertices()) {
        const auto h = mesh.halfedge_handle(v);
        if (!h.is_valid()) continue;
        EXPECT_EQ(mesh.from_vertex_handle(h), v);
        bool on_boundary = false;
        for (const auto out : mesh.voh_range(v)) on_boundary = on_boundary || mesh.is_boundary(out);
        EXPECT_EQ(mesh.is_boundary(h), on_boundary);  // a boundary vertex names its boundary half-edge
    }
    for (const auto f : mesh.faces()) EXPECT_EQ(mesh.face_handle(mesh.halfedge_handle(f)), f);
}

std::string refusal(const TriangleSoup& soup) {
    try {
        half_edge_mesh(soup);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "accepted";
}

TEST(TriangleSoup, makes_a_consistent_half_edge_mesh_and_comes_back_unchanged) {
    auto all = shapes::solids();
    for (auto& shape : shapes::open_surfaces()) all.push_back(shape);
    for (const auto& shape : all) {
        SCOPED_TRACE(shape.name);
        const auto mesh = half_edge_mesh(shape.soup);
        expect_consistent(mesh);
        const auto back = triangle_soup(mesh);
        EXPECT_EQ(back.points, shape.soup.points);
        ASSERT_EQ(back.triangles.size(), shape.soup.triangles.size());
        for (std::size_t t = 0; t < back.triangles.size(); ++t)
            EXPECT_EQ(back.triangles[t], shape.soup.triangles[t]);
    }
}

TEST(TriangleSoup, has_the_connectivity_that_openmesh_builds_face_by_face) {
    for (const auto& shape : shapes::open_surfaces()) {
        const auto mesh = half_edge_mesh(shape.soup);
        TriMesh slow;
        for (const auto& p : shape.soup.points) slow.add_vertex({p.x, p.y, p.z});
        for (const auto& t : shape.soup.triangles)
            slow.add_face(slow.vertex_handle(t[0]), slow.vertex_handle(t[1]), slow.vertex_handle(t[2]));
        EXPECT_EQ(mesh.n_edges(), slow.n_edges());
        for (const auto v : mesh.vertices()) {
            EXPECT_EQ(mesh.valence(v), slow.valence(v));
            EXPECT_EQ(mesh.is_boundary(v), slow.is_boundary(v));
        }
    }
}

TEST(TriangleSoup, can_be_edited_after_the_fast_path) {
    auto mesh = half_edge_mesh(shapes::uv_sphere(1, 12, 16));
    const std::size_t vertices = mesh.n_vertices();
    for (const auto h : mesh.halfedges()) {
        if (!mesh.is_collapse_ok(h)) continue;
        mesh.collapse(h);
        break;
    }
    const auto left_out = triangle_soup(mesh);  // deleted elements are skipped before garbage collection…
    mesh.garbage_collection();
    EXPECT_EQ(mesh.n_vertices(), vertices - 1);
    EXPECT_EQ(left_out.points.size(), vertices - 1);
    EXPECT_EQ(left_out.triangles.size(), mesh.n_faces());
    expect_consistent(half_edge_mesh(left_out));  // …and what is left is a sound mesh
}

TEST(TriangleSoup, keeps_isolated_vertices) {
    auto soup = shapes::tetrahedron();
    soup.points.insert(soup.points.begin(), {7, 7, 7});
    for (auto& t : soup.triangles) t = {t[0] + 1, t[1] + 1, t[2] + 1};
    const auto mesh = half_edge_mesh(soup);
    EXPECT_EQ(mesh.n_vertices(), 5u);
    EXPECT_TRUE(mesh.is_isolated(mesh.vertex_handle(0)));
    EXPECT_EQ(half_edge_mesh({}).n_faces(), 0u);
}

TEST(TriangleSoup, that_is_no_manifold_is_refused_by_name_and_place) {
    auto three_wings = shapes::tetrahedron();
    three_wings.points.push_back({5, 5, 5});
    three_wings.triangles.push_back({0, 1, 4});
    EXPECT_NE(refusal(three_wings).find("edge 1-0 from (1, 0, 0) to (0, 0, 0)"), std::string::npos)
        << refusal(three_wings);
    EXPECT_NE(refusal(three_wings).find("more than two triangles"), std::string::npos);

    TriangleSoup bow_tie;
    bow_tie.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    bow_tie.triangles = {{0, 1, 2}, {0, 3, 4}};
    EXPECT_NE(refusal(bow_tie).find("vertex 0 at (0, 0, 0)"), std::string::npos) << refusal(bow_tie);

    auto turned = shapes::tetrahedron();
    std::swap(turned.triangles[0][0], turned.triangles[0][1]);
    EXPECT_NE(refusal(turned).find("wound against each other"), std::string::npos) << refusal(turned);

    EXPECT_NE(refusal({{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}}}).find("names a vertex twice"), std::string::npos);
    EXPECT_NE(refusal({{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}}).find("names vertex 2 of 2"), std::string::npos);
    EXPECT_NE(refusal(shapes::mobius(30)).find("wound against each other"), std::string::npos);
}

}  // namespace
}  // namespace stratareeb
