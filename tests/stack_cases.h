// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "mesh/triangle_soup.h"
#include "reeb/contour_stack.h"
#include "reeb/enhanced_reeb_graph.h"
#include "reeb/level_set.h"
#include "reeb/scalar_field.h"

//! Stacks of contours and bodies to cut them from.
namespace stratareeb::testing {

inline StackContour circle(double z, double x, double y, double radius, int corners = 40) {
    StackContour contour{.z = z, .points = {}, .name = {}};
    for (int i = 0; i < corners; ++i) {
        const double u = 2 * std::numbers::pi * i / corners;
        contour.points.push_back({x + radius * std::cos(u), y + radius * std::sin(u)});
    }
    return contour;
}

inline StackContour rectangle(double z, double x0, double y0, double x1, double y1) {
    return {.z = z, .points = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, .name = {}};
}

//! A ring of these radii with a gap of the half angle (radians) around the direction `at`.
inline StackContour c_shape(double z, double inner, double outer, double gap, double at = 0,
                            int corners = 60) {
    StackContour contour{.z = z, .points = {}, .name = {}};
    const double sweep = 2 * std::numbers::pi - 2 * gap;
    for (int i = 0; i <= corners; ++i) {
        const double u = at + gap + sweep * i / corners;
        contour.points.push_back({outer * std::cos(u), outer * std::sin(u)});
    }
    for (int i = corners; i >= 0; --i) {
        const double u = at + gap + sweep * i / corners;
        contour.points.push_back({inner * std::cos(u), inner * std::sin(u)});
    }
    return contour;
}

inline ContourStack sections(const TriMesh& mesh, const ScalarField& field,
                             const std::vector<double>& levels) {
    ContourStack stack;
    for (const LevelSet& set : level_sets(mesh, field, levels))
        for (const Contour& contour : set.contours) {
            stack.contours.push_back({.z = set.level, .points = {}, .name = {}});
            for (const Point3& p : contour.points) stack.contours.back().points.push_back({p.x, p.y});
        }
    return stack;
}

//! Where f > 0 in the box from 0 to (n, n, n), by marching tetrahedra over unit cells; closed if f < 0 on the box's sides.
inline TriangleSoup implicit_body(std::uint32_t n, const std::function<double(double, double, double)>& f) {
    TriangleSoup soup;
    std::vector<double> value;
    const auto at = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        return (k * (n + 1) + j) * (n + 1) + i;
    };
    std::vector<Point3> place;
    for (std::uint32_t k = 0; k <= n; ++k)
        for (std::uint32_t j = 0; j <= n; ++j)
            for (std::uint32_t i = 0; i <= n; ++i) {
                place.push_back({double(i), double(j), double(k)});
                value.push_back(f(i, j, k));
            }
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> on_edge;
    const auto cut = [&](std::uint32_t a, std::uint32_t b) {
        const auto [low, high] = std::minmax(a, b);
        const auto [found, is_new] =
            on_edge.insert({{low, high}, static_cast<std::uint32_t>(soup.points.size())});
        if (is_new) {
            const double t = value[low] / (value[low] - value[high]);
            const Point3 &p = place[low], &q = place[high];
            soup.points.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)});
        }
        return found->second;
    };
    const auto tetrahedron = [&](std::array<std::uint32_t, 4> corner) {
        std::vector<std::uint32_t> in, out;
        for (const auto c : corner) (value[c] > 0 ? in : out).push_back(c);
        if (in.empty() || out.empty()) return;
        std::vector<std::array<std::uint32_t, 3>> faces;
        if (in.size() == 1) faces = {{cut(in[0], out[0]), cut(in[0], out[1]), cut(in[0], out[2])}};
        if (in.size() == 3) faces = {{cut(in[0], out[0]), cut(in[1], out[0]), cut(in[2], out[0])}};
        if (in.size() == 2) {
            const auto p = cut(in[0], out[0]), q = cut(in[0], out[1]), r = cut(in[1], out[1]),
                       s = cut(in[1], out[0]);
            faces = {{p, q, r}, {p, r, s}};
        }
        const Point3 &from = place[in[0]], &to = place[out[0]];
        for (auto face : faces) {
            const Point3 &a = soup.points[face[0]], &b = soup.points[face[1]], &c = soup.points[face[2]];
            const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
            const Point3 normal{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
            // Outward is away from what is inside of the tetrahedron; in[0] is on the inner side of the face's plane.
            const double side = (from.x - a.x) * normal.x + (from.y - a.y) * normal.y +
                                (from.z - a.z) * normal.z -
                                ((to.x - a.x) * normal.x + (to.y - a.y) * normal.y + (to.z - a.z) * normal.z);
            if (side > 0) std::swap(face[1], face[2]);
            soup.triangles.push_back(face);
        }
    };
    for (std::uint32_t k = 0; k < n; ++k)
        for (std::uint32_t j = 0; j < n; ++j)
            for (std::uint32_t i = 0; i < n; ++i) {
                const std::uint32_t a = at(i, j, k), g = at(i + 1, j + 1, k + 1);
                const std::array<std::uint32_t, 6> round{at(i + 1, j, k), at(i + 1, j + 1, k),
                                                         at(i, j + 1, k), at(i, j + 1, k + 1),
                                                         at(i, j, k + 1), at(i + 1, j, k + 1)};
                for (std::size_t s = 0; s < 6; ++s) tetrahedron({a, round[s], round[(s + 1) % 6], g});
            }
    return soup;
}

//! Random blobs, some of them hollows, in the box from 0 to (n, n, n).
inline std::function<double(double, double, double)> random_blobs(double n, int count,
                                                                  std::mt19937_64& random) {
    struct Blob {
        double x, y, z, radius, weight;
    };
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Blob> blobs;
    for (int b = 0; b < count; ++b)
        blobs.push_back({n * (0.2 + 0.6 * unit(random)), n * (0.2 + 0.6 * unit(random)),
                         n * (0.2 + 0.6 * unit(random)), n * (0.06 + 0.12 * unit(random)),
                         unit(random) < 0.35 ? -1.3 : 1.0});
    return [blobs, n](double x, double y, double z) {
        const double edge = std::min({x, y, z, n - x, n - y, n - z});
        double sum = -0.3;
        for (const Blob& b : blobs)
            sum +=
                b.weight * std::exp(-((x - b.x) * (x - b.x) + (y - b.y) * (y - b.y) + (z - b.z) * (z - b.z)) /
                                    (2 * b.radius * b.radius));
        return std::min(sum, edge - 0.7);
    };
}

//! A random sponge in the box from 0 to (n, n, n): waves in random directions.
inline std::function<double(double, double, double)> random_waves(double n, std::mt19937_64& random) {
    struct Wave {
        double x, y, z, phase;
    };
    std::normal_distribution<double> normal(0, 0.55);
    std::uniform_real_distribution<double> angle(0, 6.28);
    std::vector<Wave> waves;
    for (int w = 0; w < 6; ++w)
        waves.push_back({normal(random), normal(random), normal(random), angle(random)});
    return [waves, n](double x, double y, double z) {
        double sum = -0.35;
        for (const Wave& w : waves) sum += std::sin(w.x * x + w.y * y + w.z * z + w.phase);
        return std::min(sum,
                        std::min({x, y, z, n - x, n - y, n - z}) - 0.7 - 0.01 * std::sin(x + 2 * y + 3 * z));
    };
}

//! Nodes by the numbers of edges below and above.
inline std::map<std::pair<int, int>, int> node_kinds(const EnhancedReebGraph& graph) {
    std::vector<std::pair<int, int>> degree(graph.nodes.size());
    for (const EnhancedEdge& edge : graph.edges) {
        ++degree[edge.from].second;
        ++degree[edge.to].first;
    }
    std::map<std::pair<int, int>, int> kinds;
    for (const auto& d : degree) ++kinds[d];
    return kinds;
}

}  // namespace stratareeb::testing
