// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "mesh/triangle_soup.h"

//! Shapes made in code, with the numbers that mathematics knows of them. Solids are wound outward.
namespace stratareeb::shapes {

using Index = std::uint32_t;

inline void quad(TriangleSoup& soup, Index a, Index b, Index c, Index d) {
    soup.triangles.push_back({a, b, c});
    soup.triangles.push_back({a, c, d});
}

//! Box from (0,0,0) to (x,y,z): 8 vertices, 12 triangles.
inline TriangleSoup slab(double x, double y, double z) {
    TriangleSoup soup;
    for (const double h : {0.0, z}) {
        soup.points.push_back({0, 0, h});
        soup.points.push_back({x, 0, h});
        soup.points.push_back({x, y, h});
        soup.points.push_back({0, y, h});
    }
    quad(soup, 3, 2, 1, 0);
    quad(soup, 4, 5, 6, 7);
    for (Index i = 0; i < 4; ++i) quad(soup, i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i);
    return soup;
}

inline TriangleSoup cube() {
    return slab(1, 1, 1);
}

//! Thickness z along x = 0, none along x = x: volume x y z / 2.
inline TriangleSoup wedge(double x, double y, double z) {
    TriangleSoup soup;
    soup.points = {{0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}, {0, 0, z}, {0, y, z}};
    quad(soup, 3, 2, 1, 0);
    quad(soup, 4, 1, 2, 5);
    quad(soup, 0, 4, 5, 3);
    soup.triangles.push_back({0, 1, 4});
    soup.triangles.push_back({2, 3, 5});
    return soup;
}

//! Corners at the origin and at 1 on each axis: volume 1/6, area 3/2 + sqrt(3)/2.
inline TriangleSoup tetrahedron() {
    TriangleSoup soup;
    soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    soup.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    return soup;
}

//! Latitudes and longitudes; points on the sphere around the origin.
inline TriangleSoup uv_sphere(double radius, Index rings, Index segments) {
    TriangleSoup soup;
    soup.points.push_back({0, 0, radius});
    for (Index i = 1; i < rings; ++i) {
        const double theta = std::numbers::pi * i / rings;
        for (Index j = 0; j < segments; ++j) {
            const double phi = 2 * std::numbers::pi * j / segments;
            soup.points.push_back({radius * std::sin(theta) * std::cos(phi),
                                   radius * std::sin(theta) * std::sin(phi), radius * std::cos(theta)});
        }
    }
    soup.points.push_back({0, 0, -radius});
    const auto at = [&](Index i, Index j) { return 1 + (i - 1) * segments + j % segments; };
    const Index south = static_cast<Index>(soup.points.size() - 1);
    for (Index j = 0; j < segments; ++j) soup.triangles.push_back({0, at(1, j), at(1, j + 1)});
    for (Index i = 1; i + 1 < rings; ++i)
        for (Index j = 0; j < segments; ++j)
            quad(soup, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    for (Index j = 0; j < segments; ++j)
        soup.triangles.push_back({south, at(rings - 1, j + 1), at(rings - 1, j)});
    return soup;
}

//! Ring of radius R around the z axis, tube of radius r: genus 1.
inline TriangleSoup torus(double R, double r, Index around, Index tube) {
    TriangleSoup soup;
    for (Index i = 0; i < around; ++i) {
        const double u = 2 * std::numbers::pi * i / around;
        for (Index j = 0; j < tube; ++j) {
            const double v = 2 * std::numbers::pi * j / tube;
            const double d = R + r * std::cos(v);
            soup.points.push_back({d * std::cos(u), d * std::sin(u), r * std::sin(v)});
        }
    }
    const auto at = [&](Index i, Index j) { return (i % around) * tube + j % tube; };
    for (Index i = 0; i < around; ++i)
        for (Index j = 0; j < tube; ++j) quad(soup, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    return soup;
}

//! A plate of unit cells, `columns` x `rows`, thickness 1, with the cells for which `hole` holds left out:
//! its genus is the number of holes if they are apart and inside.
inline TriangleSoup plate(Index columns, Index rows, const std::function<bool(Index, Index)>& hole) {
    TriangleSoup soup;
    const Index layer = (columns + 1) * (rows + 1);
    for (Index z = 0; z < 2; ++z)
        for (Index j = 0; j <= rows; ++j)
            for (Index i = 0; i <= columns; ++i) soup.points.push_back({double(i), double(j), double(z)});
    const auto at = [&](Index i, Index j, Index z) { return z * layer + j * (columns + 1) + i; };
    const auto solid = [&](std::int64_t i, std::int64_t j) {
        return i >= 0 && j >= 0 && i < columns && j < rows && !hole(Index(i), Index(j));
    };
    const auto wall = [&](Index a, Index b) { quad(soup, a, b, b + layer, a + layer); };
    for (Index j = 0; j < rows; ++j) {
        for (Index i = 0; i < columns; ++i) {
            if (!solid(i, j)) continue;
            quad(soup, at(i, j, 1), at(i + 1, j, 1), at(i + 1, j + 1, 1), at(i, j + 1, 1));
            quad(soup, at(i, j + 1, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0), at(i, j, 0));
            if (!solid(i, std::int64_t(j) - 1)) wall(at(i, j, 0), at(i + 1, j, 0));
            if (!solid(i + 1, j)) wall(at(i + 1, j, 0), at(i + 1, j + 1, 0));
            if (!solid(i, j + 1)) wall(at(i + 1, j + 1, 0), at(i, j + 1, 0));
            if (!solid(std::int64_t(i) - 1, j)) wall(at(i, j + 1, 0), at(i, j, 0));
        }
    }
    return soup;
}

//! Plate with n holes in a row, volume (2n+1) 3 - n: genus n.
inline TriangleSoup plate_with_holes(Index n) {
    return plate(2 * n + 1, 3, [](Index i, Index j) { return j == 1 && i % 2 == 1; });
}

inline TriangleSoup double_torus() {
    return plate_with_holes(2);
}

//! A regular polygon of `sides` corners on the circle of the radius, extruded from z = 0 to `height`.
inline TriangleSoup prism(Index sides, double radius, double height) {
    TriangleSoup soup;
    for (const double z : {0.0, height}) {
        for (Index i = 0; i < sides; ++i) {
            const double u = 2 * std::numbers::pi * i / sides;
            soup.points.push_back({radius * std::cos(u), radius * std::sin(u), z});
        }
    }
    for (Index i = 2; i < sides; ++i) soup.triangles.push_back({0, i, i - 1});
    for (Index i = 2; i < sides; ++i) soup.triangles.push_back({sides, sides + i - 1, sides + i});
    for (Index i = 0; i < sides; ++i) {
        const Index j = (i + 1) % sides;
        quad(soup, i, j, sides + j, sides + i);
    }
    return soup;
}

//! An open tube: a prism without its ends, two boundary loops.
inline TriangleSoup cylinder(Index sides, double radius, double height) {
    TriangleSoup soup = prism(sides, radius, height);
    soup.triangles.erase(soup.triangles.begin(), soup.triangles.begin() + 2 * (sides - 2));
    return soup;
}

//! A fan around the origin, facing up: one boundary loop.
inline TriangleSoup disc(Index sides, double radius) {
    TriangleSoup soup;
    soup.points.push_back({0, 0, 0});
    for (Index i = 0; i < sides; ++i) {
        const double u = 2 * std::numbers::pi * i / sides;
        soup.points.push_back({radius * std::cos(u), radius * std::sin(u), 0});
        soup.triangles.push_back({0, 1 + i, 1 + (i + 1) % sides});
    }
    return soup;
}

//! A flat ring, facing up: two boundary loops.
inline TriangleSoup annulus(Index sides, double inner, double outer) {
    TriangleSoup soup;
    for (const double radius : {inner, outer}) {
        for (Index i = 0; i < sides; ++i) {
            const double u = 2 * std::numbers::pi * i / sides;
            soup.points.push_back({radius * std::cos(u), radius * std::sin(u), 0});
        }
    }
    for (Index i = 0; i < sides; ++i) {
        const Index j = (i + 1) % sides;
        quad(soup, i, sides + i, sides + j, j);
    }
    return soup;
}

//! n x n unit cells under z = f(x, y), facing up: one boundary loop.
inline TriangleSoup terrain(Index n, const std::function<double(double, double)>& f) {
    TriangleSoup soup;
    for (Index j = 0; j <= n; ++j)
        for (Index i = 0; i <= n; ++i) soup.points.push_back({double(i), double(j), f(i, j)});
    const auto at = [&](Index i, Index j) { return j * (n + 1) + i; };
    for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < n; ++i) quad(soup, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    return soup;
}

inline TriangleSoup terrain(Index n) {
    return terrain(n, [](double x, double y) { return std::sin(0.7 * x) + std::cos(0.9 * y + 0.3 * x); });
}

//! The solid between a terrain and a parallel one `thickness` below: volume n² thickness.
inline TriangleSoup terrain_solid(Index n, double thickness, const std::function<double(double, double)>& f) {
    TriangleSoup soup = terrain(n, f);
    const Index layer = static_cast<Index>(soup.points.size());
    const auto top = soup.triangles;
    for (Index v = 0; v < layer; ++v) {
        auto p = soup.points[v];
        p.z -= thickness;
        soup.points.push_back(p);
    }
    for (const auto& t : top) soup.triangles.push_back({t[2] + layer, t[1] + layer, t[0] + layer});
    const auto at = [&](Index i, Index j) { return j * (n + 1) + i; };
    const auto wall = [&](Index a, Index b) { quad(soup, a, a + layer, b + layer, b); };
    for (Index i = 0; i < n; ++i) {
        wall(at(i, 0), at(i + 1, 0));
        wall(at(n, i), at(n, i + 1));
        wall(at(i + 1, n), at(i, n));
        wall(at(0, i + 1), at(0, i));
    }
    return soup;
}

//! A band with a half twist: one boundary loop, one side.
inline TriangleSoup mobius(Index segments) {
    TriangleSoup soup;
    for (Index i = 0; i < segments; ++i) {
        const double u = 2 * std::numbers::pi * i / segments;
        for (const double w : {-0.4, 0.4}) {
            const double d = 1 + w * std::cos(u / 2);
            soup.points.push_back({d * std::cos(u), d * std::sin(u), w * std::sin(u / 2)});
        }
    }
    for (Index i = 0; i + 1 < segments; ++i) quad(soup, 2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1);
    quad(soup, 2 * segments - 2, 1, 0, 2 * segments - 1);
    return soup;
}

inline TriangleSoup moved(TriangleSoup soup, double x, double y, double z) {
    for (auto& p : soup.points) p = {p.x + x, p.y + y, p.z + z};
    return soup;
}

inline TriangleSoup turned_over(TriangleSoup soup) {
    for (auto& t : soup.triangles) std::swap(t[1], t[2]);
    return soup;
}

inline TriangleSoup joined(TriangleSoup a, const TriangleSoup& b) {
    const auto offset = static_cast<Index>(a.points.size());
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    for (const auto& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    return a;
}

inline TriangleSoup two_components() {
    return joined(cube(), moved(tetrahedron(), 3, 0, 0));
}

struct Shape {
    std::string name;
    TriangleSoup soup;
};

//! A closed, sound solid of each kind, for invariants that hold for all.
inline std::vector<Shape> solids() {
    return {{"slab", slab(3, 2, 0.5)},
            {"wedge", wedge(3, 2, 1)},
            {"tetrahedron", tetrahedron()},
            {"cube", cube()},
            {"sphere", uv_sphere(2, 12, 20)},
            {"torus", torus(3, 1, 24, 12)},
            {"double torus", double_torus()},
            {"prism", prism(7, 2, 3)},
            {"terrain solid", terrain_solid(8, 2, [](double x, double y) { return 0.3 * std::sin(x + y); })},
            {"two components", two_components()},
            {"far away", moved(slab(3, 2, 0.5), 500000, 5000000, 100)}};
}

//! An open surface of each kind.
inline std::vector<Shape> open_surfaces() {
    return {{"cylinder", cylinder(9, 1, 2)},
            {"disc", disc(11, 2)},
            {"annulus", annulus(10, 1, 2)},
            {"terrain", terrain(9)}};
}

}  // namespace stratareeb::shapes
