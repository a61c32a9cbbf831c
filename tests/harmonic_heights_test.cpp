// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/harmonic_heights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reeb/link_signs.h"

namespace stratareeb {
namespace {

//! Squares of side 1, each as two triangles.
TriangleSoup strip(std::uint32_t columns, std::uint32_t rows) {
    TriangleSoup soup;
    for (std::uint32_t r = 0; r <= rows; ++r)
        for (std::uint32_t c = 0; c <= columns; ++c) soup.points.push_back({double(c), double(r), 0});
    for (std::uint32_t r = 0; r < rows; ++r)
        for (std::uint32_t c = 0; c < columns; ++c) {
            const std::uint32_t v = r * (columns + 1) + c, w = v + columns + 1;
            soup.triangles.push_back({v, v + 1, w + 1});
            soup.triangles.push_back({v, w + 1, w});
        }
    return soup;
}

TEST(HarmonicHeights, of_a_plane_are_the_plane) {
    TriangleSoup soup = strip(7, 5);
    std::vector<std::optional<double>> given(soup.points.size());
    const auto plane = [](const Point3& p) { return 3 + 2 * p.x - 0.5 * p.y; };
    for (std::size_t v = 0; v < given.size(); ++v) {
        const Point3& p = soup.points[v];
        if (p.x == 0 || p.x == 7 || p.y == 0 || p.y == 5) given[v] = plane(p);
    }
    const auto found = harmonic_heights(soup, given);
    ASSERT_TRUE(found);
    // Diagonals have the weight 0, raised to a small one: they are as good as none.
    for (std::size_t v = 0; v < given.size(); ++v) EXPECT_NEAR((*found)[v], plane(soup.points[v]), 1e-9);
}

// A bay 60 times as long as wide: heights in it differ from its shore's by less than rounding.
TEST(HarmonicHeights, keep_their_order_in_deep_bays) {
    TriangleSoup soup = strip(4, 120);
    std::vector<std::optional<double>> given(soup.points.size());
    for (std::size_t v = 0; v < given.size(); ++v) {
        const Point3& p = soup.points[v];
        if (p.y == 120)
            given[v] = 2450.5;
        else if (p.x == 0 || p.x == 4 || p.y == 0)
            given[v] = 2400.5;
    }
    std::vector<bool> inner(given.size());
    for (std::size_t v = 0; v < given.size(); ++v) inner[v] = !given[v];
    const auto regular = [&](double stretched) {
        const auto found = harmonic_heights(soup, given, stretched);
        for (std::size_t v = 0; v < given.size(); ++v) soup.points[v].z = (*found)[v];
        std::size_t count = 0;
        const auto signs = link_signs(soup, inner);
        for (std::size_t v = 0; v < given.size(); ++v)
            if (inner[v] && signs[v] == 2 && soup.points[v].z > 2400.5) ++count;
        return count;
    };
    const auto all = static_cast<std::size_t>(std::ranges::count(inner, true));
    EXPECT_LT(regular(0), all) << "what the stretch is for";
    EXPECT_EQ(regular(0.05), all);
}

TEST(HarmonicHeights, need_two_heights) {
    TriangleSoup soup = strip(2, 2);
    EXPECT_FALSE(harmonic_heights(soup, std::vector<std::optional<double>>(9)));
    EXPECT_FALSE(harmonic_heights(soup, {1, 1, 1, 1, {}, 1, 1, 1, 1}));
}

}  // namespace
}  // namespace stratareeb
