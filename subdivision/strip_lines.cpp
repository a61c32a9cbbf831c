// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/strip_lines.h"

#include <algorithm>
#include <cmath>

namespace stratareeb {
namespace {

constexpr std::size_t kMostStrips = 16;  // of a sheet
constexpr double kClear = 0.08;          // of a span: how far a line stays from corners and turns of edges
constexpr double kApart = 0.3;           // of a span: how far from lines of other sheets
constexpr int kSamplesASpan = 8;

//! What bounds a sheet's faces: how far it goes, and the x of corners and turns, where lines must not be.
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

std::vector<Extent> extents_of(const SmoothBrep& brep) {
    std::vector<Extent> extents(brep.horizons.sheets.size());
    for (std::uint32_t c = 0; c < brep.cells.cells.size(); ++c)
        for (const auto& loop : brep.cells.cells[c].loops)
            for (const auto& use : loop) {
                Extent& extent = extents[brep.horizons.of_cell[c]];
                const SplineCurve& curve = brep.edges[use.edge].curve;
                add_turns(curve, extent.places);
                const auto [low, high] = std::ranges::minmax(curve.coefficients[0]);
                extent.low = std::min(extent.low, low);
                extent.high = std::max(extent.high, high);
            }
    return extents;
}

bool is_clear(double x, const std::vector<double>& from, double by) {
    return std::ranges::none_of(from, [&](double p) { return std::abs(p - x) < by; });
}

class Lines {
 public:
    Lines(const SmoothBrep& brep, std::size_t spans) : brep_(brep), spans_(spans) {
        for (const auto& cuts : brep.cuts) all_.insert(all_.end(), cuts.begin(), cuts.end());
    }

    std::vector<double> lay(std::uint32_t s, const Extent& extent) {
        std::vector<double> lines;
        const std::vector<double> before = s < brep_.cuts.size() ? brep_.cuts[s] : std::vector<double>();
        const CubicKnots& knots = brep_.horizons.sheets[s].x;
        const std::size_t first = knots.span(extent.low), last = knots.span(extent.high),
                          spans = last - first + 1;
        const std::size_t strips = std::min((spans + spans_ - 1) / spans_, kMostStrips);
        for (std::size_t k = 1; k < strips; ++k) {
            const std::size_t target = first + k * spans / strips;
            const double at = knots.breaks()[target];
            const double half = (knots.breaks()[std::min(target + spans_ / 2, knots.spans())] -
                                 knots.breaks()[target - std::min(target, spans_ / 2)]) /
                                2;
            if (!is_clear(at, before, half)) continue;
            const double span = std::min(knots.breaks()[target + 1] - at, at - knots.breaks()[target - 1]);
            const double line = clear_line(at, span, extent.places);
            if (std::isnan(line) || line <= extent.low || line >= extent.high) continue;
            if (!lines.empty() && !(line > lines.back())) continue;
            if (std::ranges::find(before, line) != before.end()) continue;
            lines.push_back(line);
            if (std::ranges::find(all_, line) == all_.end()) all_.push_back(line);
        }
        return lines;
    }

 private:
    // A line of another sheet near a place if there is one, else a new one; none if there is no room.
    double clear_line(double at, double span, const std::vector<double>& places) const {
        double best = NAN;
        for (const double x : all_)
            if (std::abs(x - at) < 2 * span && is_clear(x, places, kClear * span) &&
                !(std::abs(best - at) <= std::abs(x - at)))
                best = x;
        if (!std::isnan(best)) return best;
        for (const double by : {0.0, 0.2, -0.2, 0.4, -0.4, 0.6, -0.6, 0.8, -0.8})
            if (is_clear(at + by * span, places, kClear * span) &&
                is_clear(at + by * span, all_, kApart * span))
                return at + by * span;
        return NAN;
    }

    const SmoothBrep& brep_;
    std::size_t spans_;
    std::vector<double> all_;  // of any sheet
};

}  // namespace

std::vector<std::vector<double>> strip_lines(const SmoothBrep& brep, const std::vector<char>& sheets,
                                             std::size_t spans) {
    const std::vector<Extent> extents = extents_of(brep);
    std::vector<std::vector<double>> result(extents.size());
    Lines lines(brep, spans);
    for (std::uint32_t s = 0; s < extents.size(); ++s)
        if (sheets[s] && extents[s].low < extents[s].high) result[s] = lines.lay(s, extents[s]);
    return result;
}

}  // namespace stratareeb
