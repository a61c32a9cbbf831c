// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/point_run_tree.h"

#include <gtest/gtest.h>

#include "tests/band_cases.h"

namespace stratareeb {
namespace {

using namespace band_cases;

double distance_to_line(const Point3& p, const Point3& place, const Point3& direction) {
    const Point3 d{p.x - place.x, p.y - place.y, p.z - place.z};
    if (direction == Point3{}) return std::hypot(d.x, d.y, d.z);
    return std::hypot(d.y * direction.z - d.z * direction.y, d.z * direction.x - d.x * direction.z,
                      d.x * direction.y - d.y * direction.x);
}

void expect_bounds(const Points& points, std::mt19937& random) {
    std::normal_distribution<double> normal;
    const PointRunTree tree(points);
    for (int query = 0; query < 50; ++query) {
        const Point3 place{normal(random), normal(random), normal(random)};
        Point3 direction;
        if (query % 2) {
            direction = {normal(random), normal(random), normal(random)};
            const double length = std::hypot(direction.x, direction.y, direction.z);
            direction = {direction.x / length, direction.y / length, direction.z / length};
        }
        double nearest = std::numeric_limits<double>::infinity();
        for (const Point3& p : points) nearest = std::min(nearest, distance_to_line(p, place, direction));
        const auto guess = static_cast<std::uint32_t>(random() % points.size());
        EXPECT_NEAR(tree.distance(place, direction, guess, 0), nearest, 1e-12);
        const double bound = tree.distance(place, direction, guess, 0.1);
        EXPECT_LE(bound, nearest + 1e-12);
        EXPECT_GE(bound, 0.9 * nearest - 1e-12);
    }
}

TEST(PointRunTree, bounds_the_distance_of_the_nearest_point_from_below_and_closely) {
    std::mt19937 random(1);
    for (const std::size_t count : {1, 2, 8, 9, 17, 100, 1000}) {
        expect_bounds(wobbly_circle(count, 1, 0.5, 0.2, 0.05, random), random);
        expect_bounds(grid_points(count, 3, random), random);
        expect_bounds(Points(count, {1, 1, 1}), random);
    }
}

}  // namespace
}  // namespace stratareeb
