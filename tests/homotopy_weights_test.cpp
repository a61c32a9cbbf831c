// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/homotopy_weights.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "boreholes/errors.h"
#include "tests/curve_cases.h"

namespace stratareeb {
namespace {

using curve_cases::Random;
using curve_cases::through;

constexpr std::array kKinds{HomotopyKind::Linear,   HomotopyKind::Parabola,   HomotopyKind::Quadrant,
                            HomotopyKind::Cardinal, HomotopyKind::CatmullRom, HomotopyKind::NaturalCubic};

std::vector<double> random_places(Random& random, std::size_t n) {
    std::vector<double> places{random.uniform(-3, 3)};
    while (places.size() < n) places.push_back(places.back() + random.uniform(0.1, 1));
    return places;
}

std::vector<double> random_values(Random& random, std::size_t n) {
    std::vector<double> values(n);
    for (auto& y : values) y = random.uniform(-1, 1);
    return values;
}

HomotopyOptions random_options(Random& random, HomotopyKind kind) {
    HomotopyOptions options{.kind = kind};
    options.tension = random.uniform(0, 1);
    options.a = options.b = random.uniform(0, 1);
    options.direction = random.below(2) == 0 ? HomotopyDirection::Upward : HomotopyDirection::Downward;
    return options;
}

double mix(const HomotopyWeights& weights, const std::vector<double>& values, std::size_t interval,
           double t) {
    double sum = 0;
    for (const auto& [contour, weight] : weights.at(interval, t)) sum += weight * values[contour];
    return sum;
}

//! One-sided derivatives over the place, from values that a cubic takes: exact for cubics up to rounding.
struct EndSlopes {
    double first = 0, second = 0;
};

EndSlopes slopes(const std::function<double(double)>& f, double from, double h) {
    const double f0 = f(from), f1 = f(from + h), f2 = f(from + 2 * h), f3 = f(from + 3 * h);
    return {(-11 * f0 + 18 * f1 - 9 * f2 + 2 * f3) / (6 * h), (2 * f0 - 5 * f1 + 4 * f2 - f3) / (h * h)};
}

EndSlopes slopes_after(const HomotopyWeights& weights, const std::vector<double>& y, std::size_t interval) {
    const double h = weights.places()[interval + 1] - weights.places()[interval];
    return slopes([&](double x) { return mix(weights, y, interval, x / h); }, 0, h / 3);
}

EndSlopes slopes_before(const HomotopyWeights& weights, const std::vector<double>& y, std::size_t interval) {
    const double h = weights.places()[interval + 1] - weights.places()[interval];
    return slopes([&](double x) { return mix(weights, y, interval, x / h); }, h, -h / 3);
}

TEST(HomotopyWeights, add_up_to_one_and_single_out_the_given_contours) {
    Random random(1);
    for (int round = 0; round < 300; ++round) {
        const auto places = random_places(random, 2 + random.below(12));
        for (const auto kind : kKinds) {
            const HomotopyWeights weights(places, random_options(random, kind));
            for (std::size_t i = 0; i < weights.intervals(); ++i) {
                ASSERT_EQ(weights.at(i, 0).size(), 1u);
                EXPECT_EQ(weights.at(i, 0)[0].contour, i);
                EXPECT_EQ(weights.at(i, 0)[0].weight, 1);
                EXPECT_EQ(weights.at(i, 1)[0].contour, i + 1);
                const double t = random.uniform(0, 1);
                EXPECT_NEAR(mix(weights, std::vector<double>(places.size(), 1.0), i, t), 1, 1e-13);
                // Steady right up to the given contours: no jump hidden behind the exact ends.
                const auto y = random_values(random, places.size());
                EXPECT_NEAR(mix(weights, y, i, 1e-14), y[i], 1e-6);
                EXPECT_NEAR(mix(weights, y, i, 1 - 1e-14), y[i + 1], 1e-6);
            }
        }
    }
}

TEST(HomotopyWeights, the_primitive_ones_are_their_formulas) {
    const std::vector<double> y{3, 8};
    const auto value = [&](HomotopyKind kind, HomotopyDirection direction, double t) {
        return mix(HomotopyWeights({0, 1}, {.kind = kind, .direction = direction}), y, 0, t);
    };
    using D = HomotopyDirection;
    for (double t = 0; t <= 1; t += 0.05) {
        EXPECT_NEAR(value(HomotopyKind::Linear, D::Upward, t), 3 + 5 * t, 1e-14);
        EXPECT_NEAR(value(HomotopyKind::Linear, D::Downward, t), 3 + 5 * t, 1e-14);
        EXPECT_NEAR(value(HomotopyKind::Parabola, D::Upward, t), (1 - t * t) * 3 + t * t * 8, 1e-14);
        EXPECT_NEAR(value(HomotopyKind::Parabola, D::Downward, 1 - t), (1 - t * t) * 8 + t * t * 3, 1e-14);
        const double q = std::sqrt(1 - t * t);
        EXPECT_NEAR(value(HomotopyKind::Quadrant, D::Upward, t), q * 3 + (1 - q) * 8, 1e-14);
        EXPECT_NEAR(value(HomotopyKind::Quadrant, D::Downward, 1 - t), q * 8 + (1 - q) * 3, 1e-7);
    }
}

TEST(HomotopyWeights, of_evenly_spaced_contours_are_the_spline_curves) {
    Random random(2);
    for (int round = 0; round < 100; ++round) {
        const std::size_t n = 2 + random.below(8);
        std::vector<double> places, y;
        std::vector<Point3> points;
        for (std::size_t i = 0; i < n; ++i) {
            places.push_back(0.25 * static_cast<double>(i) - 2);
            points.push_back(random.point());
            y.push_back(points.back().x);
        }
        for (const auto kind : {HomotopyKind::Cardinal, HomotopyKind::CatmullRom}) {
            auto options = random_options(random, kind);
            options.b = random.uniform(0, 1);
            Curve curve =
                through(kind == HomotopyKind::Cardinal ? CurveKind::Cardinal : CurveKind::CatmullRom, points);
            curve.tension = options.tension;
            curve.a = options.a;
            curve.b = options.b;
            const ParametricCurve f(curve);
            const HomotopyWeights weights(places, options);
            for (std::size_t i = 0; i + 1 < n; ++i) {
                const double t = random.uniform(0, 1);
                EXPECT_NEAR(mix(weights, y, i, t),
                            f.at((static_cast<double>(i) + t) / static_cast<double>(n - 1)).x, 1e-12);
            }
        }
    }
}

TEST(HomotopyWeights, missing_contours_are_mirrored_ones) {
    Random random(3);
    for (int round = 0; round < 100; ++round) {
        auto places = random_places(random, 2 + random.below(3));
        auto y = random_values(random, places.size());
        for (const auto kind : {HomotopyKind::Cardinal, HomotopyKind::CatmullRom}) {
            const auto options = random_options(random, kind);
            auto more = places, more_y = y;
            const std::size_t n = places.size();
            more.insert(more.begin(), 2 * places[0] - places[1]);
            more_y.insert(more_y.begin(), 2 * y[0] - y[1]);
            more.push_back(2 * places[n - 1] - places[n - 2]);
            more_y.push_back(2 * y[n - 1] - y[n - 2]);
            const HomotopyWeights without(places, options), with(more, options);
            for (std::size_t i = 0; i + 1 < n; ++i) {
                const double t = random.uniform(0, 1);
                EXPECT_NEAR(mix(without, y, i, t), mix(with, more_y, i + 1, t), 1e-12);
            }
        }
    }
}

TEST(HomotopyWeights, slopes_agree_on_both_sides_of_a_contour_where_claimed) {
    Random random(4);
    for (int round = 0; round < 200; ++round) {
        const auto places = random_places(random, 3 + random.below(8));
        const auto y = random_values(random, places.size());
        for (const auto kind :
             {HomotopyKind::Cardinal, HomotopyKind::CatmullRom, HomotopyKind::NaturalCubic}) {
            const HomotopyWeights weights(places, random_options(random, kind));
            for (std::size_t i = 0; i + 1 < weights.intervals(); ++i) {
                EXPECT_NEAR(slopes_before(weights, y, i).first, slopes_after(weights, y, i + 1).first, 1e-9);
            }
        }
    }
    const HomotopyWeights uneven({0, 1, 2}, {.kind = HomotopyKind::CatmullRom, .a = 0.2, .b = 0.8});
    EXPECT_GT(std::abs(slopes_before(uneven, {0, 0, 1}, 0).first - slopes_after(uneven, {0, 0, 1}, 1).first),
              0.1);
}

TEST(HomotopyWeights, natural_spline_is_twice_smooth_with_straight_ends) {
    Random random(5);
    for (int round = 0; round < 200; ++round) {
        const auto places = random_places(random, 2 + random.below(60));
        const auto y = random_values(random, places.size());
        const HomotopyWeights weights(places, {.kind = HomotopyKind::NaturalCubic});
        EXPECT_NEAR(slopes_after(weights, y, 0).second, 0, 1e-8);
        EXPECT_NEAR(slopes_before(weights, y, weights.intervals() - 1).second, 0, 1e-8);
        for (std::size_t i = 0; i + 1 < weights.intervals(); ++i) {
            const double second = slopes_before(weights, y, i).second;
            EXPECT_NEAR(second, slopes_after(weights, y, i + 1).second, 1e-9 * (1 + std::abs(second)));
        }
    }
}

TEST(HomotopyWeights, natural_spline_is_exact_on_lines_and_on_natural_splines) {
    Random random(6);
    const auto places = random_places(random, 9);
    const HomotopyWeights weights(places, {.kind = HomotopyKind::NaturalCubic});
    for (std::size_t i = 0; i < weights.intervals(); ++i) {
        const double t = random.uniform(0, 1);
        EXPECT_NEAR(mix(weights, places, i, t), places[i] + t * (places[i + 1] - places[i]), 1e-13);
    }
    // The cubic B-spline's bump over 0..4: second derivative 0 at both ends, C2, cubic between whole numbers.
    const auto bump = [](double x) {
        const double d = std::abs(x - 2);
        return d < 1 ? 4 - 6 * d * d + 3 * d * d * d : (2 - d) * (2 - d) * (2 - d);
    };
    const HomotopyWeights whole({0, 1, 2, 3, 4}, {.kind = HomotopyKind::NaturalCubic});
    const std::vector<double> y{bump(0), bump(1), bump(2), bump(3), bump(4)};
    for (double x = 0; x < 4; x += 0.01) {
        EXPECT_NEAR(mix(whole, y, static_cast<std::size_t>(x), x - std::floor(x)), bump(x), 1e-13);
    }
}

TEST(HomotopyWeights, natural_spline_converges_to_fourth_order_inside) {
    double before = 0;
    for (const std::size_t n : {20u, 40u, 80u}) {
        std::vector<double> places, y;
        for (std::size_t i = 0; i <= n; ++i) {
            places.push_back(static_cast<double>(i) / static_cast<double>(n));
            y.push_back(std::sin(5 * places.back()));
        }
        const HomotopyWeights weights(places, {.kind = HomotopyKind::NaturalCubic});
        double error = 0;
        for (std::size_t i = n / 3; i < 2 * n / 3; ++i) {
            const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
            error = std::max(error, std::abs(mix(weights, y, i, 0.5) - std::sin(5 * x)));
        }
        if (before > 0) {
            EXPECT_LT(error, before / 12);
        }
        before = error;
    }
}

TEST(HomotopyWeights, of_many_contours_stay_few) {
    std::vector<double> places;
    for (int i = 0; i < 200; ++i) places.push_back(i);
    const HomotopyWeights weights(places, {.kind = HomotopyKind::NaturalCubic});
    EXPECT_LT(weights.at(100, 0.4).size(), 70u);
}

TEST(HomotopyWeights, names_lead_to_kinds_and_back) {
    for (const auto kind : kKinds) EXPECT_EQ(homotopy_kind(homotopy_name(kind)), kind);
    EXPECT_FALSE(homotopy_kind("spline"));
}

TEST(HomotopyWeights, places_that_do_not_rise_are_refused) {
    EXPECT_THROW(HomotopyWeights({}, {}), InvalidInput);
    EXPECT_THROW(HomotopyWeights({1}, {}), InvalidInput);
    EXPECT_THROW(HomotopyWeights({1, 1}, {}), InvalidInput);
    EXPECT_THROW(HomotopyWeights({2, 1}, {}), InvalidInput);
    EXPECT_THROW(HomotopyWeights({2, std::nan("")}, {}), InvalidInput);
    EXPECT_THROW(HomotopyWeights({1, 2}, {.tension = std::nan("")}), InvalidInput);
}

// Whatever the spacing, at the ends too; the cardinal one of even pace bends parabolas where contours are not evenly spaced.
TEST(HomotopyWeights, of_round_pace_reproduce_parabolas) {
    Random random(31);
    for (int round = 0; round < 200; ++round) {
        const auto places = random_places(random, 3 + random.below(6));
        const double a = random.uniform(-1, 1), b = random.uniform(-1, 1), c = random.uniform(-1, 1);
        const auto parabola = [&](double x) { return a + b * x + c * x * x; };
        std::vector<double> values;
        for (const double x : places) values.push_back(parabola(x));
        const HomotopyWeights weights(places, {.kind = HomotopyKind::Cardinal, .pace = HomotopyPace::Round});
        for (std::size_t k = 0; k < weights.intervals(); ++k)
            for (const double t : {0.1, 0.5, 0.8}) {
                const double x = places[k] + t * (places[k + 1] - places[k]);
                EXPECT_NEAR(mix(weights, values, k, t), parabola(x), 1e-12);
            }
    }
}

TEST(HomotopyWeights, of_round_pace_leave_no_kink_and_take_two_contours_straight) {
    Random random(32);
    for (int round = 0; round < 50; ++round) {
        const auto places = random_places(random, 4 + random.below(5));
        const auto values = random_values(random, places.size());
        const HomotopyWeights weights(places, {.kind = HomotopyKind::Cardinal, .pace = HomotopyPace::Round});
        for (std::size_t k = 0; k + 1 < weights.intervals(); ++k) {
            const double h = 1e-6, at = mix(weights, values, k + 1, 0),
                         below = weights.places()[k + 1] - weights.places()[k],
                         above = weights.places()[k + 2] - weights.places()[k + 1];
            EXPECT_NEAR((at - mix(weights, values, k, 1 - h / below)) / h,
                        (mix(weights, values, k + 1, h / above) - at) / h, 1e-3);
        }
    }
    const HomotopyWeights two({1, 3}, {.kind = HomotopyKind::Cardinal, .pace = HomotopyPace::Round});
    EXPECT_NEAR(mix(two, {10, 20}, 0, 0.3), 13, 1e-12);
}

}  // namespace
}  // namespace stratareeb
