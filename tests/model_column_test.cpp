// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/model_column.h"

#include <gtest/gtest.h>

#include <cmath>

#include "boreholes/random_survey.h"

namespace stratareeb {
namespace {

TEST(ModelColumn, at_a_hole_is_the_hole_s_own_log) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Survey survey = random_survey({.holes = 30,
                                             .layers = 5,
                                             .seed = seed,
                                             .corner = {5e6, 4.9e6},
                                             .truth = TruthKind::Lens,
                                             .pinch_outs = true,
                                             .zero_share = 0.2});
        const LayerModel model = build_layer_model(survey);
        const ColumnQuery query(model);
        for (const Borehole& hole : survey.holes) {
            const auto column = query.column(hole.at);
            ASSERT_TRUE(column);
            EXPECT_NEAR(column->horizons[0], *hole.horizons[0], 1e-9);
            for (std::size_t i = 0; i < hole.layers.size(); ++i) {
                EXPECT_NEAR(column->thickness(i), hole.layers[i].thickness, 1e-9);
                if (hole.layers[i].is_absent()) {
                    EXPECT_EQ(column->thickness(i), 0);
                }
            }
        }
    }
}

TEST(ModelColumn, volumes_of_columns_add_up_to_the_envelope) {
    const Survey survey = random_survey({.holes = 20, .seed = 4});
    const LayerModel model = build_layer_model(survey);
    const ColumnQuery query(model);
    // Midpoint rule on a grid: second order, the outline is a square.
    constexpr int kCells = 300;
    constexpr double kStep = 300.0 / kCells;
    double volume = 0;
    for (int i = 0; i < kCells; ++i)
        for (int j = 0; j < kCells; ++j) {
            const auto column = query.column({(i + 0.5) * kStep, (j + 0.5) * kStep});
            ASSERT_TRUE(column);
            volume += (column->horizons.front() - column->horizons.back()) * kStep * kStep;
        }
    EXPECT_NEAR(volume / envelope_volume(model), 1, 1e-4);
}

TEST(ModelColumn, knows_the_layer_at_an_elevation) {
    const ModelColumn column{.at = {}, .horizons = {10, 8, 8, 3}};
    EXPECT_EQ(column.layer_at(10.001), std::nullopt);
    EXPECT_EQ(column.layer_at(10), 0u);
    EXPECT_EQ(column.layer_at(9), 0u);
    EXPECT_EQ(column.layer_at(8), 0u);  // where two meet, the upper one
    EXPECT_EQ(column.layer_at(7.999), 2u);
    EXPECT_EQ(column.layer_at(3), 2u);
    EXPECT_EQ(column.layer_at(2.999), std::nullopt);
    EXPECT_EQ(column.layer_at(std::nan("")), std::nullopt);
}

}  // namespace
}  // namespace stratareeb
