// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "mesh/triangle_soup.h"
#include "tests/shapes.h"

//! Meshes of any size on which contours and Reeb graphs are measured: smooth, noisy, of high genus, rough. Made by
//! arithmetic alone, so that the same arguments give the same mesh everywhere.
namespace stratareeb::bench {

using Index = std::uint32_t;

//! A number in [0, 1) that belongs to a place of a table (SplitMix64, G. Steele et al. 2014).
inline double random_at(std::uint64_t seed, std::uint64_t place) {
    std::uint64_t x = seed * 0xd1342543de82ef95u + (place + 1) * 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-53;
}

//! Each triangle as n x n triangles, flat; neighbours share the new vertices. Old vertices keep their numbers.
inline TriangleSoup refined(const TriangleSoup& coarse, Index n) {
    TriangleSoup fine{.points = coarse.points, .triangles = {}};
    std::map<std::pair<Index, Index>, Index> first_on_edge;  // from the lower vertex to the higher
    const auto blend = [&](Index a, Index b, Index c, Index i, Index j) {
        const Point3 &p = coarse.points[a], &q = coarse.points[b], &r = coarse.points[c];
        const double v = double(i) / n, w = double(j) / n, u = 1 - v - w;
        return Point3{u * p.x + v * q.x + w * r.x, u * p.y + v * q.y + w * r.y, u * p.z + v * q.z + w * r.z};
    };
    const auto on_edge = [&](Index a, Index b, Index step) {  // `step` of n on the way from a to b
        if (a > b) std::swap(a, b), step = n - step;
        const auto [found, is_new] =
            first_on_edge.try_emplace({a, b}, static_cast<Index>(fine.points.size()));
        for (Index i = 1; is_new && i < n; ++i) fine.points.push_back(blend(a, b, a, i, 0));
        return found->second + step - 1;
    };
    for (const auto& [a, b, c] : coarse.triangles) {
        std::vector<Index> at((n + 1) * (n + 1));  // i steps towards b and j towards c
        for (Index j = 0; j <= n; ++j)
            for (Index i = 0; i + j <= n; ++i) {
                Index& v = at[j * (n + 1) + i];
                if (i == n || j == n || i + j == 0)
                    v = i == n ? b : j == n ? c : a;
                else if (j == 0)
                    v = on_edge(a, b, i);
                else if (i == 0)
                    v = on_edge(a, c, j);
                else if (i + j == n)
                    v = on_edge(b, c, j);
                else
                    v = static_cast<Index>(fine.points.size()), fine.points.push_back(blend(a, b, c, i, j));
            }
        for (Index j = 0; j < n; ++j)
            for (Index i = 0; i + j < n; ++i) {
                const Index here = j * (n + 1) + i, over = here + n + 1;
                fine.triangles.push_back({at[here], at[here + 1], at[over]});
                if (i + j + 1 < n) fine.triangles.push_back({at[here + 1], at[over + 1], at[over]});
            }
    }
    return fine;
}

//! Corners on the sphere of radius 1, wound outward.
inline TriangleSoup icosahedron() {
    const double g = std::numbers::phi, s = 1 / std::sqrt(1 + g * g);
    TriangleSoup soup;
    for (const auto& [x, y] : {std::pair{1.0, g}, {-1.0, g}, {1.0, -g}, {-1.0, -g}}) {
        soup.points.push_back({0, s * x, s * y});
        soup.points.push_back({s * x, s * y, 0});
        soup.points.push_back({s * y, 0, s * x});
    }
    // The faces are the triples of corners at the distance of an edge, 2 s.
    const auto near = [&](Index a, Index b) {
        const Point3 &p = soup.points[a], &q = soup.points[b];
        return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z) < 2.1 * s;
    };
    for (Index a = 0; a < 12; ++a)
        for (Index b = a + 1; b < 12; ++b)
            for (Index c = b + 1; c < 12; ++c) {
                if (!near(a, b) || !near(b, c) || !near(c, a)) continue;
                const Point3 &p = soup.points[a], &q = soup.points[b], &r = soup.points[c];
                const double outward = p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) +
                                       p.z * (q.x * r.y - q.y * r.x);
                soup.triangles.push_back(outward > 0 ? std::array{a, b, c} : std::array{a, c, b});
            }
    return soup;
}

//! Share of the mean edge length that gives about 7,000 critical vertices at a million triangles.
constexpr double kScanNoise = 0.32;

//! A closed surface of genus 0 and 20 n^2 triangles, a lumpy head of size 2: n = 116 is as large as the scan igea and has
//! about as many critical vertices (84 to its 96), n = 232 with kScanNoise is as large and as noisy as that scan subdivided once.
//! `noise` moves each vertex by up to that share of the mean edge length, in or out.
inline TriangleSoup scan_like_blob(Index n, double noise = 0) {
    constexpr std::size_t kWaves = 40;
    constexpr double kSlope = 0.3;  // of each wave: steep enough together to make summits and hollows
    std::array<std::array<double, 5>, kWaves> waves{};  // direction times wave number, phase, amplitude
    for (std::size_t w = 0; w < kWaves; ++w) {
        const double z = 2 * random_at(1, w) - 1, turn = 2 * std::numbers::pi * random_at(2, w);
        const double number = 4 + 20 * double(w) / kWaves, across = number * std::sqrt(1 - z * z);
        waves[w] = {across * std::cos(turn), across * std::sin(turn), number * z,
                    2 * std::numbers::pi * random_at(3, w), kSlope / number};
    }
    TriangleSoup blob = refined(icosahedron(), n);
    const double edge = std::sqrt(4 * std::numbers::pi / (5 * std::sqrt(3.0))) / n;  // of a sphere so tiled
    for (std::size_t i = 0; i < blob.points.size(); ++i) {
        Point3& p = blob.points[i];
        const double length = std::hypot(p.x, p.y, p.z);
        double radius = 1 + noise * edge * (2 * random_at(4, i) - 1);
        for (const auto& [kx, ky, kz, phase, amplitude] : waves)
            radius += amplitude * std::sin((kx * p.x + ky * p.y + kz * p.z) / length + phase);
        p = {p.x * radius / length, p.y * radius / length, p.z * radius / length};
    }
    return blob;
}

//! A closed plate with k x k square holes: genus k^2. It has (20 k^2 + 32 k + 12) n^2 triangles, 596,992 for k = 10 and
//! n = 16, and is tilted so that equal heights are rare: 2 + 2 k^2 critical vertices.
inline TriangleSoup plate_with_holes_refined(Index k, Index n) {
    TriangleSoup plate = refined(
        shapes::plate(2 * k + 1, 2 * k + 1, [](Index i, Index j) { return i % 2 == 1 && j % 2 == 1; }), n);
    const double about_x = 0.31, about_y = 0.17;  // radians
    for (Point3& p : plate.points) {
        const double y = std::cos(about_x) * p.y - std::sin(about_x) * p.z;
        const double z = std::sin(about_x) * p.y + std::cos(about_x) * p.z;
        p = {std::cos(about_y) * p.x + std::sin(about_y) * z, y,
             std::cos(about_y) * z - std::sin(about_y) * p.x};
    }
    return plate;
}

//! An open grid of n x n vertices and 2 (n - 1)^2 triangles under rough heights, noise of all wavelengths from one cell up
//! (a sum of octaves): one vertex in seven or eight is critical, 267,000 for n = 1415.
inline TriangleSoup fractal_terrain(Index n) {
    constexpr double kRoughness = 0.85;  // heights grow with distance to this power
    std::vector<double> height(std::size_t(n) * n);
    for (Index octave = 0; octave == 0 || (1u << octave) < n; ++octave) {
        const Index period = 1u << octave;
        const double amplitude = std::pow(double(period), kRoughness);
        const auto lattice = [&](Index i, Index j) {
            return amplitude * random_at(10 + octave, (std::uint64_t(j) << 32) + i);
        };
        for (Index j = 0; j < n; ++j)
            for (Index i = 0; i < n; ++i) {
                double u = double(i % period) / period, v = double(j % period) / period;
                u *= u * (3 - 2 * u), v *= v * (3 - 2 * v);
                const Index a = i / period, b = j / period;
                height[std::size_t(j) * n + i] +=
                    (1 - v) * ((1 - u) * lattice(a, b) + u * lattice(a + 1, b)) +
                    v * ((1 - u) * lattice(a, b + 1) + u * lattice(a + 1, b + 1));
            }
    }
    return shapes::terrain(n - 1,
                           [&](double x, double y) { return height[std::size_t(y) * n + std::size_t(x)]; });
}

}  // namespace stratareeb::bench
