// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/ring_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stratareeb {

namespace {

constexpr double kMostSteps = 4e6;  // distances from corner to edge, over all pairs of rings
constexpr std::size_t kMostTried = 4096;

struct Gap {
    Point2 middle;
    double length = std::numeric_limits<double>::infinity();
};

using Ring = std::vector<Point2>;

Gap gap_at(const Point2& p, const Ring& ring) {
    Point2 nearest;
    double least = std::numeric_limits<double>::infinity();
    Point2 a = ring.back();
    for (const Point2& b : ring) {
        const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
        const double u =
            squared > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0) : 0.0;
        const Point2 q{a.x + u * dx, a.y + u * dy};
        const double away = (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y);
        if (away < least) least = away, nearest = q;
        a = b;
    }
    return {{p.x + (nearest.x - p.x) / 2, p.y + (nearest.y - p.y) / 2}, std::sqrt(least)};
}

void add_gaps(const Ring& from, const Ring& to, double steps, std::vector<Gap>& gaps) {
    const double all = static_cast<double>(from.size()) * static_cast<double>(to.size());
    const auto stride = static_cast<std::size_t>(std::max(1.0, std::ceil(all / steps)));
    for (std::size_t i = 0; i < from.size(); i += stride) gaps.push_back(gap_at(from[i], to));
}

using Allowed = std::function<bool(const Point2&)>;

Gap shortest_gap(const Ring& a, const Ring& b, double steps, const Allowed& allowed) {
    std::vector<Gap> gaps;
    add_gaps(a, b, steps / 2, gaps);
    add_gaps(b, a, steps / 2, gaps);
    std::ranges::stable_sort(gaps, {}, &Gap::length);
    for (std::size_t i = 0; i < std::min(gaps.size(), kMostTried); ++i)
        if (gaps[i].length > 0 && allowed(gaps[i].middle)) return gaps[i];
    return gaps.front();
}

//! The gaps that join all rings with least length (R. Prim 1957).
std::vector<Gap> joining_gaps(std::span<const Ring> rings, const Allowed& allowed) {
    const auto count = static_cast<double>(rings.size());
    const double steps = kMostSteps / (count * (count - 1) / 2);
    std::vector<Gap> nearest(rings.size()), result;
    std::vector<bool> joined(rings.size(), false);
    std::size_t last = 0;
    while (result.size() + 1 < rings.size()) {
        joined[last] = true;
        std::size_t next = rings.size();
        for (std::size_t r = 0; r < rings.size(); ++r) {
            if (joined[r]) continue;
            const Gap gap = shortest_gap(rings[last], rings[r], steps, allowed);
            if (gap.length < nearest[r].length) nearest[r] = gap;
            if (next == rings.size() || nearest[r].length < nearest[next].length) next = r;
        }
        result.push_back(nearest[next]);
        last = next;
    }
    return result;
}

}  // namespace

Point2 ring_gap(std::span<const Ring> rings, const Allowed& allowed) {
    const std::vector<Gap> gaps = joining_gaps(rings, allowed);
    if (gaps.size() == 1) return gaps.front().middle;
    Point2 offset;  // from the first, so that far coordinates lose nothing
    const Point2 origin = gaps.front().middle;
    for (const Gap& gap : gaps)
        offset = {offset.x + gap.middle.x - origin.x, offset.y + gap.middle.y - origin.y};
    const auto count = static_cast<double>(gaps.size());
    const Point2 mean{origin.x + offset.x / count, origin.y + offset.y / count};
    if (allowed(mean)) return mean;
    return std::ranges::min_element(
               gaps, {},
               [&](const Gap& gap) { return std::hypot(gap.middle.x - mean.x, gap.middle.y - mean.y); })
        ->middle;
}

}  // namespace stratareeb
