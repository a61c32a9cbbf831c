// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/level_pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "boreholes/errors.h"
#include "mesh/ring_crossings.h"
#include "mesh/ring_fill.h"
#include "reeb/arc_length.h"
#include "reeb/graph_strands.h"
#include "reeb/point_math.h"
#include "reeb/sampled_contour.h"

namespace stratareeb {

namespace {

//! How far visits of one corner are drawn apart, of the contour's shorter side there; less and less until they are free.
constexpr double kApart[] = {1e-3, 1e-5, 1e-7};

std::size_t corner_before(const std::vector<Point3>& points, std::size_t i) {
    return i > 0 ? i - 1 : points.size() - 1;
}

//! Which corners stand at each place.
using Visits = std::map<std::pair<double, double>, std::vector<std::size_t>>;

Visits visits_of(const std::vector<Point3>& points) {
    Visits visits;
    for (std::size_t i = 0; i < points.size(); ++i) visits[{points[i].x, points[i].y}].push_back(i);
    return visits;
}

bool is_simple(const std::vector<Point3>& points) {
    std::vector<std::vector<Point2>> ring(1);
    for (const Point3& p : points) ring[0].push_back({p.x, p.y});
    return ring_crossings(ring, {.most = 1}).empty();
}

struct Corner {
    Point3 back, ahead;  // unit vectors in plan along its two sides
};

Corner corner_at(const std::vector<Point3>& points, std::size_t i) {
    const auto unit = [&](std::size_t to) {
        const Point3 way = points[to] - points[i];
        const double length = std::hypot(way.x, way.y);
        return Point3{way.x / length, way.y / length, 0};
    };
    return {unit(corner_before(points, i)), unit((i + 1) % points.size())};
}

//! The middle of what is on a corner's left, counter-clockwise from its side ahead to that back.
Point3 to_the_left(const Corner& corner) {
    const Point3 normals{corner.back.y - corner.ahead.y, corner.ahead.x - corner.back.x, 0};
    const double length = std::hypot(normals.x, normals.y);
    if (length < 1e-9) return {};
    return {normals.x / length, normals.y / length, 0};
}

//! Turning counter-clockwise from a direction to another, 0 to 2 pi.
double turn(const Point3& from, const Point3& to) {
    const double angle = std::atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

//! Away from the other visits of a corner's place, which are all on one side of it; nothing if they are not. Where the contour runs
//! along itself there and back, `otherwise` says which way to go, left (1) or right (-1).
std::optional<Point3> away_from_others(const std::vector<Point3>& points, std::size_t i,
                                       const std::vector<std::size_t>& visits, double otherwise) {
    constexpr double kSame = 1e-9;  // radians
    const Corner own = corner_at(points, i);
    const double left = turn(own.ahead, own.back);
    bool any_left = false, any_right = false;
    for (const std::size_t k : visits) {
        if (k == i) continue;
        const Corner other = corner_at(points, k);
        for (const Point3& side : {other.back, other.ahead}) {
            const double at = turn(own.ahead, side);
            if (std::min({at, 2 * std::numbers::pi - at, std::abs(at - left)}) < kSame) continue;
            (at < left ? any_left : any_right) = true;
        }
    }
    if (any_left && any_right) return std::nullopt;
    const double way = any_left ? -1 : any_right ? 1 : otherwise;
    return way * to_the_left(own);
}

std::optional<std::vector<Point3>> drawn_apart(const std::vector<Point3>& points, double share,
                                               double otherwise) {
    std::vector<Point3> apart = points;
    for (const auto& [place, corners] : visits_of(points)) {
        if (corners.size() == 1) continue;
        for (const std::size_t i : corners) {
            const auto way = away_from_others(points, i, corners, otherwise);
            if (!way) return std::nullopt;
            const double side = std::min(magnitude(points[i] - points[corner_before(points, i)]),
                                         magnitude(points[(i + 1) % points.size()] - points[i]));
            apart[i] += share * side * *way;
        }
    }
    if (!is_simple(apart)) return std::nullopt;
    return apart;
}

std::optional<std::vector<Point3>> drawn_apart(const std::vector<Point3>& points) {
    if (visits_of(points).size() == points.size()) return points;
    for (const double share : kApart)
        for (const double otherwise : {1.0, -1.0})
            if (auto apart = drawn_apart(points, share, otherwise)) return apart;
    return std::nullopt;
}

class Parting {
 public:
    Parting(const EnhancedReebGraph& graph, std::size_t samples) : graph_(graph), samples_(samples) {}

    LevelPieces run() {
        pieces_.graph = graph_;
        for (const EnhancedNode& node : graph_.nodes) names_.insert(node.id);
        std::vector<std::vector<std::pair<std::uint32_t, bool>>> ends(graph_.nodes.size());
        for (const bool is_top : {true, false})
            for (std::uint32_t e = 0; e < graph_.edges.size(); ++e)
                ends[is_top ? graph_.edges[e].to : graph_.edges[e].from].emplace_back(e, is_top);
        for (std::uint32_t n = 0; n < ends.size(); ++n) {
            if (graph_.nodes[n].form == NodeForm::Point) continue;
            bool is_first = true;
            for (const auto& [e, is_top] : ends[n]) part(n, e, is_top, std::exchange(is_first, false));
        }
        find_turned();
        return std::move(pieces_);
    }

 private:
    void part(std::uint32_t n, std::uint32_t e, bool is_top, bool is_first) {
        EnhancedEdge& edge = pieces_.graph.edges[e];
        const std::uint32_t c = is_top ? edge.contours.back() : edge.contours.front();
        LevelEnd end{.node = n, .edge = e, .is_top = is_top, .points = {}, .apart = {}};
        end.points = sample_contour(graph_.contours[c].curve, samples_).points;
        auto apart = drawn_apart(end.points);
        if (!apart)
            throw InvalidInput(
                fmt::format("contour {} runs along itself at node {}: leave out what goes there and back",
                            text_of(graph_.contours[c].id), text_of(graph_.nodes[n].id)));
        pieces_.has_pinched_ends |= *apart != end.points;
        end.apart = std::move(*apart);
        Curve& curve = pieces_.graph.contours[c].curve;
        curve = {.kind = CurveKind::Polyline, .closed = true};
        curve.points = end.apart;
        if (!is_first) (is_top ? edge.to : edge.from) = another(n);
        // The edge ends amid its own contour, so that nothing leans towards a place shared with others.
        EnhancedNode& node = pieces_.graph.nodes[is_top ? edge.to : edge.from];
        const Point3 middle = mean_point(contour_by_perimeter(end.points));
        node.form = NodeForm::Flat;
        node.position = {middle.x, middle.y, node.position.z};
        pieces_.ends.push_back(std::move(end));
    }

    std::uint32_t another(std::uint32_t n) {
        EnhancedNode node = graph_.nodes[n];
        for (int k = 2;; ++k) {
            node.id = fmt::format("{}, part {}", text_of(graph_.nodes[n].id), k);
            if (names_.insert(node.id).second) break;
        }
        pieces_.graph.nodes.push_back(std::move(node));
        return static_cast<std::uint32_t>(pieces_.graph.nodes.size() - 1);
    }

    //! Holes of the whole graph tell more than those of a piece. Contours at a flat node may lie on one another: those next to them
    //! say which lies in which.
    void find_turned() {
        EnhancedReebGraph whole = graph_;
        for (EnhancedEdge& edge : whole.edges) {
            if (edge.contours.size() > 1 && whole.nodes[edge.from].form == NodeForm::Flat)
                edge.contours.erase(edge.contours.begin());
            if (edge.contours.size() > 1 && whole.nodes[edge.to].form == NodeForm::Flat)
                edge.contours.pop_back();
        }
        const auto wanted = hole_edges(whole, strands_of(whole, samples_)),
                   own = hole_edges(pieces_.graph, strands_of(pieces_.graph, samples_));
        for (std::size_t e = 0; e < own.size(); ++e) pieces_.turned.push_back(wanted[e] != own[e]);
    }

    const EnhancedReebGraph& graph_;
    const std::size_t samples_;
    std::set<GraphId> names_;
    LevelPieces pieces_;
};

}  // namespace

LevelPieces level_pieces(const EnhancedReebGraph& graph, std::size_t samples) {
    return Parting(graph, samples).run();
}

bool fit_at_level_node(const std::vector<std::vector<Point3>>& contours) {
    std::map<std::pair<double, double>, std::uint32_t> number;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    std::vector<Point2> corners;
    std::vector<std::vector<std::uint32_t>> rings;
    for (const auto& contour : contours) {
        if (!drawn_apart(contour)) return false;
        auto& ring = rings.emplace_back();
        for (const Point3& p : contour) {
            const auto [at, is_new] =
                number.try_emplace({p.x, p.y}, static_cast<std::uint32_t>(corners.size()));
            if (is_new) corners.push_back({p.x, p.y});
            ring.push_back(at->second);
        }
        for (std::size_t i = 0; i < ring.size(); ++i)
            if (++sides[std::minmax(ring[i], ring[(i + 1) % ring.size()])] > 2) return false;
    }
    try {
        ring_fill(corners, rings);
        return true;
    } catch (const InvalidInput&) {
        return false;
    }
}

}  // namespace stratareeb
