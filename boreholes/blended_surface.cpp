// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/blended_surface.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace stratareeb {

namespace {

constexpr std::size_t kPatchesAsked = 12;  // for leave-one-out errors of large sets

template <class T>
std::vector<T> picked(const std::vector<T>& from, std::span<const std::uint32_t> which) {
    std::vector<T> result;
    for (const std::uint32_t i : which) result.push_back(from[i]);
    return result;
}

}  // namespace

ValueScale value_scale(const FieldSites& sites) {
    ValueScale scale;
    const double n = static_cast<double>(sites.measured);
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (!sites.at_least[i]) scale.mean += sites.value[i] / n;
    double variance = 0;
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (!sites.at_least[i]) variance += (sites.value[i] - scale.mean) * (sites.value[i] - scale.mean) / n;
    if (variance > 0) scale.spread = std::sqrt(variance);
    return scale;
}

BlendedSurface::BlendedSurface(const FieldSites& sites, RadialModel model, const PatchCoverOptions& options)
    : sites_(sites), model_(std::move(model)), cover_(sites.at, options) {
    const ValueScale scale = value_scale(sites);
    mean_ = scale.mean, spread_ = scale.spread;
    for (const double v : sites.value) scaled_.push_back((v - mean_) / spread_);
}

RadialSystem BlendedSurface::system(std::uint32_t patch) const {
    const auto which = cover_.sites(patch);
    return {picked(sites_.at, which), picked(scaled_, which), picked(sites_.at_least, which), model_};
}

BlendedSurface::Result BlendedSurface::at(std::span<const Point2> where, bool deviations) const {
    std::vector<std::vector<Place>> places(cover_.size());
    std::vector<std::size_t> first(where.size() + 1, 0);  // of a place's slots, in the order of patches
    std::vector<PatchWeight> weights;
    std::size_t slots = 0;
    std::vector<double> slot_weight;
    for (std::size_t i = 0; i < where.size(); ++i) {
        cover_.weights(where[i], weights);
        for (const PatchWeight& w : weights) {
            places[w.patch].push_back({slots++, w.weight});
            slot_weight.push_back(w.weight);
        }
        first[i + 1] = slots;
    }
    std::vector<std::size_t> place_of(slots);
    for (std::size_t i = 0; i < where.size(); ++i)
        for (std::size_t k = first[i]; k < first[i + 1]; ++k) place_of[k] = i;
    std::vector<double> value(slots), variance(deviations ? slots : 0);
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t patch) {
        if (places[patch].empty()) return;
        const auto number = static_cast<std::uint32_t>(patch);
        const RadialSystem surface = system(number);
        const ValueLimits limits = value_limits(picked(sites_.value, cover_.sites(number)));
        const auto solve_at = [&](std::size_t k) {
            const std::size_t slot = places[patch][k].number;
            const Point2& p = where[place_of[slot]];
            value[slot] = limits.clamp(mean_ + spread_ * surface.value(p));
            if (deviations) variance[slot] = surface.variance(p);
        };
        tbb::parallel_for(std::size_t{0}, places[patch].size(), solve_at);
    });
    Result result{std::vector<double>(where.size()), std::vector<double>(deviations ? where.size() : 0)};
    for (std::size_t i = 0; i < where.size(); ++i) {
        double spread = 0;
        for (std::size_t k = first[i]; k < first[i + 1]; ++k) {
            result.value[i] += slot_weight[k] * value[k];
            if (deviations) spread += slot_weight[k] * std::sqrt(variance[k]);
        }
        if (deviations) result.deviation[i] = spread_ * spread;
    }
    return result;
}

std::vector<std::uint32_t> BlendedSurface::some_patches() const {
    std::vector<std::uint32_t> result;
    const std::size_t count = std::min(kPatchesAsked, cover_.size());
    for (std::size_t k = 0; k < count; ++k)
        result.push_back(static_cast<std::uint32_t>((2 * k + 1) * cover_.size() / (2 * count)));
    return result;
}

double BlendedSurface::leave_one_out_rms() const {
    const auto patches = some_patches();
    std::vector<double> sum(patches.size(), 0.0), count(patches.size(), 0.0);
    tbb::parallel_for(std::size_t{0}, patches.size(), [&](std::size_t k) {
        const auto which = cover_.sites(patches[k]);
        const auto error = system(patches[k]).leave_one_out_errors();
        for (std::size_t i = 0; i < which.size(); ++i) {
            if (sites_.at_least[which[i]] || !cover_.owns(patches[k], sites_.at[which[i]])) continue;
            sum[k] += error[i] * error[i], count[k] += 1;
        }
    });
    double all = 0, number = 0;
    for (std::size_t k = 0; k < patches.size(); ++k) all += sum[k], number += count[k];
    return number > 0 ? std::sqrt(all / number) : 0;
}

double BlendedSurface::energy_per_freedom() const {
    const auto patches = some_patches();
    double sum = 0;
    for (const std::uint32_t patch : patches) sum += system(patch).energy_per_freedom();
    return patches.empty() ? 1 : sum / static_cast<double>(patches.size());
}

}  // namespace stratareeb
