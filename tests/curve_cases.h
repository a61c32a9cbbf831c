// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "reeb/curve.h"
#include "reeb/point_math.h"

//! Points, curves and random numbers for the tests of curves, correspondence and homotopies.
namespace stratareeb::curve_cases {

//! The same numbers with every compiler: splitmix64.
class Random {
 public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
    }
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
    Point3 point(double size = 1) {
        return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
    }
    std::vector<Point3> points(std::size_t n, double size = 1) {
        std::vector<Point3> result(n);
        for (auto& p : result) p = point(size);
        return result;
    }

 private:
    std::uint64_t next() {
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ull);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return z ^ (z >> 31);
    }
    std::uint64_t state_;
};

inline void expect_near(const Point3& a, const Point3& b, double tolerance, const char* what = "") {
    EXPECT_NEAR(a.x, b.x, tolerance) << what;
    EXPECT_NEAR(a.y, b.y, tolerance) << what;
    EXPECT_NEAR(a.z, b.z, tolerance) << what;
}

inline Curve circle(const Point3& center, double radius, const Point3& normal = {0, 0, 1}) {
    Curve curve;
    curve.kind = CurveKind::Circle;
    curve.closed = true;
    curve.center = center;
    curve.radius = radius;
    curve.normal = normal;
    return curve;
}

inline Curve through(CurveKind kind, std::vector<Point3> points, bool closed = false) {
    Curve curve;
    curve.kind = kind;
    curve.closed = closed;
    curve.points = std::move(points);
    return curve;
}

//! The full unit circle as nine weighted points of degree 2, counter-clockwise from (1, 0, 0).
inline Curve nurbs_circle() {
    Curve curve = through(CurveKind::Nurbs,
                          {{1, 0, 0},
                           {1, 1, 0},
                           {0, 1, 0},
                           {-1, 1, 0},
                           {-1, 0, 0},
                           {-1, -1, 0},
                           {0, -1, 0},
                           {1, -1, 0},
                           {1, 0, 0}},
                          true);
    curve.degree = 2;
    const double w = std::sqrt(0.5);
    curve.weights = {1, w, 1, w, 1, w, 1, w, 1};
    curve.knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
    return curve;
}

//! A polygon of n points around a wavy circle at one height, counter-clockwise seen from above.
inline std::vector<Point3> wavy_ring(Random& random, std::size_t n, double z, double waviness = 0.3) {
    const double phase = random.uniform(0, 6), second = random.uniform(0, 6);
    std::vector<Point3> ring;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        const double r = 1 + waviness * (std::sin(2 * angle + phase) + 0.4 * std::sin(5 * angle + second)) +
                         random.uniform(-0.01, 0.01);
        ring.push_back({r * std::cos(angle), r * std::sin(angle), z});
    }
    return ring;
}

}  // namespace stratareeb::curve_cases
