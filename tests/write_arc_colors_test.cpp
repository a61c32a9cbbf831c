// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_arc_colors.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstring>
#include <regex>
#include <set>

#include "boreholes/errors.h"
#include "io/arc_colors.h"
#include "io/read_mesh.h"
#include "tests/shapes.h"
#include "tests/users_programs.h"

namespace stratareeb {
namespace {

struct Face {
    std::array<std::int32_t, 3> corners;
    Rgb color;
    std::int32_t arc;
};

//! The faces of such a file, byte by byte.
std::vector<Face> faces_of(const std::string& bytes, std::size_t vertices, std::size_t faces) {
    std::size_t at = bytes.find("end_header\n") + 11 + vertices * 27;
    EXPECT_EQ(bytes.size(), at + faces * 20);
    std::vector<Face> result(faces);
    for (Face& face : result) {
        EXPECT_EQ(bytes[at], 3);
        std::memcpy(face.corners.data(), &bytes[at + 1], 12);
        std::memcpy(face.color.data(), &bytes[at + 13], 3);
        std::memcpy(&face.arc, &bytes[at + 16], 4);
        at += 20;
    }
    return result;
}

class WriteArcColors : public ::testing::Test {
 protected:
    test::TemporaryFolder folder_{"write_arc_colors"};
    std::filesystem::path file_ = folder_.path() / "colored.ply";
    TriMesh mesh_ = half_edge_mesh(shapes::torus(3, 1, 40, 20));
    ReebGraph graph_ = reeb_graph(mesh_, height_field(mesh_, {1, 0.1, 0.05}));
};

TEST_F(WriteArcColors, each_face_has_its_arc_and_the_colour_of_it) {
    static_assert(std::endian::native == std::endian::little);
    write_arc_colors(file_, mesh_, graph_);
    const auto colors = arc_colors(graph_);
    const auto faces = faces_of(test::text_of(file_), mesh_.n_vertices(), mesh_.n_faces());
    const TriangleSoup soup = triangle_soup(mesh_);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        EXPECT_EQ(faces[f].arc, static_cast<std::int32_t>(graph_.triangle_arc[f]));
        EXPECT_EQ(faces[f].color, colors[graph_.triangle_arc[f]]);
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(faces[f].corners[k], static_cast<std::int32_t>(soup.triangles[f][k]));
    }
    EXPECT_EQ(read_mesh(file_).points, soup.points);
}

TEST_F(WriteArcColors, what_has_no_arc_is_grey) {
    graph_.triangle_arc[7] = ReebGraph::kNone;
    write_arc_colors(file_, mesh_, graph_);
    const Face face = faces_of(test::text_of(file_), mesh_.n_vertices(), mesh_.n_faces())[7];
    EXPECT_EQ(face.arc, -1);
    EXPECT_EQ(face.color[0], face.color[1]);
}

TEST_F(WriteArcColors, handles_are_parts_of_the_mesh) {
    const auto handles = loop_handles(mesh_, graph_);
    ASSERT_EQ(handles.size(), 1u);
    const auto parts_file = folder_.path() / "loops.obj";
    write_loop_handles(parts_file, mesh_, handles);
    const auto parts = read_mesh_parts(parts_file);
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].name, "loop_0");
    EXPECT_EQ(parts[0].soup.triangles.size(), handles[0].triangles.size());
    // The handle is one half of the ring, beside the plane through its axis and its highest point; but for a triangle's side.
    const auto beside = [](const Point3& p) { return p.y - p.x / 10; };
    double side = 0;
    for (const Point3& p : parts[0].soup.points) side += beside(p);
    for (const Point3& p : parts[0].soup.points) {
        EXPECT_GT(side > 0 ? beside(p) : -beside(p), -0.63);
        EXPECT_GE(p.x, handles[0].box_min.x);
        EXPECT_LE(p.x, handles[0].box_max.x);
    }
}

TEST_F(WriteArcColors, opens_in_meshlab) {
    if (!test::has_program("meshlabserver") || !test::has_program("xvfb-run"))
        GTEST_SKIP() << "meshlabserver or xvfb-run is not installed";
    write_arc_colors(file_, mesh_, graph_);
    const auto report = test::open_in_meshlab(file_, folder_.path());
    EXPECT_NE(report.output.find("V:    800"), std::string::npos) << report.output;
    EXPECT_EQ(report.genus, 1) << report.output;
    EXPECT_TRUE(report.two_manifold);
}

TEST_F(WriteArcColors, other_formats_are_refused) {
    EXPECT_THROW(write_arc_colors("mesh.obj", mesh_, graph_), IoError);
    EXPECT_THROW(write_loop_handles("mesh.xyz", mesh_, {}), IoError);
}

TEST(ArcColors, differ_at_each_node_and_are_all_different) {
    std::set<Rgb> palette;
    for (std::size_t i = 0; i < 27; ++i) palette.insert(palette_color(i));
    EXPECT_EQ(palette.size(), 27u);
    for (const auto& soup : {shapes::plate_with_holes(8), shapes::terrain(30), shapes::torus(3, 1, 20, 10)}) {
        const TriMesh mesh = half_edge_mesh(soup);
        const ReebGraph graph = reeb_graph(mesh, height_field(mesh));
        const auto colors = arc_colors(graph);
        ASSERT_EQ(colors.size(), graph.arcs.size());
        for (std::uint32_t n = 0; n < graph.nodes.size(); ++n) {
            std::set<Rgb> here;
            std::size_t arcs = 0;
            for (std::size_t a = 0; a < graph.arcs.size(); ++a)
                if (graph.arcs[a].lower == n || graph.arcs[a].upper == n) {
                    here.insert(colors[a]);
                    ++arcs;
                }
            EXPECT_EQ(here.size(), arcs);
        }
    }
}

}  // namespace
}  // namespace stratareeb
