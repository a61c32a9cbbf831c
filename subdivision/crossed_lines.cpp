// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/crossed_lines.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/ring_crossings.h"

namespace stratareeb {
namespace {

constexpr int kSamplesASpan = 8;
constexpr int kHalvingsAtEnds = 6;  // of the steps there

struct Outline {
    std::vector<std::vector<Point2>> rings;
    std::vector<std::vector<std::uint32_t>> line_of;  // [ring][edge]
};

// Parameters along a curve, crowded at its ends: lines that leave a corner at a small angle cross close to it, if at all.
std::vector<double> places_on(const CubicKnots& knots) {
    const auto& breaks = knots.breaks();
    std::vector<double> places;
    for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
        for (int k = 0; k < kSamplesASpan; ++k)
            places.push_back(std::lerp(breaks[s], breaks[s + 1], k / double(kSamplesASpan)));
    double first = (places[1] - places[0]) / 2, last = (breaks.back() - places.back()) / 2;
    for (int i = 0; i < kHalvingsAtEnds; ++i, first /= 2, last /= 2) {
        places.push_back(breaks.front() + first);
        places.push_back(breaks.back() - last);
    }
    places.push_back(breaks.back());
    std::ranges::sort(places);
    return places;
}

// Each line without its end, which is the start of the next.
void add_line(const LineCurve& line, std::uint32_t number, bool forward, std::vector<Point2>& ring,
              std::vector<std::uint32_t>& line_of) {
    auto places = places_on(line.curve.knots);
    if (!forward) std::ranges::reverse(places);
    places.pop_back();
    for (const double t : places) ring.push_back({line.curve.at(0, t), line.curve.at(1, t)});
    line_of.insert(line_of.end(), places.size(), number);
}

Outline outline_of(const PlanCells& cells, const PlanCurves& curves, const PlanCells::Cell& cell) {
    Outline outline;
    for (const auto& loop : cell.loops) {
        auto& ring = outline.rings.emplace_back();
        auto& line_of = outline.line_of.emplace_back();
        for (const auto& use : loop) {
            const std::uint32_t line = cells.edges[use.edge].line;
            add_line(curves.lines[line], line, use.forward, ring, line_of);
        }
    }
    return outline;
}

}  // namespace

std::set<std::uint32_t> crossed_lines(const PlanCells& cells, const PlanCurves& curves) {
    std::vector<std::vector<std::uint32_t>> found(cells.cells.size());
    tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t c) {
        const Outline outline = outline_of(cells, curves, cells.cells[c]);
        for (const auto& crossing : ring_crossings(outline.rings, {.shared_corners = true}))
            for (const auto line : {outline.line_of[crossing.ring][crossing.edge],
                                    outline.line_of[crossing.other_ring][crossing.other_edge]})
                if (cells.lines[line].side == PlanCells::kNone) found[c].push_back(line);
    });
    std::set<std::uint32_t> lines;
    for (const auto& some : found) lines.insert(some.begin(), some.end());
    return lines;
}

}  // namespace stratareeb
