// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "reeb/span_costs.h"
#include "reeb/stair_paths.h"
#include "reeb/start_prices.h"
#include "reeb/step_bounds.h"

namespace stratareeb {

//! The part of the unrolled graph that closed paths can use which cost no more than a known one. Two sweeps over all paths
//! from any start to any end, forward and backward, give for each span what a path through it costs at least; spans where
//! that is too much are dropped from both ends of their antidiagonal. On the way, a path whose extra over the bounds of its
//! steps is too large already is not followed, so most spans are never looked at.
class SpanCorridor {
 public:
    SpanCorridor(const SpanCosts& costs, const StepBounds& bounds, const StartPrices& prices);

    //! Drop all spans and starts that no closed path of at most this cost needs. Again, with what is left, drops more.
    void narrow(double cost);

    const Corridor& corridor() const { return corridor_; }
    const std::vector<std::int32_t>& starts() const { return starts_; }  // that are left
    std::int32_t likely_start() const { return likely_start_; }          // from which a path may be cheapest
    std::size_t looked_at() const { return looked_at_; }                 // spans, in all sweeps

 private:
    //! Rows lo … hi of one antidiagonal, and what they cost.
    struct Front {
        std::ptrdiff_t lo = 0, hi = -1;
        double* cost = nullptr;
        bool empty() const { return lo > hi; }
    };

    void sweep_forward();
    void sweep_backward();
    void add_source(std::ptrdiff_t k, Front& front) const;
    void add_sink(std::ptrdiff_t row, Front& front) const;
    void keep(std::size_t t, const Front& front);
    void set(std::size_t t, const Front& front);
    bool is_start(std::ptrdiff_t row) const { return row >= starts_.front() && row <= starts_.back(); }
    double forward_cost(std::size_t t, std::ptrdiff_t row) const {
        return static_cast<double>(
                   reached_[first_reached_[t] + static_cast<std::size_t>(row - corridor_.lo[t])]) *
               unit_;
    }

    const SpanCosts& costs_;
    const StepBounds& bounds_;
    const StartPrices& prices_;
    std::ptrdiff_t height_;
    Corridor corridor_;  // from k = 0 on
    std::vector<std::int32_t> starts_;
    std::int32_t likely_start_ = 0;
    std::size_t looked_at_ = 0;

    double turn_ = 0, limit_ = 0,
           unit_ = 1;  // bounds of all rows; the highest cost of a path with prices paid; see reached_
    std::vector<double> from_, to_;  // by row, shifted by one
    // Costs of the forward sweep, in units that float can hold, if they are not too many.
    std::unique_ptr<float[]> reached_;
    std::size_t capacity_ = 0;
    std::vector<std::size_t> first_reached_;  // where an antidiagonal's begin; the last one: their number
};

}  // namespace stratareeb
