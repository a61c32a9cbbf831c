// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/linear_tin.h"

namespace stratareeb {

namespace {

double weighted_mean(const PlanLocation& location, const SiteField& field) {
    double sum = 0, weight_sum = 0;
    for (int k = 0; k < 3; ++k) {
        const auto site = location.site[k];
        if (location.weight[k] == 1 && field.is_measured(site)) return field.value[site];
        if (location.weight[k] == 0 || !field.is_measured(site)) continue;
        sum += location.weight[k] * field.value[site];
        weight_sum += location.weight[k];
    }
    return weight_sum > 0 ? sum / weight_sum : 0.0;
}

}  // namespace

std::vector<std::vector<double>> LinearTin::predict(std::span<const Point2> where,
                                                    std::span<const SiteField> fields) const {
    const std::vector<PlanLocation> locations = holes_->locate(where);
    std::vector<std::vector<double>> result(fields.size(), std::vector<double>(where.size()));
    for (std::size_t f = 0; f < fields.size(); ++f)
        for (std::size_t i = 0; i < where.size(); ++i) result[f][i] = weighted_mean(locations[i], fields[f]);
    return result;
}

}  // namespace stratareeb
