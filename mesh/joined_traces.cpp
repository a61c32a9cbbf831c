// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "boreholes/errors.h"
#include "mesh/fault_blocks.h"

namespace stratareeb {

namespace {

// Of the footprint's extent: ends no longer than that beyond a crossing are cut, and no shorter than that before it led on.
constexpr double kSlip = 0.02;
constexpr double kTouches = 1e-9;  // of the footprint's extent
constexpr double kClear = 1e-3;    // of the footprint's extent: how far ways on stay from holes
constexpr int kMostTurns = 20;     // of two degrees, for that
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

double distance_to_segment(const Point2& p, const Point2& from, const Point2& to) {
    const Point2 on = minus(to, from), off = minus(p, from);
    const double t = std::clamp((off.x * on.x + off.y * on.y) / (on.x * on.x + on.y * on.y), 0.0, 1.0);
    return distance(p, along(from, on, t));
}

class TraceJoiner {
 public:
    TraceJoiner(const Footprint& footprint, FaultTraces traces, const std::vector<Point2>& holes)
        : footprint_(footprint), traces_(std::move(traces)), holes_(holes) {
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
        return {std::move(traces_), std::move(ways_on_), std::move(notes_)};
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
            if (share && *share > 0 && *share < best && *share * length < kSlip * extent_) best = *share;
        });
        if (best == 1) return;
        const double keep = best - kBeyond * extent_ / length;
        (at_front ? trace.front() : trace.back()) = {end.x + keep * back.x, end.y + keep * back.y};
    }

    //! Where the way from an end in a direction meets the next trace or the outline, in lengths of that direction.
    struct NextTrace {
        double share = -1;  // < 0: nowhere
        bool joined = false, crossed = false;
    };
    NextTrace next_trace(std::size_t t, bool at_front, const Point2& on) const {
        const Point2 end = at_front ? traces_[t].front() : traces_[t].back();
        const double length = std::hypot(on.x, on.y), touching = kTouches * extent_ / length,
                     beyond = kBeyond * extent_ / length;
        NextTrace next{.crossed = !is_inside(footprint_, end)};
        const auto look = [&](const Segment& s) {
            const auto share = meets(end, on, s, kTouches * extent_);
            if (!share) return;
            if (std::abs(*share) <= touching) next.joined = true;
            if (*share < -touching && *share >= -2 * beyond) next.crossed = true;
            if (*share > touching && (next.share < 0 || *share < next.share)) next.share = *share;
        };
        for_each_other(t, at_front, look);
        std::ranges::for_each(outline_, look);
        return next;
    }

    bool is_clear(const Point2& from, const Point2& to) const {
        return std::ranges::none_of(holes_, [&](const Point2& hole) {
            return distance_to_segment(hole, from, to) < kClear * extent_;
        });
    }

    void lead_on(std::size_t t, bool at_front) {
        if (is_closed(t)) return;
        auto& trace = traces_[t];
        const Point2 end = at_front ? trace.front() : trace.back();
        const Point2 on = minus(end, at_front ? trace[1] : trace[trace.size() - 2]);
        const double length = std::hypot(on.x, on.y), beyond = kBeyond * extent_ / length;
        const NextTrace straight = next_trace(t, at_front, on);
        if (straight.crossed) return;
        if (straight.joined) {
            (at_front ? trace.front() : trace.back()) = along(end, on, beyond);
            return;
        }
        if (straight.share < 0) return;
        if (straight.share * length < kSlip * extent_) {
            const Point2 to = along(end, on, straight.share);
            notes_.push_back(
                fmt::format("fault trace {} ends at x {:.10g}, y {:.10g}, just short of x {:.10g}, y "
                            "{:.10g}; it is led on to there",
                            t + 1, end.x, end.y, to.x, to.y));
            trace.insert(at_front ? trace.begin() : trace.end(), along(end, on, straight.share + beyond));
            return;
        }
        notes_.push_back(
            fmt::format("fault trace {} ends inside at x {:.10g}, y {:.10g}; its throw dies out there", t + 1,
                        end.x, end.y));
        const Point2 to = way_on(t, at_front, on, along(end, on, straight.share + beyond));
        ways_on_.push_back({end, to});
        trace.insert(at_front ? trace.begin() : trace.end(), to);
    }

    //! Straight if no hole is in the way, else as little to a side as that takes.
    Point2 way_on(std::size_t t, bool at_front, const Point2& on, const Point2& straight) const {
        const Point2 end = at_front ? traces_[t].front() : traces_[t].back();
        if (is_clear(end, straight)) return straight;
        for (int turn = 2; turn < 2 * kMostTurns; ++turn) {
            const double angle = (turn % 2 == 0 ? 1 : -1) * (turn / 2) * std::numbers::pi / 90;
            const Point2 turned{on.x * std::cos(angle) - on.y * std::sin(angle),
                                on.x * std::sin(angle) + on.y * std::cos(angle)};
            const NextTrace next = next_trace(t, at_front, turned);
            if (next.share < 0) continue;
            const double beyond = kBeyond * extent_ / std::hypot(on.x, on.y);
            const Point2 to = along(end, turned, next.share + beyond);
            if (is_clear(end, to)) return to;
        }
        return straight;
    }

    const Footprint& footprint_;
    FaultTraces traces_;
    const std::vector<Point2>& holes_;
    std::vector<Segment> outline_;
    double extent_ = 0;
    std::vector<WayOn> ways_on_;
    std::vector<std::string> notes_;
};

}  // namespace

bool WayOn::holds(const Point2& a, const Point2& b, double tolerance) const {
    const auto is_on = [&](const Point2& p) { return distance_to_segment(p, tip, end) <= tolerance; };
    return is_on(a) && is_on(b) && is_on({(a.x + b.x) / 2, (a.y + b.y) / 2});
}

JoinedTraces joined_traces(const Footprint& footprint, FaultTraces traces, const std::vector<Point2>& holes) {
    return TraceJoiner(footprint, std::move(traces), holes).run();
}

}  // namespace stratareeb
