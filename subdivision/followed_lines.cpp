// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/followed_lines.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "subdivision/sheet_gaps.h"

namespace stratareeb {
namespace {

constexpr double kReach = 0.25;       // of a line's mean edge, or of the way to its end: how far it is bent
constexpr double kGapShare = 0.5;     // of the gap: how closely it is kept between the places that were moved
constexpr double kLineSpan = 1.5;     // of the sheets' spans around it
constexpr int kRounds = 4;            // of halving spans
constexpr double kMostLonger = 1.05;  // a line that winds more than that stays as it was
constexpr std::size_t kMostSpans = 1500;
constexpr int kSamplesASpan = 8;

class Follower {
 public:
    Follower(const LineCurve& line, const SheetGaps& gaps, const HorizonSheets& sheets, double size)
        : line_(line.curve), gaps_(gaps), sheets_(sheets), size_(size) {
        const auto& t = line.parameters;
        from_ = t.front(), to_ = t.back();
        edge_ = (to_ - from_) / static_cast<double>(t.size() - 1);
    }

    SplineCurve followed() const {
        CubicKnots knots = as_fine_as_sheets();
        for (int round = 0;; ++round) {
            SplineCurve curve = bent_curve(knots);
            const auto halve = spans_off(curve);
            const auto more = static_cast<std::size_t>(std::ranges::count(halve, 1));
            if (more == 0 || round == kRounds || knots.spans() + more > kMostSpans)
                return is_better(curve) ? curve : line_;
            knots = knots.refined(halve);
        }
    }

 private:
    static Point2 point(const SplineCurve& curve, double t) { return {curve.at(0, t), curve.at(1, t)}; }

    // Where a place of the line moves to.
    Point2 bent(double t) const {
        const Point2 p = point(line_, t), way{line_.at(0, t, 1), line_.at(1, t, 1)};
        const double n = std::hypot(way.x, way.y), reach = kReach * std::min({edge_, t - from_, to_ - t});
        if (!(n > 0 && reach > 0)) return p;
        return closest_to_gaps(sheets_, gaps_, p, {-way.y / n, way.x / n}, reach, size_);
    }

    SplineCurve bent_curve(const CubicKnots& knots) const {
        std::vector<std::pair<double, Point2>> places;
        for (const double t : knots.greville()) places.emplace_back(t, bent(t));
        const auto at = [&](double t) {
            return std::ranges::lower_bound(places, t, {}, [](const auto& p) { return p.first; })->second;
        };
        return {knots,
                {interpolate_spline(knots, [&](double t) { return at(t).x; }),
                 interpolate_spline(knots, [&](double t) { return at(t).y; })}};
    }

    // Spans where sheets are otherwise apart than where the line's places would move to.
    std::vector<char> spans_off(const SplineCurve& curve) const {
        std::vector<char> off(curve.knots.spans(), 0);
        const auto& breaks = curve.knots.breaks();
        for (std::size_t s = 0; s < off.size(); ++s)
            for (const double share : {0.25, 0.5, 0.75}) {
                const double t = std::lerp(breaks[s], breaks[s + 1], share);
                const Point2 wanted = bent(t), here = point(curve, t);
                for (const SheetGap& gap : gaps_)
                    if (std::abs(off_gap(sheets_, gap, wanted) - off_gap(sheets_, gap, here)) >
                        kGapShare * gap.gap)
                        off[s] = 1;
            }
        return off;
    }

    // Where shifts jump from one place to the next, a spline through them swings.
    bool is_better(const SplineCurve& curve) const {
        return length(curve) <= kMostLonger * length(line_) &&
               worst_off(curve, curve.knots) <= worst_off(line_, curve.knots);
    }

    double worst_off(const SplineCurve& curve, const CubicKnots& knots) const {
        double worst = 0;
        const auto& breaks = knots.breaks();
        for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
            for (int k = 0; k < kSamplesASpan; ++k) {
                const double t = std::lerp(breaks[s], breaks[s + 1], k / double(kSamplesASpan));
                for (const SheetGap& gap : gaps_)
                    worst = std::max(worst, std::abs(off_gap(sheets_, gap, point(curve, t))));
            }
        return worst;
    }

    CubicKnots as_fine_as_sheets() const {
        CubicKnots knots = line_.knots;
        while (true) {
            std::vector<char> halve(knots.spans(), 0);
            for (std::size_t s = 0; s < knots.spans(); ++s) {
                const double a = knots.breaks()[s], b = knots.breaks()[s + 1];
                halve[s] = b - a > kLineSpan * shortest_span(point(line_, a), point(line_, b));
            }
            const auto more = static_cast<std::size_t>(std::ranges::count(halve, 1));
            if (more == 0 || knots.spans() + more > kMostSpans) return knots;
            knots = knots.refined(halve);
        }
    }

    // Of the sheets, between two places.
    double shortest_span(const Point2& a, const Point2& b) const {
        double shortest = INFINITY;
        const auto look = [&](const CubicKnots& knots, double from, double to) {
            const auto [low, high] = std::minmax(from, to);
            for (std::size_t s = knots.span(low); s <= knots.span(high); ++s)
                shortest = std::min(shortest, knots.breaks()[s + 1] - knots.breaks()[s]);
        };
        for (const SheetGap& gap : gaps_)
            for (const auto s : {gap.above, gap.below}) {
                look(sheets_.sheets[s].x, a.x, b.x);
                look(sheets_.sheets[s].y, a.y, b.y);
            }
        return shortest;
    }

    static double length(const SplineCurve& curve) {
        double sum = 0;
        const auto& breaks = curve.knots.breaks();
        for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
            for (const double share : {0.25, 0.75}) {
                const double t = std::lerp(breaks[s], breaks[s + 1], share);
                sum += std::hypot(curve.at(0, t, 1), curve.at(1, t, 1)) * (breaks[s + 1] - breaks[s]) / 2;
            }
        return sum;
    }

    const SplineCurve& line_;
    const SheetGaps& gaps_;
    const HorizonSheets& sheets_;
    double size_;
    double from_ = 0, to_ = 0, edge_ = 0;  // parameters, which are lengths
};

}  // namespace

std::vector<SplineCurve> followed_lines(const PlanCells& cells, const PlanCurves& curves,
                                        const HorizonSheets& sheets, double size) {
    const auto gaps = sheet_gaps(cells, sheets);
    std::vector<SplineCurve> result;
    for (const auto& line : curves.lines) result.push_back(line.curve);
    tbb::parallel_for(std::size_t{0}, result.size(), [&](std::size_t l) {
        if (cells.lines[l].side == PlanCells::kNone && gaps[l].size() == 1)
            result[l] = Follower(curves.lines[l], gaps[l], sheets, size).followed();
    });
    return result;
}

}  // namespace stratareeb
