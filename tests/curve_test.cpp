// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "boreholes/errors.h"
#include "reeb/plane_frame.h"
#include "tests/curve_cases.h"

namespace stratareeb {
namespace {

using curve_cases::circle;
using curve_cases::expect_near;
using curve_cases::nurbs_circle;
using curve_cases::Random;
using curve_cases::through;
using std::numbers::pi;

constexpr std::array kSplines{CurveKind::Polyline, CurveKind::Cardinal, CurveKind::CatmullRom};
constexpr std::array kOfPoints{CurveKind::Polyline, CurveKind::Bezier, CurveKind::Nurbs, CurveKind::Cardinal,
                               CurveKind::CatmullRom};

Curve random_curve(Random& random, CurveKind kind, bool closed) {
    Curve curve = through(kind, random.points(4 + random.below(6)), closed);
    if (random.below(2) == 0) {
        curve.weights.resize(curve.points.size());
        for (auto& w : curve.weights) w = random.uniform(0.2, 3);
    }
    curve.tension = random.uniform(0, 1.5);
    curve.a = random.uniform(0, 1);
    curve.b = curve.a;
    return curve;
}

TEST(Curve, open_curves_start_and_end_at_their_end_points_exactly) {
    Random random(1);
    for (const CurveKind kind : kOfPoints) {
        for (int round = 0; round < 50; ++round) {
            const Curve curve = random_curve(random, kind, false);
            const ParametricCurve f(curve);
            EXPECT_EQ(f.at(0), curve.points.front());
            EXPECT_EQ(f.at(1), curve.points.back());
            EXPECT_EQ(f.at(-3), curve.points.front()) << "an open curve stays at its ends";
            EXPECT_EQ(f.at(7), curve.points.back());
        }
    }
}

TEST(Curve, closed_curves_end_where_they_start_and_go_round) {
    Random random(2);
    for (const CurveKind kind : kOfPoints) {
        for (int round = 0; round < 50; ++round) {
            const ParametricCurve f(random_curve(random, kind, true));
            EXPECT_EQ(f.at(0), f.at(1));
            expect_near(f.at(1 - 1e-12), f.at(0), 1e-9);
            expect_near(f.at(0.3), f.at(1.3), 1e-12);
            expect_near(f.at(0.3), f.at(-2.7), 1e-12);
        }
    }
}

TEST(Curve, splines_pass_through_all_their_points) {
    Random random(3);
    for (const CurveKind kind : kSplines) {
        for (const bool closed : {false, true}) {
            const Curve curve = random_curve(random, kind, closed);
            const ParametricCurve f(curve);
            ASSERT_EQ(f.pieces(), curve.points.size() - (closed ? 0 : 1));
            for (std::size_t i = 0; i <= f.pieces(); ++i) {
                expect_near(f.at(f.joints()[i]), curve.points[i % curve.points.size()], 1e-13);
            }
        }
    }
}

TEST(Curve, derivative_is_the_difference_quotient) {
    Random random(4);
    std::vector<Curve> curves{nurbs_circle(), circle({1, 2, 3}, 2, {1, -2, 0.5})};
    for (const CurveKind kind : kOfPoints) {
        for (const bool closed : {false, true}) curves.push_back(random_curve(random, kind, closed));
    }
    for (const Curve& curve : curves) {
        const ParametricCurve f(curve);
        const double h = 1e-6;
        for (std::size_t i = 0; i < f.pieces(); ++i) {  // inside of pieces
            for (const double u : {0.03, 0.41, 0.97}) {
                const double t = f.joints()[i] + u * (f.joints()[i + 1] - f.joints()[i]);
                expect_near(f.derivative(t), (0.5 / h) * (f.at(t + h) - f.at(t - h)), 1e-4,
                            std::string(curve_name(curve.kind, curve.closed)).c_str());
            }
        }
    }
}

//! The largest jump of the derivative over the joints inside (and the seam, if closed).
double tangent_jump(const Curve& curve) {
    const ParametricCurve f(curve);
    double jump = 0;
    for (std::size_t i = curve.closed ? 0 : 1; i < f.pieces(); ++i) {
        const double t = f.joints()[i];
        jump = std::max(jump, magnitude(f.derivative(t + 1e-9) - f.derivative(t - 1e-9)));
    }
    return jump;
}

TEST(Curve, tangents_are_continuous_where_claimed) {
    Random random(5);
    for (int round = 0; round < 100; ++round) {
        for (const bool closed : {false, true}) {
            for (const CurveKind kind : {CurveKind::Cardinal, CurveKind::CatmullRom, CurveKind::Nurbs}) {
                EXPECT_LT(tangent_jump(random_curve(random, kind, closed)), 1e-4);
            }
        }
    }
    EXPECT_LT(tangent_jump(circle({}, 1)), 1e-6);
}

TEST(Curve, catmull_rom_with_different_a_and_b_has_corners) {
    Random random(6);
    Curve curve = through(CurveKind::CatmullRom, random.points(6));
    curve.a = 0.2;
    curve.b = 0.8;
    EXPECT_GT(tangent_jump(curve), 0.1);
}

TEST(Curve, cardinal_of_one_half_is_catmull_rom_of_one_half) {
    Random random(7);
    for (const bool closed : {false, true}) {
        const auto points = random.points(7);
        const ParametricCurve f(through(CurveKind::Cardinal, points, closed));
        const ParametricCurve g(through(CurveKind::CatmullRom, points, closed));
        for (double t = 0; t <= 1; t += 0.01) expect_near(f.at(t), g.at(t), 1e-14);
    }
}

TEST(Curve, cardinal_piece_is_its_printed_matrix) {
    Random random(8);
    for (int round = 0; round < 200; ++round) {
        Curve curve = through(CurveKind::Cardinal, random.points(4));
        const double a = curve.tension = random.uniform(-1, 2), t = random.uniform(0, 1);
        const std::array row{-a * t * t * t + 2 * a * t * t - a * t,
                             (2 - a) * t * t * t + (a - 3) * t * t + 1,
                             (a - 2) * t * t * t + (3 - 2 * a) * t * t + a * t, a * t * t * t - a * t * t};
        Point3 expected;
        for (std::size_t k = 0; k < 4; ++k) expected += row[k] * curve.points[k];
        expect_near(ParametricCurve(curve).at((1 + t) / 3), expected, 1e-12);
    }
}

TEST(Curve, cardinal_with_tension_half_keeps_evenly_run_lines_and_parabolas) {
    std::vector<Point3> points;
    for (int i = 0; i < 6; ++i) points.push_back({double(i), double(i * i), 2.0 * i});
    const ParametricCurve f(through(CurveKind::Cardinal, points));
    for (double t = 0.2; t <= 0.8; t += 0.01) {
        expect_near(f.at(t), {5 * t, 25 * t * t, 10 * t}, 1e-12);
    }
}

TEST(Curve, nurbs_circle_is_a_circle) {
    const ParametricCurve f(nurbs_circle());
    for (int i = 0; i <= 1000; ++i) {
        const Point3 p = f.at(i / 1000.0);
        EXPECT_NEAR(std::hypot(p.x, p.y), 1, 1e-12);
        EXPECT_NEAR(dot_product(p, f.derivative(i / 1000.0)), 0, 1e-11);
    }
}

TEST(Curve, nurbs_of_one_span_is_a_bezier_curve) {
    Random random(9);
    for (std::size_t n = 2; n < 9; ++n) {
        const auto points = random.points(n);
        Curve nurbs = through(CurveKind::Nurbs, points);
        nurbs.degree = static_cast<int>(n) - 1;
        const ParametricCurve f(nurbs), g(through(CurveKind::Bezier, points));
        for (double t = 0; t <= 1; t += 0.05) expect_near(f.at(t), g.at(t), 1e-13);
    }
}

TEST(Curve, nurbs_moves_only_near_a_moved_point) {
    Random random(10);
    Curve curve = through(CurveKind::Nurbs, random.points(12));
    const ParametricCurve before(curve);
    curve.points[2] = {9, 9, 9};
    const ParametricCurve after(curve);
    EXPECT_GT(magnitude(before.at(0.2) - after.at(0.2)), 1);
    for (double t = 3.0 / 9; t <= 1; t += 0.01) expect_near(before.at(t), after.at(t), 1e-13);
}

TEST(Curve, periodic_nurbs_is_smooth_and_does_not_depend_on_where_it_starts) {
    Random random(11);
    auto points = random.points(7);
    const ParametricCurve f(through(CurveKind::Nurbs, points, true));
    std::rotate(points.begin(), points.begin() + 1, points.end());
    const ParametricCurve g(through(CurveKind::Nurbs, points, true));
    for (double t = 0; t <= 1; t += 0.01) expect_near(f.at(t + 1.0 / 7), g.at(t), 1e-12);
}

Point3 affine(const Point3& p) {
    return {2 * p.x - p.y + 0.5 * p.z + 3, p.x + p.z - 1, 0.3 * p.y - 4 * p.z + 7};
}

TEST(Curve, curves_are_invariant_under_affine_maps) {
    Random random(12);
    for (const CurveKind kind : kOfPoints) {
        for (const bool closed : {false, true}) {
            Curve curve = random_curve(random, kind, closed);
            const ParametricCurve f(curve);
            for (auto& p : curve.points) p = affine(p);
            const ParametricCurve g(curve);
            for (double t = 0; t <= 1; t += 0.03) expect_near(g.at(t), affine(f.at(t)), 1e-12);
        }
    }
}

TEST(Curve, bezier_stays_in_the_hull_at_any_degree) {
    std::vector<Point3> points;
    for (int i = 0; i < 3000; ++i) points.push_back({std::cos(i * 0.1), std::sin(i * 0.1), i / 2999.0});
    const ParametricCurve f(through(CurveKind::Bezier, points));
    for (double t = 0; t <= 1; t += 0.01) {
        const Point3 p = f.at(t);
        EXPECT_LE(std::hypot(p.x, p.y), 1 + 1e-12);
        EXPECT_NEAR(p.z, t, 1e-11) << "control values that rise evenly give the parameter itself";
    }
}

TEST(Curve, circle_lies_in_its_plane_and_turns_about_its_normal) {
    Random random(13);
    std::vector<Point3> normals{{0, 0, 1}, {0, 0, -2}, {1e-9, 0, -1}, {3, 0, 0}};
    for (int i = 0; i < 100; ++i) normals.push_back(random.point());
    for (const Point3& normal : normals) {
        const ParametricCurve f(circle({1, 2, 3}, 2.5, normal));
        for (double t = 0; t < 1; t += 0.1) {
            const Point3 arm = f.at(t) - Point3{1, 2, 3};
            EXPECT_NEAR(magnitude(arm), 2.5, 1e-12);
            EXPECT_NEAR(dot_product(arm, normal), 0, 1e-12 * magnitude(normal) + 1e-12);
            EXPECT_NEAR(dot_product(cross_product(arm, f.derivative(t)), normal) / magnitude(normal),
                        2 * pi * 6.25, 1e-9);
        }
    }
    expect_near(ParametricCurve(circle({0, 0, 5}, 1)).at(0.25), {0, 1, 5}, 1e-15,
                "like a cylindrical coordinate");
}

TEST(PlaneFrame, is_a_right_handed_orthonormal_frame_of_the_shortest_turn) {
    Random random(14);
    for (int i = 0; i < 1000; ++i) {
        Point3 normal = random.point();
        if (i % 3 == 0) normal = {normal.x * 1e-8, normal.y * 1e-8, normal.z};
        const PlaneFrame f = plane_frame(normal);
        expect_near(cross_product(f.u, f.v), f.w, 1e-12);
        EXPECT_NEAR(magnitude(f.u), 1, 1e-12);
        EXPECT_NEAR(dot_product(f.u, f.v), 0, 1e-12);
        EXPECT_NEAR(dot_product(f.w, normal), magnitude(normal), 1e-12);
        // A shortest turn leaves alone the line that is level in both planes.
        const Point3 axis = cross_product({0, 0, 1}, f.w);
        expect_near(f.turned(axis), axis, 1e-12);
    }
}

TEST(Curve, repeated_first_point_changes_nothing) {
    Random random(15);
    for (const CurveKind kind : kOfPoints) {
        Curve curve = random_curve(random, kind, true);
        curve.weights.clear();
        const ParametricCurve f(curve);
        curve.points.push_back(curve.points.front());
        const ParametricCurve g(curve);
        for (double t = 0; t <= 1; t += 0.1) EXPECT_EQ(f.at(t), g.at(t));
    }
}

TEST(Curve, far_from_the_origin_keeps_millimetres) {
    std::vector<Point3> points{
        {5e6, 4e6, 100}, {5e6 + 1, 4e6, 101}, {5e6 + 2, 4e6 + 1, 102}, {5e6 + 2, 4e6 + 2, 105}};
    std::vector<Point3> near = points;
    for (auto& p : near) p = p - Point3{5e6, 4e6, 0};
    for (const CurveKind kind : kOfPoints) {
        const ParametricCurve f(through(kind, points)), g(through(kind, near));
        for (double t = 0; t <= 1; t += 0.1) expect_near(f.at(t) - Point3{5e6, 4e6, 0}, g.at(t), 1e-8);
    }
}

TEST(Curve, names_lead_to_kinds_and_back) {
    for (int i = 0; i <= static_cast<int>(CurveKind::CatmullRom); ++i) {
        const auto kind = static_cast<CurveKind>(i);
        EXPECT_EQ(curve_kind(curve_name(kind, true)), kind);
        EXPECT_EQ(curve_kind(curve_name(kind, false)), kind);
    }
    EXPECT_FALSE(curve_kind("unknown"));
    EXPECT_FALSE(curve_kind(""));
}

void expect_refused(const Curve& curve, const std::string& part) {
    try {
        const ParametricCurve refused(curve);
        ADD_FAILURE() << "accepted, expected: " << part;
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

TEST(Curve, curves_that_are_none_are_refused_with_the_place) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    const std::vector<Point3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (const CurveKind kind : kOfPoints) {
        expect_refused(through(kind, {}), "0 points");
        expect_refused(through(kind, {{1, 1, 1}, {2, 2, 2}}, true), "2 points");
        auto points = square;
        points[2].y = nan;
        expect_refused(through(kind, points), "point 2");
    }
    expect_refused(circle({0, 0, 0}, 0), "radius 0");
    expect_refused(circle({0, 0, 0}, infinite), "radius inf");
    expect_refused(circle({nan, 0, 0}, 1), "center");
    expect_refused(circle({0, 0, 0}, 1, {0, 0, 0}), "normal");

    Curve curve = through(CurveKind::Nurbs, square);
    curve.degree = 0;
    expect_refused(curve, "degree 0");
    curve.degree = 1000000;
    expect_refused(curve, "degree 1000000");
    curve.degree = 2;
    curve.knots = {0, 0, 0, 1, 1};
    expect_refused(curve, "5 knots for 4 points of degree 2 (expected 7");
    curve.knots = {0, 0, 0, 2, 1, 3, 3};
    expect_refused(curve, "knot 4 is 1");
    curve.knots = {0, 0, 1, 1, 1, 2, 2};
    expect_refused(curve, "leave no range");
    curve.points.push_back({2, 2, 2});
    curve.points.push_back({2, 2, 3});
    curve.knots = {0, 0, 0, 1, 1, 1, 2, 2, 2};
    expect_refused(curve, "broken");
    curve.knots = {0, 0, 0, 1, 2, 3, 4, 4, 4};
    curve.closed = true;
    expect_refused(curve, "ends are");
    curve.closed = false;
    curve.weights = {1, 1, 1};
    expect_refused(curve, "3 weights for 6 points");
    curve.weights = {1, 1, 0, 1, 1, 1};
    expect_refused(curve, "weight 0 of point 2");

    curve = through(CurveKind::CatmullRom, square);
    curve.b = nan;
    expect_refused(curve, "finite");
    EXPECT_THROW(ParametricCurve(circle({}, 1)).at(nan), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
