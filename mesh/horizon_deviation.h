// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "mesh/layer_model.h"

namespace stratareeb {

//! How far other triangles over the same vertices are from a model's horizons: the vertical distance, the largest of all
//! horizons. What differs is linear between the model's vertices and the places where edges cross, so its maximum is found
//! by looking at these alone.
class HorizonDeviation {
 public:
    using Vertex = TriMesh::VertexHandle;

    //! \pre the model outlives this
    explicit HorizonDeviation(const LayerModel& model);

    //! At the place of vertex p, of the triangle over a, b, c; outside of it, of its plane.
    double at_vertex(Vertex p, const std::array<Vertex, 3>& triangle) const;

    //! Along the straight edge from a to b, where it crosses the model's edges and vertices. Infinite if the edge leaves
    //! the footprint.
    double along(Vertex a, Vertex b) const;

    //! The smallest of p's barycentric coordinates: negative outside of the triangle.
    double inside(Vertex p, const std::array<Vertex, 3>& triangle) const;

 private:
    class Walk;

    std::array<double, 3> weights(Vertex p, const std::array<Vertex, 3>& triangle) const;
    const double* elevations(Vertex v) const { return &z_[static_cast<std::size_t>(v.idx()) * horizons_]; }

    const TriMesh& plan_;
    std::size_t horizons_;
    std::vector<double> z_;  // vertex by vertex: what is compared together lies together
};

}  // namespace stratareeb
