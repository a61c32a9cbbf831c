// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/monotone_edge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "boreholes/errors.h"
#include "tests/curve_cases.h"

namespace stratareeb {
namespace {

using curve_cases::circle;
using curve_cases::expect_near;
using curve_cases::Random;
using curve_cases::through;

//! Control points that rise, by steps that differ a lot: the curve between them may not.
std::vector<Point3> rising_points(Random& random, double contrast) {
    auto points = random.points(2 + random.below(6));
    double z = random.uniform(-5, 5);
    for (auto& p : points) {
        p.z = z;
        z += std::exp(random.uniform(-contrast, contrast));
    }
    return points;
}

//! Height lost on the way up, at many places of each piece.
double largest_drop(const ParametricCurve& f, int samples) {
    double drop = 0, highest = f.at(0).z;
    const int count = static_cast<int>(f.pieces()) * samples;
    for (int i = 1; i <= count; ++i) {
        const double z = f.at(static_cast<double>(i) / count).z;
        drop = std::max(drop, highest - z);
        highest = std::max(highest, z);
    }
    return drop;
}

TEST(MonotoneEdge, agrees_with_dense_sampling_on_thousands_of_curves) {
    Random random(1);
    int turned_back = 0, risen = 0, undecided = 0;
    for (int round = 0; round < 6000; ++round) {
        Curve curve = through(round % 2 == 0 ? CurveKind::Cardinal : CurveKind::CatmullRom,
                              rising_points(random, random.uniform(0, 3)));
        curve.tension = random.uniform(0, 1.5);
        curve.a = random.uniform(0, 1);
        curve.b = random.uniform(0, 1);
        const ParametricCurve f(curve);
        const auto found = z_monotonicity(f);
        const double drop = largest_drop(f, 200);
        EXPECT_EQ(found.direction, 1);
        if (drop > 1e-12) {
            EXPECT_FALSE(found.monotone) << "control points rise, the curve does not, round " << round;
            ++turned_back;
        } else if (found.monotone) {
            ++risen;
        } else {
            EXPECT_LT(found.to - found.from, 0.01) << "a turn too short for the samples";
            ++undecided;
        }
        if (!found.monotone) {
            const double lost = f.at(found.from).z - f.at(found.to).z;
            EXPECT_GT(lost, 0) << "the stretch named is one that falls";
            EXPECT_NEAR(f.at(found.from).z, found.from_z, 1e-9);
            EXPECT_NEAR(f.at(found.to).z, found.to_z, 1e-9);
            EXPECT_LT(f.at(0.5 * (found.from + found.to)).z, found.from_z);
        }
    }
    EXPECT_GT(turned_back, 1000);
    EXPECT_GT(risen, 1000);
    EXPECT_LT(undecided, 30);
}

TEST(MonotoneEdge, falling_curves_are_rising_ones_turned) {
    Random random(2);
    for (int round = 0; round < 500; ++round) {
        Curve curve = through(CurveKind::Cardinal, rising_points(random, 1.5));
        const auto up = z_monotonicity(ParametricCurve(curve));
        std::reverse(curve.points.begin(), curve.points.end());
        const auto down = z_monotonicity(ParametricCurve(curve));
        EXPECT_EQ(up.monotone, down.monotone);
        EXPECT_EQ(down.direction, -1);
    }
}

TEST(MonotoneEdge, a_place_where_z_stands_still_is_allowed_a_level_stretch_is_not) {
    Curve still = through(CurveKind::Cardinal, {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}});
    still.tension = 0;  // z' = 0 at every joint
    EXPECT_TRUE(z_monotonicity(ParametricCurve(still)).monotone);
    still.tension = 1.5;  // tangents of 3 chords: z' = 0 in the middle of each piece
    EXPECT_TRUE(z_monotonicity(ParametricCurve(still)).monotone);
    still.tension = 1.51;
    EXPECT_FALSE(z_monotonicity(ParametricCurve(still)).monotone);
    const auto level = z_monotonicity(
        ParametricCurve(through(CurveKind::Polyline, {{0, 0, 0}, {0, 0, 1}, {5, 0, 1}, {0, 0, 2}})));
    EXPECT_FALSE(level.monotone);
    EXPECT_NEAR(level.from, 1.0 / 3, 1e-15);
    EXPECT_NEAR(level.to, 2.0 / 3, 1e-15);
}

TEST(MonotoneEdge, double_root_inside_a_piece_is_no_turn_and_a_little_more_is_one) {
    // The middle piece rises by 1/4 with tangents d at both ends: z' = 3 (u - 1/2)^2 for d = 3/4, below 0 inside for more.
    const auto spline = [](double d) {
        Curve curve = through(CurveKind::Cardinal, {{0, 0, 0.25 - d}, {0, 0, 0}, {0, 0, 0.25}, {0, 0, d}});
        curve.tension = 1;
        return ParametricCurve(curve);
    };
    EXPECT_TRUE(z_monotonicity(spline(0.75)).monotone);
    EXPECT_FALSE(z_monotonicity(spline(0.75 + 1e-6)).monotone) << "too short a turn for any sampling";
    EXPECT_TRUE(z_monotonicity(spline(0.75 - 1e-6)).monotone);
}

TEST(MonotoneEdge, finds_the_point_of_a_height) {
    Random random(3);
    int tried = 0;
    while (tried < 500) {
        auto points = rising_points(random, 1);
        if (tried % 2 == 0) std::reverse(points.begin(), points.end());
        const Curve curve = through(CurveKind::CatmullRom, points);
        if (!z_monotonicity(ParametricCurve(curve)).monotone) continue;
        ++tried;
        const MonotoneEdge edge(curve);
        EXPECT_EQ(edge.lowest(), std::min(points.front().z, points.back().z));
        EXPECT_EQ(edge.highest(), std::max(points.front().z, points.back().z));
        for (int i = 0; i < 20; ++i) {
            const double z = random.uniform(edge.lowest(), edge.highest());
            EXPECT_NEAR(edge.curve().at(edge.parameter_at(z)).z, z, 1e-12);
            EXPECT_EQ(edge.at(z).z, z);
        }
        for (const auto& p : points) expect_near(edge.at(p.z), p, 1e-6);
        EXPECT_EQ(edge.at(points.front().z), points.front());
        EXPECT_EQ(edge.at(points.back().z), points.back());
    }
}

TEST(MonotoneEdge, edges_that_are_none_are_refused_with_the_stretch) {
    const auto refused = [](const Curve& curve, const std::string& part) {
        try {
            const MonotoneEdge edge(curve);
            ADD_FAILURE() << "accepted, expected: " << part;
        } catch (const InvalidInput& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    };
    refused(through(CurveKind::Polyline, {{0, 0, 0}, {0, 0, 2}, {0, 0, 1}, {0, 0, 3}}),
            "turns back from z = 2 to 1");
    refused(through(CurveKind::Polyline, {{0, 0, 1}, {3, 0, 1}}), "level");
    refused(through(CurveKind::Bezier, {{0, 0, 1}, {3, 0, 2}}), "bezier");
    refused(circle({}, 1), "circle");
    refused(through(CurveKind::Cardinal, {{0, 0, 1}, {3, 0, 2}, {0, 1, 3}}, true), "closed");
    const MonotoneEdge edge(through(CurveKind::Polyline, {{0, 0, 1}, {3, 0, 2}}));
    EXPECT_THROW(edge.parameter_at(0.99), InvalidInput);
    EXPECT_THROW(edge.parameter_at(std::nan("")), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
