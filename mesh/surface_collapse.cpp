// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface_collapse.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/triangle_contact.h"

namespace stratareeb {

namespace {

using Point = TriMesh::Point;
using Corners = std::array<Point, 3>;

std::size_t index(OpenMesh::BaseHandle handle) {
    return static_cast<std::size_t>(handle.idx());
}

Point cross(const Corners& t) {
    return (t[1] - t[0]) % (t[2] - t[0]);
}

//! The sine of the smallest angle: the height on the longest side over the middle one.
double smallest_sine(const Corners& t) {
    std::array sides{(t[1] - t[0]).sqrnorm(), (t[2] - t[1]).sqrnorm(), (t[0] - t[2]).sqrnorm()};
    std::ranges::sort(sides);
    const double product = std::sqrt(sides[1] * sides[2]);
    return product > 0 ? cross(t).norm() / product : 0;
}

bool has_area(const Corners& t) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    const auto exact = [](const Point& p) { return Kernel::Point_3(p[0], p[1], p[2]); };
    return !CGAL::collinear(exact(t[0]), exact(t[1]), exact(t[2]));
}

AxisBox box_of(const TriangleSoup& soup, const std::array<std::uint32_t, 3>& triangle) {
    AxisBox box;
    for (const auto v : triangle) {
        const Point3& p = soup.points[v];
        box.include({{p.x, p.y, p.z}, {p.x, p.y, p.z}});
    }
    return box;
}

double square_distance(const Point& p, const Corners& t) {
    using Kernel = CGAL::Simple_cartesian<double>;
    const auto plain = [](const Point& q) { return Kernel::Point_3(q[0], q[1], q[2]); };
    return CGAL::squared_distance(plain(p), Kernel::Triangle_3(plain(t[0]), plain(t[1]), plain(t[2])));
}

}  // namespace

SurfaceCollapse::SurfaceCollapse(const TriMesh& mesh, const TriangleSoup& soup, std::vector<char> kept,
                                 const Limits& limits)
    : limits_(limits),
      mesh_(mesh),
      soup_(soup),
      triangles_(mesh.n_faces()),
      kept_(std::move(kept)),
      quadric_(mesh.n_vertices()),
      first_in_face_(mesh.n_faces(), kNone),
      next_in_face_(mesh.n_vertices(), kNone) {
    add_quadrics();
    if (limits_.distance) original_.emplace(triangle_soup(mesh));
    if (limits_.crossings) return;
    std::vector<AxisBox> boxes;
    boxes.reserve(soup_.triangles.size());
    for (const auto& triangle : soup_.triangles) boxes.push_back(box_of(soup_, triangle));
    boxes_.emplace(std::move(boxes));
}

//! Squared distances to the planes around a vertex, weighted by area.
void SurfaceCollapse::add_quadrics() {
    for (auto& quadric : quadric_) quadric.clear();
    for (const Face f : mesh_.faces()) {
        Corners corners;
        int k = 0;
        for (const Vertex v : mesh_.fv_range(f)) corners[k++] = mesh_.point(v);
        Point normal = cross(corners);
        const double length = normal.norm();
        if (!(length > 0)) continue;
        normal /= length;
        Quadric quadric(normal[0], normal[1], normal[2], -(corners[0] | normal));
        quadric *= length / 2;
        for (const Vertex v : mesh_.fv_range(f)) quadric_[index(v)] += quadric;
    }
}

SurfaceCollapse::Fan SurfaceCollapse::fan_of(Halfedge into) const {
    const Vertex gone = mesh_.from_vertex_handle(into), kept = mesh_.to_vertex_handle(into);
    Fan fan;
    for (const Face f : mesh_.vf_range(gone)) {
        Corners before, after;
        std::array<std::uint32_t, 3> vertices;
        int k = 0;
        bool vanishes = false;
        for (const Vertex v : mesh_.fv_range(f)) {
            vanishes |= v == kept;
            before[k] = mesh_.point(v);
            vertices[k] = static_cast<std::uint32_t>((v == gone ? kept : v).idx());
            after[k++] = mesh_.point(v == gone ? kept : v);
        }
        if (vanishes) continue;
        fan.faces.push_back(f);
        fan.before.push_back(before);
        fan.after.push_back(after);
        fan.vertices.push_back(vertices);
    }
    return fan;
}

//! The link condition, and that a boundary goes along itself. A vertex with one triangle is a corner.
bool SurfaceCollapse::keeps_topology(Halfedge into) {
    const Vertex gone = mesh_.from_vertex_handle(into);
    if (kept_[index(gone)] || !mesh_.is_collapse_ok(into) || !keeps_boundary(into)) return false;
    const Halfedge back = mesh_.opposite_halfedge_handle(into);
    if (mesh_.is_boundary(into) || mesh_.is_boundary(back)) return mesh_.valence(gone) > 2;
    // A tetrahedron would become two triangles back to back.
    const Vertex left = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(into)),
                 right = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(back));
    const auto would_lose_all = [&](Vertex v) { return !mesh_.is_boundary(v) && mesh_.valence(v) <= 3; };
    return !would_lose_all(left) && !would_lose_all(right);
}

bool SurfaceCollapse::keeps_boundary(Halfedge into) const {
    const Vertex gone = mesh_.from_vertex_handle(into), kept = mesh_.to_vertex_handle(into);
    if (!mesh_.is_boundary(gone)) return true;
    if (!mesh_.is_boundary(mesh_.edge_handle(into))) return false;
    Vertex other;
    for (const Halfedge h : mesh_.voh_range(gone))
        if (mesh_.is_boundary(mesh_.edge_handle(h)) && mesh_.to_vertex_handle(h) != kept)
            other = mesh_.to_vertex_handle(h);
    const Point a = mesh_.point(other), along = mesh_.point(kept) - a, p = mesh_.point(gone);
    const double share = std::clamp(((p - a) | along) / along.sqrnorm(), 0.0, 1.0);
    return (a + along * share - p).norm() <= limits_.straight;
}

bool SurfaceCollapse::keeps_shape(Halfedge into) const {
    const Fan fan = fan_of(into);
    double sine_before = 1, sine_after = 1;
    for (std::size_t i = 0; i < fan.faces.size(); ++i) {
        const Point before = cross(fan.before[i]), after = cross(fan.after[i]);
        const double turn = before | after;
        if (turn < limits_.min_cosine * before.norm() * after.norm() || !has_area(fan.after[i])) return false;
        sine_before = std::min(sine_before, smallest_sine(fan.before[i]));
        sine_after = std::min(sine_after, smallest_sine(fan.after[i]));
    }
    return sine_after >= std::min(limits_.min_sine, sine_before);
}

std::vector<SurfaceCollapse::Choice> SurfaceCollapse::choices(Vertex v) {
    std::vector<Choice> found;
    if (kept_[index(v)]) return found;
    for (const Halfedge h : mesh_.voh_range(v)) {
        if (!keeps_topology(h) || !keeps_shape(h)) continue;
        const Vertex to = mesh_.to_vertex_handle(h);
        Quadric quadric = quadric_[index(v)];
        quadric += quadric_[index(to)];
        found.push_back({h, std::max(0.0, quadric(mesh_.point(to))), mesh_.calc_edge_length(h)});
    }
    std::ranges::sort(found, {}, [](const Choice& c) { return std::tuple(c.error, c.length, c.into.idx()); });
    return found;
}

bool SurfaceCollapse::is_near_new(const Corners& t) const {
    TriangleSoup soup;
    for (const Point& p : t) soup.points.push_back({p[0], p[1], p[2]});
    soup.triangles.push_back({0, 1, 2});
    return std::ranges::all_of(surface_samples(soup, limits_.sample_spacing),
                               [&](const Point3& p) { return original_->is_within(p, *limits_.distance); });
}

bool SurfaceCollapse::is_near_old(Vertex gone, const Fan& fan) const {
    const double limit = *limits_.distance * *limits_.distance;
    const auto is_near = [&](Vertex v) {
        return std::ranges::any_of(
            fan.after, [&](const Corners& t) { return square_distance(mesh_.point(v), t) <= limit; });
    };
    if (!is_near(gone)) return false;
    for (const Face f : mesh_.vf_range(gone))
        for (auto p = first_in_face_[index(f)]; p != kNone; p = next_in_face_[p])
            if (!is_near(Vertex(static_cast<int>(p)))) return false;
    return true;
}

bool SurfaceCollapse::is_near(Halfedge into) const {
    if (!limits_.distance) return true;
    const Fan fan = fan_of(into);
    return is_near_old(mesh_.from_vertex_handle(into), fan) &&
           std::ranges::all_of(fan.after, [&](const Corners& t) { return is_near_new(t); });
}

//! New triangles against all that are left around, and among each other.
bool SurfaceCollapse::comes_to_cross(Halfedge into) {
    if (!boxes_) return false;
    const Fan fan = fan_of(into);
    const auto first = static_cast<std::uint32_t>(soup_.triangles.size());
    soup_.triangles.insert(soup_.triangles.end(), fan.vertices.begin(), fan.vertices.end());
    const auto end = static_cast<std::uint32_t>(soup_.triangles.size());
    const TriangleContact contact(soup_);
    const auto gone = static_cast<std::uint32_t>(mesh_.from_vertex_handle(into).idx());
    bool crosses = false;
    for (auto t = first; t < end && !crosses; ++t) {
        crosses = contact.is_degenerate(t);
        for (auto u = first; u < t && !crosses; ++u) crosses = contact.meet(u, t);
        crosses = crosses || boxes_->any_of(box_of(soup_, soup_.triangles[t]), [&](std::uint32_t other) {
            return std::ranges::count(soup_.triangles[other], gone) == 0 && contact.meet(other, t);
        });
    }
    soup_.triangles.resize(first);
    return crosses;
}

//! To be called before the collapse.
void SurfaceCollapse::update_boxes(const Fan& fan) {
    for (std::size_t i = 0; i < fan.faces.size(); ++i) {
        soup_.triangles[index(fan.faces[i])] = fan.vertices[i];
        boxes_->set(static_cast<std::uint32_t>(fan.faces[i].idx()), box_of(soup_, fan.vertices[i]));
    }
}

bool SurfaceCollapse::is_sound(Halfedge into) {
    return is_near(into) && !comes_to_cross(into);
}

void SurfaceCollapse::collapse(Halfedge into) {
    const Vertex gone = mesh_.from_vertex_handle(into), kept = mesh_.to_vertex_handle(into);
    std::vector<std::uint32_t> moved{static_cast<std::uint32_t>(gone.idx())};
    for (const Face f : mesh_.vf_range(gone)) {
        for (auto p = first_in_face_[index(f)]; p != kNone; p = next_in_face_[p]) moved.push_back(p);
        first_in_face_[index(f)] = kNone;
    }
    const Fan fan = fan_of(into);
    if (boxes_) {
        for (const Face f : mesh_.vf_range(gone)) boxes_->set(static_cast<std::uint32_t>(f.idx()), {});
        update_boxes(fan);
    }
    if (limits_.distance) {
        for (const auto p : moved) {
            const Point& at = mesh_.point(Vertex(static_cast<int>(p)));
            const auto nearest = std::ranges::min_element(
                fan.after, {}, [&](const Corners& t) { return square_distance(at, t); });
            auto& first =
                first_in_face_[index(fan.faces[static_cast<std::size_t>(nearest - fan.after.begin())])];
            next_in_face_[p] = first;
            first = p;
        }
    }
    quadric_[index(kept)] += quadric_[index(gone)];
    triangles_ -= mesh_.is_boundary(mesh_.edge_handle(into)) ? 1 : 2;
    mesh_.collapse(into);
}

}  // namespace stratareeb
