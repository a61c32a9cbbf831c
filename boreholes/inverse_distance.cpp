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

bool has_same_sites(const SiteField& a, const SiteField& b, std::size_t sites) {
    for (std::size_t i = 0; i < sites; ++i)
        if (a.is_measured(i) != b.is_measured(i)) return false;
    return true;
}

double mean_of(std::span<const double> value, const std::vector<std::uint32_t>& site,
               const std::vector<NearSite>& near, const std::vector<double>& weight) {
    double sum = 0, weights = 0, low = value[site[near[0].site]], high = low;
    for (std::size_t k = 0; k < near.size(); ++k) {
        const double v = value[site[near[k].site]];
        sum += weight[k] * v, weights += weight[k];
        low = std::min(low, v), high = std::max(high, v);
    }
    return std::clamp(sum / weights, low, high);
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
    std::vector<char> done(fields.size(), 0);
    for (std::size_t f = 0; f < fields.size(); ++f) {
        if (done[f]) continue;
        const FieldSites sites = measured_sites(holes_->sites(), fields[f]);
        std::vector<std::size_t> alike;  // fields with the same sites, and so the same weights
        for (std::size_t g = f; g < fields.size(); ++g)
            if (!done[g] && has_same_sites(fields[f], fields[g], holes_->sites().size()))
                alike.push_back(g), done[g] = 1;
        if (sites.size() == 0) continue;
        const NearestSites index(sites.at);
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, where.size(), 256), [&](const auto& range) {
            std::vector<NearSite> near;
            std::vector<double> weight;
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                index.nearest(sites.frame.to_local(inside[i]), neighbours_ + 1, near);
                set_weights(near, weight);
                for (const std::size_t g : alike)
                    result[g][i] = mean_of(fields[g].value, sites.site, near, weight);
            }
        });
    }
    return result;
}

void InverseDistance::set_weights(std::vector<NearSite>& near, std::vector<double>& weight) const {
    weight.assign(1, 1);
    if (near[0].squared_distance == 0) return near.resize(1);
    double beyond = 0;  // 1 / R
    if (near.size() > neighbours_) {
        beyond = 1 / std::sqrt(near.back().squared_distance);
        near.pop_back();
    }
    weight.clear();
    const double closest = std::sqrt(near[0].squared_distance);
    bool any = false;
    for (const NearSite& n : near) {
        // times the closest distance, which keeps powers within doubles
        const double closeness = std::max(0.0, (1 / std::sqrt(n.squared_distance) - beyond) * closest);
        weight.push_back(power_ == 2 ? closeness * closeness : std::pow(closeness, power_));
        any |= weight.back() > 0;
    }
    if (!any) weight.assign(near.size(), 1);  // all equally far
}

}  // namespace stratareeb
