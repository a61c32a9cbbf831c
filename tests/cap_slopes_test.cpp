// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/cap_slopes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "io/read_enhanced_graph.h"
#include "reeb/point_math.h"
#include "reeb/surface_construction.h"

namespace stratareeb {
namespace {

constexpr std::size_t kPoints = 720;

double angle_of(std::size_t i) {
    return 2 * std::numbers::pi * static_cast<double>(i) / kPoints;
}

// A circle that grows by a in x and by b in y a unit of height: by a cos^2 + b sin^2 outward, however its points slide along it.
TEST(CapSlopes, are_those_of_the_tangent_plane_at_each_point) {
    const double a = 0.8, b = -0.1, share = 1e-4;
    std::vector<Point3> circle, beside;
    for (std::size_t i = 0; i < kPoints; ++i) {
        const double x = std::cos(angle_of(i)), y = std::sin(angle_of(i)),
                     slide = 3 * share * std::sin(5 * angle_of(i));
        circle.push_back({x, y, 1});
        beside.push_back({x + share * a * x - slide * y, y + share * b * y + slide * x, 1 + share});
    }
    const auto slopes = cap_slopes(circle, std::vector<Point3>(kPoints, Point3{0, 0, 0}), beside, share);
    for (std::size_t i = 0; i < kPoints; ++i) {
        const double c = std::cos(angle_of(i)), s = std::sin(angle_of(i));
        EXPECT_NEAR(slopes[i], a * c * c + b * s * s, 0.001);
    }
}

TEST(CapSlopes, are_one_for_all_where_a_contour_cannot_be_seen_whole) {
    const std::vector<Point3> hook{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {0, 1, 0}};
    std::vector<Point3> beside = hook;
    for (Point3& p : beside) p = {1.01 * p.x, 1.02 * p.y, 0.01};
    const auto slopes =
        cap_slopes(hook, std::vector<Point3>(hook.size(), Point3{0.1, 0.5, -1}), beside, 0.01);
    EXPECT_EQ(std::ranges::adjacent_find(slopes, std::ranges::not_equal_to{}), slopes.end());
    EXPECT_GT(slopes[0], 0.5);
}

//! By height of level edges: the largest angle between the two triangles there, degrees.
std::map<double, double> bends_at_level_edges(const TriangleSoup& soup) {
    const auto normal = [&](const std::array<std::uint32_t, 3>& t) {
        const Point3 u = soup.points[t[1]] - soup.points[t[0]], v = soup.points[t[2]] - soup.points[t[0]];
        const Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
        return 1 / magnitude(n) * n;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, Point3> seen;
    std::map<double, double> bends;
    for (const auto& t : soup.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            if (soup.points[a].z != soup.points[b].z) continue;
            const auto other = seen.find({b, a});
            if (other == seen.end()) {
                seen.emplace(std::pair(a, b), normal(t));
                continue;
            }
            const double cosine = std::clamp(dot_product(other->second, normal(t)), -1.0, 1.0);
            double& most = bends[soup.points[a].z];
            most = std::max(most, std::acos(cosine) * 180 / std::numbers::pi);
        }
    return bends;
}

// Tangent planes agree where a cap begins, so the angle there goes to 0 with the bands' height. The first contour of these graphs is round and
// the second three times as long as wide: one slope for all would leave 40 degrees.
TEST(CapSlopes, leave_no_crease_where_caps_begin) {
    for (const auto& [name, z] : {std::pair{"torus", 0.4}, {"torus", 7.6}, {"double_torus", 0.4}}) {
        const auto graph =
            read_enhanced_graph(std::string(STRATAREEB_SOURCE_DIR) + "/examples/graphs/" + name + ".json");
        const auto bend = [&, z = z](std::size_t steps) {
            return bends_at_level_edges(construct_surface(graph, {.steps = steps}).soup).at(z);
        };
        const double coarse = bend(12), fine = bend(48);
        EXPECT_LT(fine, 6) << name << " at " << z;
        EXPECT_LT(fine, 0.5 * coarse) << name << " at " << z;
    }
}

}  // namespace
}  // namespace stratareeb
