// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/coarse_to_fine.h"

#include <algorithm>

#include "reeb/greedy_band.h"
#include "reeb/stair_paths.h"

namespace stratareeb {

namespace {

constexpr std::ptrdiff_t kBand = 12;   // rows on either side
constexpr std::size_t kCoarsest = 24;  // points of a contour that are no more joined

//! A contour with neighbouring points joined two by two (the last with one or two before it, if their number is odd).
struct HalvedContour {
    std::vector<Point3> points;
    std::vector<double> parameters;
    std::vector<std::uint32_t> first;  // finer point of each; at the end the number of finer points

    HalvedContour(std::span<const Point3> fine, std::span<const double> fine_parameters) {
        const std::size_t step = fine.size() > kCoarsest ? 2 : 1;
        for (std::size_t i = 0; i + step <= fine.size(); i += step) {
            const Point3 a = fine[i], b = fine[i + step - 1];
            points.push_back({a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2});
            if (!fine_parameters.empty()) parameters.push_back(fine_parameters[i]);
            first.push_back(static_cast<std::uint32_t>(i));
        }
        first.push_back(static_cast<std::uint32_t>(fine.size()));
    }
};

//! The path that takes, per step of a coarse one, all the finer steps.
SpanPath refined(const SpanPath& coarse, const HalvedContour& upper, const HalvedContour& lower) {
    SpanPath path{.upper = upper.first[coarse.upper], .lower = lower.first[coarse.lower]};
    std::size_t i = coarse.upper, j = coarse.lower;
    for (const std::uint8_t up : coarse.upper_advances) {
        const HalvedContour& moving = up ? upper : lower;
        std::size_t& end = up ? i : j;
        path.upper_advances.insert(path.upper_advances.end(), moving.first[end + 1] - moving.first[end], up);
        end = end + 1 == moving.points.size() ? 0 : end + 1;
    }
    return path;
}

Corridor band_around(const SpanPath& path, std::ptrdiff_t height) {
    Corridor band;
    std::ptrdiff_t row = 0;
    const auto add = [&] {
        band.lo.push_back(static_cast<std::int32_t>(std::max<std::ptrdiff_t>(0, row - kBand)));
        band.hi.push_back(static_cast<std::int32_t>(std::min(height, row + kBand)));
    };
    add();
    for (const bool up : path.upper_advances) {
        row += up;
        add();
    }
    return band;
}

//! The best path with the same start near a path. (Its start changes from level to level: see below.)
SpanPath improved(const SpanContours& c, const SpanPath& path) {
    const SpanCosts costs(c, path.upper, path.lower);
    const auto height = static_cast<std::ptrdiff_t>(c.upper.size());
    const auto better = StairPathFinder(costs, height).shortest(0, band_around(path, height));
    return better ? span_path(*better, c, path.upper, path.lower) : path;
}

}  // namespace

SpanPath coarse_to_fine_cycle(const SpanContours& c) {
    SpanPath path;
    if (std::max(c.upper.size(), c.lower.size()) <= kCoarsest) {
        path = improved(c, greedy_path(c, 0, 0));
    } else {
        const HalvedContour upper(c.upper, c.upper_parameters), lower(c.lower, c.lower_parameters);
        path = refined(coarse_to_fine_cycle({.upper = upper.points,
                                             .lower = lower.points,
                                             .upper_parameters = upper.parameters,
                                             .lower_parameters = lower.parameters,
                                             .cost = c.cost,
                                             .closed = true}),
                       upper, lower);
    }
    // The start span is not chosen well yet. Halfway round it doesn't matter: begin there next time.
    turn(path, path.upper_advances.size() / 2, c);
    return improved(c, path);
}

}  // namespace stratareeb
