// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons in files: whole where they are asked for, fans of triangles for all others.
#include "io/polygon_fan.h"

#include <gtest/gtest.h>

#include <fstream>

#include "boreholes/errors.h"
#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "mesh/analysis.h"
#include "tests/refine_cases.h"
#include "tests/shapes.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

void expect_equal(const PolygonMesh& a, const PolygonMesh& b) {
    EXPECT_EQ(a.points, b.points);
    EXPECT_EQ(a.corners, b.corners);
    EXPECT_EQ(a.sizes, b.sizes);
}

TEST(PolygonFan, fans_are_counted_from_the_first_polygon_on) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    Fans fans;
    const std::uint32_t corners[] = {5, 6, 7, 8, 9};
    append_fan(std::span(corners, 3), triangles, fans);
    append_fan(std::span(corners, 3), triangles, fans);
    EXPECT_TRUE(fans.empty());
    append_fan(std::span(corners, 5), triangles, fans);
    append_fan(std::span(corners, 3), triangles, fans);
    append_fan(std::span(corners, 4), triangles, fans);
    EXPECT_EQ(fans, (Fans{1, 1, 3, 1, 2}));
    std::vector<std::vector<std::uint32_t>> polygons;
    for_each_polygon({{}, triangles}, fans,
                     [&](std::span<const std::uint32_t> p) { polygons.emplace_back(p.begin(), p.end()); });
    EXPECT_EQ(polygons, (std::vector<std::vector<std::uint32_t>>{
                            {5, 6, 7}, {5, 6, 7}, {5, 6, 7, 8, 9}, {5, 6, 7}, {5, 6, 7, 8}}));
}

TEST(PolygonFan, files_keep_polygons) {
    const TemporaryFolder folder;
    for (const auto& mesh : {shapes::quad_cube(), shapes::polygon_prism(9, 1.7, 0.3), shapes::octahedron()})
        for (const char* name : {"a.ply", "a.obj", "a.off"}) {
            write_polygons(folder / name, "a", mesh);
            auto back = read_polygons(folder / name);
            if (back.sizes.empty()) back.sizes.assign(back.face_count(), 3);
            expect_equal(back, mesh);
            EXPECT_EQ(read_mesh(folder / name).triangles, triangle_fans(mesh).triangles) << name;
        }
}

TEST(PolygonFan, formats_of_triangles_get_fans) {
    const TemporaryFolder folder;
    for (const char* name : {"a.stl", "a.glb", "a.3mf"}) {
        write_polygons(folder / name, "a", shapes::quad_cube());
        const auto back = read_polygons(folder / name);
        EXPECT_TRUE(back.sizes.empty());
        EXPECT_EQ(back.face_count(), 12u);
        EXPECT_NEAR(volume(triangle_fans(back)), 8, 1e-6) << name;
    }
}

TEST(PolygonFan, ply_cuts_polygons_of_more_corners_than_it_can_count) {
    const TemporaryFolder folder;
    const auto prism = shapes::polygon_prism(300, 1, 1);
    write_polygons(folder / "a.ply", "a", prism);
    write_polygons(folder / "a.obj", "a", prism);
    EXPECT_EQ(read_polygons(folder / "a.ply").face_count(), 300u + 2 * 298);
    expect_equal(read_polygons(folder / "a.obj"), prism);
    EXPECT_NEAR(volume(read_mesh(folder / "a.ply")), volume(triangle_fans(prism)), 1e-12);
}

TEST(PolygonFan, parts_are_joined) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.obj")
        << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\no one\nf 1 2 3 4\no two\nf 1 2 3\n";
    const auto mesh = read_polygons(folder / "a.obj");
    EXPECT_EQ(mesh.sizes, (std::vector<std::uint32_t>{4, 3}));
    EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6}));
}

TEST(PolygonFan, damage_is_named) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.off") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2 3\n";
    EXPECT_THROW(read_polygons(folder / "a.off"), InvalidInput);
    EXPECT_THROW(read_polygons(folder / "none.off"), IoError);
    EXPECT_THROW(write_polygons(folder / "a.xyz", "a", shapes::quad_cube()), IoError);
    EXPECT_THROW(write_polygons(folder / "no" / "such" / "folder.ply", "a", shapes::quad_cube()), IoError);
}

TEST(PolygonMesh, quads_begin_at_an_end_of_their_shorter_diagonal) {
    PolygonMesh mesh{{{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 1, 0}}, {0, 1, 2, 3}, {4}};
    start_at_short_diagonals(mesh);
    EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{1, 2, 3, 0}));
    start_at_short_diagonals(mesh);
    EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{1, 2, 3, 0}));
    EXPECT_NEAR(area(triangle_fans(mesh)), 2, 1e-15);
    auto prism = shapes::polygon_prism(6, 1, 2);
    const double before = volume(triangle_fans(prism));
    start_at_short_diagonals(prism);
    EXPECT_NEAR(volume(triangle_fans(prism)), before, 1e-14);
}

}  // namespace
}  // namespace stratareeb
