// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/inverse_distance.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "boreholes/closest_in_hull.h"
#include "boreholes/errors.h"
#include "boreholes/field_sites.h"
#include "boreholes/nearest_sites.h"

namespace stratareeb {

namespace {

FieldSites measured_sites(std::span<const Point2> sites, const SiteField& field) {
    std::vector<char> use(sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) use[i] = static_cast<char>(field.is_measured(i));
    return field_sites(sites, {field.value, use});
}

}  // namespace

InverseDistance::InverseDistance(std::shared_ptr<const HoleTriangulation> holes,
                                 const InterpolatorOptions& options)
    : holes_(std::move(holes)), power_(options.power), neighbours_(options.neighbours) {
    if (!(power_ > 0) || neighbours_ < 1)
        throw InvalidInput("inverse distance needs a power above 0 and at least one neighbour");
}

std::vector<std::vector<double>> InverseDistance::predict(std::span<const Point2> where,
                                                          std::span<const SiteField> fields) const {
    std::vector<std::vector<double>> result(fields.size(), std::vector<double>(where.size()));
    const std::vector<Point2> inside = closest_in_hull(*holes_, where);
    for (std::size_t f = 0; f < fields.size(); ++f) {
        const FieldSites sites = measured_sites(holes_->sites(), fields[f]);
        if (sites.size() == 0) continue;
        const NearestSites index(sites.at);
        const auto mean_at = [&](const Point2& p, std::vector<NearSite>& near) {
            index.nearest(p, neighbours_ + 1, near);
            if (near[0].squared_distance == 0) return sites.value[near[0].site];
            double beyond = 0;  // 1 / R
            if (near.size() > neighbours_) {
                beyond = 1 / std::sqrt(near.back().squared_distance);
                near.pop_back();
            }
            const double closest = std::sqrt(near[0].squared_distance);
            double sum = 0, weights = 0, low = sites.value[near[0].site], high = low;
            for (const NearSite& n : near) {
                // times the closest distance, which keeps powers within doubles
                const double closeness =
                    std::max(0.0, (1 / std::sqrt(n.squared_distance) - beyond) * closest);
                const double w = power_ == 2 ? closeness * closeness : std::pow(closeness, power_);
                sum += w * sites.value[n.site], weights += w;
                low = std::min(low, sites.value[n.site]), high = std::max(high, sites.value[n.site]);
            }
            if (!(weights > 0)) {  // all equally far
                sum = 0, weights = static_cast<double>(near.size());
                for (const NearSite& n : near) sum += sites.value[n.site];
            }
            return std::clamp(sum / weights, low, high);
        };
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, where.size(), 256), [&](const auto& range) {
            std::vector<NearSite> near;
            for (std::size_t i = range.begin(); i < range.end(); ++i)
                result[f][i] = mean_at(sites.frame.to_local(inside[i]), near);
        });
    }
    return result;
}

}  // namespace stratareeb
