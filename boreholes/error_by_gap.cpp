// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/error_by_gap.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "boreholes/nearest_sites.h"

namespace stratareeb {

namespace {

constexpr std::size_t kClass = 30;  // errors that a class has at least
constexpr std::size_t kMostClasses = 12;

}  // namespace

double GapProfile::at(double distance) const {
    if (gap.empty()) return 0;
    const auto above = static_cast<std::size_t>(std::ranges::upper_bound(gap, distance) - gap.begin());
    if (above == 0) return size.front();
    if (above == gap.size()) return size.back();
    const double t = (distance - gap[above - 1]) / (gap[above] - gap[above - 1]);
    return size[above - 1] + t * (size[above] - size[above - 1]);
}

ErrorByGap::ErrorByGap(std::span<const PlacedError> errors) {
    const std::size_t count = std::clamp<std::size_t>(errors.size() / kClass, 1, kMostClasses);
    classes_.resize(count);
    std::vector<std::size_t> order(errors.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return errors[i].gap; });
    std::size_t number = 0;
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
        const PlacedError& error = errors[order[rank]];
        // Equal gaps stay together, so that the order of the list has no say.
        if (rank > 0 && errors[order[rank - 1]].gap != error.gap) number = rank * count / order.size();
        auto& own = of_draw_[error.draw];
        own.resize(count);
        for (Class* c : {&classes_[number], &own[number]}) {
            c->gap += error.gap;
            c->size += std::abs(error.error);
            c->count += 1;
        }
    }
}

//! Neighbouring classes of which the nearer has the larger errors become one.
GapProfile ErrorByGap::rising(const std::vector<Class>& classes) {
    std::vector<Class> pooled;
    for (const Class& next : classes) {
        if (next.count <= 0) continue;
        pooled.push_back(next);
        while (pooled.size() > 1) {
            const Class last = pooled.back();
            Class& before = pooled[pooled.size() - 2];
            const bool rises = before.size * last.count < last.size * before.count;
            if (rises && before.gap * last.count < last.gap * before.count) break;
            before = {before.gap + last.gap, before.size + last.size, before.count + last.count};
            pooled.pop_back();
        }
    }
    GapProfile profile;
    for (const Class& c : pooled) {
        profile.gap.push_back(c.gap / c.count);
        profile.size.push_back(std::max(c.size, 0.0) / c.count);
    }
    return profile;
}

GapProfile ErrorByGap::profile() const {
    return rising(classes_);
}

GapProfile ErrorByGap::without(std::size_t draw) const {
    const auto own = of_draw_.find(draw);
    if (own == of_draw_.end()) return profile();
    std::vector<Class> others = classes_;
    for (std::size_t i = 0; i < others.size(); ++i) {
        others[i].gap -= own->second[i].gap;
        others[i].size -= own->second[i].size;
        others[i].count -= own->second[i].count;
    }
    return rising(others);
}

std::vector<double> gaps_to_other_draws(std::span<const Point2> know, std::span<const std::size_t> draw,
                                        std::span<const std::size_t> asked) {
    if (know.empty()) return std::vector<double>(asked.size(), 0.0);
    const NearestSites index(know);
    std::vector<double> result;
    std::vector<NearSite> near;
    for (const std::size_t hole : asked) {
        double gap = 0;
        bool found = false;
        for (std::size_t count = 4; !found; count *= 4) {
            index.nearest(know[hole], count, near);
            for (const NearSite& site : near) {
                if (draw[site.site] == draw[hole]) continue;
                gap = std::sqrt(site.squared_distance), found = true;
                break;
            }
            if (count >= know.size()) break;
        }
        result.push_back(gap);
    }
    return result;
}

}  // namespace stratareeb
