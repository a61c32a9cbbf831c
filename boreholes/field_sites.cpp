// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/field_sites.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace stratareeb {

namespace {

bool is_bound(const SiteField& field, std::uint32_t i) {
    return !field.at_least.empty() && field.at_least[i];
}

std::vector<std::uint32_t> sites_with_a_say(std::span<const Point2> sites, const SiteField& field) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < sites.size(); ++i)
        if (field.use.empty() || field.use[i]) order.push_back(i);
    std::ranges::sort(order, {}, [&](std::uint32_t i) {
        return std::tuple(sites[i].x, sites[i].y, is_bound(field, i), i);
    });
    const auto repeated =
        std::ranges::unique(order, {}, [&](std::uint32_t i) { return std::pair(sites[i].x, sites[i].y); });
    order.erase(repeated.begin(), repeated.end());
    std::ranges::sort(order);
    return order;
}

PlanFrame frame_of(std::span<const Point2> sites, std::span<const std::uint32_t> chosen) {
    if (chosen.empty()) return {};
    Point2 low = sites[chosen[0]], high = low;
    for (const std::uint32_t i : chosen) {
        low = {std::min(low.x, sites[i].x), std::min(low.y, sites[i].y)};
        high = {std::max(high.x, sites[i].x), std::max(high.y, sites[i].y)};
    }
    const double extent = std::max(high.x - low.x, high.y - low.y);
    const double scale = extent > 0 ? std::ldexp(1.0, 1 - std::ilogb(extent)) : 1;
    return {{low.x + (high.x - low.x) / 2, low.y + (high.y - low.y) / 2}, scale, 0, 0, scale};
}

}  // namespace

PlanFrame PlanFrame::then(double a, double b, double c, double d) const {
    return {origin, a * xx + b * yx, a * xy + b * yy, c * xx + d * yx, c * xy + d * yy};
}

FieldSites field_sites(std::span<const Point2> sites, const SiteField& field) {
    FieldSites result;
    result.site = sites_with_a_say(sites, field);
    result.frame = frame_of(sites, result.site);
    for (const std::uint32_t i : result.site) {
        result.at.push_back(result.frame.to_local(sites[i]));
        result.value.push_back(field.value[i]);
        result.at_least.push_back(static_cast<char>(is_bound(field, i)));
        result.measured += !is_bound(field, i);
    }
    return result;
}

FieldSites in_frame(const FieldSites& sites, std::span<const Point2> all_sites, const PlanFrame& frame) {
    FieldSites result = sites;
    result.frame = frame;
    for (std::size_t k = 0; k < sites.size(); ++k) result.at[k] = frame.to_local(all_sites[sites.site[k]]);
    return result;
}

SiteLookup::SiteLookup(std::span<const Point2> all_sites, const FieldSites& sites) {
    for (std::size_t k = 0; k < sites.size(); ++k)
        if (!sites.at_least[k]) entries_.push_back({all_sites[sites.site[k]], sites.value[k]});
    std::ranges::sort(entries_, {}, [](const Entry& e) { return std::pair(e.at.x, e.at.y); });
}

const double* SiteLookup::value_at(const Point2& p) const {
    const auto found = std::ranges::lower_bound(entries_, std::pair(p.x, p.y), {},
                                                [](const Entry& e) { return std::pair(e.at.x, e.at.y); });
    return found != entries_.end() && found->at == p ? &found->value : nullptr;
}

ValueLimits value_limits(std::span<const double> values) {
    if (values.empty()) return {};
    const auto [low, high] = std::ranges::minmax(values);
    const double slack = (high - low) / 2;
    return {low > 0 ? std::max(low - slack, low / 2) : low - slack, high + slack};
}

}  // namespace stratareeb
