// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/crease_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "mesh/plan_mesh.h"
#include "subdivision/field_subdivision.h"

namespace stratareeb {
namespace {

//! An irregular triangulation of a square with a window, and random creases and corners on it.
struct Patch {
    TriMesh mesh;
    FieldCreases creases;
    std::vector<double> values;
    std::vector<char> is_dart;  // ends of one crease, where OpenSubdiv's limit mask is another one
};

Patch random_patch(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    std::vector<Point2> points;
    for (int i = 0; i < 12; ++i) points.push_back({0.05 + 0.9 * unit(), 0.05 + 0.9 * unit()});
    const Footprint square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                           {{0.4, 0.4}, {0.4, 0.6}, {0.6, 0.6}, {0.6, 0.4}}};
    Patch patch{build_plan_mesh(square, points, {}, {.spacing = 0.3}).surface, {}, {}, {}};
    std::vector<int> ends(patch.mesh.n_vertices(), 0);
    for (const auto e : patch.mesh.edges()) {
        const bool named = !patch.mesh.is_boundary(e) && unit() < 0.15;
        if (named) patch.creases.edges.push_back(static_cast<std::uint32_t>(e.idx()));
        if (!named && !patch.mesh.is_boundary(e)) continue;
        const auto h = patch.mesh.halfedge_handle(e, 0);
        ++ends[static_cast<std::size_t>(patch.mesh.from_vertex_handle(h).idx())];
        ++ends[static_cast<std::size_t>(patch.mesh.to_vertex_handle(h).idx())];
    }
    for (std::uint32_t v = 0; v < patch.mesh.n_vertices(); ++v) {
        if (unit() < 0.1) patch.creases.corners.push_back(v), ends[v] = 3;
        patch.values.push_back(unit());
        patch.is_dart.push_back(ends[v] == 1);
    }
    return patch;
}

FieldSubdivision peer(const Patch& patch, int levels) {
    const std::vector<FieldSubdivision::Triangle> triangles = LoopTopology(patch.mesh, 0).finest().triangles;
    std::vector<Crease> creases;
    for (const std::uint32_t e : patch.creases.edges) {
        const auto h = patch.mesh.halfedge_handle(TriMesh::EdgeHandle(static_cast<int>(e)), 0);
        creases.push_back({static_cast<std::uint32_t>(patch.mesh.from_vertex_handle(h).idx()),
                           static_cast<std::uint32_t>(patch.mesh.to_vertex_handle(h).idx())});
    }
    std::vector<SharpCorner> corners;
    for (const std::uint32_t v : patch.creases.corners) corners.push_back({v});
    return {triangles, patch.mesh.n_vertices(), creases, corners, levels};
}

TEST(CreaseField, has_the_refined_values_of_OpenSubdiv) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Patch patch = random_patch(seed);
        for (const int levels : {0, 1, 3}) {
            const LoopTopology topology(patch.mesh, levels);
            const FieldSubdivision osd = peer(patch, levels);
            ASSERT_EQ(topology.finest().vertices, osd.refined_vertices());
            const std::vector<double> ours = refined_values(topology, patch.creases, patch.values),
                                      theirs = osd.refined(patch.values);
            // Each numbers refined vertices in its own way, but within the same control triangle.
            const auto triangles = osd.refined_triangles();
            ASSERT_EQ(topology.finest().triangles.size(), triangles.size());
            const std::size_t children = triangles.size() / patch.mesh.n_faces();
            for (std::size_t first = 0; first < triangles.size(); first += children) {
                std::vector<double> a, b;
                for (std::size_t f = first; f < first + children; ++f)
                    for (std::size_t k = 0; k < 3; ++k) {
                        a.push_back(ours[topology.finest().triangles[f][k]]);
                        b.push_back(theirs[triangles[f][k]]);
                    }
                std::ranges::sort(a);
                std::ranges::sort(b);
                for (std::size_t k = 0; k < a.size(); ++k)
                    ASSERT_NEAR(a[k], b[k], 1e-12) << "seed " << seed << " level " << levels;
            }
        }
    }
}

TEST(CreaseField, has_the_limits_of_OpenSubdiv_at_control_vertices) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const Patch patch = random_patch(seed);
        const LoopTopology topology(patch.mesh, 2);
        const std::vector<double> ours = limit_values(topology, patch.creases, patch.values);
        const std::vector<double> theirs = peer(patch, 2).limit(patch.values);
        const SparseRows rows = limit_rows(topology.level(0), patch.creases);
        for (std::uint32_t v = 0; v < patch.values.size(); ++v) {
            if (patch.is_dart[v]) continue;
            EXPECT_NEAR(ours[v], theirs[v], 1e-12) << "seed " << seed << " vertex " << v;
            double limit = 0;
            for (auto k = rows.first[v]; k < rows.first[v + 1]; ++k)
                limit += rows.weight[k] * patch.values[rows.column[k]];
            EXPECT_NEAR(limit, theirs[v], 1e-12);
        }
    }
}

TEST(CreaseField, keeps_zero_along_creases_and_never_leaves_the_range) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Patch patch = random_patch(seed);
        const LoopTopology topology(patch.mesh, 3);
        for (const double z : limit_values(topology, patch.creases, patch.values)) {
            EXPECT_GE(z, 0);
            EXPECT_LE(z, 1);
        }
        std::vector<double> none(patch.values.size(), 0.0);
        for (const double z : limit_values(topology, patch.creases, none)) EXPECT_EQ(z, 0);
    }
}

}  // namespace
}  // namespace stratareeb
