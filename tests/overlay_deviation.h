// SPDX-License-Identifier: GPL-3.0-or-later
// How far two models over the same ground are apart, by brute force: the difference of two piecewise linear surfaces is
// largest at a vertex of either or where an edge of one crosses an edge of the other. Every pair of edges is looked at.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/layer_model.h"

namespace stratareeb::testing {

class PlanOracle {
 public:
    explicit PlanOracle(const LayerModel& model) : model_(model) {
        for (const auto f : model.plan.surface.faces()) {
            std::array<std::size_t, 3> t;
            int k = 0;
            for (const auto v : model.plan.surface.fv_range(f)) t[k++] = static_cast<std::size_t>(v.idx());
            triangles_.push_back(t);
        }
    }

    Point2 at(std::size_t v) const {
        const auto& p = model_.plan.surface.point(TriMesh::VertexHandle(static_cast<int>(v)));
        return {p[0], p[1]};
    }

    //! Elevations of all horizons in the triangle that a place is deepest inside.
    std::vector<double> elevations(const Point2& p) const {
        double deepest = -1e300;
        std::array<double, 3> best{};
        std::size_t where = 0;
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            const auto w = weights(triangles_[i], p);
            if (const double depth = std::min({w[0], w[1], w[2]}); depth > deepest)
                deepest = depth, best = w, where = i;
        }
        std::vector<double> z;
        for (const auto& horizon : model_.horizons) {
            double sum = 0;
            for (int k = 0; k < 3; ++k) sum += best[k] * horizon[triangles_[where][k]];
            z.push_back(sum);
        }
        return z;
    }

    std::size_t vertices() const { return model_.plan.surface.n_vertices(); }
    const LayerModel& model() const { return model_; }

 private:
    static double cross(const Point2& a, const Point2& b, const Point2& c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    }
    std::array<double, 3> weights(const std::array<std::size_t, 3>& t, const Point2& p) const {
        const Point2 a = at(t[0]), b = at(t[1]), c = at(t[2]);
        const double whole = cross(a, b, c);
        return {cross(p, b, c) / whole, cross(a, p, c) / whole, cross(a, b, p) / whole};
    }

    const LayerModel& model_;
    std::vector<std::array<std::size_t, 3>> triangles_;
};

inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0;
    for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
    return largest;
}

//! Both models' vertices, and the places where their edges cross.
inline std::vector<Point2> overlay_places(const LayerModel& a, const LayerModel& b) {
    std::vector<Point2> places;
    const PlanOracle of_a(a), of_b(b);
    for (std::size_t v = 0; v < of_a.vertices(); ++v) places.push_back(of_a.at(v));
    for (std::size_t v = 0; v < of_b.vertices(); ++v) places.push_back(of_b.at(v));
    const auto edges = [](const LayerModel& model) {
        std::vector<std::array<TriMesh::Point, 2>> list;
        const TriMesh& mesh = model.plan.surface;
        for (const auto e : mesh.edges()) {
            const auto h = mesh.halfedge_handle(e, 0);
            list.push_back({mesh.point(mesh.from_vertex_handle(h)), mesh.point(mesh.to_vertex_handle(h))});
        }
        return list;
    };
    const auto edges_b = edges(b);
    for (const auto& [p, q] : edges(a))
        for (const auto& [r, s] : edges_b) {
            const double det = (q[0] - p[0]) * (s[1] - r[1]) - (q[1] - p[1]) * (s[0] - r[0]);
            if (det == 0) continue;
            const double t = ((r[0] - p[0]) * (s[1] - r[1]) - (r[1] - p[1]) * (s[0] - r[0])) / det;
            const double u = ((r[0] - p[0]) * (q[1] - p[1]) - (r[1] - p[1]) * (q[0] - p[0])) / det;
            if (t > 0 && t < 1 && u > 0 && u < 1)
                places.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])});
        }
    return places;
}

//! Largest vertical distance between the same horizons of two models.
inline double overlay_deviation(const LayerModel& a, const LayerModel& b) {
    const PlanOracle of_a(a), of_b(b);
    double largest = 0;
    for (const Point2& p : overlay_places(a, b))
        largest = std::max(largest, largest_difference(of_a.elevations(p), of_b.elevations(p)));
    return largest;
}

}  // namespace stratareeb::testing
