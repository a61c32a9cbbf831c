// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/start_prices.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stratareeb {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::ptrdiff_t kReach = 256;      // starts on either side, at most
constexpr std::ptrdiff_t kReachShare = 16;  // and at most so small a part of a turn
constexpr std::ptrdiff_t kRun = 4;  // antidiagonals per start of the reach for paths to come together in

//! The known cycle, for ever in both directions.
class Spine {
 public:
    Spine(const SpanPath& cycle, std::ptrdiff_t start, std::ptrdiff_t height)
        : start_(start), height_(height), rows_{start} {
        for (const bool up : cycle.upper_advances) rows_.push_back(rows_.back() + up);
    }
    std::ptrdiff_t length() const { return static_cast<std::ptrdiff_t>(rows_.size()) - 1; }
    std::ptrdiff_t row(std::ptrdiff_t k) const {
        const std::ptrdiff_t t = k - start_;
        const std::ptrdiff_t turns = t < 0 ? -1 : t > length() ? 1 : 0;
        return rows_[static_cast<std::size_t>(t - turns * length())] + turns * height_;
    }

 private:
    std::ptrdiff_t start_, height_;
    std::vector<std::ptrdiff_t> rows_;
};

class Fans {
 public:
    Fans(const SpanCosts& costs, const SpanPath& cycle)
        : costs_(costs),
          height_(costs.rows() / 2),
          start_(height_ / 2),
          spine_(cycle, start_, height_),
          reach_(std::clamp<std::ptrdiff_t>(height_ / kReachShare, 1, kReach)),
          from_(costs.array_size()),
          to_(from_.size()) {
        reach_ = std::min(reach_, height_ - start_ - 1);
        reach_ = std::min(reach_, start_);
    }

    std::ptrdiff_t reach() const { return reach_; }
    std::ptrdiff_t start() const { return start_; }

    //! Costs from a span of the cycle to the ends around its own end.
    std::vector<double> to_ends() {
        std::vector<double> result(static_cast<std::size_t>(2 * reach_ + 1), kInfinity);
        double *from = from_.data() + 1, *to = to_.data() + 1;
        const std::ptrdiff_t end = start_ + spine_.length();
        std::ptrdiff_t k = end - run(), lo = spine_.row(k), hi = lo;
        from[lo - 1] = from[lo + 1] = kInfinity;
        from[lo] = 0;
        for (++k; k <= end + reach_; ++k) {
            lo = std::max({lo, spine_.row(k) - reach_, k - costs_.columns()});
            hi = std::min({hi + 1, spine_.row(k) + reach_, costs_.rows() - 1});
            if (lo > hi) break;
            costs_.advance(k, lo, hi, from, to, nullptr);
            to[lo - 1] = to[hi + 1] = kInfinity;
            std::swap(from, to);
            note(k - costs_.columns() - height_, k - costs_.columns() == lo ? from[lo] : kInfinity, result);
        }
        return result;
    }

    //! Costs from the starts around that of the cycle to a later span of it.
    std::vector<double> from_starts() {
        std::vector<double> result(static_cast<std::size_t>(2 * reach_ + 1), kInfinity);
        double *from = from_.data() + 1, *to = to_.data() + 1;
        std::ptrdiff_t k = start_ + run(), lo = spine_.row(k), hi = lo;
        from[lo - 1] = from[lo + 1] = kInfinity;
        from[lo] = 0;
        for (--k; k >= start_ - reach_; --k) {
            lo = std::max<std::ptrdiff_t>({lo - 1, spine_.row(k) - reach_, 0});
            hi = std::min({hi, spine_.row(k) + reach_, k});
            if (lo > hi) break;
            costs_.retreat(k, lo, hi, from, to);
            to[lo - 1] = to[hi + 1] = kInfinity;
            std::swap(from, to);
            note(k, hi == k ? from[k] : kInfinity, result);
        }
        return result;
    }

 private:
    std::ptrdiff_t run() const { return std::min(kRun * reach_, spine_.length()); }
    void note(std::ptrdiff_t start, double cost, std::vector<double>& result) const {
        if (std::abs(start - start_) <= reach_)
            result[static_cast<std::size_t>(start - start_ + reach_)] = cost;
    }

    const SpanCosts& costs_;
    std::ptrdiff_t height_, start_;
    Spine spine_;
    std::ptrdiff_t reach_;
    std::vector<double> from_, to_;  // by row, shifted by one
};

}  // namespace

StartPrices start_prices(const SpanCosts& costs, const StepBounds& bounds, const SpanPath& cycle,
                         double deviation) {
    Fans fans(costs, cycle);
    const std::vector<double> up = fans.to_ends(), down = fans.from_starts();
    const std::ptrdiff_t reach = fans.reach();
    const auto extra = [&](const std::vector<double>& fan, std::ptrdiff_t offset) {
        return fan[static_cast<std::size_t>(offset + reach)] - fan[static_cast<std::size_t>(reach)];
    };
    StartPrices prices{.price = {}, .deviation = deviation};
    const std::ptrdiff_t starts = costs.rows() / 2;
    for (std::ptrdiff_t row = 0; row < starts; ++row) {
        const std::ptrdiff_t offset = std::clamp(row - fans.start(), -reach, reach);
        const auto at = static_cast<std::size_t>(fans.start() + offset);
        const double fair = (extra(up, offset) - extra(down, offset)) / 2;
        const double over = fair - (bounds.upper[at] - bounds.upper[static_cast<std::size_t>(fans.start())]);
        prices.price.push_back(bounds.upper[static_cast<std::size_t>(row)] +
                               (std::isfinite(over) ? std::clamp(over, -deviation, deviation) : 0.0));
    }
    return prices;
}

}  // namespace stratareeb
