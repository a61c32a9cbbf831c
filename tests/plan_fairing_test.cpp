// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/plan_fairing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/shapes.h"

namespace stratareeb {
namespace {

double roughness(const TriangleSoup& soup) {  // of a sphere of radius 2
    double sum = 0;
    for (const Point3& p : soup.points) sum += std::pow(std::hypot(p.x, p.y) - std::sqrt(4 - p.z * p.z), 2);
    return sum;
}

TEST(FairInPlan, takes_bends_out_and_leaves_heights_and_what_is_not_free) {
    std::mt19937_64 random(81);
    TriangleSoup soup = shapes::uv_sphere(2, 40, 60);
    const TriangleSoup smooth = soup;
    std::vector<bool> is_free(soup.points.size());
    for (std::size_t v = 0; v < is_free.size(); ++v) {
        is_free[v] = std::abs(soup.points[v].z) < 1;
        if (!is_free[v]) continue;
        soup.points[v].x += 0.05 * (static_cast<double>(random() % 1000) / 1000 - 0.5);
        soup.points[v].y += 0.05 * (static_cast<double>(random() % 1000) / 1000 - 0.5);
    }
    const double before = roughness(soup);
    const TriangleSoup rough = soup;
    fair_in_plan(soup, is_free, 10);
    EXPECT_LT(roughness(soup), before / 4);
    for (std::size_t v = 0; v < is_free.size(); ++v) {
        EXPECT_EQ(soup.points[v].z, smooth.points[v].z);
        EXPECT_TRUE(is_free[v] || soup.points[v] == smooth.points[v]);
    }
    TriangleSoup same = rough;
    fair_in_plan(same, is_free, 0);
    EXPECT_EQ(same.points, rough.points);
}

TEST(FairInPlan, keeps_sizes) {
    TriangleSoup soup = shapes::uv_sphere(2, 40, 60);
    fair_in_plan(soup, std::vector<bool>(soup.points.size(), true), 20);
    EXPECT_LT(roughness(soup) / static_cast<double>(soup.points.size()), 1e-4);
}

}  // namespace
}  // namespace stratareeb
