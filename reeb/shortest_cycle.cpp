// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/shortest_cycle.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "reeb/coarse_to_fine.h"
#include "reeb/span_corridor.h"
#include "reeb/stair_paths.h"
#include "reeb/start_prices.h"
#include "reeb/step_bounds.h"

namespace stratareeb {

namespace {

constexpr int kNarrowings = 3;             // each next one gains less
constexpr double kPriceDeviation = 0.125;  // of what the known cycle costs over the bounds

StairPath one_turn_on(StairPath path, std::ptrdiff_t height) {
    path.start += height;
    for (std::int32_t& row : path.rows) row += static_cast<std::int32_t>(height);
    return path;
}

//! The cheapest of the shortest paths from many starts.
class CheapestStart {
 public:
    CheapestStart(StairPathFinder& finder, const Corridor& corridor, const std::vector<std::int32_t>& starts,
                  std::ptrdiff_t height)
        : finder_(finder), corridor_(corridor), starts_(starts), height_(height) {}

    std::optional<StairPath> find() {
        if (starts_.empty()) return std::nullopt;
        const auto first = look_at(0, nullptr, nullptr);
        if (!first) {  // nothing to divide by
            divide(1, starts_.size(), nullptr, nullptr);
            return best_;
        }
        const StairPath next_turn = one_turn_on(*first, height_);
        divide(1, starts_.size(), &*first, &next_turn);
        return best_;
    }

 private:
    void divide(std::size_t first, std::size_t last, const StairPath* left, const StairPath* right) {
        if (first >= last) return;
        const std::size_t middle = (first + last) / 2;
        const auto path = look_at(middle, left, right);
        divide(first, middle, left, path ? &*path : right);
        divide(middle + 1, last, path ? &*path : left, right);
    }

    std::optional<StairPath> look_at(std::size_t which, const StairPath* left, const StairPath* right) {
        auto path = finder_.shortest(starts_[which], corridor_, left, right);
        if (path && (!best_ || std::pair(path->cost, path->start) < std::pair(best_->cost, best_->start)))
            best_ = path;
        return path;
    }

    StairPathFinder& finder_;
    const Corridor& corridor_;
    const std::vector<std::int32_t>& starts_;
    std::ptrdiff_t height_;
    std::optional<StairPath> best_;
};

//! Narrow the corridor while that gains something.
void narrow(SpanCorridor& corridor, StairPathFinder& finder, double known) {
    for (int i = 0; i < kNarrowings && corridor.starts().size() > 1; ++i) {
        const std::size_t before = corridor.corridor().spans();
        corridor.narrow(known);
        if (corridor.starts().empty() || corridor.corridor().spans() > before / 8 * 7) return;
        const auto path = finder.shortest(corridor.likely_start(), corridor.corridor());
        if (path) known = std::min(known, path->cost);
    }
}

//! For m <= n.
SpanPath shortest_cycle_by_rows(const SpanContours& c, const ShortestCycleOptions& options) {
    const std::size_t m = c.upper.size();
    const auto height = static_cast<std::ptrdiff_t>(m);
    const SpanPath known = coarse_to_fine_cycle(c);
    // Unrolled so that the known cycle starts midway between the first and the last start.
    const auto first_upper = static_cast<std::uint32_t>((known.upper + m - m / 2) % m);
    const SpanCosts costs(c, first_upper, known.lower);
    StairPathFinder finder(costs, height);
    const StepBounds bounds = step_bounds(c, first_upper, known.lower, known);
    const double over = std::max(0.0, known.cost - bounds.upper[m] - bounds.lower.back());
    const StartPrices prices = start_prices(costs, bounds, known, kPriceDeviation * over);
    SpanCorridor corridor(costs, bounds, prices);
    if (options.corridor) narrow(corridor, finder, known.cost);
    const auto best = CheapestStart(finder, corridor.corridor(), corridor.starts(), height).find();
    if (options.work) {
        options.work->spans = corridor.looked_at() + finder.looked_at();
        options.work->starts = corridor.starts().size();
    }
    return best ? span_path(*best, c, first_upper, known.lower) : known;
}

}  // namespace

SpanPath shortest_cycle(const SpanContours& c, const ShortestCycleOptions& options) {
    if (c.upper.size() <= c.lower.size()) return shortest_cycle_by_rows(c, options);
    SpanPath path = shortest_cycle_by_rows({.upper = c.lower,
                                            .lower = c.upper,
                                            .upper_parameters = c.lower_parameters,
                                            .lower_parameters = c.upper_parameters,
                                            .cost = c.cost,
                                            .closed = c.closed},
                                           options);
    std::swap(path.upper, path.lower);
    for (std::uint8_t& up : path.upper_advances) up = up ? 0 : 1;
    return path;
}

}  // namespace stratareeb
