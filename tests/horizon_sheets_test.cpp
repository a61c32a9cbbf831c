// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/horizon_sheets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/grid_model.h"

namespace stratareeb {
namespace {

using test::grid_model;

constexpr double kSize = 150;

struct Fitted {
    LayerModel model;
    PlanCells cells;
    PlanCurves curves;
    HorizonSheets horizons;
};

Fitted fitted(LayerModel model, double end_gap = 0) {
    Fitted result{.model = std::move(model)};
    result.cells = build_plan_cells(result.model);
    result.curves = build_plan_curves(result.model.plan.surface, result.cells, 2e-5 * kSize);
    result.horizons =
        fit_horizon_sheets(result.model, result.cells, result.curves, kSize, {.end_gap = end_gap});
    return result;
}

double wavy(double x, double y) {
    return 3 * std::sin(x / 13) * std::cos(y / 11);
}

double lens(double x, double y) {
    const double r = std::hypot(x - 50, y - 50) / 30;
    return r < 1 - 1e-9 ? 6 * (1 - r * r) : 0;
}

// Far thinner than the sheets are off their waves: order comes from coefficients, not from closeness.
TEST(HorizonSheets, keep_a_very_thin_layer_below_its_top_everywhere) {
    const auto made = fitted(
        grid_model({.cells = 40, .ground = wavy, .thickness = {test::constant(1e-3), test::constant(4)}}));
    const auto& sheets = made.horizons.sheets;
    ASSERT_EQ(sheets.size(), 3u);
    for (double x = 0; x <= 100; x += 0.61)
        for (double y = 0; y <= 100; y += 0.57) {
            ASSERT_GT(sheets[0].z({x, y}), sheets[1].z({x, y})) << x << " " << y;
            ASSERT_GT(sheets[1].z({x, y}), sheets[2].z({x, y})) << x << " " << y;
        }
    for (const double least : made.horizons.least_thickness) EXPECT_GT(least, 0);
}

// Thicknesses that jump between holes close to each other: sheets can't follow, but must not cross nor swing.
TEST(HorizonSheets, neither_cross_nor_swing_at_holes_that_disagree) {
    for (unsigned seed = 1; seed <= 2; ++seed) {
        std::mt19937_64 random(seed);
        std::vector<double> at;
        for (int i = 0; i < 20; ++i) at.push_back(std::uniform_real_distribution<double>(5, 95)(random));
        const auto pins = [&](double x, double y) {
            double thickness = 0.02;
            for (std::size_t i = 0; i < 20; i += 2)
                thickness += 8 * std::exp(-std::pow(std::hypot(x - at[i], y - at[i + 1]) / 2, 2));
            return thickness;
        };
        const auto made =
            fitted(grid_model({.cells = 40, .ground = wavy, .thickness = {pins, test::constant(0.5)}}));
        const auto& sheets = made.horizons.sheets;
        for (double x = 0; x <= 100; x += 0.61)
            for (double y = 0; y <= 100; y += 0.57) {
                const double first = sheets[0].z({x, y}) - sheets[1].z({x, y}),
                             second = sheets[1].z({x, y}) - sheets[2].z({x, y});
                ASSERT_GT(first, 0) << seed << " " << x << " " << y;
                ASSERT_LT(first, 12) << seed << " " << x << " " << y;
                ASSERT_GT(second, 0) << seed << " " << x << " " << y;
                ASSERT_LT(second, 6) << seed << " " << x << " " << y;
            }
    }
}

TEST(HorizonSheets, meet_where_a_lens_ends_and_part_inside) {
    const auto made = fitted(grid_model({.cells = 48,
                                         .ground = wavy,
                                         .thickness = {test::constant(5), lens, test::constant(5)},
                                         .rounds = {{50, 50, 30}}}));
    const auto& sheets = made.horizons.sheets;
    ASSERT_EQ(sheets.size(), 4u);
    for (double a = 0; a < 6.28; a += 0.05)
        for (const double r : {0.0, 5.0, 10.0, 20.0, 26.0, 28.5, 30.0}) {
            const Point2 p{50 + r * std::cos(a), 50 + r * std::sin(a)};
            const double thickness = sheets[1].z(p) - sheets[2].z(p);
            EXPECT_NEAR(thickness, lens(p.x, p.y), 0.4) << r << " " << a;
            EXPECT_GT(thickness, r < 29 ? 0 : -0.01) << r << " " << a;
            EXPECT_GT(sheets[2].z(p), sheets[3].z(p));
        }
    std::size_t on_line = 0;
    for (const auto& line : made.curves.lines)
        for (const double t : line.parameters) {
            const Point2 p{line.curve.at(0, t), line.curve.at(1, t)};
            if (std::abs(std::hypot(p.x - 50, p.y - 50) - 30) > 1e-6) continue;
            EXPECT_NEAR(sheets[1].z(p), sheets[2].z(p), 1e-4 * kSize);
            ++on_line;
        }
    EXPECT_GT(on_line, 20u);
}

TEST(HorizonSheets, stay_a_gap_apart_where_a_lens_ends_if_asked_to) {
    const auto made = fitted(grid_model({.cells = 48,
                                         .ground = wavy,
                                         .thickness = {test::constant(5), lens, test::constant(5)},
                                         .rounds = {{50, 50, 30}}}),
                             1e-6);
    const auto& sheets = made.horizons.sheets;
    std::size_t on_line = 0;
    for (const auto& line : made.curves.lines)
        for (const double t : line.parameters) {
            const Point2 p{line.curve.at(0, t), line.curve.at(1, t)};
            if (std::abs(std::hypot(p.x - 50, p.y - 50) - 30) > 1e-6) continue;
            EXPECT_GT(sheets[1].z(p), sheets[2].z(p));
            EXPECT_NEAR(sheets[1].z(p), sheets[2].z(p), 1.5e-4 * kSize);
            ++on_line;
        }
    EXPECT_GT(on_line, 20u);
}

// A CAD program measures volumes from a point, so a slit around a thin lens counts as the cone over it.
TEST(HorizonSheets, keep_gaps_in_proportion_to_thin_bodies) {
    const auto thin = [](double x, double y) { return lens(x, y) / 600; };
    const auto made = fitted(grid_model({.cells = 40,
                                         .ground = wavy,
                                         .thickness = {test::constant(5), thin, test::constant(5)},
                                         .rounds = {{50, 50, 30}}}),
                             1e-6);
    ASSERT_EQ(made.horizons.gaps.size(), 3u);
    EXPECT_EQ(made.horizons.gaps[0], 1e-6 * kSize);
    EXPECT_LT(made.horizons.gaps[1], 5e-4 * 0.006);  // its mean is half of the 10 mm at its middle
    EXPECT_GT(made.horizons.gaps[1], 5e-4 * 0.004);
}

TEST(HorizonSheets, have_the_volumes_asked_for) {
    const auto model = grid_model({.cells = 40,
                                   .ground = wavy,
                                   .thickness = {test::constant(2), lens, test::constant(1)},
                                   .rounds = {{50, 50, 30}}});
    const PlanCells cells = build_plan_cells(model);
    const PlanCurves curves = build_plan_curves(model.plan.surface, cells, 2e-5 * kSize);
    const std::vector<double> factors{1, 1.03, 0.98};
    const auto horizons = fit_horizon_sheets(model, cells, curves, kSize, {.volume_factors = factors});
    const TriMesh& plan = model.plan.surface;
    for (std::size_t b = 0; b < 3; ++b) {
        const auto& body = cells.bodies[b];
        double volume = 0, wanted = 0;
        for (const auto f : body.faces) {
            const double area = plan.calc_face_area(plan.face_handle(f));
            volume -= area * mean_height(plan, f, horizons.sheets[b + 1]);
            for (const auto v : plan.fv_range(plan.face_handle(f)))
                wanted +=
                    area / 3 * factors[b] * model.thickness(body.layer, static_cast<std::size_t>(v.idx()));
        }
        for (const auto c : body.top)
            for (const auto f : cells.cells[c].faces)
                volume += plan.calc_face_area(plan.face_handle(f)) *
                          mean_height(plan, f, horizons.sheets[horizons.of_cell[c]]);
        EXPECT_NEAR(volume, wanted, 5e-4 * wanted) << b;
    }
}

}  // namespace
}  // namespace stratareeb
