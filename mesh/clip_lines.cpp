// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/clip_lines.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>

namespace stratareeb {

namespace {

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::size_t>;

Box box_of(const Point2& a, const Point2& b, double margin, std::size_t i) {
    return {CGAL::Bbox_2(std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin,
                         std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin),
            i};
}

double cross(const Point2& u, const Point2& v) {
    return u.x * v.y - u.y * v.x;
}
Point2 between(const Point2& a, const Point2& b) {
    return {b.x - a.x, b.y - a.y};
}
Point2 along(const Point2& a, const Point2& b, double t) {
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

}  // namespace

InsideTest::InsideTest(const Footprint& footprint) {
    std::size_t corners = 0;
    double y1 = footprint[0][0].y;
    y0_ = y1;
    for (const auto& ring : footprint)
        for (const Point2& p : ring) {
            ++corners;
            y0_ = std::min(y0_, p.y);
            y1 = std::max(y1, p.y);
        }
    rows_.resize(corners);
    row_height_ = (y1 - y0_) / static_cast<double>(corners);
    const auto row = [&](double y) {
        return std::min(rows_.size() - 1, static_cast<std::size_t>((y - y0_) / row_height_));
    };
    for (const auto& ring : footprint)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            for (std::size_t r = row(std::min(a.y, b.y)); r <= row(std::max(a.y, b.y)); ++r)
                rows_[r].push_back({a, b});
        }
}

bool InsideTest::operator()(const Point2& p) const {
    const double at = (p.y - y0_) / row_height_;
    if (!(at >= 0 && at <= static_cast<double>(rows_.size()))) return false;
    bool inside = false;
    for (const auto& [a, b] : rows_[std::min(rows_.size() - 1, static_cast<std::size_t>(at))])
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    return inside;
}

PlanLines clipped_lines(const PlanLines& lines, const Footprint& footprint, double tolerance) {
    std::vector<std::pair<Point2, Point2>> sides;
    std::vector<Box> side_boxes, line_boxes;
    for (const auto& ring : footprint)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            sides.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
            side_boxes.push_back(
                box_of(sides.back().first, sides.back().second, tolerance, sides.size() - 1));
        }
    for (std::size_t s = 0; s < lines.segments.size(); ++s)
        line_boxes.push_back(
            box_of(lines.points[lines.segments[s][0]], lines.points[lines.segments[s][1]], 0, s));

    std::vector<std::vector<double>> meets(lines.segments.size());  // shares of the way along each segment
    CGAL::box_intersection_d(line_boxes.begin(), line_boxes.end(), side_boxes.begin(), side_boxes.end(),
                             [&](const Box& line, const Box& side) {
                                 const Point2 &p = lines.points[lines.segments[line.info()][0]],
                                              &q = lines.points[lines.segments[line.info()][1]];
                                 const auto& [a, b] = sides[side.info()];
                                 const double turn = cross(between(p, q), between(a, b));
                                 if (turn == 0) return;
                                 const double t = cross(between(p, a), between(a, b)) / turn,
                                              u = cross(between(p, a), between(p, q)) / turn;
                                 const double slack = tolerance / std::hypot(b.x - a.x, b.y - a.y);
                                 if (t > 0 && t < 1 && u >= -slack && u <= 1 + slack)
                                     meets[line.info()].push_back(t);
                             });

    const InsideTest is_inside(footprint);
    PlanLines result{.points = lines.points, .segments = {}};
    for (std::size_t s = 0; s < lines.segments.size(); ++s) {
        const auto [first, last] = lines.segments[s];
        const Point2 p = lines.points[first], q = lines.points[last];
        const double shortest = tolerance / std::hypot(q.x - p.x, q.y - p.y);
        std::ranges::sort(meets[s]);
        double from = 0;
        std::uint32_t from_point = first;
        const auto piece_to = [&](double t, bool end) {
            if (!end && (t - from <= shortest || 1 - t <= shortest)) return;
            std::uint32_t to_point = last;
            if (!end) {
                to_point = static_cast<std::uint32_t>(result.points.size());
                result.points.push_back(along(p, q, t));
            }
            if (is_inside(along(p, q, (from + t) / 2))) result.segments.push_back({from_point, to_point});
            from = t;
            from_point = to_point;
        };
        for (const double t : meets[s]) piece_to(t, false);
        piece_to(1, true);
    }
    // Points of pieces outside are gone with them.
    std::vector<std::uint32_t> number(result.points.size(), ~0u);
    std::vector<Point2> kept;
    for (auto& segment : result.segments)
        for (auto& end : segment) {
            if (number[end] == ~0u) {
                number[end] = static_cast<std::uint32_t>(kept.size());
                kept.push_back(result.points[end]);
            }
            end = number[end];
        }
    result.points = std::move(kept);
    return result;
}

}  // namespace stratareeb
