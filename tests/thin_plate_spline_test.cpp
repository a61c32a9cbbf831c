// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/thin_plate_spline.h"

#include <gtest/gtest.h>

#include "boreholes/errors.h"
#include "tests/scattered_values.h"

namespace stratareeb {
namespace {

double rolling(const Point2& p) {
    return 10 + std::sin(7 * p.x) + std::cos(5 * p.y) * p.x;
}
double plane(const Point2& p) {
    return 3 - 2 * p.x + 5 * p.y;
}

// Duchon's spline from its definition, r² ln r and a plane, solved by another method.
TEST(ThinPlateSpline, without_tension_is_the_textbook_s) {
    const auto at = places_over_square(1, 40), where = places_over_square(2, 60);
    const auto value = values_at(at, rolling);
    const auto n = static_cast<Eigen::Index>(at.size());
    const auto kernel = [](const Point2& p, const Point2& q) {
        const double r = std::hypot(p.x - q.x, p.y - q.y);
        return r > 0 ? r * r * std::log(r) : 0;
    };
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n + 3, n + 3);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n + 3);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Point2& p = at[static_cast<std::size_t>(i)];
        for (Eigen::Index j = 0; j < n; ++j) A(i, j) = kernel(p, at[static_cast<std::size_t>(j)]);
        A(i, n) = A(n, i) = 1, A(i, n + 1) = A(n + 1, i) = p.x, A(i, n + 2) = A(n + 2, i) = p.y;
        b[i] = value[static_cast<std::size_t>(i)];
    }
    const Eigen::VectorXd w = A.fullPivLu().solve(b);
    const auto found = predicted(InterpolatorKind::Spline, at, value, where, {.tension = 0});
    for (std::size_t k = 0; k < where.size(); ++k) {
        double expected = w[n] + w[n + 1] * where[k].x + w[n + 2] * where[k].y;
        for (Eigen::Index i = 0; i < n; ++i)
            expected += w[i] * kernel(where[k], at[static_cast<std::size_t>(i)]);
        EXPECT_NEAR(found[k], expected, 1e-9);
    }
}

TEST(ThinPlateSpline, reproduces_planes_with_any_tension_and_smoothing) {
    const auto at = places_over_square(3, 50), where = places_over_square(4, 60);
    const auto value = values_at(at, plane);
    for (const double tension : {0.0, 1.0, 10.0})
        for (const double smoothing : {0.0, 0.1, 10.0}) {
            const auto z = predicted(InterpolatorKind::Spline, at, value, where,
                                     {.tension = tension, .smoothing = smoothing});
            for (std::size_t k = 0; k < where.size(); ++k) EXPECT_NEAR(z[k], plane(where[k]), 1e-9);
        }
    const auto patches = predicted(InterpolatorKind::Spline, at, value, where, {.single_patch = 10});
    for (std::size_t k = 0; k < where.size(); ++k) EXPECT_NEAR(patches[k], plane(where[k]), 1e-9);
}

TEST(ThinPlateSpline, goes_to_the_thin_plate_as_tension_goes_to_nothing) {
    const auto at = places_over_square(5, 40), where = places_over_square(6, 40);
    const auto value = values_at(at, rolling);
    const auto plate = predicted(InterpolatorKind::Spline, at, value, where, {.tension = 0});
    double before = 1;
    for (const double tension : {1.0, 0.1, 0.01}) {
        const auto z = predicted(InterpolatorKind::Spline, at, value, where, {.tension = tension});
        double difference = 0;
        for (std::size_t k = 0; k < z.size(); ++k)
            difference = std::max(difference, std::abs(z[k] - plate[k]));
        EXPECT_LT(difference, before / 5) << tension;
        before = difference;
    }
}

TEST(ThinPlateSpline, that_smooths_ends_as_the_plane_of_least_squares) {
    const auto at = places_over_square(7, 60), where = places_over_square(8, 20);
    const auto value = values_at(at, rolling);
    Eigen::MatrixXd F(60, 3);
    Eigen::VectorXd z(60);
    for (Eigen::Index i = 0; i < 60; ++i) {
        const auto k = static_cast<std::size_t>(i);
        F.row(i) << 1, at[k].x, at[k].y;
        z[i] = value[k];
    }
    const Eigen::Vector3d fit = F.colPivHouseholderQr().solve(z);
    const auto found =
        predicted(InterpolatorKind::Spline, at, value, where, {.tension = 0, .smoothing = 1e9});
    for (std::size_t k = 0; k < where.size(); ++k)
        EXPECT_NEAR(found[k], fit[0] + fit[1] * where[k].x + fit[2] * where[k].y, 1e-5);
    double before = 0;
    for (const double smoothing : {1e-3, 1e-1, 10.0}) {
        const auto beside =
            predicted(InterpolatorKind::Spline, at, value, at, {.tension = 0, .smoothing = smoothing});
        double miss = 0;
        for (std::size_t k = 0; k < at.size(); ++k) miss += (beside[k] - value[k]) * (beside[k] - value[k]);
        EXPECT_GT(miss, before);
        before = miss;
    }
}

TEST(ThinPlateSpline, chooses_smoothing_where_values_are_noisy_and_none_where_they_are_not) {
    const auto at = places_over_square(9, 200), where = places_over_square(10, 200);
    const auto clean = values_at(at, rolling);
    auto noisy = clean;
    std::mt19937_64 random(11);
    for (double& v : noisy) v += 0.3 * normal_number(random);
    const auto rms = [&](const std::vector<double>& value, bool by_data) {
        const auto z = predicted(InterpolatorKind::Spline, at, value, where, {.smoothing_by_data = by_data});
        double sum = 0;
        for (std::size_t k = 0; k < z.size(); ++k)
            sum += (z[k] - rolling(where[k])) * (z[k] - rolling(where[k]));
        return std::sqrt(sum / static_cast<double>(z.size()));
    };
    EXPECT_LT(rms(noisy, true), 0.75 * rms(noisy, false));
    EXPECT_LT(rms(clean, true), 1.1 * rms(clean, false) + 1e-4);
}

TEST(ThinPlateSpline, in_patches_is_close_to_one_piece_and_has_no_jumps) {
    const auto at = places_over_square(12, 900), where = places_over_square(13, 300);
    const auto value = values_at(at, rolling);
    const auto whole =
        predicted(InterpolatorKind::Spline, at, value, where, {.tension = 0, .single_patch = 2000});
    const auto patches =
        predicted(InterpolatorKind::Spline, at, value, where, {.tension = 0, .single_patch = 100});
    double squares = 0;
    for (std::size_t k = 0; k < where.size(); ++k) {
        EXPECT_NEAR(whole[k], patches[k], 0.02);
        squares += (whole[k] - patches[k]) * (whole[k] - patches[k]);
    }
    EXPECT_LT(std::sqrt(squares / static_cast<double>(where.size())), 1e-3);
    std::vector<Point2> pairs;
    for (const Point2& p : where) pairs.push_back(p), pairs.push_back({p.x + 1e-9, p.y + 1e-9});
    const auto z = predicted(InterpolatorKind::Spline, at, value, pairs, {.tension = 0, .single_patch = 100});
    for (std::size_t k = 0; k < z.size(); k += 2) EXPECT_NEAR(z[k], z[k + 1], 1e-6);
}

TEST(ThinPlateSpline, refuses_what_makes_no_sense) {
    const auto holes = std::make_shared<HoleTriangulation>(places_over_square(1, 5));
    EXPECT_THROW(ThinPlateSpline(holes, {.tension = -1}), InvalidInput);
    EXPECT_THROW(ThinPlateSpline(holes, {.smoothing = std::nan("")}), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
