// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/graph_strands.h"

#include <algorithm>
#include <numeric>

#include "reeb/arc_length.h"
#include "reeb/correspondence.h"
#include "reeb/homotopy.h"

namespace stratareeb {

namespace {

double mean_height(const std::vector<Point3>& points) {
    const double first = points.front().z;  // a level contour's height stays its own
    double sum = 0;
    for (const Point3& p : points) sum += p.z - first;
    return first + sum / static_cast<double>(points.size());
}

bool is_inside(const std::vector<Point3>& ring, const Point3& p) {
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

//! A strand, its ends included, asked for its cross-section at a height.
class Sections {
 public:
    Sections(const EnhancedReebGraph& graph, const EnhancedEdge& edge, const GraphStrand& strand)
        : strand_(strand), bottom_(graph.nodes[edge.from].position), top_(graph.nodes[edge.to].position) {
        low_ = high_ = strand.contours.front().points.front();
        for (const SampledContour& contour : strand.contours)
            for (const Point3& p : contour.points) widen(p);
    }

    //! \pre p is not on the strand's surface
    bool surrounds(const Point3& p) const {
        if (p.z <= bottom_.z || p.z >= top_.z || p.x < low_.x || p.x > high_.x || p.y < low_.y ||
            p.y > high_.y)
            return false;
        return is_inside(section(p.z), p);
    }

 private:
    void widen(const Point3& p) {
        low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), 0};
        high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), 0};
    }

    std::vector<Point3> section(double z) const {
        const auto& heights = strand_.heights;
        const auto above = static_cast<std::size_t>(std::ranges::lower_bound(heights, z) - heights.begin());
        if (above < heights.size() && heights[above] == z) return strand_.contours[above].points;
        if (above == 0) return shrunk(strand_.contours.front(), heights.front(), bottom_, z);
        if (above == heights.size()) return shrunk(strand_.contours.back(), heights.back(), top_, z);
        const ContourHomotopy between(
            corresponding_contours({strand_.contours[above - 1], strand_.contours[above]}),
            {heights[above - 1], heights[above]}, {.kind = HomotopyKind::Linear});
        return between.contour(0, (z - heights[above - 1]) / (heights[above] - heights[above - 1])).points;
    }

    //! On the way from a contour to the node at its end.
    static std::vector<Point3> shrunk(const SampledContour& contour, double height, const Point3& tip,
                                      double z) {
        const double share = (z - tip.z) / (height - tip.z);
        std::vector<Point3> points = contour.points;
        for (Point3& p : points) p = {tip.x + share * (p.x - tip.x), tip.y + share * (p.y - tip.y), z};
        return points;
    }

    const GraphStrand& strand_;
    Point3 bottom_, top_, low_, high_;
};

}  // namespace

std::vector<GraphStrand> strands_of(const EnhancedReebGraph& graph, std::size_t samples) {
    std::vector<GraphStrand> strands;
    for (const EnhancedEdge& edge : graph.edges) {
        GraphStrand& strand = strands.emplace_back();
        for (const std::uint32_t c : edge.contours) {
            strand.contours.push_back(sample_contour(graph.contours[c].curve, samples));
            strand.heights.push_back(mean_height(strand.contours.back().points));
        }
    }
    return strands;
}

std::vector<bool> hole_edges(const EnhancedReebGraph& graph, const std::vector<GraphStrand>& strands) {
    std::vector<Sections> sections;
    for (std::size_t e = 0; e < graph.edges.size(); ++e)
        sections.emplace_back(graph, graph.edges[e], strands[e]);
    std::vector<bool> is_hole;
    for (std::size_t e = 0; e < strands.size(); ++e) {
        const std::size_t middle = strands[e].contours.size() / 2;
        Point3 place = strands[e].contours[middle].points.front();
        place.z = strands[e].heights[middle];
        std::size_t around = 0;
        for (std::size_t other = 0; other < sections.size(); ++other)
            around += other != e && sections[other].surrounds(place);
        is_hole.push_back(around % 2 == 1);
    }
    return is_hole;
}

}  // namespace stratareeb
