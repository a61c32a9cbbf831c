// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/stack_level.h"

#include "reeb/contour_nesting.h"

namespace stratareeb {

namespace {

ContourNesting nesting_of(std::span<const StackContour> contours) {
    LevelSet set;
    for (const StackContour& contour : contours) {
        Contour ring;
        for (const Point2& p : contour.points) ring.points.push_back({p.x, p.y, contour.z});
        set.contours.push_back(std::move(ring));
    }
    return nest_contours(set);
}

}  // namespace

std::vector<StackLevel::Edge> StackLevel::edges_of(std::span<const StackContour> contours) {
    std::vector<Edge> edges;
    for (std::uint32_t r = 0; r < contours.size(); ++r) {
        Point2 a = contours[r].points.back();
        for (const Point2& b : contours[r].points) {
            if (a.y < b.y) edges.push_back({a, b, r});
            if (b.y < a.y) edges.push_back({b, a, r});
            a = b;
        }
    }
    return edges;
}

IntervalTree StackLevel::tree_of(const std::vector<Edge>& edges) {
    std::vector<IntervalTree::Interval> heights;
    for (const Edge& edge : edges) heights.push_back({edge.low.y, edge.high.y});
    return IntervalTree(heights);
}

StackLevel::StackLevel(std::span<const StackContour> contours)
    : contours_(contours), edges_(edges_of(contours)), tree_(tree_of(edges_)) {
    ContourNesting nesting = nesting_of(contours);
    static_assert(ContourNesting::kNone == kOutside);
    parent_ = std::move(nesting.parent);
    depth_ = std::move(nesting.depth);
}

std::vector<StackLevel::Passage> StackLevel::passages(double y) const {
    std::vector<Passage> result;
    for (const std::uint32_t e : tree_.holding(y)) {
        const Edge& edge = edges_[e];
        // From the upper end, which is met exactly. The wide type keeps apart what a double would not.
        const long double share = (static_cast<long double>(edge.high.y) - y) /
                                  (static_cast<long double>(edge.high.y) - edge.low.y);
        result.push_back(
            {edge.ring, edge.high.x + share * (static_cast<long double>(edge.low.x) - edge.high.x)});
    }
    return result;
}

bool StackLevel::is_solid(const Point2& place) const {
    bool solid = false;
    for (const Passage& passage : passages(place.y)) solid ^= passage.x < place.x;
    return solid;
}

}  // namespace stratareeb
