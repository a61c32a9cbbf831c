// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/pinched_band.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "reeb/stair_paths.h"

namespace stratareeb {

namespace {

SpanContours exchanged(const SpanContours& c) {
    return {.upper = c.lower,
            .lower = c.upper,
            .upper_parameters = c.lower_parameters,
            .lower_parameters = c.upper_parameters,
            .cost = c.cost,
            .closed = c.closed};
}

SpanPath exchanged(SpanPath path) {
    std::swap(path.upper, path.lower);
    for (std::uint8_t& up : path.upper_advances) up = up ? 0 : 1;
    return path;
}

//! The cheapest cycle that climbs from row `upper` in column `lower`, takes one lower step on the way, climbs the rest, and
//! goes home.
SpanPath split_climb(const SpanContours& c, std::uint32_t upper, std::uint32_t lower) {
    const SpanCosts costs(c, upper, lower);
    const std::size_t m = c.upper.size(), n = c.lower.size();
    const auto rise = static_cast<std::ptrdiff_t>(m), run = static_cast<std::ptrdiff_t>(n);
    double before = 0, after = 0, way_home = 0;
    for (std::ptrdiff_t i = 1; i <= rise; ++i) after += costs.arrivals(i, 1)[0];
    for (std::ptrdiff_t j = 2; j <= run; ++j) way_home += costs.arrivals(rise, j)[1];
    double best = 0;
    std::ptrdiff_t split = 0;
    for (std::ptrdiff_t i = 1; i < rise; ++i) {
        before += costs.arrivals(i, 0)[0];
        after -= costs.arrivals(i, 1)[0];
        const double cost = before + costs.arrivals(i, 1)[1] + after;
        if (split == 0 || cost < best) best = cost, split = i;
    }
    SpanPath path{.upper = upper,
                  .lower = lower,
                  .upper_advances = std::vector<std::uint8_t>(m + n, 0),
                  .cost = best + way_home};
    std::fill_n(path.upper_advances.begin(), m + 1, 1);
    path.upper_advances[static_cast<std::size_t>(split)] = 0;
    return path;
}

}  // namespace

bool is_pinched(const SpanPath& cycle) {
    std::size_t changes = 0;
    const auto& steps = cycle.upper_advances;
    for (std::size_t t = 0; t < steps.size(); ++t)
        changes += steps[t] != steps[t == 0 ? steps.size() - 1 : t - 1];
    return changes <= 2;
}

SpanPath opened(const SpanPath& pinched, const SpanContours& c) {
    SpanPath start = pinched;  // turned so that it climbs first
    std::size_t first = 0;
    const auto& steps = pinched.upper_advances;
    while (!steps[first] || steps[first == 0 ? steps.size() - 1 : first - 1]) ++first;
    turn(start, first, c);
    const auto m = static_cast<std::uint32_t>(c.upper.size()), n = static_cast<std::uint32_t>(c.lower.size());
    const SpanContours swapped = exchanged(c);
    SpanPath best = split_climb(c, start.upper, start.lower);
    for (const SpanPath& other : {split_climb(c, start.upper, (start.lower + n - 1) % n),
                                  exchanged(split_climb(swapped, start.lower, start.upper)),
                                  exchanged(split_climb(swapped, start.lower, (start.upper + m - 1) % m))})
        if (other.cost < best.cost) best = other;
    return best;
}

}  // namespace stratareeb
