// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/span_corridor.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace stratareeb {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSmallest = 1e-300;         // cost whose reciprocal is a number
constexpr std::size_t kFewSpans = 1u << 16;  // that are kept however few spans the graph has

std::size_t index(std::ptrdiff_t i) {
    return static_cast<std::size_t>(i);
}

}  // namespace

SpanCorridor::SpanCorridor(const SpanCosts& costs, const StepBounds& bounds, const StartPrices& prices)
    : costs_(costs),
      bounds_(bounds),
      prices_(prices),
      height_(costs.rows() / 2),
      starts_(index(height_)),
      turn_(bounds.upper[index(height_)]),
      from_(costs.array_size()),
      to_(from_.size()),
      capacity_(index(height_) * index(costs.columns()) / 2 + kFewSpans) {
    std::iota(starts_.begin(), starts_.end(), 0);
    const std::ptrdiff_t top = costs.rows() - 1;
    for (std::ptrdiff_t k = 0; k <= top + costs.columns(); ++k) {
        corridor_.lo.push_back(static_cast<std::int32_t>(std::max<std::ptrdiff_t>(0, k - costs.columns())));
        corridor_.hi.push_back(static_cast<std::int32_t>(std::min(top, k)));
    }
}

void SpanCorridor::narrow(double cost) {
    if (starts_.empty()) return;
    // Sums of so many terms, and floats, are wrong by less than this.
    const auto terms = static_cast<double>(corridor_.lo.size());
    const double rounding =
        8 * terms * std::numeric_limits<double>::epsilon() + 8.0 * std::numeric_limits<float>::epsilon();
    limit_ = cost * (1 + rounding) - turn_;
    unit_ = cost > kSmallest ? cost : 1;
    sweep_forward();
    sweep_backward();
}

void SpanCorridor::add_source(std::ptrdiff_t k, Front& front) const {
    if (front.empty()) front.lo = k, front.hi = k - 1;
    std::fill(front.cost + front.hi + 1, front.cost + k + 1, front.hi < k ? kInfinity : front.cost[k]);
    front.cost[k] = std::min(front.cost[k], prices_.price[index(k)]);
    front.hi = k;
}

void SpanCorridor::add_sink(std::ptrdiff_t row, Front& front) const {
    if (front.empty()) front.lo = row + 1, front.hi = row;
    if (front.lo > row) std::fill(front.cost + row, front.cost + front.lo, kInfinity);
    front.cost[row] = std::min(front.cost[row], -prices_.price[index(row - height_)] - turn_);
    front.lo = row;
}

void SpanCorridor::set(std::size_t t, const Front& front) {
    corridor_.lo[t] = static_cast<std::int32_t>(front.lo);
    corridor_.hi[t] = static_cast<std::int32_t>(front.hi);
    front.cost[front.lo - 1] = front.cost[front.hi + 1] = kInfinity;
}

void SpanCorridor::keep(std::size_t t, const Front& front) {
    const std::size_t count = front.empty() ? 0 : index(front.hi - front.lo + 1);
    first_reached_[t + 1] = first_reached_[t] + count;
    if (first_reached_[t + 1] > capacity_) return;
    if (!reached_) reached_ = std::make_unique_for_overwrite<float[]>(capacity_);
    float* to = reached_.get() + first_reached_[t];
    const double* from = front.cost + front.lo;
    const double scale = 1 / unit_;
    for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<float>(from[i] * scale);
}

//! The cheapest path from a start to each span, prices paid.
void SpanCorridor::sweep_forward() {
    const double slack = limit_ - bounds_.lower.back() + prices_.deviation;
    first_reached_.assign(corridor_.lo.size() + 1, 0);
    Front last{.lo = starts_.front(), .hi = starts_.front() - 1, .cost = from_.data() + 1};
    Front front{.cost = to_.data() + 1};
    last.cost[last.lo - 1] = last.cost[last.lo] = kInfinity;
    for (std::size_t t = 0; t < corridor_.lo.size(); ++t) {
        const auto k = static_cast<std::ptrdiff_t>(t);
        front.lo = std::max<std::ptrdiff_t>(last.lo, corridor_.lo[t]);
        front.hi = std::min<std::ptrdiff_t>(last.hi + 1, corridor_.hi[t]);
        if (!front.empty()) {
            costs_.advance(k, front.lo, front.hi, last.cost, front.cost, nullptr);
            looked_at_ += index(front.hi - front.lo + 1);
        }
        const auto too_dear = [&](std::ptrdiff_t i) {
            return front.cost[i] - bounds_.upper[index(i)] - bounds_.lower[index(k - i)] > slack;
        };
        while (!front.empty() && too_dear(front.lo)) ++front.lo;
        while (!front.empty() && too_dear(front.hi)) --front.hi;
        if (is_start(k) && k <= corridor_.hi[t]) add_source(k, front);
        if (front.empty()) front.lo = last.lo, front.hi = last.lo - 1;
        set(t, front);
        keep(t, front);
        std::swap(last, front);
    }
}

//! The cheapest path from each span to an end, the price paid back; and what is left of the corridor by both sweeps.
void SpanCorridor::sweep_backward() {
    const bool kept = first_reached_.back() <= capacity_;
    const double slack = limit_ + prices_.deviation;
    // What paths cost at least that begin at a start, or end one turn above; infinite if that is too much.
    std::vector<double> begin(index(height_), kInfinity), end(index(height_), kInfinity);
    Front last{.cost = from_.data() + 1}, front{.cost = to_.data() + 1};
    for (std::size_t t = corridor_.lo.size(); t-- > 0;) {
        const auto k = static_cast<std::ptrdiff_t>(t);
        front.lo = std::max<std::ptrdiff_t>(last.lo - 1, corridor_.lo[t]);
        front.hi = std::min<std::ptrdiff_t>(last.hi, corridor_.hi[t]);
        if (last.empty()) front.hi = front.lo - 1;
        if (!front.empty()) {
            costs_.retreat(k, front.lo, front.hi, last.cost, front.cost);
            looked_at_ += index(front.hi - front.lo + 1);
        }
        const std::ptrdiff_t sink =
            k - costs_.columns();  // the row of this antidiagonal's span in the last column
        if (is_start(sink - height_) && sink >= corridor_.lo[t] && sink <= corridor_.hi[t]) {
            add_sink(sink, front);
            const double cost =
                kept ? forward_cost(t, sink) - prices_.price[index(sink - height_)] - turn_ : limit_;
            if (!(cost > limit_)) end[index(sink - height_)] = cost;
        }
        const auto too_dear = [&](std::ptrdiff_t i) {
            if (kept) return forward_cost(t, i) + front.cost[i] > limit_;
            return bounds_.upper[index(i)] + bounds_.lower[index(k - i)] + front.cost[i] > slack;
        };
        std::ptrdiff_t lo = front.lo, hi = front.hi;
        while (lo <= hi && too_dear(lo)) ++lo;
        while (lo <= hi && too_dear(hi)) --hi;
        front.lo = lo, front.hi = hi;
        if (is_start(k) && hi == k && lo <= hi) {
            const double cost = prices_.price[index(k)] + front.cost[k];
            if (!(cost > limit_)) begin[index(k)] = cost;
        }
        if (front.empty()) front.lo = corridor_.lo[t], front.hi = front.lo - 1;
        set(t, front);
        std::swap(last, front);
    }
    std::erase_if(starts_,
                  [&](std::int32_t start) { return begin[index(start)] + end[index(start)] == kInfinity; });
    if (starts_.empty()) return;
    likely_start_ = *std::ranges::min_element(
        starts_, {}, [&](std::int32_t start) { return begin[index(start)] + end[index(start)]; });
}

}  // namespace stratareeb
