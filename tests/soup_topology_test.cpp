// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/soup_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/shapes.h"

namespace stratareeb {
namespace {

std::vector<std::uint32_t> further(const TriangleSoup& soup) {
    return corners_in_further_fans(soup, soup_topology(soup));
}

TEST(SoupTopology, sound_surfaces_have_one_fan_at_each_vertex) {
    for (const auto& shape : shapes::solids()) EXPECT_TRUE(further(shape.soup).empty()) << shape.name;
    for (const auto& shape : shapes::open_surfaces()) EXPECT_TRUE(further(shape.soup).empty()) << shape.name;
}

//! As many copies of a sphere as meet in one vertex, less one, are further fans: all corners there but those of the first.
TEST(SoupTopology, surfaces_that_meet_in_a_vertex_have_a_fan_each_there) {
    const TriangleSoup sphere = shapes::uv_sphere(1, 6, 8);
    std::size_t around = 0;  // vertex 0
    for (const auto& t : sphere.triangles) around += std::ranges::count(t, 0u);
    std::mt19937 random(3);
    for (std::size_t copies = 1; copies < 5; ++copies) {
        TriangleSoup soup;
        for (std::size_t i = 0; i < copies; ++i) soup = shapes::joined(soup, sphere);
        for (auto& t : soup.triangles)
            for (std::uint32_t& v : t)
                if (v % sphere.points.size() == 0) v = 0;
        std::ranges::shuffle(soup.triangles, random);
        const auto corners = further(soup);
        EXPECT_EQ(corners.size(), (copies - 1) * around);
        EXPECT_TRUE(std::ranges::is_sorted(corners));
        for (const std::uint32_t corner : corners) EXPECT_EQ(vertex_at(soup, corner), 0u);
    }
}

TEST(SoupTopology, triangles_that_name_a_vertex_twice_make_no_fans) {
    TriangleSoup soup = shapes::uv_sphere(1, 6, 8);
    soup.triangles.insert(soup.triangles.begin(), {0, 0, 1});
    EXPECT_TRUE(further(soup).empty());
}

}  // namespace
}  // namespace stratareeb
