// SPDX-License-Identifier: GPL-3.0-or-later
// Closed solids for the tests of planar faces and of what is written from them.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <vector>

#include "mesh/tri_mesh.h"

namespace stratareeb::test {

using Height = std::function<double(double, double)>;
using Mask = std::function<bool(int, int)>;

inline Height level(double z) {
    return [z](double, double) { return z; };
}

struct GridSlab {
    int n = 4;        // cells a side
    double size = 1;  // length of a side
    double x0 = 0, y0 = 0;
    Height top = level(1), base = level(0);
    Mask has_cell = [](int, int) { return true; };  // cells that touch at a corner only are not allowed
    bool inward = false;
};

//! A slab over the cells of a square grid, two triangles a cell, vertical walls around.
inline void add_slab(TriMesh& mesh, const GridSlab& s) {
    std::map<std::pair<int, int>, std::array<TriMesh::VertexHandle, 2>> at;
    const auto corner = [&](int i, int j) {
        auto [found, is_new] = at.try_emplace({i, j});
        if (is_new) {
            const double x = s.x0 + s.size * i / s.n, y = s.y0 + s.size * j / s.n;
            found->second = {mesh.add_vertex({x, y, s.top(x, y)}), mesh.add_vertex({x, y, s.base(x, y)})};
        }
        return found->second;
    };
    const auto triangle = [&](auto a, auto b, auto c) {
        s.inward ? mesh.add_face(a, c, b) : mesh.add_face(a, b, c);
    };
    const auto present = [&](int i, int j) {
        return i >= 0 && j >= 0 && i < s.n && j < s.n && s.has_cell(i, j);
    };
    const auto wall = [&](auto a, auto b) {
        triangle(a[1], b[1], b[0]);
        triangle(a[1], b[0], a[0]);
    };
    for (int j = 0; j < s.n; ++j) {
        for (int i = 0; i < s.n; ++i) {
            if (!present(i, j)) continue;
            const auto a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
            triangle(a[0], b[0], c[0]);
            triangle(a[0], c[0], d[0]);
            triangle(a[1], c[1], b[1]);
            triangle(a[1], d[1], c[1]);
            if (!present(i, j - 1)) wall(a, b);
            if (!present(i + 1, j)) wall(b, c);
            if (!present(i, j + 1)) wall(c, d);
            if (!present(i - 1, j)) wall(d, a);
        }
    }
}

inline TriMesh slab(const GridSlab& s) {
    TriMesh mesh;
    add_slab(mesh, s);
    return mesh;
}

//! Two cones of a regular polygon, one up and one down, sharing a sharp rim. `rings` ≥ 1.
inline TriMesh cone_lens(int sides, int rings, double radius, double up, double down) {
    TriMesh mesh;
    const auto sheet = [&](double height, int ring) { return height * (rings - ring) / rings; };
    std::vector<TriMesh::VertexHandle> rim;
    const auto place = [&](int ring, int side, double height) {
        const double angle = 2 * std::numbers::pi * side / sides, r = radius * ring / rings;
        return mesh.add_vertex({r * std::cos(angle), r * std::sin(angle), sheet(height, ring)});
    };
    for (int k = 0; k < sides; ++k) rim.push_back(place(rings, k, 0));
    for (const double height : {up, -down}) {
        const bool is_top = height > 0;
        const auto triangle = [&](auto a, auto b, auto c) {
            is_top ? mesh.add_face(a, b, c) : mesh.add_face(a, c, b);
        };
        auto outer = rim;
        for (int ring = rings - 1; ring > 0; --ring) {
            std::vector<TriMesh::VertexHandle> inner;
            for (int k = 0; k < sides; ++k) inner.push_back(place(ring, k, height));
            for (int k = 0; k < sides; ++k) {
                const int next = (k + 1) % sides;
                triangle(inner[k], outer[k], outer[next]);
                triangle(inner[k], outer[next], inner[next]);
            }
            outer = inner;
        }
        const auto apex = mesh.add_vertex({0, 0, height});
        for (int k = 0; k < sides; ++k) triangle(apex, outer[k], outer[(k + 1) % sides]);
    }
    return mesh;
}

//! Volume of a closed outward mesh, about its first vertex.
inline double mesh_volume(const TriMesh& mesh) {
    const auto o = mesh.point(TriMesh::VertexHandle(0));
    double six = 0;
    for (const auto f : mesh.faces()) {
        auto v = mesh.cfv_iter(f);
        const auto a = mesh.point(*v++) - o, b = mesh.point(*v++) - o, c = mesh.point(*v) - o;
        six += dot(a, cross(b, c));
    }
    return six / 6;
}

}  // namespace stratareeb::test
