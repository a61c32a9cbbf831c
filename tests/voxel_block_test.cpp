// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/voxel_block.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "boreholes/errors.h"
#include "boreholes/random_survey.h"
#include "mesh/layer_volumes.h"
#include "mesh/model_column.h"
#include "tests/grid_model.h"

namespace stratareeb {
namespace {

using test::constant;
using test::grid_model;

TEST(VoxelBlock, has_at_each_middle_what_the_column_there_has) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        SCOPED_TRACE(seed);
        const LayerModel model = build_layer_model(random_survey({.holes = 25,
                                                                  .layers = 4,
                                                                  .seed = seed,
                                                                  .corner = {5e5, 2e5},
                                                                  .pinch_outs = true,
                                                                  .zero_share = 0.3}));
        const VoxelBlock block = voxel_block(model, 11.3, 3.7);
        const ColumnQuery query(model);
        for (std::size_t row = 0; row < block.plan.rows; ++row)
            for (std::size_t column = 0; column < block.plan.columns; ++column) {
                const Point2 at{block.plan.north_west.x + (static_cast<double>(column) + 0.5) * 11.3,
                                block.plan.north_west.y - (static_cast<double>(row) + 0.5) * 11.3};
                const auto log = query.column(at);
                for (std::size_t level = 0; level < block.levels; ++level) {
                    const auto layer = log ? log->layer_at(block.middle(level)) : std::nullopt;
                    ASSERT_EQ(block.unit(level, row, column), layer ? *layer + 1 : 0)
                        << at.x << " " << at.y << " " << block.middle(level);
                }
            }
    }
}

//! Holes stand in the middles of cells of 10, whose sides lie at multiples of 10.
TEST(VoxelBlock, is_what_the_hole_says_at_a_borehole) {
    Survey survey = random_survey({.holes = 36, .layers = 4, .seed = 5, .pinch_outs = true});
    for (std::size_t h = 0; h < 36; ++h) {
        const double x = static_cast<double>(h % 6), y = static_cast<double>(h / 6);
        survey.holes[h].at = {1000 + 60 * x + 5, 2000 + 60 * y + 5};
    }
    const LayerModel model = build_layer_model(survey);
    const VoxelBlock block = voxel_block(model, 10, 0.7);
    std::size_t asked = 0;
    for (const Borehole& hole : survey.holes) {
        const auto column = static_cast<std::size_t>((hole.at.x - block.plan.north_west.x) / 10);
        const auto row = static_cast<std::size_t>((block.plan.north_west.y - hole.at.y) / 10);
        for (std::size_t level = 0; level < block.levels; ++level) {
            std::size_t expected = 0;
            bool close = false;  // to a contact, where rounding decides
            double top = *hole.horizons[0];
            for (std::size_t i = 0; i < 4; ++i) {
                const double base = top - hole.layers[i].thickness, z = block.middle(level);
                close |= std::abs(z - top) < 1e-6 || std::abs(z - base) < 1e-6;
                if (expected == 0 && base <= z && z <= top && hole.layers[i].thickness > 0) expected = i + 1;
                top = base;
            }
            if (close) continue;
            ++asked;
            EXPECT_EQ(block.unit(level, row, column), expected) << hole.id << " " << block.middle(level);
        }
    }
    EXPECT_GT(asked, 1000u);
}

TEST(VoxelBlock, volumes_converge_at_first_order_or_better) {
    std::array<double, 4> error{};
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        // No outline along the cells' sides: its share would jump with the size.
        const LayerModel model = build_layer_model(
            random_survey({.holes = 25, .layers = 3, .seed = seed, .pinch_outs = true, .corners = false}));
        const auto exact = layer_volumes(model);
        for (std::size_t k = 0; k < error.size(); ++k)
            for (const double size : {1.0, 0.91, 0.83}) {
                const double shrink = size * std::pow(0.5, static_cast<double>(k));
                const auto volumes = voxel_volumes(voxel_block(model, 30.7 * shrink, 4.3 * shrink), 3);
                for (std::size_t i = 0; i < 3; ++i)
                    error[k] += std::abs(volumes[i] - exact[i]) / envelope_volume(model) / 54;
            }
    }
    for (std::size_t k = 1; k < error.size(); ++k) EXPECT_LT(error[k], error[k - 1]);
    const double rate = std::log2(error.front() / error.back()) / 3;
    EXPECT_GE(rate, 1.25) << error[0] << " " << error[3];
    EXPECT_LT(error.back(), 1e-3);
    RecordProperty("rate", std::to_string(rate));
}

//! Any outline: a cell is counted wrongly only if a surface of the layer passes it.
TEST(VoxelBlock, volumes_are_within_the_cells_that_surfaces_meet) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const LayerModel model =
            build_layer_model(random_survey({.holes = 25, .layers = 3, .seed = seed, .pinch_outs = true}));
        const auto exact = layer_volumes(model);
        for (const double size : {30.0, 11.0, 4.0}) {
            const auto volumes = voxel_volumes(voxel_block(model, size, size / 5), 3);
            for (std::size_t i = 0; i < 3; ++i) {
                const auto solid = build_layer_solid(model, i).surface;
                double surface = 0;
                for (const auto f : solid.faces()) surface += solid.calc_face_area(f);
                EXPECT_LE(std::abs(volumes[i] - exact[i]), surface * size);
            }
        }
    }
}

TEST(VoxelBlock, of_cells_that_fit_is_exact) {
    const LayerModel slab = grid_model({.ground = constant(10), .thickness = {constant(2), constant(4)}});
    const VoxelBlock block = voxel_block(slab, 5, 0.5);
    EXPECT_EQ(block.levels, 12u);
    EXPECT_EQ(block.bottom, 4);
    const auto volumes = voxel_volumes(block, 2);
    EXPECT_DOUBLE_EQ(volumes[0], 2e4);
    EXPECT_DOUBLE_EQ(volumes[1], 4e4);
    // A middle on a contact belongs to the layer above it, one on the ground to the top layer.
    const VoxelBlock on_contacts =
        voxel_block(grid_model({.ground = constant(10.5), .thickness = {constant(2), constant(4)}}), 50, 1);
    EXPECT_EQ(on_contacts.unit(on_contacts.levels - 1, 0, 0), 1);
    EXPECT_EQ(on_contacts.unit(on_contacts.levels - 3, 0, 0), 1);
    EXPECT_EQ(on_contacts.unit(on_contacts.levels - 4, 0, 0), 2);
}

TEST(VoxelBlock, refuses_sizes_that_make_no_sense) {
    const LayerModel slab = grid_model({.thickness = {constant(2)}});
    EXPECT_THROW(voxel_block(slab, 0, 1), InvalidInput);
    EXPECT_THROW(voxel_block(slab, 1, 0), InvalidInput);
    EXPECT_THROW(voxel_block(slab, 1, -1), InvalidInput);
    EXPECT_THROW(voxel_block(slab, 1, NAN), InvalidInput);
    EXPECT_THROW(voxel_block(slab, 0.1, 1e-6), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
