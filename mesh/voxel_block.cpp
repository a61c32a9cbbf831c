// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/voxel_block.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boreholes/errors.h"

namespace stratareeb {

namespace {

//! Levels between the lowest base and the highest ground.
void set_levels(VoxelBlock& block, const LayerModel& model) {
    constexpr double kMostCells = 2e9;
    const double low = *std::ranges::min_element(model.horizons.back()) + model.origin.z;
    const double high = *std::ranges::max_element(model.horizons.front()) + model.origin.z;
    const double first = std::floor(low / block.height), last = std::ceil(high / block.height);
    const double levels = std::max(1.0, last - first);
    const double cells = levels * static_cast<double>(block.cells_per_level());
    if (!(cells <= kMostCells))
        throw InvalidInput(fmt::format("cells of {} by {} make {:.3g} of them; give larger ones",
                                       block.plan.cell, block.height, cells));
    block.bottom = first * block.height;
    block.levels = static_cast<std::size_t>(levels);
}

//! The first level with its middle above z (clamped to the block).
std::size_t level_above(const VoxelBlock& block, double z) {
    const double guess = std::floor((z - block.bottom) / block.height - 0.5);
    auto level = static_cast<std::size_t>(std::clamp(guess, 0.0, static_cast<double>(block.levels)));
    while (level < block.levels && block.middle(level) <= z) ++level;
    return level;
}

}  // namespace

VoxelBlock voxel_block(const LayerModel& model, double cell, double height) {
    if (!(height > 0) || !std::isfinite(height))
        throw InvalidInput(fmt::format("cells of height {}: give a length above 0", height));
    VoxelBlock block{.plan = grid_over(model, cell), .bottom = 0, .height = height, .levels = 0, .units = {}};
    set_levels(block, model);
    const std::size_t cells = block.cells_per_level();
    block.units.assign(cells * block.levels, 0);
    // A layer reaches from its base (the level's middle on it included: the upper of two layers) up to below its top;
    // the ground itself belongs to what lies under it.
    std::vector<const std::vector<double>*> fields;
    for (const auto& horizon : model.horizons) fields.push_back(&horizon);
    const auto horizons = rasterized(model, block.plan, fields);
    for (std::size_t layer = 0; layer < model.units.size(); ++layer) {
        const auto &top = horizons[layer], &base = horizons[layer + 1];
        for (std::size_t c = 0; c < cells; ++c) {
            if (!(top[c] > base[c])) continue;  // absent, or outside
            const double low = base[c] + model.origin.z, high = top[c] + model.origin.z;
            std::size_t level = level_above(block, low);
            while (level > 0 && block.middle(level - 1) >= low) --level;
            for (; level < block.levels && block.middle(level) <= high; ++level) {
                auto& unit = block.units[level * cells + c];
                if (unit == 0) unit = static_cast<std::uint16_t>(layer + 1);
            }
        }
    }
    return block;
}

std::vector<double> voxel_volumes(const VoxelBlock& block, std::size_t layers) {
    std::vector<std::size_t> count(layers + 1, 0);
    for (const std::uint16_t unit : block.units) ++count[unit];
    std::vector<double> volumes;
    for (std::size_t i = 1; i <= layers; ++i)
        volumes.push_back(static_cast<double>(count[i]) * block.plan.cell * block.plan.cell * block.height);
    return volumes;
}

}  // namespace stratareeb
