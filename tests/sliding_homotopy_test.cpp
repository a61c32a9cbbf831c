// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/sliding_homotopy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "boreholes/errors.h"
#include "reeb/correspondence.h"
#include "tests/curve_cases.h"

namespace stratareeb {
namespace {

using curve_cases::expect_near;
using curve_cases::Random;
using curve_cases::through;
using curve_cases::wavy_ring;

ContourHomotopy random_homotopy(Random& random, std::size_t n, const HomotopyOptions& options) {
    std::vector<SampledContour> contours;
    std::vector<double> heights;
    double z = 0;
    for (std::size_t i = 0; i < n; ++i) {
        auto ring = wavy_ring(random, 40, z);
        const double x = random.uniform(-0.5, 0.5);
        for (auto& p : ring) p.x += x;
        contours.push_back(contour_by_perimeter(ring));
        heights.push_back(z);
        z += random.uniform(0.5, 1);
    }
    return {corresponding_contours(std::move(contours)), heights, options};
}

//! An edge that winds and reaches from below -1 to 20.
MonotoneEdge winding_edge(Random& random, CurveKind kind = CurveKind::Cardinal) {
    std::vector<Point3> points;
    for (int i = -2; i <= 20; ++i)
        points.push_back({random.uniform(-1, 1), random.uniform(-1, 1), double(i)});
    return MonotoneEdge(through(kind, points));
}

TEST(SlidingHomotopy, weight_is_as_printed_and_vanishes_with_its_slope) {
    for (double t = 0; t <= 1; t += 0.01) {
        EXPECT_NEAR(sliding_weight(t), 0.5 * (1 - std::cos(2 * std::numbers::pi * t)), 1e-15);
        EXPECT_GE(sliding_weight(t), 0);
        EXPECT_LE(sliding_weight(t), 1);
    }
    EXPECT_EQ(sliding_weight(0), 0);
    EXPECT_EQ(sliding_weight(1), 0);
    EXPECT_LT(sliding_weight(1e-6) / 1e-6, 1e-4);
    EXPECT_LT(sliding_weight(1 - 1e-6) / 1e-6, 1e-4);
}

TEST(SlidingHomotopy, slide_and_its_slope_vanish_at_the_given_contours) {
    Random random(1);
    for (int round = 0; round < 20; ++round) {
        const SlidingHomotopy SH(random_homotopy(random, 5, {}), winding_edge(random));
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_EQ(SH.sliding_vector(i, 0), Point3{});
            EXPECT_EQ(SH.sliding_vector(i, 1), Point3{});
            const double h = 1e-5;
            EXPECT_LT(magnitude(SH.sliding_vector(i, h)) / h, 1e-3);
            EXPECT_LT(magnitude(SH.sliding_vector(i, 1 - h)) / h, 1e-3);
            EXPECT_EQ(SH.contour(i, 0).points, SH.homotopy().contours()[i].points);
            EXPECT_EQ(SH.contour(i, 1).points, SH.homotopy().contours()[i + 1].points);
        }
    }
}

TEST(SlidingHomotopy, slides_by_the_formula_and_stays_level) {
    Random random(2);
    const auto edge = winding_edge(random);
    const SlidingHomotopy SH(random_homotopy(random, 4, {.kind = HomotopyKind::Cardinal}), edge);
    const auto& H = SH.homotopy();
    for (std::size_t i = 0; i < 3; ++i) {
        for (double t = 0.1; t < 1; t += 0.1) {
            const Point3 ev = edge.at(H.level(i, t)) - edge.at(H.level(i, 0));
            Point3 hv;
            const auto s = even_parameters(10000);
            const auto moved = H.contour_at(s, i, t), start = H.contour_at(s, i, 0);
            for (std::size_t k = 0; k < s.size(); ++k) hv += 1e-4 * (moved[k] - start[k]);
            expect_near(SH.sliding_vector(i, t), sliding_weight(t) * (ev - hv), 1e-5);
            for (const auto& p : SH.contour(i, t).points) EXPECT_EQ(p.z, H.level(i, t));
        }
    }
}

TEST(SlidingHomotopy, is_smooth_across_contours) {
    Random random(3);
    for (int round = 0; round < 20; ++round) {
        const SlidingHomotopy SH(random_homotopy(random, 5, {}), winding_edge(random));
        const auto& z = SH.homotopy().places();
        for (std::size_t i = 0; i + 1 < 4; ++i) {
            const double s = random.uniform(0, 1), h = 1e-6;
            const Point3 at = SH.at(s, i, 1);
            const Point3 before = (1 / (h * (z[i + 1] - z[i]))) * (at - SH.at(s, i, 1 - h));
            const Point3 after = (1 / (h * (z[i + 2] - z[i + 1]))) * (SH.at(s, i + 1, h) - at);
            expect_near(before, after, 2e-3);
        }
    }
}

TEST(SlidingHomotopy, an_edge_through_the_middles_of_the_homotopy_changes_nothing) {
    Random random(4);
    const auto H = random_homotopy(random, 2, {.kind = HomotopyKind::Linear});
    const Curve middle = through(CurveKind::Polyline, {H.mean(0, 0), H.mean(0, 1)});
    const SlidingHomotopy SH(H, MonotoneEdge(middle));
    for (double t = 0; t <= 1; t += 0.1) expect_near(SH.sliding_vector(0, t), {}, 1e-12);
}

TEST(SlidingHomotopy, different_edges_give_different_shapes_and_their_place_does_not_matter) {
    Random random(5);
    const auto H = random_homotopy(random, 2, {.kind = HomotopyKind::Linear});
    const double top = H.levels()[1];
    const auto bent = [&](double by, double x) {
        return MonotoneEdge(through(CurveKind::Cardinal, {{x, 0, 0}, {x + by, 0, top / 2}, {x, 0, top}}));
    };
    const SlidingHomotopy left(H, bent(-1, 0)), right(H, bent(1, 0)), right_elsewhere(H, bent(1, 77));
    EXPECT_LT(left.sliding_vector(0, 0.5).x, right.sliding_vector(0, 0.5).x - 1.9);
    expect_near(right.sliding_vector(0, 0.3), right_elsewhere.sliding_vector(0, 0.3), 1e-12);
}

TEST(SlidingHomotopy, all_contours_at_once_and_falling_edges) {
    Random random(6);
    const auto edge = winding_edge(random);
    Curve turned = edge.curve().curve();
    std::reverse(turned.points.begin(), turned.points.end());
    const auto H = random_homotopy(random, 4, {});
    const SlidingHomotopy SH(H, edge), falling(H, MonotoneEdge(turned));
    const auto between = SH.contours_between(1, 7), other = falling.contours_between(1, 7);
    ASSERT_EQ(between.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(between[i].points, SH.contour(1, static_cast<double>(i + 1) / 7).points);
        expect_near(between[i].points[5], other[i].points[5], 1e-9,
                    "it does not matter which way the edge is drawn");
    }
}

TEST(SlidingHomotopy, an_edge_that_does_not_reach_the_contours_is_refused) {
    Random random(7);
    const auto H = random_homotopy(random, 3, {});
    EXPECT_THROW(SlidingHomotopy(H, MonotoneEdge(through(CurveKind::Polyline, {{0, 0, 0.1}, {0, 0, 9}}))),
                 InvalidInput);
    EXPECT_THROW(SlidingHomotopy(H, MonotoneEdge(through(CurveKind::Polyline, {{0, 0, -1}, {0, 0, 0.5}}))),
                 InvalidInput);
}

}  // namespace
}  // namespace stratareeb
