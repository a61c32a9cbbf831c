// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/self_intersection.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <span>

#include "mesh/triangle_contact.h"

namespace stratareeb {
namespace {

using Range = std::span<std::uint32_t>;

constexpr std::size_t kLeafSize = 4;            // triangles in a leaf of the box tree
constexpr std::size_t kSpare = 64;              // pairs collected before the first ones are picked
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

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

void keep_first(Pairs& pairs, std::size_t named) {
    std::sort(pairs.begin(), pairs.end());
    if (pairs.size() > named) pairs.resize(named);
}

SelfIntersections merged(SelfIntersections a, const SelfIntersections& b, std::size_t named) {
    a.count += b.count;
    a.first.insert(a.first.end(), b.first.begin(), b.first.end());
    keep_first(a.first, named);
    return a;
}

// A tree of boxes over the triangles, each range cut in half at the median along its longest axis. The two
// halves of the node over n items starting at i are the nodes over the items themselves, so no child numbers
// are stored.
class BoxTree {
 public:
    //! \param asked the triangles of the tree, if not all
    BoxTree(const TriangleSoup& soup, const std::vector<bool>* asked, std::size_t named)
        : contact_(soup), named_(named) {
        boxes_.resize(soup.triangles.size());
        for (std::uint32_t t = 0; t < boxes_.size(); ++t) {
            boxes_[t] = box_of(soup, t);
            if (asked && !(*asked)[t])
                others_.push_back(t);
            else if (!contact_.is_degenerate(t))
                order_.push_back(t);
        }
        node_boxes_.resize(2 * order_.size() + 2);
        if (!order_.empty()) build(root());
    }

    //! Among the tree's triangles, and between them and the others.
    SelfIntersections find() const {
        if (order_.empty()) return {};
        return merged(within(root()), with_others(), named_);
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

    Node root() const { return {0, order_.size(), 0}; }

    void build(Node node) {
        Box box = kNothing;
        std::array<double, 3> sizes{};
        for (auto i = node.begin; i < node.end; ++i) {
            const Box& own = boxes_[order_[i]];
            box.include(own);
            for (int k = 0; k < 3; ++k) sizes[k] += own.high[k] - own.low[k];
        }
        node_boxes_[node.id] = box;
        if (node.is_leaf()) return;
        const int axis = longest_axis(box, sizes);
        const auto centre = [&](std::uint32_t t) {
            return boxes_[t].low[axis] / 2 + boxes_[t].high[axis] / 2;
        };
        const auto begin = order_.begin();
        std::nth_element(begin + node.begin, begin + node.middle(), begin + node.end,
                         [&](auto s, auto t) { return centre(s) < centre(t); });
        in_two(
            node.size(), [&] { build(node.left()); }, [&] { build(node.right()); });
    }

    //! In units of the triangles' own mean size, so that it cuts between layers of long and low ones too.
    static int longest_axis(const Box& box, const std::array<double, 3>& sizes) {
        const auto side = [&](int k) { return box.high[k] - box.low[k]; };
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (side(axis) == 0 || side(k) * sizes[axis] > side(axis) * sizes[k]) axis = k;
        return axis;
    }

    template <class F, class G>
    static void in_two(std::size_t size, F f, G g) {
        if (size >= kParallelSize) return tbb::parallel_invoke(f, g);
        f();
        g();
    }

    SelfIntersections within(Node node) const {
        SelfIntersections found;
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
        if (!boxes_[s].meets(boxes_[t])) return;
        const auto [low, high] = std::minmax(s, t);
        if (!contact_.meet(low, high)) return;
        ++found.count;
        found.first.push_back({low, high});
        if (found.first.size() >= 2 * named_ + kSpare) keep_first(found.first, named_);
    }

    SelfIntersections with_others() const {
        return tbb::parallel_deterministic_reduce(
            tbb::blocked_range<std::size_t>(0, others_.size(), kParallelSize), SelfIntersections{},
            [&](const tbb::blocked_range<std::size_t>& part, SelfIntersections found) {
                for (std::size_t i = part.begin(); i < part.end(); ++i) query(root(), others_[i], found);
                keep_first(found.first, named_);
                return found;
            },
            [&](SelfIntersections a, const SelfIntersections& b) { return merged(std::move(a), b, named_); });
    }

    void query(Node node, std::uint32_t other, SelfIntersections& found) const {
        if (!node_boxes_[node.id].meets(boxes_[other])) return;
        if (!node.is_leaf()) {
            query(node.left(), other, found);
            query(node.right(), other, found);
            return;
        }
        for (auto i = node.begin; i < node.end; ++i) {
            if (!boxes_[order_[i]].meets(boxes_[other])) continue;
            if (contact_.is_degenerate(other)) return;
            test(order_[i], other, found);
        }
    }

    TriangleContact contact_;
    std::size_t named_;
    std::vector<Box> boxes_;             // per triangle
    std::vector<std::uint32_t> order_;   // triangles with area, neighbours in space near each other
    std::vector<std::uint32_t> others_;  // triangles that are not in the tree
    std::vector<Box> node_boxes_;
};

}  // namespace

SelfIntersections self_intersections(const TriangleSoup& soup, std::size_t named) {
    return BoxTree(soup, nullptr, named).find();
}

SelfIntersections self_intersections_of(const TriangleSoup& soup, const std::vector<bool>& asked,
                                        std::size_t named) {
    return BoxTree(soup, &asked, named).find();
}

}  // namespace stratareeb
