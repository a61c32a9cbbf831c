// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/nearest_sites.h"

#include <algorithm>
#include <numeric>

namespace stratareeb {

namespace {

constexpr std::uint32_t kLeafSites = 8;

double squared_distance(const Point2& a, const Point2& b) {
    const double dx = a.x - b.x, dy = a.y - b.y;
    return dx * dx + dy * dy;
}

double squared_distance(const PlanBox& box, const Point2& p) {
    return squared_distance(p,
                            {std::clamp(p.x, box.low.x, box.high.x), std::clamp(p.y, box.low.y, box.high.y)});
}

bool overlap(const PlanBox& a, const PlanBox& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

}  // namespace

NearestSites::NearestSites(std::span<const Point2> at) : at_(at), order_(at.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

std::uint32_t NearestSites::build(std::uint32_t begin, std::uint32_t end) {
    const auto self = static_cast<std::uint32_t>(nodes_.size());
    PlanBox box{at_[order_[begin]], at_[order_[begin]]};
    for (std::uint32_t k = begin; k < end; ++k) {
        const Point2& p = at_[order_[k]];
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    nodes_.push_back({box, begin, end});
    if (end - begin <= kLeafSites) return self;
    const bool by_x = box.high.x - box.low.x >= box.high.y - box.low.y;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         const double u = by_x ? at_[a].x : at_[a].y, v = by_x ? at_[b].x : at_[b].y;
                         return u != v ? u < v : a < b;
                     });
    const std::uint32_t left = build(begin, middle), right = build(middle, end);
    nodes_[self].left = left, nodes_[self].right = right;
    return self;
}

void NearestSites::search(std::uint32_t node, const Point2& p, std::size_t count,
                          std::vector<NearSite>& heap) const {
    const Node& n = nodes_[node];
    if (heap.size() == count && squared_distance(n.box, p) > heap.front().squared_distance) return;
    if (n.left == 0) {
        for (std::uint32_t k = n.begin; k < n.end; ++k) {
            const NearSite near{squared_distance(at_[order_[k]], p), order_[k]};
            if (heap.size() == count && near > heap.front()) continue;
            if (heap.size() == count) {
                std::ranges::pop_heap(heap);
                heap.pop_back();
            }
            heap.push_back(near);
            std::ranges::push_heap(heap);
        }
        return;
    }
    const bool left_first =
        squared_distance(nodes_[n.left].box, p) <= squared_distance(nodes_[n.right].box, p);
    search(left_first ? n.left : n.right, p, count, heap);
    search(left_first ? n.right : n.left, p, count, heap);
}

void NearestSites::nearest(const Point2& p, std::size_t count, std::vector<NearSite>& found) const {
    found.clear();
    if (nodes_.empty() || count == 0) return;
    search(0, p, count, found);
    std::ranges::sort_heap(found);
}

std::vector<NearSite> NearestSites::nearest(const Point2& p, std::size_t count) const {
    std::vector<NearSite> found;
    nearest(p, count, found);
    return found;
}

// False once a visit returns false.
template <class Visit>
bool NearestSites::visit_box(std::uint32_t node, const PlanBox& box, Visit&& visit) const {
    const Node& n = nodes_[node];
    if (!overlap(n.box, box)) return true;
    if (n.left != 0) return visit_box(n.left, box, visit) && visit_box(n.right, box, visit);
    for (std::uint32_t k = n.begin; k < n.end; ++k)
        if (box.contains(at_[order_[k]]) && !visit(order_[k])) return false;
    return true;
}

std::vector<std::uint32_t> NearestSites::in_box(const PlanBox& box) const {
    std::vector<std::uint32_t> found;
    if (nodes_.empty()) return found;
    visit_box(0, box, [&](std::uint32_t site) {
        found.push_back(site);
        return true;
    });
    std::ranges::sort(found);
    return found;
}

bool NearestSites::has_more_in(const PlanBox& box, std::size_t limit) const {
    std::size_t seen = 0;
    return !nodes_.empty() && !visit_box(0, box, [&](std::uint32_t) { return ++seen <= limit; });
}

}  // namespace stratareeb
