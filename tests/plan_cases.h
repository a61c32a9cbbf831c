// SPDX-License-Identifier: GPL-3.0-or-later
// Plan meshes of small and random patterns of layers, for the tests of plan meshes and regions.
#pragma once

#include <cmath>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "boreholes/thickness_field.h"
#include "mesh/footprint.h"
#include "mesh/pinch_lines.h"
#include "mesh/plan_mesh.h"

namespace stratareeb::testing {

//! Holes and, per layer, a letter for each: '1' has the layer, thickness 1; '0' lacks it.
struct PlanCase {
    std::vector<Point2> sites;
    std::vector<std::string> present;
    double fraction = 0.5;
    double spacing = 0;  // 0 = the bare triangulation
};

inline ThicknessField thickness_field(const PlanCase& c) {
    std::vector<std::vector<double>> thickness;
    for (const std::string& layer : c.present) {
        auto& t = thickness.emplace_back();
        for (const char letter : layer) t.push_back(letter == '1');
    }
    const auto holes = std::make_shared<const HoleTriangulation>(c.sites);
    return {holes, thickness, {c.fraction}, make_interpolator(InterpolatorKind::Linear, holes)};
}

//! Pinch-out lines and, for a bare triangulation, its cut edges.
inline PlanLines plan_lines(const ThicknessField& field, double spacing) {
    PlanLines lines = pinch_lines(field, 0);
    if (spacing > 0) return lines;
    const PlanLines edges = cut_triangulation_edges(field);
    const auto first = static_cast<std::uint32_t>(lines.points.size());
    lines.points.insert(lines.points.end(), edges.points.begin(), edges.points.end());
    for (const auto& [a, b] : edges.segments) lines.segments.push_back({a + first, b + first});
    return lines;
}

inline PlanMesh plan_mesh(const ThicknessField& field, double spacing) {
    return build_plan_mesh(hull_footprint(field.holes()), field.holes().sites(), plan_lines(field, spacing),
                           {.spacing = spacing});
}

constexpr double kCaseExtent = 100;

//! Holes in the corners of a square and at random (or on a grid) in it; layers at random.
inline PlanCase random_plan_case(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto share = [&] { return static_cast<double>(random() % 100'000) / 100'000; };
    const bool grid = random() % 3 == 0;
    std::set<std::pair<double, double>> places{
        {0, 0}, {kCaseExtent, 0}, {0, kCaseExtent}, {kCaseExtent, kCaseExtent}};
    const std::size_t count = 4 + random() % 20;
    while (places.size() < count)
        places.insert(grid ? std::pair(20.0 * static_cast<double>(random() % 6),
                                       20.0 * static_cast<double>(random() % 6))
                           : std::pair(kCaseExtent * share(), kCaseExtent * share()));
    PlanCase c;
    for (const auto& [x, y] : places) c.sites.push_back({x, y});
    const double density = 0.2 + 0.6 * share();
    for (int layer = 0; layer < 3; ++layer) {
        auto& present = c.present.emplace_back();
        for (std::size_t i = 0; i < places.size(); ++i) present += share() < density ? '1' : '0';
    }
    constexpr double kFractions[] = {0, 0.25, 1.0 / 3, 0.5};
    c.fraction = kFractions[random() % 4];
    c.spacing = random() % 2 ? 0 : 8 + 20 * share();
    return c;
}

}  // namespace stratareeb::testing
