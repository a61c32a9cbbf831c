// SPDX-License-Identifier: GPL-3.0-or-later
// Layer models over a square of 100 by 100 with thicknesses given as functions, for the tests of smooth solids.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "mesh/layer_model.h"

namespace stratareeb::test {

using Field = std::function<double(double, double)>;

inline Field constant(double value) {
    return [value](double, double) { return value; };
}

struct GridModel {
    int cells = 24;
    Field ground = constant(0);
    std::vector<Field> thickness;
    //! Circles (x, y, radius) that the grid is bent to, so that layers can end on them.
    std::vector<std::array<double, 3>> rounds = {};
};

//! Vertices close to a circle are moved onto it along the ray from its centre.
inline TriMesh::Point bent(const GridModel& g, double x, double y) {
    const double step = 100.0 / g.cells;
    for (const auto& [cx, cy, radius] : g.rounds) {
        const double r = std::hypot(x - cx, y - cy);
        if (std::abs(r - radius) < 0.5 * step && r > 0)
            return {cx + (x - cx) * radius / r, cy + (y - cy) * radius / r, 0};
    }
    return {x, y, 0};
}

inline LayerModel grid_model(const GridModel& g) {
    LayerModel model;
    auto& mesh = model.plan.surface;
    const double step = 100.0 / g.cells;
    std::vector<TriMesh::VertexHandle> at;
    for (int j = 0; j <= g.cells; ++j)
        for (int i = 0; i <= g.cells; ++i) at.push_back(mesh.add_vertex(bent(g, i * step, j * step)));
    const auto corner = [&](int i, int j) {
        return at[static_cast<std::size_t>(j) * static_cast<std::size_t>(g.cells + 1) +
                  static_cast<std::size_t>(i)];
    };
    for (int j = 0; j < g.cells; ++j)
        for (int i = 0; i < g.cells; ++i) {
            mesh.add_face(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1));
            mesh.add_face(corner(i, j), corner(i + 1, j + 1), corner(i, j + 1));
        }
    const std::size_t layers = g.thickness.size();
    for (std::size_t k = 0; k < layers; ++k)
        model.units.push_back({std::to_string(k + 1), "layer " + std::to_string(k + 1), "#8090a0"});
    std::vector<std::vector<double>> t(layers, std::vector<double>(mesh.n_vertices()));
    for (const auto v : mesh.vertices())
        for (std::size_t k = 0; k < layers; ++k)
            t[k][static_cast<std::size_t>(v.idx())] = g.thickness[k](mesh.point(v)[0], mesh.point(v)[1]);
    // Present in triangles that have thickness at a corner; no thickness at vertices with another triangle.
    for (const auto f : mesh.faces()) {
        LayerSet set;
        for (const auto v : mesh.fv_range(f))
            for (std::size_t k = 0; k < layers; ++k)
                if (t[k][static_cast<std::size_t>(v.idx())] > 0) set[k] = true;
        model.regions.in_face.push_back(set);
    }
    for (const auto v : mesh.vertices()) {
        LayerSet zero;
        for (std::size_t k = 0; k < layers; ++k) zero[k] = !(t[k][static_cast<std::size_t>(v.idx())] > 0);
        model.regions.zero_at.push_back(zero);
    }
    model.horizons.assign(layers + 1, std::vector<double>(mesh.n_vertices()));
    for (const auto v : mesh.vertices()) {
        const auto i = static_cast<std::size_t>(v.idx());
        model.horizons[0][i] = g.ground(mesh.point(v)[0], mesh.point(v)[1]);
        for (std::size_t k = 0; k < layers; ++k) model.horizons[k + 1][i] = model.horizons[k][i] - t[k][i];
    }
    return model;
}

}  // namespace stratareeb::test
