// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/strip_lines.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stratareeb {
namespace {

constexpr std::size_t kLeastSpans = 4;  // of a face: narrower ones are not cut
constexpr double kClear = 0.08;         // of a span: how far a line stays from corners and turns of edges
constexpr double kApart = 0.3;          // of a span: how far from lines of other faces
constexpr int kSamplesASpan = 8;

//! What bounds a face: how far it goes, and the x of corners and turns, where lines must not be.
struct Extent {
    double low = INFINITY, high = -INFINITY;
    std::vector<double> places;
};

void add_turns(const SplineCurve& curve, std::vector<double>& places) {
    const auto& breaks = curve.knots.breaks();
    places.push_back(curve.at(0, breaks.front()));
    double last = places.back(), direction = 0;
    for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
        for (int k = 1; k <= kSamplesASpan; ++k) {
            const double x = curve.at(0, std::lerp(breaks[s], breaks[s + 1], k / double(kSamplesASpan)));
            if ((x - last) * direction < 0) places.push_back(last);
            direction = x - last;
            last = x;
        }
    places.push_back(last);
}

Extent extent_of(const SmoothBrep& brep, const PlanCells::Cell& cell) {
    Extent extent;
    for (const auto& loop : cell.loops)
        for (const auto& use : loop) {
            const SplineCurve& curve = brep.edges[use.edge].curve;
            add_turns(curve, extent.places);
            const auto [low, high] = std::ranges::minmax(curve.coefficients[0]);
            extent.low = std::min(extent.low, low);
            extent.high = std::max(extent.high, high);
        }
    return extent;
}

bool is_clear(double x, const std::vector<double>& from, double by) {
    return std::ranges::none_of(from, [&](double p) { return std::abs(p - x) < by; });
}

// A line of another face near a place if there is one, else a new one; none if there is no room.
double clear_line(double at, double span, const std::vector<double>& places, const std::vector<double>& all) {
    double best = NAN;
    for (const double x : all)
        if (std::abs(x - at) < 2 * span && is_clear(x, places, kClear * span) &&
            !(std::abs(best - at) <= std::abs(x - at)))
            best = x;
    if (!std::isnan(best)) return best;
    for (const double by : {0.0, 0.2, -0.2, 0.4, -0.4, 0.6, -0.6, 0.8, -0.8})
        if (is_clear(at + by * span, places, kClear * span) && is_clear(at + by * span, all, kApart * span))
            return at + by * span;
    return NAN;
}

}  // namespace

std::vector<double> halving_lines(const SmoothBrep& brep, const std::vector<char>& which) {
    std::vector<double> result(brep.cells.cells.size(), NAN), all = brep.cuts;
    for (std::uint32_t c = 0; c < result.size(); ++c) {
        if (!which[c]) continue;
        const Extent extent = extent_of(brep, brep.cells.cells[c]);
        const CubicKnots& knots = brep.sheet(c).x;
        const std::size_t first = knots.span(extent.low), end = knots.span(extent.high) + 1;
        if (end - first < kLeastSpans) continue;
        const std::size_t middle = std::midpoint(first, end);
        const auto& breaks = knots.breaks();
        const double span =
            std::min(breaks[middle + 1] - breaks[middle], breaks[middle] - breaks[middle - 1]);
        const double line = clear_line(breaks[middle], span, extent.places, all);
        if (!(line > extent.low && line < extent.high)) continue;
        result[c] = line;
        if (std::ranges::find(all, line) == all.end()) all.push_back(line);
    }
    return result;
}

}  // namespace stratareeb
