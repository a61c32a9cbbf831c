// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/horizon_deviation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stratareeb {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = TriMesh::Point;
using Halfedge = TriMesh::HalfedgeHandle;

double cross(const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

Kernel::Point_2 exact(const Point& p) {
    return {p[0], p[1]};
}

}  // namespace

//! From a to b through the model's plan, by exact predicates: from vertex to edge to edge to vertex.
class HorizonDeviation::Walk {
 public:
    Walk(const HorizonDeviation& model, Vertex a, Vertex b)
        : model_(model),
          mesh_(model.plan_),
          a_(a),
          b_(b),
          from_(mesh_.point(a)),
          to_(mesh_.point(b)),
          exact_from_(exact(from_)),
          exact_to_(exact(to_)) {}

    double largest() {
        for (Vertex v = a_; v != b_;) {
            v = next_vertex(v);
            if (!v.is_valid()) return std::numeric_limits<double>::infinity();
            if (v != b_) compare(v, v, 0);
        }
        return largest_;
    }

 private:
    CGAL::Orientation side(Vertex v) const {
        return CGAL::orientation(exact_from_, exact_to_, exact(mesh_.point(v)));
    }

    bool is_ahead(Vertex v, Vertex u) const {
        const Point step = mesh_.point(u) - mesh_.point(v);
        return step[0] * (to_[0] - from_[0]) + step[1] * (to_[1] - from_[1]) > 0;
    }

    //! The vertex that the line meets next; none if it leaves the plan.
    Vertex next_vertex(Vertex v) {
        for (const Halfedge h : mesh_.voh_range(v)) {
            const Vertex u = mesh_.to_vertex_handle(h);
            const auto turn = side(u);
            if (turn == CGAL::COLLINEAR && is_ahead(v, u)) return u;
            if (turn != CGAL::RIGHT_TURN || mesh_.is_boundary(h)) continue;
            const Halfedge far = mesh_.next_halfedge_handle(h);
            if (side(mesh_.to_vertex_handle(far)) == CGAL::LEFT_TURN) return through_edges(far);
        }
        return Vertex();
    }

    //! `edge` leads from the right of the line to its left.
    Vertex through_edges(Halfedge edge) {
        while (true) {
            cross_edge(edge);
            const Halfedge back = mesh_.opposite_halfedge_handle(edge);
            if (mesh_.is_boundary(back)) return Vertex();
            const Halfedge right = mesh_.next_halfedge_handle(back);
            const Vertex apex = mesh_.to_vertex_handle(right);
            const auto turn = side(apex);
            if (turn == CGAL::COLLINEAR) return apex;
            edge = turn == CGAL::LEFT_TURN ? right : mesh_.next_halfedge_handle(right);
        }
    }

    void cross_edge(Halfedge edge) {
        const Vertex u = mesh_.from_vertex_handle(edge), w = mesh_.to_vertex_handle(edge);
        const double off_u = std::abs(cross(from_, to_, mesh_.point(u))),
                     off_w = std::abs(cross(from_, to_, mesh_.point(w)));
        compare(u, w, off_u + off_w > 0 ? off_u / (off_u + off_w) : 0.5);
    }

    //! The model at a share of the way from u to w, against the straight line from a to b.
    void compare(Vertex u, Vertex w, double share) {
        const Point place = mesh_.point(u) + (mesh_.point(w) - mesh_.point(u)) * share;
        const Point whole = to_ - from_, part = place - from_;
        const double along = std::clamp(
            (part[0] * whole[0] + part[1] * whole[1]) / (whole[0] * whole[0] + whole[1] * whole[1]), 0.0,
            1.0);
        const double *z_u = model_.elevations(u), *z_w = model_.elevations(w), *z_a = model_.elevations(a_),
                     *z_b = model_.elevations(b_);
        for (std::size_t k = 0; k < model_.horizons_; ++k) {
            const double before = z_u[k] + (z_w[k] - z_u[k]) * share;
            const double after = z_a[k] + (z_b[k] - z_a[k]) * along;
            largest_ = std::max(largest_, std::abs(before - after));
        }
    }

    const HorizonDeviation& model_;
    const TriMesh& mesh_;
    Vertex a_, b_;
    Point from_, to_;
    Kernel::Point_2 exact_from_, exact_to_;
    double largest_ = 0;
};

HorizonDeviation::HorizonDeviation(const LayerModel& model)
    : plan_(model.plan.surface),
      horizons_(model.horizons.size()),
      z_(model.horizons.size() * model.plan.surface.n_vertices()) {
    for (std::size_t k = 0; k < horizons_; ++k)
        for (std::size_t v = 0; v < plan_.n_vertices(); ++v) z_[v * horizons_ + k] = model.horizons[k][v];
}

std::array<double, 3> HorizonDeviation::weights(Vertex p, const std::array<Vertex, 3>& triangle) const {
    const Point &at = plan_.point(p), &a = plan_.point(triangle[0]), &b = plan_.point(triangle[1]),
                &c = plan_.point(triangle[2]);
    const double whole = cross(a, b, c);
    const double of_b = cross(a, at, c) / whole, of_c = cross(a, b, at) / whole;
    return {cross(at, b, c) / whole, of_b, of_c};
}

double HorizonDeviation::inside(Vertex p, const std::array<Vertex, 3>& triangle) const {
    const auto w = weights(p, triangle);
    return std::min({w[0], w[1], w[2]});
}

double HorizonDeviation::at_vertex(Vertex p, const std::array<Vertex, 3>& triangle) const {
    const auto w = weights(p, triangle);
    const double *z_p = elevations(p), *z_a = elevations(triangle[0]), *z_b = elevations(triangle[1]),
                 *z_c = elevations(triangle[2]);
    double largest = 0;
    for (std::size_t k = 0; k < horizons_; ++k)
        largest = std::max(largest,
                           std::abs(z_a[k] - z_p[k] + w[1] * (z_b[k] - z_a[k]) + w[2] * (z_c[k] - z_a[k])));
    return largest;
}

double HorizonDeviation::along(Vertex a, Vertex b) const {
    return Walk(*this, a, b).largest();
}

}  // namespace stratareeb
