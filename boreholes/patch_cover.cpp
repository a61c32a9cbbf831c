// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/patch_cover.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stratareeb {

namespace {

constexpr double kOverlap = 0.25;  // a patch reaches so far beyond its box, in widths of the box
constexpr int kDeepest = 60;       // halvings; sites closer than that share a patch
constexpr std::size_t kCrowd = 4;  // and it takes so many times the largest number of them at most

PlanBox reach_of(const PlanBox& box) {
    const double dx = kOverlap * (box.high.x - box.low.x), dy = kOverlap * (box.high.y - box.low.y);
    return {{box.low.x - dx, box.low.y - dy}, {box.high.x + dx, box.high.y + dy}};
}

PlanBox joined(const PlanBox& a, const PlanBox& b) {
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

//! The sites' box, widened where it has no width.
PlanBox box_of(std::span<const Point2> at) {
    PlanBox box{at[0], at[0]};
    for (const Point2& p : at) box = joined(box, {p, p});
    const double least = 1e-3 * std::max({box.high.x - box.low.x, box.high.y - box.low.y, 1e-9});
    if (box.high.x - box.low.x < least) box.low.x -= least, box.high.x += least;
    if (box.high.y - box.low.y < least) box.low.y -= least, box.high.y += least;
    return box;
}

//! 1 in the middle, 0 with two zero derivatives at either end.
double hump(double t, double low, double high) {
    const double u = (2 * t - low - high) / (high - low);
    const double v = 1 - u * u;
    return v > 0 ? v * v * v : 0;
}

}  // namespace

PatchCover::PatchCover(std::span<const Point2> at, const PatchCoverOptions& options)
    : at_(at), options_(options), index_(at), box_(box_of(at)) {
    if (at.size() <= options.single) options_.largest = at.size();
    split(box_, 0);
}

std::uint32_t PatchCover::split(const PlanBox& box, int depth) {
    const auto self = static_cast<std::uint32_t>(nodes_.size());
    const PlanBox reach = reach_of(box);
    nodes_.push_back({reach});
    if (depth == kDeepest || !index_.has_more_in(reach, options_.largest)) {
        nodes_[self].patch = static_cast<std::uint32_t>(cells_.size());
        cells_.push_back({box, reach});
        return self;
    }
    PlanBox low = box, high = box;
    if (box.high.x - box.low.x >= box.high.y - box.low.y)
        low.high.x = high.low.x = std::midpoint(box.low.x, box.high.x);
    else
        low.high.y = high.low.y = std::midpoint(box.low.y, box.high.y);
    const std::uint32_t left = split(low, depth + 1), right = split(high, depth + 1);
    nodes_[self] = {joined(nodes_[left].reach, nodes_[right].reach), left, right};
    return self;
}

std::vector<std::uint32_t> PatchCover::sites(std::uint32_t patch) const {
    if (cells_.size() == 1) {
        std::vector<std::uint32_t> all(at_.size());
        std::iota(all.begin(), all.end(), 0u);
        return all;
    }
    const PlanBox& box = cells_[patch].box;
    std::vector<std::uint32_t> found = index_.in_box(cells_[patch].reach);
    const std::size_t most = kCrowd * options_.largest;
    if (found.size() >= options_.fewest && found.size() <= most) return found;
    const Point2 middle{std::midpoint(box.low.x, box.high.x), std::midpoint(box.low.y, box.high.y)};
    std::vector<std::uint32_t> near, both;
    for (const NearSite& n : index_.nearest(middle, std::clamp(found.size(), options_.fewest, most)))
        near.push_back(n.site);
    std::ranges::sort(near);
    if (found.size() > most) return near;
    std::ranges::set_union(found, near, std::back_inserter(both));
    return both;
}

void PatchCover::collect(std::uint32_t node, const Point2& p, std::vector<PatchWeight>& result) const {
    const Node& n = nodes_[node];
    if (!n.reach.contains(p)) return;
    if (n.left != 0) {
        collect(n.left, p, result);
        collect(n.right, p, result);
        return;
    }
    const double weight = hump(p.x, n.reach.low.x, n.reach.high.x) * hump(p.y, n.reach.low.y, n.reach.high.y);
    if (weight > 0) result.push_back({n.patch, weight});
}

void PatchCover::weights(const Point2& p, std::vector<PatchWeight>& result) const {
    result.clear();
    if (cells_.size() == 1) {
        result.push_back({0, 1});
        return;
    }
    collect(0, {std::clamp(p.x, box_.low.x, box_.high.x), std::clamp(p.y, box_.low.y, box_.high.y)}, result);
    double sum = 0;
    for (const PatchWeight& w : result) sum += w.weight;
    for (PatchWeight& w : result) w.weight /= sum;
}

}  // namespace stratareeb
