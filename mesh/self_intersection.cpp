// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/self_intersection.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <span>

#include "mesh/triangle_contact.h"

namespace stratareeb {
namespace {

using Range = std::span<std::uint32_t>;

constexpr std::size_t kLeafSize = 4;            // triangles in a leaf of the box tree
constexpr std::size_t kParallelSize = 1 << 13;  // smaller parts are not worth a task

struct Box {
    std::array<double, 3> low, high;

    void include(const Box& other) {
        for (int k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], other.low[k]);
            high[k] = std::max(high[k], other.high[k]);
        }
    }
    bool meets(const Box& other) const {
        for (int k = 0; k < 3; ++k)
            if (low[k] > other.high[k] || other.low[k] > high[k]) return false;
        return true;
    }
};

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Box kNothing{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};

Box box_of(const TriangleSoup& soup, std::uint32_t triangle) {
    Box box = kNothing;
    for (const auto v : soup.triangles[triangle]) {
        const auto& p = soup.points[v];
        box.include({{p.x, p.y, p.z}, {p.x, p.y, p.z}});
    }
    return box;
}

SelfIntersections merged(SelfIntersections a, const SelfIntersections& b, std::size_t named) {
    a.count += b.count;
    a.first.insert(a.first.end(), b.first.begin(), b.first.end());
    std::sort(a.first.begin(), a.first.end());
    if (a.first.size() > named) a.first.resize(named);
    return a;
}

// A tree of boxes over the triangles, each range cut in half at the median along its longest side. The two
// halves of the node over n items starting at i are the nodes over the items themselves, so no child numbers
// are stored.
class BoxTree {
 public:
    BoxTree(const TriangleSoup& soup, const std::vector<bool>* asked, std::size_t named)
        : contact_(soup), asked_(asked), named_(named) {
        boxes_.resize(soup.triangles.size());
        for (std::uint32_t t = 0; t < boxes_.size(); ++t) {
            boxes_[t] = box_of(soup, t);
            if (!contact_.is_degenerate(t)) order_.push_back(t);
        }
        node_boxes_.resize(2 * order_.size() + 2);
        node_is_asked_.resize(asked_ ? node_boxes_.size() : 0, false);
        if (!order_.empty()) build({0, order_.size(), 0});
    }

    SelfIntersections self() const {
        return order_.empty() ? SelfIntersections{} : within({0, order_.size(), 0});
    }

 private:
    struct Node {
        std::size_t begin, end, id;  // ids in depth-first order: a left child follows its parent
        std::size_t size() const { return end - begin; }
        bool is_leaf() const { return size() <= kLeafSize; }
        std::size_t middle() const { return begin + size() / 2; }
        Node left() const { return {begin, middle(), id + 1}; }
        Node right() const { return {middle(), end, id + 2 * (middle() - begin)}; }
    };

    void build(Node node) {
        Box box = kNothing;
        for (auto i = node.begin; i < node.end; ++i) box.include(boxes_[order_[i]]);
        node_boxes_[node.id] = box;
        if (asked_)
            for (auto i = node.begin; i < node.end && !node_is_asked_[node.id]; ++i)
                node_is_asked_[node.id] = (*asked_)[order_[i]];
        if (node.is_leaf()) return;
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis]) axis = k;
        const auto centre = [&](std::uint32_t t) {
            return boxes_[t].low[axis] / 2 + boxes_[t].high[axis] / 2;
        };
        const auto begin = order_.begin();
        std::nth_element(begin + node.begin, begin + node.middle(), begin + node.end,
                         [&](auto s, auto t) { return centre(s) < centre(t); });
        in_two(
            node.size(), [&] { build(node.left()); }, [&] { build(node.right()); });
    }

    template <class F, class G>
    static void in_two(std::size_t size, F f, G g) {
        if (size >= kParallelSize) return tbb::parallel_invoke(f, g);
        f();
        g();
    }

    bool is_asked(Node node) const { return !asked_ || node_is_asked_[node.id]; }

    SelfIntersections within(Node node) const {
        SelfIntersections found;
        if (!is_asked(node)) return found;
        if (node.is_leaf()) {
            for (auto i = node.begin; i < node.end; ++i)
                for (auto j = node.begin; j < i; ++j) test(order_[i], order_[j], found);
            return found;
        }
        SelfIntersections left, right;
        in_two(
            node.size(), [&] { left = within(node.left()); }, [&] { right = within(node.right()); });
        between(node.left(), node.right(), found);
        return merged(merged(std::move(left), right, named_), found, named_);
    }

    void between(Node a, Node b, SelfIntersections& found) const {
        if (!is_asked(a) && !is_asked(b)) return;
        if (!node_boxes_[a.id].meets(node_boxes_[b.id])) return;
        if (a.is_leaf() && b.is_leaf()) {
            for (auto i = a.begin; i < a.end; ++i)
                for (auto j = b.begin; j < b.end; ++j) test(order_[i], order_[j], found);
        } else if (b.is_leaf() || (!a.is_leaf() && a.size() >= b.size())) {
            between(a.left(), b, found);
            between(a.right(), b, found);
        } else {
            between(a, b.left(), found);
            between(a, b.right(), found);
        }
    }

    void test(std::uint32_t s, std::uint32_t t, SelfIntersections& found) const {
        if (asked_ && !(*asked_)[s] && !(*asked_)[t]) return;
        if (!boxes_[s].meets(boxes_[t])) return;
        const auto [low, high] = std::minmax(s, t);
        if (!contact_.meet(low, high)) return;
        ++found.count;
        const std::array<std::uint32_t, 2> pair{low, high};
        auto& first = found.first;
        if (first.size() == named_ && (named_ == 0 || first.back() < pair)) return;
        first.insert(std::upper_bound(first.begin(), first.end(), pair), pair);
        if (first.size() > named_) first.pop_back();
    }

    TriangleContact contact_;
    const std::vector<bool>* asked_;  // by triangle; all, if there is none
    std::size_t named_;
    std::vector<Box> boxes_;            // per triangle
    std::vector<std::uint32_t> order_;  // triangles with area, neighbours in space near each other
    std::vector<Box> node_boxes_;
    std::vector<char> node_is_asked_;  // no bits: nodes are built side by side
};

}  // namespace

SelfIntersections self_intersections(const TriangleSoup& soup, std::size_t named) {
    return BoxTree(soup, nullptr, named).self();
}

SelfIntersections self_intersections_of(const TriangleSoup& soup, const std::vector<bool>& asked,
                                        std::size_t named) {
    return BoxTree(soup, &asked, named).self();
}

}  // namespace stratareeb
