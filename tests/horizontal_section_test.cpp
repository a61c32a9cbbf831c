// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/horizontal_section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/analysis.h"
#include "mesh/model_column.h"
#include "mesh/ring_stitching.h"
#include "reeb/contour_nesting.h"
#include "reeb/level_set.h"
#include "tests/random_model.h"

namespace stratareeb {
namespace {

using test::random_model;

std::array<double, 2> range_of(const LayerModel& model) {
    return {*std::ranges::min_element(model.horizons.back()) + model.origin.z,
            *std::ranges::max_element(model.horizons.front()) + model.origin.z};
}

std::vector<double> areas_of(const LayerModel& model, const std::vector<LevelPolygon>& polygons) {
    std::vector<double> areas(model.units.size(), 0);
    for (const LevelPolygon& polygon : polygons) areas[polygon.layer] += area(polygon);
    return areas;
}

// The other way: the area that each solid's own contours enclose.
TEST(HorizontalSection, is_the_level_s_intersection_with_the_solids) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(seed);
        const LayerModel model = random_model(seed);
        const auto [low, high] = range_of(model);
        std::vector<double> levels;
        for (int k = 1; k < 12; ++k) levels.push_back(low + (high - low) * (k + 0.123) / 12);
        for (const double z : levels) {
            const auto areas = areas_of(model, horizontal_section(model, z));
            for (std::size_t layer = 0; layer < model.units.size(); ++layer) {
                const TriMesh solid = build_layer_solid(model, layer).surface;
                if (solid.n_faces() == 0) continue;
                const auto sets = level_sets(solid, height_field(solid), std::array{z - model.origin.z});
                EXPECT_NEAR(areas[layer], enclosed_area(sets[0], nest_contours(sets[0])), 1e-7 * 300 * 300);
            }
        }
    }
}

TEST(HorizontalSection, rings_are_wound_as_said_at_vertex_heights_too) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(seed);
        const LayerModel model = random_model(seed);
        const auto [low, high] = range_of(model);
        for (double z : {std::floor((low + high) / 2), model.horizons[1][0] + model.origin.z,
                         model.horizons[2][5] + model.origin.z}) {
            for (const LevelPolygon& polygon : horizontal_section(model, z)) {
                EXPECT_GT(ring_area(polygon.rings[0]), 0);
                for (std::size_t i = 1; i < polygon.rings.size(); ++i)
                    EXPECT_LT(ring_area(polygon.rings[i]), 0);
                EXPECT_GT(area(polygon), 0);
                for (const auto& ring : polygon.rings) EXPECT_GE(ring.size(), 3u);
            }
        }
    }
}

TEST(HorizontalSection, says_at_every_place_what_a_column_says) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        SCOPED_TRACE(seed);
        const LayerModel model = random_model(seed);
        const ColumnQuery query(model);
        const auto [low, high] = range_of(model);
        const double z = low + 0.617 * (high - low);
        const auto polygons = horizontal_section(model, z);
        for (double x = 3.17; x < 300; x += 11.3)
            for (double y = 2.71; y < 300; y += 12.7) {
                const auto column = query.column({x, y});
                ASSERT_TRUE(column);
                const bool near_border = std::ranges::any_of(
                    column->horizons, [&](double horizon) { return std::abs(horizon - z) < 1e-6; });
                if (near_border) continue;
                std::vector<std::size_t> layers;
                for (const LevelPolygon& polygon : polygons)
                    if (is_inside(polygon.rings, {x, y})) layers.push_back(polygon.layer);
                const auto layer = column->layer_at(z);
                EXPECT_EQ(layers, layer ? std::vector<std::size_t>{*layer} : std::vector<std::size_t>{});
            }
    }
}

// Area is quadratic in z between the heights of vertices, where Simpson's rule is exact.
TEST(HorizontalSection, areas_integrate_to_the_volumes_of_layers) {
    const LayerModel model = build_layer_model(
        random_survey({.holes = 6, .layers = 3, .seed = 2, .pinch_outs = true}), {.spacing = 0.0});
    std::vector<double> heights;
    for (const auto& horizon : model.horizons)
        for (const double z : horizon) heights.push_back(z + model.origin.z);
    std::ranges::sort(heights);
    std::vector<double> sums(model.units.size(), 0);
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
        const double a = heights[i], b = heights[i + 1];
        if (b - a < 1e-9) continue;
        const double inner = 1e-9 * (b - a);
        const auto low = areas_of(model, horizontal_section(model, a + inner));
        const auto middle = areas_of(model, horizontal_section(model, (a + b) / 2));
        const auto high = areas_of(model, horizontal_section(model, b - inner));
        for (std::size_t k = 0; k < sums.size(); ++k)
            sums[k] += (b - a) / 6 * (low[k] + 4 * middle[k] + high[k]);
    }
    for (std::size_t k = 0; k < sums.size(); ++k)
        EXPECT_NEAR(sums[k], volume(build_layer_solid(model, k).surface), 1e-6 * envelope_volume(model));
}

TEST(RingStitching, keeps_rings_apart_that_meet_in_a_point) {
    // Two squares that share a corner.
    const std::vector<Point2> points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {4, 2}, {4, 4}, {2, 4}};
    std::vector<std::array<std::uint32_t, 2>> borders{{0, 1}, {1, 2}, {2, 3}, {3, 0},
                                                      {2, 4}, {4, 5}, {5, 6}, {6, 2}};
    const auto rings = stitch_rings(points, borders);
    ASSERT_EQ(rings.size(), 2u);
    for (const auto& ring : rings) {
        EXPECT_EQ(ring.size(), 4u);
        std::vector<Point2> outline;
        for (const auto p : ring) outline.push_back(points[p]);
        EXPECT_EQ(ring_area(outline), 4);
    }
}

TEST(RingStitching, a_hole_belongs_to_the_smallest_ring_around_it) {
    const auto square = [](double low, double high, bool hole) {
        std::vector<Point2> ring{{low, low}, {high, low}, {high, high}, {low, high}};
        if (hole) std::ranges::reverse(ring);
        return ring;
    };
    const auto nested =
        nest_rings({square(3, 7, true), square(0, 10, false), square(4, 6, false), square(4.5, 5.5, true)});
    ASSERT_EQ(nested.size(), 2u);
    ASSERT_EQ(nested[0].size(), 2u);
    EXPECT_EQ(nested[0][1].front().x, 3);
    ASSERT_EQ(nested[1].size(), 2u);
    EXPECT_EQ(nested[1][1].front().x, 4.5);
}

}  // namespace
}  // namespace stratareeb
