// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/graph_strands.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "mesh/point_in_ring.h"
#include "reeb/arc_length.h"
#include "reeb/contour_alignment.h"
#include "reeb/homotopy.h"

namespace stratareeb {

namespace {

double mean_height(const std::vector<Point3>& points) {
    const double first = points.front().z;  // a level contour's height stays its own
    double sum = 0;
    for (const Point3& p : points) sum += p.z - first;
    return first + sum / static_cast<double>(points.size());
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
        return is_inside_ring(section(p.z), p);
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
            aligned_contours({strand_.contours[above - 1], strand_.contours[above]}),
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

//! Where contours meet in a node, those that lie in another there bound the other kind; all outermost ones, below and above, are of one
//! kind. That leaves one question for each connected part of the graph, asked where its answer is surest: at its leftmost contour,
//! which only contours of other parts can surround.
class HoleFinder {
 public:
    HoleFinder(const EnhancedReebGraph& graph, const std::vector<GraphStrand>& strands)
        : graph_(graph), strands_(strands), parent_(strands.size()), differs_(strands.size(), false) {
        std::iota(parent_.begin(), parent_.end(), 0u);
        for (std::size_t e = 0; e < graph.edges.size(); ++e)
            sections_.emplace_back(graph, graph.edges[e], strands[e]);
    }

    std::vector<bool> run() {
        std::vector<std::vector<std::uint32_t>> down(graph_.nodes.size()), up(graph_.nodes.size());
        for (std::uint32_t e = 0; e < graph_.edges.size(); ++e) {
            up[graph_.edges[e].from].push_back(e);
            down[graph_.edges[e].to].push_back(e);
        }
        for (std::uint32_t n = 0; n < graph_.nodes.size(); ++n) relate(n, down[n], up[n]);
        std::vector<bool> root_is_hole(strands_.size(), false), is_hole;
        for (const auto& [root, leftmost] : leftmost_contours()) {
            const auto& [edge, point] = leftmost;
            root_is_hole[root] = is_surrounded_by_others(root, point) != find(edge).second;
        }
        for (std::uint32_t e = 0; e < strands_.size(); ++e) {
            const auto [root, differs] = find(e);
            is_hole.push_back(root_is_hole[root] != differs);
        }
        return is_hole;
    }

 private:
    //! An edge's root, and whether they are of different kinds.
    std::pair<std::uint32_t, bool> find(std::uint32_t e) const {
        bool differs = false;
        for (; parent_[e] != e; e = parent_[e]) differs ^= differs_[e];
        return {e, differs};
    }

    void relate(std::uint32_t n, const std::vector<std::uint32_t>& down,
                const std::vector<std::uint32_t>& up) {
        std::optional<std::uint32_t> outermost;
        for (const bool is_lower : {true, false}) {
            const auto& side = is_lower ? down : up;
            for (const std::uint32_t e : side) {
                const bool is_inner = depth(n, e, side, is_lower) % 2 == 1;
                if (!outermost && !is_inner) outermost = e;
            }
        }
        for (const bool is_lower : {true, false}) {
            const auto& side = is_lower ? down : up;
            for (const std::uint32_t e : side)
                if (outermost && e != *outermost) unite(e, *outermost, depth(n, e, side, is_lower) % 2 == 1);
        }
    }

    const std::vector<Point3>& end_of(std::uint32_t e, bool is_top) const {
        return is_top ? strands_[e].contours.back().points : strands_[e].contours.front().points;
    }

    std::size_t depth(std::uint32_t n, std::uint32_t e, const std::vector<std::uint32_t>& side,
                      bool is_top) const {
        const Point3& node = graph_.nodes[n].position;
        const auto from_node = [&](const Point3& p) { return std::hypot(p.x - node.x, p.y - node.y); };
        const Point3 far = *std::ranges::max_element(end_of(e, is_top), {}, from_node);
        return static_cast<std::size_t>(std::ranges::count_if(side, [&](std::uint32_t other) {
            return other != e && is_inside_ring(end_of(other, is_top), far);
        }));
    }

    void unite(std::uint32_t a, std::uint32_t b, bool differ) {
        const auto [root_a, a_differs] = find(a);
        const auto [root_b, b_differs] = find(b);
        if (root_a == root_b) return;
        parent_[root_a] = root_b;
        differs_[root_a] = (a_differs != b_differs) != differ;
    }

    //! By root: an edge with the connected part's leftmost point.
    std::map<std::uint32_t, std::pair<std::uint32_t, Point3>> leftmost_contours() const {
        std::map<std::uint32_t, std::pair<std::uint32_t, Point3>> leftmost;
        for (std::uint32_t e = 0; e < strands_.size(); ++e)
            for (std::size_t k = 0; k < strands_[e].contours.size(); ++k) {
                Point3 p = *std::ranges::min_element(strands_[e].contours[k].points, {}, &Point3::x);
                p.z = strands_[e].heights[k];
                const auto [at, is_new] = leftmost.try_emplace(find(e).first, e, p);
                if (!is_new && p.x < at->second.second.x) at->second = {e, p};
            }
        return leftmost;
    }

    bool is_surrounded_by_others(std::uint32_t root, const Point3& p) const {
        bool odd = false;
        for (std::uint32_t e = 0; e < sections_.size(); ++e)
            if (find(e).first != root) odd ^= sections_[e].surrounds(p);
        return odd;
    }

    const EnhancedReebGraph& graph_;
    const std::vector<GraphStrand>& strands_;
    std::vector<Sections> sections_;
    std::vector<std::uint32_t> parent_;
    std::vector<bool> differs_;  // from the parent
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
    return HoleFinder(graph, strands).run();
}

}  // namespace stratareeb
