// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "boreholes/interpolator.h"

namespace stratareeb {

//! Places at random over the unit square, a multiple of 1/65536 each.
inline std::vector<Point2> places_over_square(std::uint64_t seed, std::size_t count) {
    std::mt19937_64 random(seed);
    std::vector<Point2> at(count);
    for (Point2& p : at)
        p = {static_cast<double>(random() % 65536) / 65536, static_cast<double>(random() % 65536) / 65536};
    return at;
}

template <class F>
std::vector<double> values_at(const std::vector<Point2>& at, const F& f) {
    std::vector<double> result;
    for (const Point2& p : at) result.push_back(f(p));
    return result;
}

//! Normal numbers, the same with every compiler.
inline double normal_number(std::mt19937_64& random) {
    const double u = (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53,
                 v = static_cast<double>(random() >> 11) * 0x1p-53;
    return std::sqrt(-2 * std::log(u)) * std::cos(6.283185307179586 * v);
}

//! A Gaussian field with a variogram, drawn by Cholesky's factor of its covariances.
inline std::vector<double> simulated_field(const std::vector<Point2>& at, const Variogram& v,
                                           std::uint64_t seed) {
    const auto n = static_cast<Eigen::Index>(at.size());
    Eigen::MatrixXd C(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) {
            const Point2 &p = at[static_cast<std::size_t>(i)], &q = at[static_cast<std::size_t>(j)];
            C(i, j) = v.nugget + v.sill - v.at(p.x - q.x, p.y - q.y) + (i == j ? 1e-10 : 0);
        }
    std::mt19937_64 random(seed);
    Eigen::VectorXd noise(n);
    for (Eigen::Index i = 0; i < n; ++i) noise[i] = normal_number(random);
    const Eigen::VectorXd z = C.llt().matrixL() * noise;
    return {z.data(), z.data() + n};
}

inline std::vector<double> predicted(InterpolatorKind kind, const std::vector<Point2>& at,
                                     const std::vector<double>& value, const std::vector<Point2>& where,
                                     const InterpolatorOptions& options = {}) {
    return make_interpolator(kind, std::make_shared<HoleTriangulation>(at), options)
        ->predict(where, std::vector<SiteField>{{value, {}}})[0];
}

}  // namespace stratareeb
