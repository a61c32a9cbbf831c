// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/stair_paths.h"

#include <algorithm>
#include <limits>

namespace stratareeb {

namespace {
constexpr double kInfinity = std::numeric_limits<double>::infinity();
}

SpanPath span_path(const StairPath& path, const SpanContours& contours, std::uint32_t first_upper,
                   std::uint32_t first_lower) {
    const auto row = static_cast<std::size_t>(first_upper) + static_cast<std::size_t>(path.start);
    SpanPath result{.upper = static_cast<std::uint32_t>(row % contours.upper.size()),
                    .lower = first_lower,
                    .upper_advances = {},
                    .cost = path.cost};
    result.upper_advances.reserve(path.rows.size());
    for (std::size_t t = 1; t < path.rows.size(); ++t)
        result.upper_advances.push_back(path.rows[t] != path.rows[t - 1]);
    return result;
}

void turn(SpanPath& cycle, std::size_t steps, const SpanContours& contours) {
    for (std::size_t t = 0; t < steps; ++t) {
        const bool up = cycle.upper_advances[t] != 0;
        std::uint32_t& end = up ? cycle.upper : cycle.lower;
        end = end + 1 == (up ? contours.upper.size() : contours.lower.size()) ? 0 : end + 1;
    }
    std::rotate(cycle.upper_advances.begin(),
                cycle.upper_advances.begin() + static_cast<std::ptrdiff_t>(steps),
                cycle.upper_advances.end());
}

std::size_t Corridor::spans() const {
    std::size_t sum = 0;
    for (std::size_t k = 0; k < lo.size(); ++k)
        if (lo[k] <= hi[k]) sum += static_cast<std::size_t>(hi[k] - lo[k] + 1);
    return sum;
}

StairPathFinder::StairPathFinder(const SpanCosts& costs, std::ptrdiff_t height)
    : costs_(costs), height_(height), from_(costs.array_size()), to_(costs.array_size()) {}

void StairPathFinder::bound_rows(std::ptrdiff_t start, const Corridor& corridor, const StairPath* left,
                                 const StairPath* right) {
    const std::ptrdiff_t length = height_ + costs_.columns();
    lo_.resize(static_cast<std::size_t>(length) + 1);
    hi_.resize(lo_.size());
    for (std::ptrdiff_t t = 0; t <= length; ++t) {
        const std::ptrdiff_t k = start + t;
        std::ptrdiff_t lo = std::max(start, k - costs_.columns()), hi = std::min(start + height_, k);
        lo = std::max<std::ptrdiff_t>(lo, corridor.lowest(k));
        hi = std::min<std::ptrdiff_t>(hi, corridor.highest(k));
        if (left && left->has(k)) lo = std::max<std::ptrdiff_t>(lo, left->row(k));
        if (right && right->has(k)) hi = std::min<std::ptrdiff_t>(hi, right->row(k));
        // A step moves on by one row at most.
        if (t > 0) {
            lo = std::max<std::ptrdiff_t>(lo, lo_[static_cast<std::size_t>(t) - 1]);
            hi = std::min<std::ptrdiff_t>(hi, hi_[static_cast<std::size_t>(t) - 1] + 1);
        }
        lo_[static_cast<std::size_t>(t)] = static_cast<std::int32_t>(lo);
        hi_[static_cast<std::size_t>(t)] = static_cast<std::int32_t>(hi);
    }
}

std::optional<StairPath> StairPathFinder::shortest(std::ptrdiff_t start, const Corridor& corridor,
                                                   const StairPath* left, const StairPath* right) {
    bound_rows(start, corridor, left, right);
    const std::size_t length = lo_.size() - 1;
    first_step_.resize(length + 1);
    std::size_t bytes = 0;
    for (std::size_t t = 1; t <= length; ++t) {
        if (lo_[t] > hi_[t]) return std::nullopt;
        first_step_[t] = bytes;
        bytes += static_cast<std::size_t>(hi_[t] - lo_[t]) / 8 + 1;
    }
    steps_.resize(bytes);
    double *from = from_.data() + 1, *to = to_.data() + 1;
    from[start - 1] = from[start + 1] = kInfinity;
    from[start] = 0;
    for (std::size_t t = 1; t <= length; ++t) {
        costs_.advance(start + static_cast<std::ptrdiff_t>(t), lo_[t], hi_[t], from, to,
                       steps_.data() + first_step_[t]);
        to[lo_[t] - 1] = to[hi_[t] + 1] = kInfinity;
        looked_at_ += static_cast<std::size_t>(hi_[t] - lo_[t] + 1);
        std::swap(from, to);
    }
    if (!(from[start + height_] < kInfinity)) return std::nullopt;
    StairPath path = trace_back(start);
    path.cost = from[start + height_];
    return path;
}

StairPath StairPathFinder::trace_back(std::ptrdiff_t start) const {
    StairPath path{.start = start, .rows = std::vector<std::int32_t>(lo_.size()), .cost = 0};
    std::ptrdiff_t i = start + height_;
    for (std::size_t t = lo_.size() - 1; t > 0; --t) {
        path.rows[t] = static_cast<std::int32_t>(i);
        const auto bit = static_cast<std::size_t>(i - lo_[t]);
        const bool lower_moved = (steps_[first_step_[t] + bit / 8] >> (bit % 8) & 1) != 0;
        if (!lower_moved) --i;
    }
    path.rows[0] = static_cast<std::int32_t>(i);
    return path;
}

}  // namespace stratareeb
