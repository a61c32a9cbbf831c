// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/orient_soup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "boreholes/errors.h"
#include "mesh/analysis.h"
#include "mesh/components.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

//! The corners of each triangle as places, whatever the winding; a set with counts.
std::multiset<Triangle> places(const TriangleSoup& soup, const std::vector<std::uint32_t>& source) {
    std::multiset<Triangle> result;
    for (const Triangle& t : soup.triangles) {
        Triangle place{source[t[0]], source[t[1]], source[t[2]]};
        std::ranges::sort(place);
        result.insert(place);
    }
    return result;
}

//! The triangles that a repair keeps: three corners, each three once.
std::multiset<Triangle> proper(const TriangleSoup& soup) {
    std::set<Triangle> result;
    for (Triangle t : soup.triangles) {
        std::ranges::sort(t);
        if (t[0] != t[1] && t[1] != t[2]) result.insert(t);
    }
    return {result.begin(), result.end()};
}

//! Half-edge mesh of a repair that has kept the triangles and moved nothing.
TriMesh checked_mesh(const TriangleSoup& soup, const OrientedSoup& repaired) {
    EXPECT_EQ(repaired.source_point.size(), repaired.soup.points.size());
    EXPECT_EQ(repaired.copies, repaired.soup.points.size() - soup.points.size());
    for (std::size_t v = 0; v < repaired.source_point.size(); ++v) {
        EXPECT_EQ(repaired.soup.points[v], soup.points[repaired.source_point[v]]);
        if (v < soup.points.size()) {
            EXPECT_EQ(repaired.source_point[v], v);
        }
    }
    if (!repaired.is_changed()) return half_edge_mesh(soup);  // two triangles back to back are sound
    EXPECT_EQ(places(repaired.soup, repaired.source_point), proper(soup));
    EXPECT_EQ(soup.triangles.size() - repaired.soup.triangles.size(),
              repaired.degenerate + repaired.duplicate);
    return half_edge_mesh(repaired.soup);
}

TEST(OrientSoup, leaves_sound_meshes_as_they_are) {
    for (const auto& shapes : {shapes::solids(), shapes::open_surfaces()})
        for (const auto& [name, soup] : shapes) {
            const OrientedSoup repaired = orient_soup(soup);
            EXPECT_FALSE(repaired.is_changed()) << name;
            EXPECT_EQ(repaired.soup.points, soup.points) << name;
            EXPECT_EQ(repaired.soup.triangles, soup.triangles) << name;
        }
    EXPECT_FALSE(orient_soup({}).is_changed());
}

TEST(OrientSoup, a_moebius_strip_becomes_a_band_cut_open) {
    const TriangleSoup strip = shapes::mobius(20);
    const OrientedSoup repaired = orient_soup(strip);
    const TriMesh mesh = checked_mesh(strip, repaired);
    const MeshReport report = analyze(mesh, {.self_intersections = false});
    EXPECT_EQ(report.euler, 1);  // a disc; the strip has 0
    EXPECT_EQ(report.boundary_loops, 1u);
    EXPECT_EQ(report.components, 1u);
    EXPECT_EQ(repaired.copies, 2u);  // the ends of one rung
    EXPECT_TRUE(report.oriented);
}

TEST(OrientSoup, a_wide_moebius_strip_is_cut_across) {
    TriangleSoup strip;  // 60 cells around, 8 across; the last ones meet the first ones upside down
    constexpr std::uint32_t kAround = 60, kAcross = 8;
    for (std::uint32_t i = 0; i < kAround; ++i)
        for (std::uint32_t j = 0; j <= kAcross; ++j) strip.points.push_back({double(i), double(j), 0});
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
        return i < kAround ? i * (kAcross + 1) + j : kAcross - j;
    };
    for (std::uint32_t i = 0; i < kAround; ++i)
        for (std::uint32_t j = 0; j < kAcross; ++j)
            shapes::quad(strip, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    const OrientedSoup repaired = orient_soup(strip);
    const MeshReport report = analyze(checked_mesh(strip, repaired), {.self_intersections = false});
    EXPECT_EQ(report.euler, 1);
    EXPECT_EQ(report.boundary_loops, 1u);
    EXPECT_LE(repaired.copies, 2 * kAcross + 1);  // 9 if the cut ran straight
    EXPECT_GT(repaired.copies, kAcross);
}

TEST(OrientSoup, turned_triangles_follow_the_majority) {
    TriangleSoup soup = shapes::joined(shapes::torus(3, 1, 12, 8), shapes::moved(shapes::cube(), 9, 0, 0));
    std::mt19937 random(5);
    std::size_t turned = 0;
    for (auto& triangle : soup.triangles)
        if (random() % 3 == 0) {
            std::swap(triangle[0], triangle[1]);
            ++turned;
        }
    const OrientedSoup repaired = orient_soup(soup);
    const auto parts = connected_components(triangle_soup(checked_mesh(soup, repaired)));
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_GT(volume(parts[0]), 0);
    EXPECT_GT(volume(parts[1]), 0);
    EXPECT_EQ(repaired.turned, turned);
    EXPECT_EQ(repaired.copies, 0u);
}

TEST(OrientSoup, three_sheets_at_an_edge_are_cut_apart) {
    TriangleSoup book;
    book.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
    book.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
    EXPECT_THROW(half_edge_mesh(book), InvalidInput);
    const OrientedSoup repaired = orient_soup(book);
    EXPECT_EQ(connected_components(triangle_soup(checked_mesh(book, repaired))).size(), 3u);
    EXPECT_EQ(repaired.copies, 4u);
}

TEST(OrientSoup, two_cubes_at_a_corner_part_there) {
    TriangleSoup soup = shapes::cube();
    const TriangleSoup other = shapes::moved(shapes::cube(), 1, 1, 1);
    for (const auto& p : other.points)
        if (!(p == soup.points[6])) soup.points.push_back(p);
    for (const auto& t : other.triangles) {
        Triangle named{};
        for (int k = 0; k < 3; ++k)
            named[k] = static_cast<std::uint32_t>(std::ranges::find(soup.points, other.points[t[k]]) -
                                                  soup.points.begin());
        soup.triangles.push_back(named);
    }
    EXPECT_THROW(half_edge_mesh(soup), InvalidInput);
    const OrientedSoup repaired = orient_soup(soup);
    EXPECT_NEAR(volume(checked_mesh(soup, repaired)), 2, 1e-12);
    EXPECT_EQ(repaired.copies, 1u);
}

TEST(OrientSoup, drops_triangles_without_three_corners_and_repeated_ones) {
    TriangleSoup soup = shapes::cube();
    soup.triangles.push_back({0, 0, 1});
    soup.triangles.push_back(soup.triangles[3]);
    soup.triangles.push_back({soup.triangles[5][1], soup.triangles[5][0], soup.triangles[5][2]});
    const OrientedSoup repaired = orient_soup(soup);
    EXPECT_EQ(repaired.degenerate, 1u);
    EXPECT_EQ(repaired.duplicate, 2u);
    EXPECT_EQ(repaired.soup.triangles, shapes::cube().triangles);
    soup.triangles.push_back({0, 1, 99});
    EXPECT_THROW(orient_soup(soup), InvalidInput);
}

TEST(OrientSoup, makes_a_mesh_of_any_triangles) {
    std::mt19937 random(11);
    for (int round = 0; round < 3000; ++round) {
        TriangleSoup soup;
        const auto points = 4 + random() % 8;
        for (std::uint32_t v = 0; v < points; ++v) soup.points.push_back({double(v), double(v * v % 7), 1});
        for (auto t = random() % 30; t > 0; --t)
            soup.triangles.push_back({static_cast<std::uint32_t>(random() % points),
                                      static_cast<std::uint32_t>(random() % points),
                                      static_cast<std::uint32_t>(random() % points)});
        ASSERT_NO_THROW(checked_mesh(soup, orient_soup(soup))) << round;
    }
}

}  // namespace
}  // namespace stratareeb
