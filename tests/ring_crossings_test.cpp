// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/ring_crossings.h"

#include <gtest/gtest.h>

#include <random>

namespace stratareeb {
namespace {

using Rings = std::vector<std::vector<Point2>>;

std::vector<Point2> square(double x, double y, double size) {
    return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

TEST(RingCrossings, of_rings_apart_and_nested_are_none) {
    EXPECT_TRUE(ring_crossings(Rings{}).empty());
    EXPECT_TRUE(
        ring_crossings(Rings{square(0, 0, 10), square(2, 2, 3), square(6, 6, 2), square(20, 0, 1)}).empty());
}

TEST(RingCrossings, say_which_edges_and_where) {
    const auto found = ring_crossings(Rings{square(0, 0, 10), {{5, 5}, {15, 5}, {15, 6}, {5, 6}}});
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0], (RingCrossing{0, 1, 1, 0, {10, 0}}));
    EXPECT_EQ(found[1].other_edge, 2u);
    EXPECT_EQ(ring_crossings(Rings{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}).size(), 1u) << "a bow tie";
    EXPECT_EQ(ring_crossings(Rings{square(0, 0, 10), square(0, 0, 10)}, {.most = 1}).size(), 1u);
}

TEST(RingCrossings, find_spikes_and_touches) {
    EXPECT_FALSE(ring_crossings(Rings{{{0, 0}, {4, 0}, {4, 4}, {4, 6}, {4, 4}, {0, 4}}}).empty())
        << "a spike";
    EXPECT_FALSE(ring_crossings(Rings{{{0, 0}, {1, 0}}}).empty()) << "there and back";
    const Rings at_corner{square(0, 0, 1), square(1, 1, 1)};
    EXPECT_FALSE(ring_crossings(at_corner).empty());
    EXPECT_TRUE(ring_crossings(at_corner, {.shared_corners = true}).empty());
    // A corner on the inside of an edge is a touch all the same.
    EXPECT_FALSE(ring_crossings(Rings{square(0, 0, 2), square(2, 0.5, 1)}, {.shared_corners = true}).empty());
    // Shared corners don't excuse edges that lie on one another.
    EXPECT_FALSE(ring_crossings(Rings{square(0, 0, 1), square(1, 0, 1)}, {.shared_corners = true}).empty());
}

double cross(const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool meet(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    const auto on = [](const Point2& p, const Point2& q, const Point2& r) {
        return cross(p, q, r) == 0 && std::min(p.x, q.x) <= r.x && r.x <= std::max(p.x, q.x) &&
               std::min(p.y, q.y) <= r.y && r.y <= std::max(p.y, q.y);
    };
    if (on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b)) return true;
    return (cross(a, b, c) > 0) != (cross(a, b, d) > 0) && (cross(c, d, a) > 0) != (cross(c, d, b) > 0);
}

// Small whole coordinates: all decisions are exact in doubles, and touches and overlaps are frequent.
TEST(RingCrossings, agree_with_looking_at_every_pair) {
    std::mt19937_64 random(41);
    int sound = 0;
    for (int round = 0; round < 3000; ++round) {
        Rings rings(1 + random() % 2);
        for (auto& ring : rings)
            for (std::size_t k = 3 + random() % 3; k > 0; --k)
                ring.push_back({static_cast<double>(random() % 9), static_cast<double>(random() % 9)});
        bool any = false;
        for (std::size_t r = 0; r < rings.size(); ++r)
            for (std::size_t i = 0; i < rings[r].size(); ++i)
                for (std::size_t s = r; s < rings.size(); ++s)
                    for (std::size_t j = s == r ? i + 1 : 0; j < rings[s].size(); ++j) {
                        const auto n = rings[r].size();
                        const Point2 &a = rings[r][i], &b = rings[r][(i + 1) % n], &c = rings[s][j],
                                     &d = rings[s][(j + 1) % rings[s].size()];
                        if (!meet(a, b, c, d)) continue;
                        // Neighbours meet in their corner, and may meet in no other point.
                        if (r == s && j == i + 1)
                            any |= cross(a, b, d) == 0 &&
                                   (a.x - b.x) * (d.x - b.x) + (a.y - b.y) * (d.y - b.y) >= 0;
                        else if (r == s && i == 0 && j == n - 1)
                            any |= cross(c, a, b) == 0 &&
                                   (c.x - a.x) * (b.x - a.x) + (c.y - a.y) * (b.y - a.y) >= 0;
                        else
                            any = true;
                    }
        ASSERT_EQ(!ring_crossings(rings).empty(), any) << "round " << round;
        sound += !any;
    }
    EXPECT_GT(sound, 300);
}

}  // namespace
}  // namespace stratareeb
