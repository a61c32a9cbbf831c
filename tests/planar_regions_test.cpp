// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/planar_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "boreholes/errors.h"
#include "tests/planar_shapes.h"

namespace stratareeb {
namespace {

using Vec = OpenMesh::Vec3d;

Vec at(const TriMesh& mesh, std::uint32_t v) {
    return mesh.point(TriMesh::VertexHandle(static_cast<int>(v)));
}

Vec area_vector(const TriMesh& mesh, const std::vector<std::uint32_t>& loop) {
    Vec sum(0, 0, 0);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        sum += cross(at(mesh, loop[i]) - at(mesh, loop[0]), at(mesh, loop[i + 1]) - at(mesh, loop[0]));
    return 0.5 * sum;
}

Vec vec(const Point3& p) {
    return {p.x, p.y, p.z};
}

// The divergence theorem over the polygons: a third of the sum of area vector times a point of the plane.
double polygon_volume(const TriMesh& mesh, const std::vector<PlanarRegion>& regions) {
    const Vec o = at(mesh, 0);
    double three = 0;
    for (const auto& region : regions)
        for (const auto& loop : region.loops) three += dot(area_vector(mesh, loop), vec(region.point) - o);
    return three / 3;
}

// Every polygon is planar with simple loops, outer first; every side is used once each way; the volume is the
// mesh's.
void expect_sound(const TriMesh& mesh, const std::vector<PlanarRegion>& regions, double size) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    std::size_t triangles = 0;
    for (const auto& region : regions) {
        triangles += region.triangles;
        std::set<std::uint32_t> seen;
        for (std::size_t k = 0; k < region.loops.size(); ++k) {
            const auto& loop = region.loops[k];
            ASSERT_GE(loop.size(), 3u);
            EXPECT_EQ(dot(area_vector(mesh, loop), vec(region.normal)) > 0, k == 0)
                << "outer loop first, then holes";
            for (std::size_t i = 0; i < loop.size(); ++i) {
                EXPECT_TRUE(seen.insert(loop[i]).second) << "vertex twice in a region";
                EXPECT_NEAR(dot(at(mesh, loop[i]) - vec(region.point), vec(region.normal)), 0, 1e-10 * size);
                ++sides[{loop[i], loop[(i + 1) % loop.size()]}];
            }
        }
    }
    EXPECT_EQ(triangles, mesh.n_faces());
    for (const auto& [side, count] : sides) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(sides.contains({side.second, side.first}));
    }
    const double volume = test::mesh_volume(mesh);
    EXPECT_NEAR(polygon_volume(mesh, regions), volume, 1e-9 * volume);
}

std::size_t corner_count(const std::vector<PlanarRegion>& regions) {
    std::set<std::uint32_t> corners;
    for (const auto& region : regions)
        for (const auto& loop : region.loops) corners.insert(loop.begin(), loop.end());
    return corners.size();
}

TEST(PlanarRegions, a_finely_triangulated_box_has_six_faces_and_eight_corners) {
    const auto mesh = test::slab({.n = 9});
    const auto regions = planar_regions(mesh);
    EXPECT_EQ(regions.size(), 6u);
    EXPECT_EQ(corner_count(regions), 8u);
    for (const auto& region : regions) EXPECT_EQ(region.loops.size(), 1u);
    expect_sound(mesh, regions, 1);
}

TEST(PlanarRegions, straight_vertices_stay_when_asked) {
    const auto mesh = test::slab({.n = 9});
    const auto regions = planar_regions(mesh, {.drop_straight_vertices = false});
    EXPECT_EQ(regions.size(), 6u);
    EXPECT_EQ(corner_count(regions), 2u * 4 * 9);
    expect_sound(mesh, regions, 1);
}

TEST(PlanarRegions, a_box_with_a_hole_has_ten_faces_two_of_them_with_a_hole) {
    const auto mesh =
        test::slab({.n = 6, .has_cell = [](int i, int j) { return i < 2 || i > 3 || j < 2 || j > 3; }});
    const auto regions = planar_regions(mesh);
    EXPECT_EQ(regions.size(), 10u);
    EXPECT_EQ(corner_count(regions), 16u);
    EXPECT_EQ(std::ranges::count_if(regions, [](const auto& r) { return r.loops.size() == 2; }), 2);
    expect_sound(mesh, regions, 1);
}

TEST(PlanarRegions, a_dipping_slab_far_from_zero_keeps_its_six_faces) {
    const auto dip = [](double x, double y) { return 0.3 * (x - 5e6) - 0.2 * (y - 5e6); };
    const auto mesh = test::slab({.n = 20,
                                  .size = 1000,
                                  .x0 = 5e6,
                                  .y0 = 5e6,
                                  .top = [&](double x, double y) { return dip(x, y) + 7; },
                                  .base = dip});
    const auto regions = planar_regions(mesh);
    EXPECT_EQ(regions.size(), 6u);
    expect_sound(mesh, regions, 1000);
}

TEST(PlanarRegions, a_wedge_has_five_faces) {
    // The base rises to the top along one side: columns without thickness there would be degenerate, so the
    // wedge is a triangular prism made by hand.
    TriMesh mesh;
    std::vector<TriMesh::VertexHandle> a, b;
    for (int k = 0; k < 2; ++k) {
        a.push_back(mesh.add_vertex({0, 1.0 * k, 0}));
        b.push_back(mesh.add_vertex({2, 1.0 * k, 0}));
    }
    const auto c0 = mesh.add_vertex({2, 0, 1}), c1 = mesh.add_vertex({2, 1, 1});
    mesh.add_face(a[0], b[0], c0);
    mesh.add_face(a[1], c1, b[1]);
    mesh.add_face(a[0], a[1], b[1]);
    mesh.add_face(a[0], b[1], b[0]);
    mesh.add_face(b[0], b[1], c1);
    mesh.add_face(b[0], c1, c0);
    mesh.add_face(a[0], c0, c1);
    mesh.add_face(a[0], c1, a[1]);
    const auto regions = planar_regions(mesh);
    EXPECT_EQ(regions.size(), 5u);
    expect_sound(mesh, regions, 2);
}

TEST(PlanarRegions, triangles_that_are_not_coplanar_stay_triangles) {
    const auto mesh =
        test::slab({.n = 12,
                    .size = 6,
                    .top = [](double x, double y) { return 2 + std::sin(x) * std::cos(1.3 * y); },
                    .base = [](double x, double y) { return 0.03 * x * x - 0.02 * x * y - 2; }});
    const auto regions = planar_regions(mesh);
    const auto triangles = std::ranges::count_if(regions, [](const auto& r) { return r.triangles == 1; });
    EXPECT_GT(triangles, 12 * 12 * 4 - 30);  // by symmetry a few neighbours of the sine are coplanar
    EXPECT_LE(regions.size(), 12u * 12 * 4 + 4);
    expect_sound(mesh, regions, 6);
}

TEST(PlanarRegions, a_lens_keeps_its_sharp_rim) {
    const auto mesh = test::cone_lens(7, 5, 10, 2, 3);
    const auto regions = planar_regions(mesh);
    EXPECT_EQ(regions.size(), 14u);  // a triangle a side and sheet
    EXPECT_EQ(corner_count(regions), 9u);
    expect_sound(mesh, regions, 10);
}

TEST(PlanarRegions, a_region_that_touches_itself_is_cut) {
    // Two raised vertices whose stars share the vertex (3, 3): the flat rest would touch itself there.
    const auto mesh = test::slab({.n = 6, .size = 6, .top = [](double x, double y) {
                                      return (x == 2 && y == 2) || (x == 4 && y == 4) ? 2.0 : 1.0;
                                  }});
    const auto regions = planar_regions(mesh);
    expect_sound(mesh, regions, 6);
    EXPECT_LT(regions.size(), 6u + 12 + 8);  // a few large pieces, not triangles
}

TEST(PlanarRegions, random_steps_and_flats_give_sound_regions) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        std::mt19937 random(seed);
        std::map<std::pair<int, int>, int> height;
        for (int i = 0; i <= 8; ++i)
            for (int j = 0; j <= 8; ++j) height[{i, j}] = static_cast<int>(random() % 8 == 0);
        const auto mesh = test::slab({.n = 8, .size = 8, .top = [&](double x, double y) {
                                          return 1.0 + height[{static_cast<int>(x), static_cast<int>(y)}];
                                      }});
        SCOPED_TRACE(seed);
        expect_sound(mesh, planar_regions(mesh), 8);
    }
}

TEST(PlanarRegions, an_empty_mesh_has_none_and_an_open_one_is_refused) {
    EXPECT_TRUE(planar_regions({}).empty());
    TriMesh open;
    open.add_face(open.add_vertex({0, 0, 0}), open.add_vertex({1, 0, 0}), open.add_vertex({0, 1, 0}));
    EXPECT_THROW(planar_regions(open), InvalidInput);
}

TEST(PlanarRegions, a_triangle_without_area_is_named) {
    auto mesh = test::slab({.n = 1});
    mesh.set_point(TriMesh::VertexHandle(0), mesh.point(TriMesh::VertexHandle(2)));
    try {
        planar_regions(mesh);
        FAIL();
    } catch (const GeometryError& e) {
        EXPECT_NE(std::string(e.what()).find("no area"), std::string::npos);
    }
}

}  // namespace
}  // namespace stratareeb
