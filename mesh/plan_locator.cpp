// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/plan_locator.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stratareeb {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr double kOnOutline = 1e-12;  // of the plan's size

double doubled_area(const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool is_right_of(const Point2& a, const Point2& b, const Point2& p) {
    return CGAL::orientation(Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y),
                             Kernel::Point_2(p.x, p.y)) == CGAL::RIGHT_TURN;
}

//! How far p lies to the right of a -> b; negative to the left.
double distance_right(const Point2& a, const Point2& b, const Point2& p) {
    return -doubled_area(a, b, p) / std::hypot(b.x - a.x, b.y - a.y);
}

void sort_once(std::vector<std::uint32_t>& numbers) {
    std::ranges::sort(numbers);
    const auto repeated = std::ranges::unique(numbers);
    numbers.erase(repeated.begin(), repeated.end());
}

}  // namespace

PlanLocator::PlanLocator(const TriMesh& plan) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    low_ = {kInfinity, kInfinity};
    high_ = {-kInfinity, -kInfinity};
    points_.reserve(plan.n_vertices());
    for (const auto v : plan.vertices()) {
        const Point2 p{plan.point(v)[0], plan.point(v)[1]};
        points_.push_back(p);
        low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
        high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
    triangles_.reserve(plan.n_faces());
    for (const auto f : plan.faces()) {
        std::array<std::uint32_t, 3> corner{};
        std::size_t i = 0;
        for (const auto v : plan.fv_range(f)) corner[i++] = static_cast<std::uint32_t>(v.idx());
        triangles_.push_back(corner);
    }
    if (triangles_.empty()) {
        first_.assign(2, 0);
        return;
    }
    const double width = std::max(high_.x - low_.x, std::numeric_limits<double>::min());
    const double height = std::max(high_.y - low_.y, std::numeric_limits<double>::min());
    tolerance_ = kOnOutline * std::max(width, height);
    const double side = std::sqrt(width * height / static_cast<double>(triangles_.size()));
    const auto buckets = [&](double length) {
        return static_cast<std::size_t>(
            std::clamp(std::ceil(length / side), 1.0, static_cast<double>(triangles_.size())));
    };
    count_ = {buckets(width), buckets(height)};
    step_ = {width / static_cast<double>(count_[0]), height / static_cast<double>(count_[1])};

    const auto each_bucket = [&](auto&& visit) {
        for (std::uint32_t f = 0; f < triangles_.size(); ++f) {
            Point2 low = points_[triangles_[f][0]], high = low;
            for (const std::uint32_t v : triangles_[f]) {
                low = {std::min(low.x, points_[v].x), std::min(low.y, points_[v].y)};
                high = {std::max(high.x, points_[v].x), std::max(high.y, points_[v].y)};
            }
            const auto from = bucket_of(low), to = bucket_of(high);
            for (std::size_t j = from[1]; j <= to[1]; ++j)
                for (std::size_t i = from[0]; i <= to[0]; ++i) visit(j * count_[0] + i, f);
        }
    };
    first_.assign(count_[0] * count_[1] + 1, 0);
    each_bucket([&](std::size_t bucket, std::uint32_t) { ++first_[bucket + 1]; });
    for (std::size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
    in_bucket_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    each_bucket([&](std::size_t bucket, std::uint32_t f) { in_bucket_[next[bucket]++] = f; });
}

std::array<std::size_t, 2> PlanLocator::bucket_of(const Point2& p) const {
    const auto along = [](double offset, double step, std::size_t count) {
        return static_cast<std::size_t>(
            std::clamp(std::floor(offset / step), 0.0, static_cast<double>(count - 1)));
    };
    return {along(p.x - low_.x, step_[0], count_[0]), along(p.y - low_.y, step_[1], count_[1])};
}

std::optional<PlanPlace> PlanLocator::place_in(std::uint32_t face, const Point2& p, double outside) const {
    const auto& [i, j, k] = triangles_[face];
    const Point2 &a = points_[i], &b = points_[j], &c = points_[k];
    if (outside > 0) {
        if (distance_right(a, b, p) > outside || distance_right(b, c, p) > outside ||
            distance_right(c, a, p) > outside)
            return std::nullopt;
    } else if (is_right_of(a, b, p) || is_right_of(b, c, p) || is_right_of(c, a, p)) {
        return std::nullopt;
    }
    PlanPlace place{.face = face,
                    .vertex = {i, j, k},
                    .weight = {std::max(0.0, doubled_area(p, b, c)), std::max(0.0, doubled_area(p, c, a)),
                               std::max(0.0, doubled_area(p, a, b))}};
    const double sum = place.weight[0] + place.weight[1] + place.weight[2];
    for (double& w : place.weight) w /= sum;
    return place;
}

std::optional<PlanPlace> PlanLocator::search(const Point2& p, double outside) const {
    const auto from = bucket_of({p.x - outside, p.y - outside}),
               to = bucket_of({p.x + outside, p.y + outside});
    for (std::size_t j = from[1]; j <= to[1]; ++j)
        for (std::size_t i = from[0]; i <= to[0]; ++i)
            for (std::size_t t = first_[j * count_[0] + i]; t < first_[j * count_[0] + i + 1]; ++t)
                if (auto place = place_in(in_bucket_[t], p, outside)) return place;
    return std::nullopt;
}

std::optional<PlanPlace> PlanLocator::locate(const Point2& p) const {
    const auto is_near = [&](double x, double low, double high) {
        return x >= low - tolerance_ && x <= high + tolerance_;  // false for NaN
    };
    if (!is_near(p.x, low_.x, high_.x) || !is_near(p.y, low_.y, high_.y)) return std::nullopt;
    if (auto place = search(p, 0)) return place;
    return search(p, tolerance_);
}

void PlanLocator::add_near(const Point2& low, const Point2& high, std::vector<std::uint32_t>& faces) const {
    const auto from = bucket_of(low), to = bucket_of(high);
    for (std::size_t j = from[1]; j <= to[1]; ++j)
        for (std::size_t i = from[0]; i <= to[0]; ++i)
            for (std::size_t t = first_[j * count_[0] + i]; t < first_[j * count_[0] + i + 1]; ++t) {
                const auto& corner = triangles_[in_bucket_[t]];
                const auto [x0, x1] =
                    std::minmax({points_[corner[0]].x, points_[corner[1]].x, points_[corner[2]].x});
                const auto [y0, y1] =
                    std::minmax({points_[corner[0]].y, points_[corner[1]].y, points_[corner[2]].y});
                if (x0 <= high.x && x1 >= low.x && y0 <= high.y && y1 >= low.y)
                    faces.push_back(in_bucket_[t]);
            }
}

std::vector<std::uint32_t> PlanLocator::near(const Point2& low, const Point2& high) const {
    std::vector<std::uint32_t> faces;
    if (triangles_.empty()) return faces;
    add_near(low, high, faces);
    sort_once(faces);
    return faces;
}

std::vector<std::uint32_t> PlanLocator::along(const Point2& from, const Point2& to) const {
    std::vector<std::uint32_t> faces;
    if (triangles_.empty()) return faces;
    // The part over the plan's box alone, in pieces about as long as a bucket.
    double start = 0, end = 1;
    const auto clip = [&](double p, double step, double low, double high) {
        if (step == 0) {
            if (p < low - tolerance_ || p > high + tolerance_) end = -1;
            return;
        }
        const auto [enter, leave] =
            std::minmax({(low - tolerance_ - p) / step, (high + tolerance_ - p) / step});
        start = std::max(start, enter);
        end = std::min(end, leave);
    };
    const double dx = to.x - from.x, dy = to.y - from.y;
    clip(from.x, dx, low_.x, high_.x);
    clip(from.y, dy, low_.y, high_.y);
    if (!(start <= end)) return faces;
    const double buckets = std::max(std::abs(dx) / step_[0], std::abs(dy) / step_[1]) * (end - start);
    const auto pieces = static_cast<std::size_t>(std::ceil(buckets)) + 1;
    for (std::size_t k = 0; k < pieces; ++k) {
        const auto at = [&](std::size_t i) {
            const double share = start + (end - start) * static_cast<double>(i) / static_cast<double>(pieces);
            return Point2{from.x + share * dx, from.y + share * dy};
        };
        const Point2 a = at(k), b = at(k + 1);
        add_near({std::min(a.x, b.x) - tolerance_, std::min(a.y, b.y) - tolerance_},
                 {std::max(a.x, b.x) + tolerance_, std::max(a.y, b.y) + tolerance_}, faces);
    }
    sort_once(faces);
    return faces;
}

}  // namespace stratareeb
