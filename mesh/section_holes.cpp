// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/section_holes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "boreholes/errors.h"

namespace stratareeb {

namespace {

//! Nearest place on a polyline: distance along it and aside.
std::pair<double, double> nearest_on(const VerticalSection& section, const Point2& p) {
    std::pair<double, double> best{0, HUGE_VAL};
    for (std::size_t i = 0; i + 1 < section.line.size(); ++i) {
        const Point2 &a = section.line[i], &b = section.line[i + 1];
        const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
        const double share = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (length * length), 0.0, 1.0);
        const double aside = std::hypot(p.x - a.x - share * dx, p.y - a.y - share * dy);
        if (aside < best.second) best = {section.corners[i] + share * length, aside};
    }
    return best;
}

std::string some_names(const Survey& survey) {
    constexpr std::size_t kShown = 12;
    std::vector<std::string> names;
    for (const Borehole& hole : survey.holes)
        if (names.size() < kShown) names.push_back(hole.id);
    return fmt::format("{}{}", fmt::join(names, ", "), survey.holes.size() > kShown ? ", …" : "");
}

}  // namespace

std::vector<LogInterval> log_of(const Borehole& hole) {
    std::vector<LogInterval> log;
    auto horizons = hole.horizons;
    horizons.resize(hole.layers.size() + 1);
    for (std::size_t i = 0; i < hole.layers.size(); ++i) {
        const LayerFact& fact = hole.layers[i];
        if (!horizons[i]) continue;
        const double top = *horizons[i];
        const double base = horizons[i + 1] ? *horizons[i + 1] : top - fact.thickness;
        if (fact.is_present() && top > base)
            log.push_back({i, top, base, fact.knowledge == Knowledge::AtLeast});
        if (fact.knowledge == Knowledge::Measured) horizons[i + 1] = base;
    }
    return log;
}

std::vector<SectionHole> holes_along(const VerticalSection& section, const Survey& survey, double within) {
    std::vector<SectionHole> holes;
    for (const Borehole& hole : survey.holes) {
        if (hole.horizons.empty() || !hole.horizons[0]) continue;
        const auto [along, aside] = nearest_on(section, hole.at);
        if (aside <= within) holes.push_back({hole.id, along, aside, *hole.horizons[0], log_of(hole)});
    }
    std::ranges::stable_sort(holes,
                             [](const SectionHole& a, const SectionHole& b) { return a.along < b.along; });
    return holes;
}

std::vector<Point2> line_through(const Survey& survey, const std::vector<std::string>& ids) {
    std::vector<Point2> line;
    for (const std::string& id : ids) {
        const auto hole = std::ranges::find(survey.holes, id, &Borehole::id);
        if (hole == survey.holes.end())
            throw InvalidInput(
                fmt::format("there is no borehole '{}' in the model; there are {}", id, some_names(survey)));
        line.push_back(hole->at);
    }
    return line;
}

}  // namespace stratareeb
