// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/terrain_stack.h"

#include <algorithm>
#include <vector>

#include "mesh/point_in_ring.h"
#include "mesh/ring_crossings.h"
#include "reeb/graph_strands.h"

namespace stratareeb {

namespace {

constexpr std::size_t kSamples = 96;     // of a contour that is no polygon
constexpr std::size_t kExceptions = 20;  // one of so many neighbours may be otherwise

std::vector<Point2> outline(const SampledContour& contour) {
    std::vector<Point2> points;
    for (const Point3& p : contour.points) points.push_back({p.x, p.y});
    return points;
}

bool is_level(const SampledContour& contour) {
    return std::ranges::all_of(contour.points,
                               [&](const Point3& p) { return p.z == contour.points.front().z; });
}

//! How many contours are not within the one below, or around it if it is a hole.
std::size_t overhangs(const GraphStrand& strand, bool is_hole) {
    std::vector<std::vector<Point2>> rings;
    for (const SampledContour& contour : strand.contours) rings.push_back(outline(contour));
    std::size_t count = 0;
    for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
        const auto &outer = rings[is_hole ? k + 1 : k], &inner = rings[is_hole ? k : k + 1];
        if (!is_inside_ring(outer, inner.front()) ||
            !ring_crossings(std::vector{outer, inner}, {.most = 1}).empty())
            ++count;
    }
    return count;
}

}  // namespace

bool is_terrain(const EnhancedReebGraph& graph) {
    const auto strands = strands_of(graph, kSamples);
    const auto is_hole = hole_edges(graph, strands);
    std::vector<bool> is_open_above(
        graph.nodes.size(), false);  // it goes on there, or ends in a rim with what is around the hole
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        is_open_above[graph.edges[e].from] = true;
        if (!is_hole[e]) is_open_above[graph.edges[e].to] = true;
    }
    std::size_t exceptions = 0, neighbours = 0;
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        if (!std::ranges::all_of(strands[e].contours, is_level)) return false;
        const bool is_roof = is_hole[e] && !is_open_above[graph.edges[e].to];
        exceptions += is_roof + overhangs(strands[e], is_hole[e]);
        neighbours += strands[e].contours.size();
    }
    return exceptions * kExceptions <= neighbours;
}

}  // namespace stratareeb
