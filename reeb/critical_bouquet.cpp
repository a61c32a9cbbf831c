// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/critical_bouquet.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>

namespace stratareeb {

namespace {

//! A piece of contour from one critical point to the next, which may be the same; the solid is on its left.
struct Piece {
    std::uint32_t from = 0, to = 0;
    PointLoop points;                   // between them
    std::size_t next = 0;               // on the side that is given
    double departure = 0, arrival = 0;  // directions seen from the critical points, radians
};

std::vector<Piece> pieces_of(std::span<const PointLoop> contours, const std::vector<bool>& is_hole,
                             const std::set<std::uint32_t>& critical) {
    std::vector<Piece> pieces;
    for (std::size_t c = 0; c < contours.size(); ++c) {
        PointLoop contour = contours[c];
        if (is_hole[c]) std::ranges::reverse(contour);
        const auto is_critical = [&](std::uint32_t point) { return critical.contains(point); };
        std::ranges::rotate(contour, std::ranges::find_if(contour, is_critical));
        const std::size_t first = pieces.size();
        for (const std::uint32_t point : contour) {
            if (!is_critical(point)) {
                pieces.back().points.push_back(point);
                continue;
            }
            if (pieces.size() > first) pieces.back().to = point;
            Piece& piece = pieces.emplace_back();
            piece.from = point;
            piece.next = pieces.size();
        }
        pieces.back().to = contour.front();
        pieces.back().next = first;
    }
    return pieces;
}

double direction(const Point3& from, const Point3& to) {
    return std::atan2(to.y - from.y, to.x - from.x);
}

//! For each piece the one that starts next, turning about the critical point where it ends.
std::vector<std::size_t> next_by_turning(const std::vector<Piece>& pieces, bool counter_clockwise) {
    std::vector<std::size_t> next(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        double least = 4 * std::numbers::pi;
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            if (pieces[k].from != pieces[i].to) continue;
            double turn = pieces[k].departure - pieces[i].arrival;
            if (!counter_clockwise) turn = -turn;
            if (turn < 0) turn += 2 * std::numbers::pi;
            if (turn >= least) continue;
            least = turn;
            next[i] = k;
        }
    }
    return next;
}

bool is_permutation_of_all(std::vector<std::size_t> next) {
    std::ranges::sort(next);
    for (std::size_t i = 0; i < next.size(); ++i)
        if (next[i] != i) return false;
    return true;
}

std::vector<PointLoop> joined(const std::vector<Piece>& pieces, const std::vector<std::size_t>& next) {
    std::vector<PointLoop> curves;
    std::vector<bool> used(pieces.size(), false);
    for (std::size_t first = 0; first < pieces.size(); ++first) {
        if (used[first]) continue;
        PointLoop& curve = curves.emplace_back();
        for (std::size_t k = first; !used[k]; k = next[k]) {
            used[k] = true;
            curve.push_back(pieces[k].from);
            curve.insert(curve.end(), pieces[k].points.begin(), pieces[k].points.end());
        }
    }
    return curves;
}

}  // namespace

double twice_plan_area(std::span<const std::uint32_t> loop, std::span<const Point3> points) {
    double sum = 0;
    const Point3& o = points[loop.front()];
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point3 &a = points[loop[i]], &b = points[loop[(i + 1) % loop.size()]];
        sum += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
    }
    return sum;
}

std::optional<std::vector<PointLoop>> contours_across(std::span<const PointLoop> contours,
                                                      const std::vector<bool>& is_hole,
                                                      const std::set<std::uint32_t>& critical,
                                                      std::span<const Point3> points) {
    std::vector<Piece> pieces = pieces_of(contours, is_hole, critical);
    std::vector<std::size_t> given;
    for (Piece& piece : pieces) {
        if (piece.points.empty() && piece.from == piece.to) return std::nullopt;
        const std::uint32_t first = piece.points.empty() ? piece.to : piece.points.front(),
                            last = piece.points.empty() ? piece.from : piece.points.back();
        piece.departure = direction(points[piece.from], points[first]);
        piece.arrival = direction(points[piece.to], points[last]);
        given.push_back(piece.next);
    }
    // One of the two ways to turn gives back what is given, the other the far side.
    for (const bool counter_clockwise : {true, false}) {
        if (next_by_turning(pieces, !counter_clockwise) != given) continue;
        const std::vector<std::size_t> across = next_by_turning(pieces, counter_clockwise);
        if (!is_permutation_of_all(across)) continue;
        std::vector<PointLoop> curves = joined(pieces, across);
        for (PointLoop& curve : curves)
            if (twice_plan_area(curve, points) < 0) std::ranges::reverse(curve);
        return curves;
    }
    return std::nullopt;
}

}  // namespace stratareeb
