// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/closest_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <vector>

namespace stratareeb {
namespace {

constexpr std::size_t kLeafSize = 8;

double squared_distance(const Point2& a, const Point2& b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

struct Best {
    double squared = std::numeric_limits<double>::infinity();
    std::size_t first = 0, second = 0;
};

//! A k-d tree of points: every node has the box of its range; ranges are halved along the box's longer side.
class PointTree {
 public:
    explicit PointTree(std::span<const Point2> points) : points_(points), order_(points.size()) {
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        build(0, points.size());
    }

    //! Better `best` by the pairs of `query`, point i of the set `first`.
    void search(std::span<const Point2> first, std::size_t i, Best& best) const { visit(0, first, i, best); }

 private:
    struct Node {
        Point2 low, high;
        std::size_t begin = 0, end = 0;
        std::size_t right = 0;  // the left child is the next node; 0 = a leaf
    };

    std::size_t build(std::size_t begin, std::size_t end) {
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        Node node{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}, begin, end};
        for (std::size_t k = begin; k < end; ++k) {
            const Point2& p = points_[order_[k]];
            node.low = {std::min(node.low.x, p.x), std::min(node.low.y, p.y)};
            node.high = {std::max(node.high.x, p.x), std::max(node.high.y, p.y)};
        }
        const std::size_t id = nodes_.size();
        nodes_.push_back(node);
        if (end - begin <= kLeafSize) return id;
        const bool along_x = node.high.x - node.low.x >= node.high.y - node.low.y;
        const std::size_t middle = begin + (end - begin) / 2;
        const auto at = [&](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
        std::nth_element(at(begin), at(middle), at(end), [&](std::size_t a, std::size_t b) {
            return along_x ? points_[a].x < points_[b].x : points_[a].y < points_[b].y;
        });
        build(begin, middle);
        nodes_[id].right = build(middle, end);
        return id;
    }

    double squared_distance_to(const Node& node, const Point2& p) const {
        return squared_distance(
            p, {std::clamp(p.x, node.low.x, node.high.x), std::clamp(p.y, node.low.y, node.high.y)});
    }

    void visit(std::size_t id, std::span<const Point2> first, std::size_t i, Best& best) const {
        const Node& node = nodes_[id];
        if (squared_distance_to(node, first[i]) > best.squared) return;
        if (node.right == 0) {
            for (std::size_t k = node.begin; k < node.end; ++k) offer(first, i, order_[k], best);
            return;
        }
        std::size_t near = id + 1, far = node.right;
        if (squared_distance_to(nodes_[far], first[i]) < squared_distance_to(nodes_[near], first[i])) {
            std::swap(near, far);
        }
        visit(near, first, i, best);
        visit(far, first, i, best);
    }

    void offer(std::span<const Point2> first, std::size_t i, std::size_t j, Best& best) const {
        const double squared = squared_distance(first[i], points_[j]);
        if (squared > best.squared) return;
        const auto key = [&](std::size_t a, std::size_t b) {
            return std::tuple(first[a].x, first[a].y, points_[b].x, points_[b].y, a, b);
        };
        if (squared < best.squared || key(i, j) < key(best.first, best.second)) best = {squared, i, j};
    }

    std::span<const Point2> points_;
    std::vector<std::size_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace

ClosestPair closest_pair(std::span<const Point2> first, std::span<const Point2> second) {
    const PointTree tree(second);
    Best best;
    for (std::size_t i = 0; i < first.size(); ++i) tree.search(first, i, best);
    return {best.first, best.second, std::sqrt(best.squared)};
}

ClosestPair closest_parameters(std::span<const double> first, std::span<const double> second) {
    ClosestPair best{0, 0, std::numeric_limits<double>::infinity()};
    std::size_t next = 0;  // the first of `second` that is not below
    for (std::size_t i = 0; i < first.size(); ++i) {
        while (next < second.size() && second[next] < first[i]) ++next;
        const std::size_t size = second.size();
        for (const std::size_t j : {next == 0 ? size - 1 : next - 1, next == size ? 0 : next}) {
            const double straight = std::abs(first[i] - second[j]);
            const double distance = std::min(straight, 1 - straight);
            if (distance < best.distance) best = {i, j, distance};
        }
    }
    return best;
}

}  // namespace stratareeb
