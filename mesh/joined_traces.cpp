// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "boreholes/errors.h"
#include "mesh/fault_blocks.h"

namespace stratareeb {

namespace {

constexpr double kOvershoot =
    0.02;  // of the footprint's extent: ends no longer than that beyond a crossing are cut
constexpr double kTouches = 1e-9;  // of the footprint's extent
constexpr double kBeyond = 1e-8;  // of the footprint's extent: joined ends cross what they end at for certain

struct Segment {
    Point2 a, b;
};

double cross(const Point2& u, const Point2& v) {
    return u.x * v.y - u.y * v.x;
}

Point2 minus(const Point2& a, const Point2& b) {
    return {a.x - b.x, a.y - b.y};
}

double distance(const Point2& a, const Point2& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

Point2 along(const Point2& p, const Point2& direction, double share) {
    return {p.x + share * direction.x, p.y + share * direction.y};
}

//! How far along the way from p in a direction a segment is met, in lengths of that direction.
std::optional<double> meets(const Point2& p, const Point2& direction, const Segment& s, double slack) {
    const Point2 side = minus(s.b, s.a);
    const double turn = cross(direction, side);
    if (turn == 0) return std::nullopt;
    const double t = cross(minus(s.a, p), side) / turn, u = cross(minus(s.a, p), direction) / turn;
    const double margin = slack / distance(s.a, s.b);
    if (u < -margin || u > 1 + margin) return std::nullopt;
    return t;
}

class TraceJoiner {
 public:
    TraceJoiner(const Footprint& footprint, FaultTraces traces)
        : footprint_(footprint), traces_(std::move(traces)) {
        double x0 = footprint[0][0].x, x1 = x0, y0 = footprint[0][0].y, y1 = y0;
        for (const auto& ring : footprint)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point2& p = ring[i];
                x0 = std::min(x0, p.x), x1 = std::max(x1, p.x), y0 = std::min(y0, p.y),
                y1 = std::max(y1, p.y);
                outline_.push_back({p, ring[(i + 1) % ring.size()]});
            }
        extent_ = std::hypot(x1 - x0, y1 - y0);
        for (std::size_t t = 0; t < traces_.size(); ++t) clean(t);
    }

    JoinedTraces run() {
        for (std::size_t t = 0; t < traces_.size(); ++t)
            for (const bool at_front : {true, false}) cut_overshoot(t, at_front);
        for (std::size_t t = 0; t < traces_.size(); ++t)
            for (const bool at_front : {true, false}) lead_on(t, at_front);
        return {std::move(traces_), std::move(notes_)};
    }

 private:
    void clean(std::size_t t) {
        auto& trace = traces_[t];
        for (const Point2& p : trace)
            if (!std::isfinite(p.x) || !std::isfinite(p.y))
                throw InvalidInput(fmt::format("fault trace {} has a point that is not a number", t + 1));
        trace.erase(std::unique(trace.begin(), trace.end()), trace.end());
        if (trace.size() < 2)
            throw InvalidInput(fmt::format("fault trace {} has fewer than two points", t + 1));
    }

    bool is_closed(std::size_t t) const {
        return traces_[t].size() > 3 && traces_[t].front() == traces_[t].back();
    }

    //! The segments of all traces but the one at an end.
    template <class Visit>
    void for_each_other(std::size_t trace, bool at_front, Visit&& visit) const {
        for (std::size_t t = 0; t < traces_.size(); ++t)
            for (std::size_t i = 0; i + 1 < traces_[t].size(); ++i) {
                const bool own = t == trace && i == (at_front ? 0 : traces_[t].size() - 2);
                const bool next = t == trace && (at_front ? i == 1 : i + 3 == traces_[t].size());
                if (!own && !next) visit(Segment{traces_[t][i], traces_[t][i + 1]});
            }
    }

    //! A short piece beyond a crossing with another trace is a slip of the pen.
    void cut_overshoot(std::size_t t, bool at_front) {
        if (is_closed(t)) return;
        auto& trace = traces_[t];
        const Point2 end = at_front ? trace.front() : trace.back();
        if (!is_inside(footprint_, end)) return;
        const Point2 before = at_front ? trace[1] : trace[trace.size() - 2], back = minus(before, end);
        const double length = distance(end, before);
        double best = 1;
        for_each_other(t, at_front, [&](const Segment& s) {
            const auto share = meets(end, back, s, kTouches * extent_);
            if (share && *share > 0 && *share < best && *share * length < kOvershoot * extent_) best = *share;
        });
        if (best == 1) return;
        const double keep = best - kBeyond * extent_ / length;
        (at_front ? trace.front() : trace.back()) = {end.x + keep * back.x, end.y + keep * back.y};
    }

    void lead_on(std::size_t t, bool at_front) {
        if (is_closed(t)) return;
        auto& trace = traces_[t];
        const Point2 end = at_front ? trace.front() : trace.back();
        const Point2 before = at_front ? trace[1] : trace[trace.size() - 2], on = minus(end, before);
        const double length = distance(end, before), touching = kTouches * extent_ / length;
        double nearest = -1;
        const double beyond = kBeyond * extent_ / length;
        bool joined = false, crossed = !is_inside(footprint_, end);
        const auto look = [&](const Segment& s) {
            const auto share = meets(end, on, s, kTouches * extent_);
            if (!share) return;
            if (std::abs(*share) <= touching) joined = true;
            if (*share < -touching && *share >= -2 * beyond) crossed = true;
            if (*share > touching && (nearest < 0 || *share < nearest)) nearest = *share;
        };
        for_each_other(t, at_front, look);
        std::ranges::for_each(outline_, look);
        if (crossed) return;
        if (joined) {
            (at_front ? trace.front() : trace.back()) = along(end, on, beyond);
            return;
        }
        if (nearest < 0) return;
        const Point2 to = along(end, on, nearest);
        notes_.push_back(
            fmt::format("fault trace {} ends inside at x {:.10g}, y {:.10g}; it is led on straight to x "
                        "{:.10g}, y {:.10g}",
                        t + 1, end.x, end.y, to.x, to.y));
        trace.insert(at_front ? trace.begin() : trace.end(), along(end, on, nearest + beyond));
    }

    const Footprint& footprint_;
    FaultTraces traces_;
    std::vector<Segment> outline_;
    double extent_ = 0;
    std::vector<std::string> notes_;
};

}  // namespace

JoinedTraces joined_traces(const Footprint& footprint, FaultTraces traces) {
    return TraceJoiner(footprint, std::move(traces)).run();
}

}  // namespace stratareeb
