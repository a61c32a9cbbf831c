// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/slabs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "boreholes/errors.h"
#include "mesh/level_cuts.h"
#include "mesh/match_seams.h"
#include "mesh/thickness_regions.h"

namespace stratareeb {
namespace {

constexpr double kClearance = 1e-6;  // of the model's height

//! Lowest base and highest ground, in the model's frame.
std::pair<double, double> range_of(const LayerModel& model) {
    return {*std::ranges::min_element(model.horizons.back()),
            *std::ranges::max_element(model.horizons.front())};
}

}  // namespace

SlabCutter::SlabCutter(const LayerModel& model, std::vector<double> levels) {
    std::tie(low_, high_) = range_of(model);
    const double z = model.origin.z;
    std::vector<double> values;
    for (const auto& horizon : model.horizons) values.insert(values.end(), horizon.begin(), horizon.end());
    std::ranges::sort(values);
    for (const double level : levels) {
        if (!(level - z > low_ && level - z < high_))
            throw InvalidInput(
                fmt::format("the level {:.10g} is not between the model's lowest base {:.10g} and highest "
                            "ground {:.10g}",
                            level, low_ + z, high_ + z));
        cuts_.push_back(clear_level(values, level - z, kClearance * (high_ - low_)));
        if (cuts_.size() > 1 && !(cuts_.back() > cuts_[cuts_.size() - 2]))
            throw InvalidInput(fmt::format("levels must ascend; {:.10g} comes after {:.10g}", level,
                                           levels[cuts_.size() - 2]));
    }
    cut_ = cut_at_levels(model, cuts_);
    if (!cut_.seams.empty()) {
        cut_.regions = regions_of_thickness(cut_.plan.surface, cut_.horizons);
        match_seams(cut_);
    }
    for (const double cut : cuts_) levels_.push_back(cut + z);
}

Slab SlabCutter::slab(std::size_t i) const {
    const double z = cut_.origin.z;
    const double low = i == 0 ? low_ : cuts_[i - 1], high = i == cuts_.size() ? high_ : cuts_[i];
    Slab slab{low + z, high + z, cut_};
    LayerModel& model = slab.model;
    for (auto& horizon : model.horizons)
        for (double& value : horizon) value = std::clamp(value, low, high);
    model.regions = regions_of_thickness(model.plan.surface, model.horizons);
    if (!model.seams.empty()) model.seams = seams_of_pieces(model.plan.surface, model.horizons);
    return slab;
}

std::vector<double> even_levels(const LayerModel& model, std::size_t count) {
    const auto [low, high] = range_of(model);
    if (count == 0 || !(high > low))
        throw InvalidInput("slabs: give 1 or more, of a model that has a height");
    std::vector<double> levels;
    for (std::size_t i = 1; i < count; ++i)
        levels.push_back(model.origin.z + low +
                         (high - low) * static_cast<double>(i) / static_cast<double>(count));
    return levels;
}

}  // namespace stratareeb
