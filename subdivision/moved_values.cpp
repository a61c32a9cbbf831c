// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/moved_values.h"

#include <algorithm>
#include <cstddef>

namespace stratareeb {

namespace {

using Corners = std::array<std::uint32_t, 3>;
using Weights = std::array<double, 3>;

Corners corners_of(const TriMesh& mesh, TriMesh::FaceHandle f) {
    Corners corners{};
    std::size_t k = 0;
    for (const auto v : mesh.fv_range(f)) corners[k++] = static_cast<std::uint32_t>(v.idx());
    return corners;
}

Weights weights_at(const TriMesh& mesh, const Corners& corners, const TriMesh::Point& p) {
    std::array<TriMesh::Point, 3> from;
    for (std::size_t k = 0; k < 3; ++k)
        from[k] = mesh.point(TriMesh::VertexHandle(static_cast<int>(corners[k]))) - p;
    Weights weights{};
    double all = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto &a = from[(k + 1) % 3], &b = from[(k + 2) % 3];
        weights[k] = a[0] * b[1] - a[1] * b[0];
        all += weights[k];
    }
    for (double& w : weights) w /= all;
    return weights;
}

}  // namespace

std::vector<double> MovedPlaces::values(const std::vector<double>& at_vertices) const {
    std::vector<double> result(corner.size());
    for (std::size_t v = 0; v < corner.size(); ++v) {
        // As an offset, so that constants stay what they are.
        const double base = at_vertices[v];
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k) sum += weight[v][k] * (at_vertices[corner[v][k]] - base);
        result[v] = base + sum;
    }
    return result;
}

MovedPlaces moved_places(const TriMesh& mesh, const std::vector<double>& x, const std::vector<double>& y) {
    MovedPlaces places;
    for (const auto v : mesh.vertices()) {
        const auto i = static_cast<std::size_t>(v.idx());
        Corners best{};
        Weights weight{};
        bool any = false;
        for (const auto f : mesh.vf_range(v)) {
            const Corners corners = corners_of(mesh, f);
            const Weights here = weights_at(mesh, corners, {x[i], y[i], 0});
            if (!any || std::ranges::min(here) > std::ranges::min(weight))
                best = corners, weight = here, any = true;
        }
        places.corner.push_back(best);
        places.weight.push_back(weight);
    }
    return places;
}

}  // namespace stratareeb
