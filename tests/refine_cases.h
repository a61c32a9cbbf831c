// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "mesh/polygon_mesh.h"

//! Control meshes of polygons for subdivision.
namespace stratareeb::shapes {

inline void append_face(PolygonMesh& mesh, const std::vector<std::uint32_t>& corners) {
    mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
    mesh.sizes.push_back(static_cast<std::uint32_t>(corners.size()));
}

//! Corners at 1 and -1 on each axis.
inline PolygonMesh octahedron() {
    PolygonMesh mesh;
    mesh.points = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (std::uint32_t i = 0; i < 4; ++i) {
        append_face(mesh, {i, (i + 1) % 4, 4});
        append_face(mesh, {(i + 1) % 4, i, 5});
    }
    return mesh;
}

//! From -1 to 1, of six quads.
inline PolygonMesh quad_cube() {
    PolygonMesh mesh;
    for (const double z : {-1.0, 1.0})
        for (const auto& [x, y] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
            mesh.points.push_back({x, y, z});
    append_face(mesh, {3, 2, 1, 0});
    append_face(mesh, {4, 5, 6, 7});
    for (std::uint32_t i = 0; i < 4; ++i) append_face(mesh, {i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i});
    return mesh;
}

//! A torus of quads, all vertices of valence four.
inline PolygonMesh quad_torus(double R, double r, std::uint32_t around, std::uint32_t tube) {
    PolygonMesh mesh;
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t j = 0; j < tube; ++j) {
            const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / tube;
            mesh.points.push_back(
                {(R + r * std::cos(v)) * std::cos(u), (R + r * std::cos(v)) * std::sin(u), r * std::sin(v)});
        }
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return i % around * tube + j % tube; };
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t j = 0; j < tube; ++j)
            append_face(mesh, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    return mesh;
}

//! n × n unit squares in z = 0, from the origin; vertex (i, j) is number i + j (n + 1).
inline PolygonMesh quad_grid(std::uint32_t n) {
    PolygonMesh mesh;
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i <= n; ++i) mesh.points.push_back({double(i), double(j), 0});
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = i + j * (n + 1);
            append_face(mesh, {a, a + 1, a + n + 2, a + n + 1});
        }
    return mesh;
}

//! A prism over a polygon: its top and base are n-gons, its sides quads.
inline PolygonMesh polygon_prism(std::uint32_t n, double radius, double height) {
    PolygonMesh mesh;
    std::vector<std::uint32_t> base, top;
    for (std::uint32_t i = 0; i < 2 * n; ++i) {
        const double u = 2 * std::numbers::pi * (i % n) / n;
        mesh.points.push_back({radius * std::cos(u), radius * std::sin(u), i < n ? 0 : height});
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        base.push_back(n - 1 - i);
        top.push_back(n + i);
        append_face(mesh, {i, (i + 1) % n, n + (i + 1) % n, n + i});
    }
    append_face(mesh, base);
    append_face(mesh, top);
    return mesh;
}

//! The neighbours of each vertex along edges, and the corners of its faces beyond those.
struct Neighbours {
    std::set<std::uint32_t> edges, faces;
};
inline std::vector<Neighbours> neighbours(const PolygonMesh& mesh) {
    std::vector<Neighbours> all(mesh.points.size());
    for_each_face(mesh, [&](std::size_t, std::span<const std::uint32_t> c) {
        for (std::size_t i = 0; i < c.size(); ++i) {
            all[c[i]].edges.insert(c[(i + 1) % c.size()]);
            all[c[i]].edges.insert(c[(i + c.size() - 1) % c.size()]);
            for (std::size_t k = 2; k + 1 < c.size(); ++k) all[c[i]].faces.insert(c[(i + k) % c.size()]);
        }
    });
    return all;
}

}  // namespace stratareeb::shapes
