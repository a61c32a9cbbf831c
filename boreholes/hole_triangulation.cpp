// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/hole_triangulation.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hilbert_sort_2.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/natural_neighbor_coordinates_2.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

#include "boreholes/errors.h"

namespace stratareeb {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<std::int32_t, Kernel>;
using DataStructure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Dt = CGAL::Delaunay_triangulation_2<Kernel, DataStructure>;
using CgalPoint = Kernel::Point_2;

constexpr std::int32_t kNoTriangle = -1;  // an infinite or peeled face
// Natural neighbour coordinates that miss their own place by more than this share of the neighbourhood are
// the victims of rounding in a flat cell; barycentric ones are taken instead.
constexpr double kCoordinateTolerance = 1e-6;
constexpr double kOnRim = 1e-7;  // height over length above an edge of the convex hull

double distance(const Point2& a, const Point2& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

double height_over_length(const Point2& a, const Point2& b, const Point2& apex) {
    const double length = distance(a, b);
    return std::abs((b.x - a.x) * (apex.y - a.y) - (b.y - a.y) * (apex.x - a.x)) / (length * length);
}

std::size_t farthest(const std::vector<Point2>& sites, const Point2& from) {
    const auto less = [&](const Point2& a, const Point2& b) { return distance(a, from) < distance(b, from); };
    return static_cast<std::size_t>(std::max_element(sites.begin(), sites.end(), less) - sites.begin());
}

PlanLocation at_site(std::uint32_t site, bool inside) {
    return {{site, site, site}, {1, 0, 0}, inside};
}

PlanLocation barycentric(const std::array<std::uint32_t, 3>& corners, const std::vector<Point2>& sites,
                         const Point2& p) {
    const Point2 &a = sites[corners[0]], &b = sites[corners[1]], &c = sites[corners[2]];
    const auto twice_area = [](const Point2& u, const Point2& v, const Point2& w) {
        return (v.x - u.x) * (w.y - u.y) - (v.y - u.y) * (w.x - u.x);
    };
    std::array<double, 3> weight{twice_area(p, b, c), twice_area(a, p, c), twice_area(a, b, p)};
    for (double& w : weight) w = std::max(w, 0.0);  // p is inside: what is below zero is rounding
    const double sum = weight[0] + weight[1] + weight[2];
    for (double& w : weight) w /= sum;
    return {corners, weight, true};
}

}  // namespace

struct HoleTriangulation::Delaunay {
    Dt dt;
    mutable Dt::Face_handle hint;
};

HoleTriangulation::HoleTriangulation(std::vector<Point2> sites, double hull_sliver)
    : sites_(std::move(sites)), delaunay_(std::make_unique<Delaunay>()) {
    if (sites_.empty()) throw InvalidInput("no holes to interpolate between");
    triangulate(hull_sliver);
}

HoleTriangulation::~HoleTriangulation() = default;

void HoleTriangulation::triangulate(double hull_sliver) {
    std::vector<std::pair<CgalPoint, std::uint32_t>> points;
    points.reserve(sites_.size());
    for (std::uint32_t i = 0; i < sites_.size(); ++i)
        points.emplace_back(CgalPoint(sites_[i].x, sites_[i].y), i);
    delaunay_->dt.insert(points.begin(), points.end());
    if (delaunay_->dt.number_of_vertices() != sites_.size())
        throw InvalidInput("two holes stand at the same place; merge them before triangulating");

    const Point2 a = sites_[farthest(sites_, sites_[0])];
    const Point2 b = sites_[farthest(sites_, a)];
    double slenderness = 0;
    if (sites_.size() > 2)
        for (const Point2& p : sites_) slenderness = std::max(slenderness, height_over_length(a, b, p));
    if (delaunay_->dt.dimension() < 2 || slenderness < hull_sliver) return chain_collinear();

    peel_hull_slivers(hull_sliver);
    if (triangles_.empty()) return chain_collinear();
    link_hull();
    link_rim();
}

// Face infos become triangle numbers, kNoTriangle where infinite or peeled.
void HoleTriangulation::peel_hull_slivers(double hull_sliver) {
    Dt& dt = delaunay_->dt;
    constexpr std::int32_t kKept = 0;
    std::vector<char> on_hull(sites_.size(), 0);
    std::deque<std::pair<Dt::Face_handle, int>> hull;  // a kept face and the index of its hull edge
    for (const auto face : dt.all_face_handles()) face->info() = dt.is_infinite(face) ? kNoTriangle : kKept;
    for (const auto face : dt.finite_face_handles())
        for (int i = 0; i < 3; ++i)
            if (face->neighbor(i)->info() == kNoTriangle) {
                hull.emplace_back(face, i);
                on_hull[face->vertex(dt.ccw(i))->info()] = on_hull[face->vertex(dt.cw(i))->info()] = 1;
            }
    while (!hull.empty()) {
        const auto [face, i] = hull.front();
        hull.pop_front();
        if (face->info() == kNoTriangle) continue;
        const std::uint32_t apex = face->vertex(i)->info();
        const Point2 &a = sites_[face->vertex(dt.ccw(i))->info()],
                     &b = sites_[face->vertex(dt.cw(i))->info()];
        if (on_hull[apex] || height_over_length(a, b, sites_[apex]) >= hull_sliver) continue;
        face->info() = kNoTriangle;
        on_hull[apex] = 1;
        for (int j = 0; j < 3; ++j)
            if (const auto next = face->neighbor(j); next->info() != kNoTriangle)
                hull.emplace_back(next, next->index(face));
    }
    for (const auto face : dt.finite_face_handles()) {
        if (face->info() == kNoTriangle) continue;
        face->info() = static_cast<std::int32_t>(triangles_.size());
        triangles_.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    }
}

void HoleTriangulation::link_hull() {
    const Dt& dt = delaunay_->dt;
    constexpr std::uint32_t kNone = ~0u;
    std::vector<std::uint32_t> next(sites_.size(), kNone);
    std::uint32_t first = kNone;
    for (const auto face : dt.finite_face_handles()) {
        if (face->info() == kNoTriangle) continue;
        for (int i = 0; i < 3; ++i)
            if (face->neighbor(i)->info() == kNoTriangle) {
                const std::uint32_t from = face->vertex(dt.ccw(i))->info();
                next[from] = face->vertex(dt.cw(i))->info();
                first = std::min(first, from);
            }
    }
    for (std::uint32_t site = first;;) {
        hull_edges_.push_back({site, next[site]});
        site = next[site];
        if (site == first) break;
    }
}

void HoleTriangulation::link_rim() {
    const Dt& dt = delaunay_->dt;
    for (const auto face : dt.finite_face_handles())
        for (int i = 0; i < 3; ++i)
            if (dt.is_infinite(face->neighbor(i)))
                rim_.push_back({face->vertex(dt.ccw(i))->info(), face->vertex(dt.cw(i))->info()});
}

void HoleTriangulation::chain_collinear() {
    triangles_.clear();
    const Point2 a = sites_[farthest(sites_, sites_[0])];
    const Point2 b = sites_[farthest(sites_, a)];
    const double length = sites_.size() > 1 ? distance(a, b) : 1;
    axis_start_ = a;
    axis_ = {(b.x - a.x) / length, (b.y - a.y) / length};
    std::vector<std::uint32_t> order(sites_.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto along = [&](std::uint32_t i) { return along_axis(sites_[i]); };
    std::sort(order.begin(), order.end(),
              [&](auto i, auto j) { return std::pair(along(i), i) < std::pair(along(j), j); });
    for (std::size_t i = 0; i + 1 < order.size(); ++i) hull_edges_.push_back({order[i], order[i + 1]});
    for (std::size_t i = order.size(); i-- > 1;) hull_edges_.push_back({order[i], order[i - 1]});
}

std::vector<std::uint32_t> HoleTriangulation::walking_order(std::span<const Point2> where) const {
    std::vector<CgalPoint> points;
    points.reserve(where.size());
    for (const Point2& p : where) points.emplace_back(p.x, p.y);
    std::vector<std::uint32_t> order(where.size());
    std::iota(order.begin(), order.end(), 0u);
    using Map = CGAL::Pointer_property_map<CgalPoint>::const_type;
    using Traits = CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>;
    CGAL::Hilbert_sort_2<Traits, CGAL::Hilbert_sort_median_policy> sort(Traits(Map(points.data())));
    sort(order.begin(), order.end());
    return order;
}

double HoleTriangulation::along_axis(const Point2& p) const {
    return (p.x - axis_start_.x) * axis_.x + (p.y - axis_start_.y) * axis_.y;
}

Point2 HoleTriangulation::outward(std::size_t hull_edge) const {
    const Point2 &a = sites_[hull_edges_[hull_edge][0]], &b = sites_[hull_edges_[hull_edge][1]];
    if (is_flat()) {
        const double sign = along_axis(a) <= along_axis(b) ? 1 : -1;
        return {sign * axis_.y, -sign * axis_.x};
    }
    const double length = distance(a, b);
    return {(b.y - a.y) / length, (a.x - b.x) / length};
}

//! Between the two sites before and behind along the axis.
PlanLocation HoleTriangulation::closest_on_chain(const Point2& p) const {
    if (sites_.size() == 1) return at_site(0, false);
    const double s = along_axis(p);
    const auto forth = std::span(hull_edges_).first(hull_edges_.size() / 2);
    const auto behind =
        std::ranges::lower_bound(forth, s, {}, [&](const auto& e) { return along_axis(sites_[e[1]]); });
    const auto [i, j] = behind == forth.end() ? forth.back() : *behind;
    const double from = along_axis(sites_[i]), to = along_axis(sites_[j]);
    const double t = to > from ? std::clamp((s - from) / (to - from), 0.0, 1.0) : 1.0;
    return {{i, j, j}, {1 - t, t, 0}, false};
}

PlanLocation HoleTriangulation::closest_on(std::span<const std::array<std::uint32_t, 2>> edges,
                                           const Point2& p) const {
    PlanLocation best;
    double best_distance = std::numeric_limits<double>::infinity();
    for (const auto& [i, j] : edges) {
        const Point2 &a = sites_[i], &b = sites_[j];
        const double dx = b.x - a.x, dy = b.y - a.y;
        const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
        const double d = std::hypot(p.x - (a.x + t * dx), p.y - (a.y + t * dy));
        if (d >= best_distance) continue;
        best_distance = d;
        best = {{i, j, j}, {1 - t, t, 0}, false};
    }
    return best;
}

Point2 HoleTriangulation::place_of(const PlanLocation& location) const {
    Point2 p;
    for (int k = 0; k < 3; ++k) {
        p.x += location.weight[k] * sites_[location.site[k]].x;
        p.y += location.weight[k] * sites_[location.site[k]].y;
    }
    return p;
}

PlanLocation HoleTriangulation::locate(const Point2& p) const {
    if (is_flat()) return closest_on_chain(p);
    Dt::Locate_type type;
    int index;
    const auto face = delaunay_->dt.locate(CgalPoint(p.x, p.y), type, index, delaunay_->hint);
    delaunay_->hint = face;
    if (type == Dt::VERTEX) return at_site(face->vertex(index)->info(), true);
    if (type != Dt::OUTSIDE_CONVEX_HULL && face->info() != kNoTriangle)
        return barycentric(triangles_[static_cast<std::size_t>(face->info())], sites_, p);
    if (type == Dt::EDGE && face->neighbor(index)->info() != kNoTriangle)
        return barycentric(triangles_[static_cast<std::size_t>(face->neighbor(index)->info())], sites_, p);
    return closest_on(hull_edges_, p);
}

std::vector<PlanLocation> HoleTriangulation::locate(std::span<const Point2> where) const {
    std::vector<PlanLocation> result(where.size());
    for (const std::uint32_t i : walking_order(where)) result[i] = locate(where[i]);
    return result;
}

// On the convex hull, natural neighbour coordinates are those of the edge's ends, and their construction divides by nothing.
bool HoleTriangulation::on_rim(const Point2& p) const {
    Dt& dt = delaunay_->dt;
    Dt::Locate_type type;
    int index;
    const auto face = dt.locate(CgalPoint(p.x, p.y), type, index, delaunay_->hint);
    delaunay_->hint = face;
    if (type == Dt::VERTEX || type == Dt::OUTSIDE_CONVEX_HULL || dt.is_infinite(face)) return true;
    for (int i = 0; i < 3; ++i)
        if (dt.is_infinite(face->neighbor(i)) &&
            height_over_length(sites_[face->vertex(dt.ccw(i))->info()],
                               sites_[face->vertex(dt.cw(i))->info()], p) < kOnRim)
            return true;
    return false;
}

void HoleTriangulation::find_natural_place(const Point2& p, NaturalPlace& place) const {
    PlanLocation location = locate(p);
    place.at = p;
    place.beyond = {};
    if (is_flat()) {
        place.at = place_of(location);
    } else if (!location.inside) {
        const Point2 in_hull = delaunay_->dt.is_infinite(delaunay_->hint) ? place_of(closest_on(rim_, p)) : p;
        location = closest_on(hull_edges_, in_hull);
        place.at = place_of(location);
        place.beyond = {in_hull.x - place.at.x, in_hull.y - place.at.y};
    }
    const bool at_site = std::ranges::count(location.weight, 1.0) > 0;
    if (!is_flat() && !at_site && !on_rim(place.at) && find_coordinates(place)) return;
    place.weights.clear();
    for (int k = 0; k < 3; ++k)
        if (location.weight[k] > 0) place.weights.push_back({location.site[k], location.weight[k]});
}

//! False where rounding spoils them.
bool HoleTriangulation::find_coordinates(NaturalPlace& place) const {
    place.weights.clear();
    std::vector<std::pair<Dt::Vertex_handle, double>> coordinates;
    const auto found = CGAL::natural_neighbors_2(delaunay_->dt, CgalPoint(place.at.x, place.at.y),
                                                 std::back_inserter(coordinates), delaunay_->hint);
    if (!found.third || !(found.second > 0)) return false;
    double x = 0, y = 0, reach = 0;
    for (const auto& [vertex, area] : coordinates) {
        const double weight = area / found.second;
        if (!(weight >= 0)) return false;
        const Point2& site = sites_[vertex->info()];
        x += weight * (site.x - place.at.x);
        y += weight * (site.y - place.at.y);
        reach = std::max(reach, weight * distance(site, place.at));
        if (weight > 0) place.weights.push_back({vertex->info(), weight});
    }
    std::ranges::sort(place.weights, {}, &SiteWeight::site);
    return std::hypot(x, y) <= kCoordinateTolerance * reach;
}

std::vector<std::vector<std::uint32_t>> HoleTriangulation::neighbours() const {
    std::vector<std::vector<std::uint32_t>> result(sites_.size());
    const auto join = [&](std::uint32_t i, std::uint32_t j) {
        result[i].push_back(j);
        result[j].push_back(i);
    };
    for (const auto& [a, b, c] : triangles_) join(a, b), join(b, c), join(c, a);
    for (const auto& [a, b] : hull_edges_) join(a, b);
    for (auto& list : result) {
        std::ranges::sort(list);
        const auto tail = std::ranges::unique(list);
        list.erase(tail.begin(), tail.end());
    }
    return result;
}

}  // namespace stratareeb
