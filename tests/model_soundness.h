// SPDX-License-Identifier: GPL-3.0-or-later
// What every layer model has to satisfy, checked independently of how it was built.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

#include "mesh/analysis.h"
#include "mesh/layer_model.h"

namespace stratareeb::testing {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<CgalKernel::Point_3>;

inline CgalMesh cgal_mesh(const TriMesh& mesh) {
    CgalMesh result;
    std::vector<CgalMesh::Vertex_index> vertex;
    for (const auto v : mesh.vertices()) {
        const auto& p = mesh.point(v);
        vertex.push_back(result.add_vertex(CgalKernel::Point_3(p[0], p[1], p[2])));
    }
    for (const auto f : mesh.faces()) {
        auto c = mesh.cfv_ccwbegin(f);
        const auto a = vertex[static_cast<std::size_t>((*c).idx())],
                   b = vertex[static_cast<std::size_t>((*++c).idx())],
                   d = vertex[static_cast<std::size_t>((*++c).idx())];
        EXPECT_NE(result.add_face(a, b, d), CgalMesh::null_face()) << "not manifold for CGAL";
    }
    return result;
}

//! Closed, 2-manifold, outward, without self-intersection: by our own analysis and by CGAL.
inline void expect_watertight(const TriMesh& solid, const std::string& what) {
    const MeshReport report = analyze(solid);
    EXPECT_TRUE(report.watertight) << what << ": "
                                   << (report.problems.empty() ? "" : report.problems.front());
    EXPECT_EQ(report.degenerate_triangles, 0u) << what;
    EXPECT_EQ(report.unused_vertices, 0u) << what;
    const CgalMesh other = cgal_mesh(solid);
    ASSERT_TRUE(CGAL::is_closed(other)) << what;
    EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(other)) << what;
    EXPECT_TRUE(CGAL::Polygon_mesh_processing::is_outward_oriented(other)) << what;
}

//! Neighbours conform: each interface triangle of one solid is, turned over, a triangle of exactly one other,
//! or of the ground or the lowest horizon. Walls stand on the footprint.
inline void expect_conforming(const LayerModel& model, const std::vector<LayerSolid>& solids) {
    using Key = std::array<std::array<double, 3>, 3>;
    std::map<Key, int> count;
    for (const auto& solid : solids)
        for (const auto f : solid.surface.faces()) {
            Key key;
            int k = 0;
            for (const auto v : solid.surface.fv_range(f)) {
                const auto& p = solid.surface.point(v);
                key[k++] = {p[0], p[1], p[2]};
            }
            std::sort(key.begin(), key.end());
            const bool is_wall = std::abs(solid.surface.calc_face_normal(f)[2]) == 0;
            if (!is_wall) ++count[key];
        }
    std::map<Key, int> outer;
    for (const std::size_t k : {std::size_t{0}, model.horizons.size() - 1})
        for (const auto f : model.plan.surface.faces()) {
            Key key;
            int i = 0;
            bool any = false;
            for (const auto v : model.plan.surface.fv_range(f)) {
                const auto& p = model.plan.surface.point(v);
                const auto n = static_cast<std::size_t>(v.idx());
                any |= model.horizons.front()[n] > model.horizons.back()[n];
                key[i++] = {p[0], p[1], model.horizons[k][n]};
            }
            std::sort(key.begin(), key.end());
            if (any) ++outer[key];
        }
    for (const auto& [key, n] : count) {
        const auto it = outer.find(key);
        EXPECT_EQ(n + (it == outer.end() ? 0 : it->second), 2);
    }
}

inline std::vector<LayerSolid> all_solids(const LayerModel& model) {
    std::vector<LayerSolid> solids;
    for (std::size_t i = 0; i < model.units.size(); ++i) solids.push_back(build_layer_solid(model, i));
    return solids;
}

//! All of the above, volumes that add up, horizons in order, and what the holes say.
inline void expect_sound(const LayerModel& model, const Survey& survey) {
    const auto solids = all_solids(model);
    ASSERT_GT(model.plan.surface.n_faces(), 0u);
    double sum = 0;
    for (const auto& solid : solids) {
        if (solid.surface.n_faces() == 0) continue;
        expect_watertight(solid.surface, "layer " + solid.unit.code);
        sum += volume(solid.surface);
    }
    EXPECT_NEAR(sum, envelope_volume(model), 1e-9 * envelope_volume(model));
    expect_conforming(model, solids);
    for (std::size_t i = 0; i < model.units.size(); ++i)
        for (std::size_t v = 0; v < model.horizons[0].size(); ++v) ASSERT_GE(model.thickness(i, v), 0);
    if (survey.contact_points) return;
    for (std::size_t h = 0; h < survey.holes.size(); ++h) {
        const auto v = model.plan.hole_vertex[h];
        if (v == PlanMesh::kNoVertex) continue;
        for (std::size_t i = 0; i < model.units.size(); ++i) {
            const LayerFact& fact = survey.holes[h].layers[i];
            const double t = model.thickness(i, v);
            const double tolerance = 1e-9 * std::max(1.0, std::abs(model.horizons[i][v]));
            if (fact.knowledge == Knowledge::Measured) {
                EXPECT_NEAR(t, fact.thickness, std::max(tolerance, 2e-9 * 300)) << "hole " << h;
                EXPECT_EQ(t == 0, fact.is_absent()) << "hole " << h;
            }
            if (fact.knowledge == Knowledge::AtLeast) {
                EXPECT_GE(t, fact.thickness - tolerance) << "hole " << h;
            }
        }
    }
}

}  // namespace stratareeb::testing
