// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/sibson_c0.h"

#include <algorithm>
#include <limits>

namespace stratareeb {

namespace {

double weighted_mean(const NaturalPlace& place, const SiteField& field) {
    double share = 0, sum = 0, low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& [site, weight] : place.weights) {
        if (!field.is_measured(site) || weight == 0) continue;
        share += weight;
        sum += weight * field.value[site];
        low = std::min(low, field.value[site]), high = std::max(high, field.value[site]);
    }
    return share > 0 ? std::clamp(sum / share, low, high) : 0.0;
}

}  // namespace

std::vector<std::vector<double>> SibsonC0::predict(std::span<const Point2> where,
                                                   std::span<const SiteField> fields) const {
    std::vector<std::vector<double>> result(fields.size(), std::vector<double>(where.size()));
    holes_->for_each_natural_place(where, [&](std::size_t i, const NaturalPlace& place) {
        for (std::size_t f = 0; f < fields.size(); ++f) result[f][i] = weighted_mean(place, fields[f]);
    });
    return result;
}

}  // namespace stratareeb
