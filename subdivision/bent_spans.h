// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "boreholes/point.h"
#include "subdivision/cubic_knots.h"
#include "subdivision/height_patch.h"

namespace stratareeb {

//! When the spans of a patch were bent last and how far they may have risen, so that only places that may have changed are
//! looked at again. A time is 0 before the first look.
class BentSpans {
 public:
    explicit BentSpans(const HeightPatch& patch)
        : x_(patch.x), y_(patch.y), bent_(patch.x.spans() * patch.y.spans(), 1), risen_(bent_.size(), 0) {}

    std::size_t span(const Point2& at) const { return x_.span(at.x) * y_.spans() + y_.span(at.y); }

    //! All coefficients that count at a place were changed, and nothing rises by more than `rise` >= 0.
    void bend(const Point2& at, double rise) {
        ++now_;
        const std::size_t i = x_.span(at.x), j = y_.span(at.y);
        for (std::size_t k = i - std::min<std::size_t>(i, 3); k <= std::min(i + 3, x_.spans() - 1); ++k)
            for (std::size_t l = j - std::min<std::size_t>(j, 3); l <= std::min(j + 3, y_.spans() - 1); ++l)
                bent_[k * y_.spans() + l] = now_, risen_[k * y_.spans() + l] += rise;
    }

    //! What a span has risen by in all, at most; what it was lowered by is not taken off.
    double risen(std::size_t span) const { return risen_[span]; }

    //! Whether a span was bent since the last call with this time.
    bool since(std::uint64_t& seen, std::size_t span) const {
        return bent_[span] > std::exchange(seen, now_);
    }

    //! The same up to `reach` around it.
    bool since(std::uint64_t& seen, std::size_t span, double reach) const {
        const std::uint64_t before = std::exchange(seen, now_);
        const std::size_t i = span / y_.spans(), j = span % y_.spans();
        const auto &x = x_.breaks(), &y = y_.breaks();
        for (std::size_t k = x_.span(x[i] - reach); k <= x_.span(x[i + 1] + reach); ++k)
            for (std::size_t l = y_.span(y[j] - reach); l <= y_.span(y[j + 1] + reach); ++l)
                if (bent_[k * y_.spans() + l] > before) return true;
        return false;
    }

 private:
    const CubicKnots &x_, &y_;
    std::uint64_t now_ = 1;
    std::vector<std::uint64_t> bent_;  // [span of x][span of y]
    std::vector<double> risen_;        // the same
};

//! Places over a patch, with a member `at`, those of a span side by side.
template <typename Place>
class PlacesBySpan {
 public:
    void add(const Place& place) { places_.push_back(place); }

    //! After the last one was added. All count as not yet looked at.
    void sort(const BentSpans& bent) {
        std::vector<std::pair<std::size_t, std::size_t>> order;
        for (std::size_t i = 0; i < places_.size(); ++i) order.emplace_back(bent.span(places_[i].at), i);
        std::ranges::sort(order);
        std::vector<Place> sorted;
        parts_.clear();
        for (const auto& [span, i] : order) {
            if (parts_.empty() || parts_.back().span != span)
                parts_.push_back({.span = span, .begin = sorted.size(), .end = sorted.size()});
            sorted.push_back(places_[i]);
            ++parts_.back().end;
            if constexpr (requires(Place p) { p.reach; })
                parts_.back().reach = std::max(parts_.back().reach, places_[i].reach);
        }
        places_ = std::move(sorted);
        until_.assign(places_.size(), -1);
    }

    //! Those in spans that were bent since the last call.
    template <typename Visit>
    void each_bent(const BentSpans& bent, const Visit& visit) {
        for (auto& part : parts_)
            if (bent.since(part.seen, part.span)) visit_all(part, visit);
    }

    //! Those that may have risen by more than `visit` said at the last call that they may rise without another look.
    template <typename Visit>  // double visit(place)
    void each_risen(const BentSpans& bent, const Visit& visit) {
        for (auto& part : parts_) {
            if (bent.risen(part.span) <= part.until) continue;
            part.until = INFINITY;
            for (std::size_t i = part.begin; i < part.end; ++i) {
                const double risen = bent.risen(part.span);
                if (risen > until_[i]) until_[i] = risen + visit(places_[i]);
                part.until = std::min(part.until, until_[i]);
            }
        }
    }

    //! Those in spans that were bent since the last call, also as far around as `reaches` times their member `reach`.
    template <typename Visit>
    void each_bent_around(const BentSpans& bent, double reaches, const Visit& visit) {
        for (auto& part : parts_)
            if (bent.since(part.seen_around, part.span, reaches * part.reach)) visit_all(part, visit);
    }

    const std::vector<Place>& all() const { return places_; }

 private:
    // [begin, end) are in a span.
    struct Part {
        std::size_t span, begin, end;
        double reach = 0, until = -1;
        std::uint64_t seen = 0, seen_around = 0;
    };

    template <typename Visit>
    void visit_all(const Part& part, const Visit& visit) const {
        for (std::size_t i = part.begin; i < part.end; ++i) visit(places_[i]);
    }

    std::vector<Place> places_;
    std::vector<double> until_;  // [place] as far as its span may rise
    std::vector<Part> parts_;
};

}  // namespace stratareeb
