// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/plan_collapse.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

namespace stratareeb {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = TriMesh::Point;

std::size_t index(OpenMesh::BaseHandle handle) {
    return static_cast<std::size_t>(handle.idx());
}

Kernel::Point_2 exact(const Point& p) {
    return {p[0], p[1]};
}

double square(double x) {
    return x * x;
}

double square_length(const Point& p, const Point& q) {
    return square(q[0] - p[0]) + square(q[1] - p[1]);
}

//! The sine of the smallest angle: the height on the longest side over the middle one.
double smallest_sine(const Point& a, const Point& b, const Point& c) {
    std::array sides{square_length(a, b), square_length(b, c), square_length(c, a)};
    std::ranges::sort(sides);
    const double twice_area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    return twice_area / std::sqrt(sides[1] * sides[2]);
}

double square_distance(const Point& p, const Point& a, const Point& b) {
    const double share = std::clamp(
        ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / square_length(a, b), 0.0, 1.0);
    return square_length(p, a + (b - a) * share);
}

std::vector<std::uint32_t> numbered(const std::vector<LayerSet>& sets) {
    std::unordered_map<LayerSet, std::uint32_t> known;
    std::vector<std::uint32_t> numbers;
    numbers.reserve(sets.size());
    for (const LayerSet& set : sets)
        numbers.push_back(known.emplace(set, static_cast<std::uint32_t>(known.size())).first->second);
    return numbers;
}

}  // namespace

PlanCollapse::PlanCollapse(const LayerModel& model, const Limits& limits)
    : model_(model),
      limits_(limits),
      before_(model),
      mesh_(model.plan.surface),
      triangles_(mesh_.n_faces()),
      fixed_(mesh_.n_vertices(), 0),
      label_(numbered(model.regions.in_face)),
      first_in_face_(mesh_.n_faces(), kNone),
      next_in_face_(mesh_.n_vertices(), kNone),
      first_on_line_(mesh_.n_edges(), kNone),
      next_on_line_(mesh_.n_vertices(), kNone) {
    for (const auto v : model.plan.hole_vertex)
        if (v != PlanMesh::kNoVertex) fixed_[v] = 1;
}

bool PlanCollapse::is_line(Halfedge h) const {
    const Halfedge o = mesh_.opposite_halfedge_handle(h);
    if (mesh_.is_boundary(h) || mesh_.is_boundary(o)) return true;
    return label(mesh_.face_handle(h)) != label(mesh_.face_handle(o));
}

std::vector<PlanCollapse::Halfedge> PlanCollapse::lines_at(Vertex v) const {
    std::vector<Halfedge> lines;
    for (const Halfedge h : mesh_.voh_range(v))
        if (is_line(h)) lines.push_back(h);
    return lines;
}

std::optional<PlanCollapse::Choice> PlanCollapse::best(Vertex v) {
    if (fixed_[index(v)]) return std::nullopt;
    const auto lines = lines_at(v);
    if (!lines.empty() && lines.size() != 2) return std::nullopt;
    std::vector<Halfedge> ways = lines;
    if (ways.empty())
        for (const Halfedge h : mesh_.voh_range(v)) ways.push_back(h);
    std::optional<Choice> found;
    for (const Halfedge h : ways) {
        const auto choice = examine(h, lines, found ? found->deviation : limits_.deviation);
        if (!choice) continue;
        const auto rank = [](const Choice& c) { return std::pair(c.deviation, -c.sine); };
        if (!found || rank(*choice) < rank(*found)) found = choice;
    }
    return found;
}

std::optional<PlanCollapse::Choice> PlanCollapse::try_into(Halfedge into) {
    return examine(into, lines_at(mesh_.from_vertex_handle(into)), limits_.deviation);
}

std::optional<PlanCollapse::Choice> PlanCollapse::examine(Halfedge into, const std::vector<Halfedge>& lines,
                                                          double deviation_limit) {
    if (!keeps_lines(into, lines) || !keeps_thickness(into) || !mesh_.is_collapse_ok(into))
        return std::nullopt;
    const auto sine = new_sine(into);
    if (!sine) return std::nullopt;
    const double deviation = new_deviation(into, deviation_limit);
    if (!(deviation <= deviation_limit)) return std::nullopt;
    const double length = std::sqrt(square_length(mesh_.point(mesh_.from_vertex_handle(into)),
                                                  mesh_.point(mesh_.to_vertex_handle(into))));
    return Choice{into, deviation, length, *sine};
}

//! A vertex of a line goes along it only, and only while all that the line has lost stays close to it. A triangle with two
//! sides on the line would vanish and its third side become the line: not that.
bool PlanCollapse::keeps_lines(Halfedge into, const std::vector<Halfedge>& lines) const {
    if (lines.empty()) return true;
    if (lines.size() != 2) return false;
    const Halfedge other = lines[0] == into ? lines[1] : lines[0];
    if (other == into || (lines[0] != into && lines[1] != into)) return false;
    const Vertex end = mesh_.to_vertex_handle(other), kept = mesh_.to_vertex_handle(into),
                 gone = mesh_.from_vertex_handle(into);
    for (const Halfedge side : {into, mesh_.opposite_halfedge_handle(into)})
        if (!mesh_.is_boundary(side) && mesh_.to_vertex_handle(mesh_.next_halfedge_handle(side)) == end)
            return false;
    const bool outline = mesh_.is_boundary(gone);
    if (outline &&
        !(mesh_.is_boundary(mesh_.edge_handle(into)) && mesh_.is_boundary(mesh_.edge_handle(other))))
        return false;
    const double tolerance = square(outline ? limits_.outline_tolerance : limits_.line_tolerance);
    const Point &a = mesh_.point(end), &b = mesh_.point(kept);
    if (square_distance(mesh_.point(gone), a, b) > tolerance) return false;
    for (const Halfedge part : lines)
        for (auto p = first_on_line_[index(mesh_.edge_handle(part))]; p != kNone; p = next_on_line_[p])
            if (square_distance(mesh_.point(Vertex(static_cast<int>(p))), a, b) > tolerance) return false;
    return true;
}

bool PlanCollapse::is_zero_triangle(Face f, const Corners& corners) const {
    LayerSet flat = model_.regions.in_face[index(f)];
    for (const Vertex v : corners) flat &= model_.regions.zero_at[index(v)];
    return flat.any();
}

//! Whether an edge of the vertex that goes leads to a neighbour that the one kept has no edge to yet, through the inside.
bool PlanCollapse::is_new_edge(Halfedge h, Vertex kept) const {
    const Vertex r = mesh_.to_vertex_handle(h);
    return r != kept && !mesh_.is_boundary(mesh_.edge_handle(h)) && !mesh_.find_halfedge(kept, r).is_valid();
}

//! What has no thickness keeps none; no layer that is there gets a triangle, or an edge inside, without thickness.
bool PlanCollapse::keeps_thickness(Halfedge into) const {
    const Vertex gone = mesh_.from_vertex_handle(into), kept = mesh_.to_vertex_handle(into);
    const auto& zero = model_.regions.zero_at;
    if ((zero[index(gone)] & ~zero[index(kept)]).any()) return false;
    if (zero[index(kept)].none()) return true;
    for (const Halfedge h : mesh_.voh_range(gone)) {
        const Vertex r = mesh_.to_vertex_handle(h);
        if (!is_new_edge(h, kept)) continue;
        const Face left = mesh_.face_handle(h), right = mesh_.opposite_face_handle(h);
        const auto& in_face = model_.regions.in_face;
        if ((in_face[index(left)] & in_face[index(right)] & zero[index(kept)] & zero[index(r)]).any())
            return false;
    }
    std::vector<Face> faces;
    const auto fan = fan_of(into, &faces);
    for (std::size_t i = 0; i < fan.size(); ++i)
        if (is_zero_triangle(faces[i], fan[i])) return false;
    return true;
}

PlanCollapse::Corners PlanCollapse::corners_of(Face f) const {
    auto corner = mesh_.cfv_ccwbegin(f);
    const Vertex a = *corner, b = *++corner, c = *++corner;
    return {a, b, c};
}

//! The triangles around the vertex as they become: with the one kept in its place.
std::vector<PlanCollapse::Corners> PlanCollapse::fan_of(Halfedge into, std::vector<Face>* faces) const {
    const Vertex gone = mesh_.from_vertex_handle(into), kept = mesh_.to_vertex_handle(into);
    std::vector<Corners> fan;
    for (const Face f : mesh_.vf_range(gone)) {
        Corners corners = corners_of(f);
        if (std::ranges::count(corners, kept) > 0) continue;
        std::ranges::replace(corners, gone, kept);
        fan.push_back(corners);
        if (faces) faces->push_back(f);
    }
    return fan;
}

bool PlanCollapse::is_unfolded(const Corners& t) const {
    return CGAL::orientation(exact(mesh_.point(t[0])), exact(mesh_.point(t[1])), exact(mesh_.point(t[2]))) ==
           CGAL::LEFT_TURN;
}

double PlanCollapse::sine_of(const Corners& t) const {
    return smallest_sine(mesh_.point(t[0]), mesh_.point(t[1]), mesh_.point(t[2]));
}

std::optional<double> PlanCollapse::new_sine(Halfedge into) const {
    double before = 1, after = 1;
    for (const Corners& t : fan_of(into)) {
        if (!is_unfolded(t)) return std::nullopt;
        after = std::min(after, sine_of(t));
    }
    if (after >= limits_.min_sine) return after;
    for (const Face f : mesh_.vf_range(mesh_.from_vertex_handle(into)))
        before = std::min(before, sine_of(corners_of(f)));
    return after >= before ? std::optional(after) : std::nullopt;
}

std::size_t PlanCollapse::place_in(const std::vector<Corners>& fan, Vertex p) const {
    std::size_t best = 0;
    double deepest = -1e300;
    for (std::size_t i = 0; i < fan.size(); ++i)
        if (const double depth = before_.inside(p, fan[i]); depth > deepest) deepest = depth, best = i;
    return best;
}

double PlanCollapse::new_deviation(Halfedge into, double limit) const {
    const Vertex gone = mesh_.from_vertex_handle(into), kept = mesh_.to_vertex_handle(into);
    const auto fan = fan_of(into);
    double largest = before_.at_vertex(gone, fan[place_in(fan, gone)]);
    for (const Face f : mesh_.vf_range(gone))
        for (auto p = first_in_face_[index(f)]; p != kNone && largest <= limit; p = next_in_face_[p]) {
            const Vertex removed(static_cast<int>(p));
            largest = std::max(largest, before_.at_vertex(removed, fan[place_in(fan, removed)]));
        }
    for (const Halfedge h : mesh_.voh_range(gone)) {
        if (largest > limit) break;
        if (is_new_edge(h, kept)) largest = std::max(largest, before_.along(kept, mesh_.to_vertex_handle(h)));
    }
    return largest;
}

void PlanCollapse::collapse(Halfedge into) {
    const Vertex gone = mesh_.from_vertex_handle(into);
    std::vector<std::uint32_t> moved{static_cast<std::uint32_t>(gone.idx())};
    for (const Face f : mesh_.vf_range(gone)) {
        for (auto p = first_in_face_[index(f)]; p != kNone; p = next_in_face_[p]) moved.push_back(p);
        first_in_face_[index(f)] = kNone;
    }
    std::vector<Face> faces;
    const auto fan = fan_of(into, &faces);
    const auto put = [](std::uint32_t p, std::uint32_t& first, std::vector<std::uint32_t>& next) {
        next[p] = first;
        first = p;
    };
    for (const auto p : moved)
        put(p, first_in_face_[index(faces[place_in(fan, Vertex(static_cast<int>(p)))])], next_in_face_);

    if (const auto lines = lines_at(gone); lines.size() == 2) {
        auto& from = first_on_line_[index(mesh_.edge_handle(into))];
        auto& to = first_on_line_[index(mesh_.edge_handle(lines[0] == into ? lines[1] : lines[0]))];
        for (auto p = from; p != kNone;) {
            const auto next = next_on_line_[p];
            put(p, to, next_on_line_);
            p = next;
        }
        put(static_cast<std::uint32_t>(gone.idx()), to, next_on_line_);
    }
    triangles_ -= mesh_.is_boundary(mesh_.edge_handle(into)) ? 1 : 2;
    mesh_.collapse(into);
}

double PlanCollapse::deviation() const {
    double largest = 0;
    for (const Face f : mesh_.faces())
        for (auto p = first_in_face_[index(f)]; p != kNone; p = next_in_face_[p])
            largest = std::max(largest, before_.at_vertex(Vertex(static_cast<int>(p)), corners_of(f)));
    for (const Edge e : mesh_.edges())
        if (!mesh_.is_boundary(e)) {
            const Halfedge h = mesh_.halfedge_handle(e, 0);
            largest =
                std::max(largest, before_.along(mesh_.from_vertex_handle(h), mesh_.to_vertex_handle(h)));
        }
    return largest;
}

}  // namespace stratareeb
