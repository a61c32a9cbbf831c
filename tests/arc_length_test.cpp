// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/arc_length.h"

#include <gtest/gtest.h>

#include "boreholes/errors.h"
#include "tests/curve_cases.h"

namespace stratareeb {
namespace {

using curve_cases::circle;
using curve_cases::expect_near;
using curve_cases::nurbs_circle;
using curve_cases::Random;
using curve_cases::through;
using std::numbers::pi;

TEST(ArcLength, polygon_is_exact) {
    const ParametricCurve square(
        through(CurveKind::Polyline, {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}}, true));
    const ArcLength length(square);
    EXPECT_EQ(length.length(), 10);
    EXPECT_EQ(length.error(), 0);
    expect_near(square.at(length.parameter_at(0.45)), {4, 0.5, 0}, 1e-14);
    EXPECT_NEAR(length.share_at(0.125), 0.2, 1e-15);
}

TEST(ArcLength, circle_is_its_angle) {
    const ArcLength length(ParametricCurve(circle({1, 2, 3}, 2)));
    EXPECT_NEAR(length.length(), 4 * pi, 1e-14);
    EXPECT_NEAR(length.parameter_at(0.3), 0.3, 1e-15);
}

TEST(ArcLength, uneven_circle_of_nurbs_is_found_to_the_stated_error) {
    double before = 1;
    for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
        const ParametricCurve f(nurbs_circle());
        const ArcLength length(f, tolerance);
        const double error = 2 * pi - length.length();
        EXPECT_GE(error, 0) << "chords are short";
        EXPECT_LE(error, 1.01 * tolerance * 2 * pi);
        EXPECT_NEAR(length.error(), error, 0.05 * error);
        EXPECT_LT(error, before);
        before = error;
        for (double share = 0; share <= 1; share += 0.01) {
            const Point3 p = f.at(length.parameter_at(share));
            expect_near(p, {std::cos(2 * pi * share), std::sin(2 * pi * share), 0}, 3 * tolerance + 1e-9);
        }
    }
}

TEST(ArcLength, parabola_has_its_closed_form) {
    // The quadratic Bezier curve (t, t^2): length sqrt(5)/2 + asinh(2)/4.
    const ArcLength length(ParametricCurve(through(CurveKind::Bezier, {{0, 0, 0}, {0.5, 0, 0}, {1, 1, 0}})),
                           1e-9);
    EXPECT_NEAR(length.length(), std::sqrt(5) / 2 + std::asinh(2) / 4, 1e-8);
}

TEST(ArcLength, an_s_shaped_piece_is_not_taken_for_its_chord) {
    const ParametricCurve f(through(CurveKind::Bezier, {{0, 0, 0}, {1, 3, 0}, {2, -3, 0}, {3, 0, 0}}));
    double dense = 0;
    for (int i = 0; i < 100000; ++i) dense += magnitude(f.at((i + 1) * 1e-5) - f.at(i * 1e-5));
    EXPECT_NEAR(ArcLength(f, 1e-8).length(), dense, 1e-6);
}

TEST(ArcLength, random_curves_agree_with_dense_sampling_and_invert) {
    Random random(5);
    for (const CurveKind kind :
         {CurveKind::Bezier, CurveKind::Nurbs, CurveKind::Cardinal, CurveKind::CatmullRom}) {
        for (int round = 0; round < 20; ++round) {
            const ParametricCurve f(through(kind, random.points(5 + random.below(5)), round % 2 == 0));
            const ArcLength length(f);
            double dense = 0;
            for (int i = 0; i < 20000; ++i) dense += magnitude(f.at((i + 1) / 2e4) - f.at(i / 2e4));
            EXPECT_NEAR(length.length(), dense, 3e-6 * dense);
            for (double t = 0; t <= 1; t += 0.1)
                EXPECT_NEAR(length.parameter_at(length.share_at(t)), t, 1e-12);
            EXPECT_EQ(length.parameter_at(0), 0);
            EXPECT_EQ(length.parameter_at(1), 1);
        }
    }
}

TEST(ArcLength, curves_with_cusps_or_without_length_end) {
    const ParametricCurve point(through(CurveKind::Cardinal, {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}));
    EXPECT_EQ(ArcLength(point).length(), 0);
    EXPECT_EQ(ArcLength(point).parameter_at(0.4), 0.4);
    const ParametricCurve cusp(through(CurveKind::Bezier, {{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}}));
    EXPECT_GT(ArcLength(cusp, 1e-9).length(), 1);
    const ParametricCurve back(through(CurveKind::Bezier, {{0, 0, 0}, {2, 0, 0}, {0, 0, 0}}));
    EXPECT_NEAR(ArcLength(back, 1e-9).length(), 2, 1e-6);
}

TEST(ArcLength, contours_are_sampled_evenly_and_polygons_keep_their_vertices) {
    const auto ring = sample_contour(nurbs_circle(), 12);
    ASSERT_EQ(ring.points.size(), 12u);
    for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_NEAR(magnitude(ring.points[(i + 1) % 12] - ring.points[i]), 2 * std::sin(pi / 12), 1e-5);
    }
    const std::vector<Point3> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_EQ(sample_contour(through(CurveKind::Polyline, triangle, true), 100).points, triangle);
    EXPECT_THROW(sample_contour(through(CurveKind::Cardinal, triangle), 10), InvalidInput);
    EXPECT_THROW(sample_contour(nurbs_circle(), 2), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
