// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/pinch_lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace stratareeb {

namespace {

// Names of points, so that the same point met from two triangles or by two layers is one point.
// A site: {site, kSite, 0}. A cut of edge (low, high): {low, high, which}; which says at which share from
// low. A crossing inside a triangle: {triangle, kCrossing, corner that the two lines leave out, 3 for all
// three}. The far end of a line beyond the hull: {edge, kOutside, which}.
using PointName = std::array<std::uint32_t, 3>;
constexpr std::uint32_t kSite = ~0u, kCrossing = ~0u - 1, kOutside = ~0u - 2;

class LineWork {
 public:
    explicit LineWork(const ThicknessField& field)
        : field_(field), sites_(field.holes().sites()), fraction_(field.rule().fraction) {}

    std::uint32_t site(std::uint32_t i) { return point({i, kSite, 0}, sites_[i]); }

    //! The point between a hole that lacks a layer and one that has it at which the layer ends.
    std::uint32_t cut(std::uint32_t lacks, std::uint32_t has) {
        if (fraction_ == 0) return site(lacks);
        const bool from_low = lacks < has;
        const auto low = std::min(lacks, has), high = std::max(lacks, has);
        const bool middle = fraction_ == 0.5;
        const double share = middle || from_low ? fraction_ : 1 - fraction_;
        const Point2 &a = sites_[low], &b = sites_[high];
        return point({low, high,
                      middle     ? 0u
                      : from_low ? 1u
                                 : 2u},
                     {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
    }

    //! Where, in a triangle, the lines around corners `p` and `q` (each the only one to have a layer) cross.
    std::uint32_t crossing(std::uint32_t triangle, int p, int q) {
        const bool at_centre = std::abs(3 * fraction_ - 1) < 1e-12;
        const int left_out = 3 - p - q;
        std::array<double, 3> weight{fraction_, fraction_, fraction_};
        weight[left_out] = 1 - 2 * fraction_;
        Point2 at;
        for (int k = 0; k < 3; ++k) {
            at.x += weight[k] * sites_[field_.holes().triangles()[triangle][k]].x;
            at.y += weight[k] * sites_[field_.holes().triangles()[triangle][k]].y;
        }
        return point({triangle, kCrossing, at_centre ? 3u : static_cast<std::uint32_t>(left_out)}, at);
    }

    std::uint32_t outside(std::uint32_t hull_edge, std::uint32_t which, std::uint32_t from,
                          const Point2& step) {
        const Point2 p = lines_.points[from];
        return point({hull_edge, kOutside, which}, {p.x + step.x, p.y + step.y});
    }

    void join(std::uint32_t a, std::uint32_t b) {
        if (a == b || !joined_.insert(std::minmax(a, b)).second) return;
        lines_.segments.push_back({a, b});
    }

    PlanLines take() { return std::move(lines_); }

 private:
    std::uint32_t point(const PointName& name, const Point2& at) {
        const auto [it, fresh] = known_.try_emplace(name, static_cast<std::uint32_t>(lines_.points.size()));
        if (fresh) lines_.points.push_back(at);
        return it->second;
    }

    const ThicknessField& field_;
    const std::vector<Point2>& sites_;
    double fraction_;
    PlanLines lines_;
    std::map<PointName, std::uint32_t> known_;
    std::set<std::pair<std::uint32_t, std::uint32_t>> joined_;
};

//! Corner k has, or lacks, a layer that the other two lack, or have; -1 where all three agree.
struct Odd {
    int corner = -1;
    bool has = false;
};

Odd odd_corner(const ThicknessField& field, std::size_t layer, const std::array<std::uint32_t, 3>& triangle) {
    std::array<bool, 3> has{};
    for (int k = 0; k < 3; ++k) has[k] = field.has(layer, triangle[k]);
    for (int k = 0; k < 3; ++k)
        if (has[k] != has[(k + 1) % 3] && has[k] != has[(k + 2) % 3]) return {k, has[k]};
    return {};
}

void add_triangle_lines(LineWork& work, const ThicknessField& field, std::uint32_t t) {
    const auto& triangle = field.holes().triangles()[t];
    std::array<bool, 3> alone_has{}, alone_lacks{};
    for (std::size_t layer = 0; layer < field.layers(); ++layer)
        if (const Odd odd = odd_corner(field, layer, triangle); odd.corner >= 0)
            (odd.has ? alone_has : alone_lacks)[odd.corner] = true;
    const double fraction = field.rule().fraction;
    for (int k = 0; k < 3; ++k) {
        const auto a = triangle[k], b = triangle[(k + 1) % 3], c = triangle[(k + 2) % 3];
        if (alone_lacks[k] && fraction > 0) work.join(work.cut(a, b), work.cut(a, c));
        if (!alone_has[k]) continue;
        if (fraction == 0) {
            work.join(work.site(b), work.site(c));
            continue;
        }
        // From side ab to side ac, the line around b is met at b's weight `fraction`, that around c at 1 - 2
        // fraction.
        std::vector<std::pair<double, std::uint32_t>> on_the_way;
        if (fraction < 0.5) {
            if (alone_has[(k + 1) % 3]) on_the_way.emplace_back(fraction, work.crossing(t, k, (k + 1) % 3));
            if (alone_has[(k + 2) % 3])
                on_the_way.emplace_back(1 - 2 * fraction, work.crossing(t, k, (k + 2) % 3));
        }
        std::ranges::sort(on_the_way, [](const auto& u, const auto& v) { return u.first > v.first; });
        std::uint32_t from = work.cut(b, a);
        for (const auto& [weight, through] : on_the_way) {
            work.join(from, through);
            from = through;
        }
        work.join(from, work.cut(c, a));
    }
}

void add_lines_beyond_hull(LineWork& work, const ThicknessField& field, double reach) {
    const auto& hull = field.holes().hull_edges();
    for (std::uint32_t e = 0; e < hull.size(); ++e) {
        const auto [a, b] = hull[e];
        const Point2 direction = field.holes().outward(e);
        const Point2 outward{direction.x * reach, direction.y * reach};
        bool from_a = false, from_b = false;
        for (std::size_t layer = 0; layer < field.layers(); ++layer) {
            from_a |= !field.has(layer, a) && field.has(layer, b);
            from_b |= field.has(layer, a) && !field.has(layer, b);
        }
        const bool same_point = field.rule().fraction == 0.5;
        if (from_a || (from_b && same_point)) {
            const auto start = work.cut(a, b);
            work.join(start, work.outside(e, 0, start, outward));
        }
        if (from_b && !same_point) {
            const auto start = work.cut(b, a);
            work.join(start, work.outside(e, 1, start, outward));
        }
    }
}

}  // namespace

PlanLines pinch_lines(const ThicknessField& field, double reach) {
    LineWork work(field);
    for (std::uint32_t t = 0; t < field.holes().triangles().size(); ++t) add_triangle_lines(work, field, t);
    if (reach > 0) add_lines_beyond_hull(work, field, reach);
    return work.take();
}

PlanLines cut_triangulation_edges(const ThicknessField& field) {
    LineWork work(field);
    const auto add_edge = [&](std::uint32_t a, std::uint32_t b) {
        bool ends_from_a = false, ends_from_b = false;
        for (std::size_t layer = 0; layer < field.layers(); ++layer) {
            ends_from_a |= !field.has(layer, a) && field.has(layer, b);
            ends_from_b |= field.has(layer, a) && !field.has(layer, b);
        }
        std::uint32_t from = work.site(a);
        const auto to = [&](std::uint32_t next) {
            work.join(from, next);
            from = next;
        };
        if (ends_from_a) to(work.cut(a, b));
        if (ends_from_b) to(work.cut(b, a));
        to(work.site(b));
    };
    for (const auto& [a, b, c] : field.holes().triangles()) {
        add_edge(std::min(a, b), std::max(a, b));
        add_edge(std::min(b, c), std::max(b, c));
        add_edge(std::min(c, a), std::max(c, a));
    }
    return work.take();
}

}  // namespace stratareeb
