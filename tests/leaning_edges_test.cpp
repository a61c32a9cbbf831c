// SPDX-License-Identifier: GPL-3.0-or-later
// Thickness around vertices where a pinch-out line has a kink.
#include "subdivision/leaning_edges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "subdivision/layer_creases.h"

namespace stratareeb {
namespace {

//! Rings of triangles around a vertex of a given valence; one layer, there in so many of the triangles around the middle and in all that
//! lie between the same two rays further out.
LayerModel fan(std::size_t valence, std::size_t triangles, std::mt19937_64& random) {
    constexpr std::size_t kRings = 4;
    const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    LayerModel model;
    TriMesh& mesh = model.plan.surface;
    const auto at = [&](std::size_t ring, std::size_t i) {
        const double r = static_cast<double>(ring), n = static_cast<double>(valence);
        const double sector = static_cast<double>(i / ring), along = static_cast<double>(i % ring) / r;
        const auto corner = [&](double k) {
            return TriMesh::Point(r * std::cos(2 * std::numbers::pi * k / n),
                                  r * std::sin(2 * std::numbers::pi * k / n), 0);
        };
        return corner(sector) * (1 - along) + corner(sector + 1) * along;
    };
    std::vector<std::vector<TriMesh::VertexHandle>> rings(kRings + 1);
    rings[0] = {mesh.add_vertex({0, 0, 0})};
    for (std::size_t r = 1; r <= kRings; ++r)
        for (std::size_t i = 0; i < r * valence; ++i) rings[r].push_back(mesh.add_vertex(at(r, i)));
    const auto vertex = [&](std::size_t ring, std::size_t sector, std::size_t step) {
        return ring == 0 ? rings[0][0] : rings[ring][(sector * ring + step) % rings[ring].size()];
    };
    std::vector<char> has;
    for (std::size_t r = 1; r <= kRings; ++r)
        for (std::size_t s = 0; s < valence; ++s)
            for (std::size_t k = 0; k < r; ++k) {
                mesh.add_face(vertex(r, s, k), vertex(r, s, k + 1), vertex(r - 1, s, k));
                has.push_back(s < triangles);
                if (k == 0) continue;
                mesh.add_face(vertex(r - 1, s, k - 1), vertex(r, s, k), vertex(r - 1, s, k));
                has.push_back(s < triangles);
            }
    model.units.push_back({"1", "layer", "#8090a0"});
    for (const char present : has) model.regions.in_face.push_back(LayerSet(present ? 1 : 0));
    model.horizons.assign(2, std::vector<double>(mesh.n_vertices(), 0.0));
    for (const auto v : mesh.vertices()) {
        bool zero = false;
        for (const auto f : mesh.vf_range(v)) zero |= !has[static_cast<std::size_t>(f.idx())];
        model.regions.zero_at.push_back(LayerSet(zero ? 1 : 0));
        if (!zero) model.horizons[1][static_cast<std::size_t>(v.idx())] = -(0.5 + uniform());
    }
    return model;
}

struct Fields {
    LoopTopology topology;
    std::vector<double> x, y, thickness;
};

Fields refined(const LayerModel& model, int levels, bool leaning = true) {
    LayerCreases creases = layer_creases(model, plan_creases(model));
    if (!leaning) creases.thickness[0].leaning.clear();
    Fields fields{LoopTopology(model.plan.surface, levels), {}, {}, {}};
    std::vector<double> x, y, thickness;
    for (const auto v : model.plan.surface.vertices()) {
        x.push_back(model.plan.surface.point(v)[0]);
        y.push_back(model.plan.surface.point(v)[1]);
        thickness.push_back(model.thickness(0, static_cast<std::size_t>(v.idx())));
    }
    fields.x = limit_values(fields.topology, creases.plan, x);
    fields.y = limit_values(fields.topology, creases.plan, y);
    fields.thickness = limit_values(fields.topology, creases.thickness[0], thickness);
    return fields;
}

OpenMesh::Vec2d slope(const Fields& f, const std::array<std::uint32_t, 3>& t) {
    const double ux = f.x[t[1]] - f.x[t[0]], uy = f.y[t[1]] - f.y[t[0]],
                 uz = f.thickness[t[1]] - f.thickness[t[0]];
    const double wx = f.x[t[2]] - f.x[t[0]], wy = f.y[t[2]] - f.y[t[0]],
                 wz = f.thickness[t[2]] - f.thickness[t[0]];
    const double twice = ux * wy - uy * wx;
    return {(uz * wy - wz * uy) / twice, (ux * wz - wx * uz) / twice};
}

//! Largest difference between the slopes of two of the layer's triangles at the middle, and largest slope.
std::pair<double, double> slopes_at_middle(const Fields& f) {
    std::vector<OpenMesh::Vec2d> slopes;
    for (const auto& t : f.topology.finest().triangles)
        if ((t[0] == 0 || t[1] == 0 || t[2] == 0) &&
            f.thickness[t[0]] + f.thickness[t[1]] + f.thickness[t[2]] > 0)
            slopes.push_back(slope(f, t));
    double jump = 0, most = 0;
    for (const auto& a : slopes)
        for (const auto& b : slopes) jump = std::max(jump, (a - b).norm()), most = std::max(most, a.norm());
    return {jump, most};
}

TEST(LeaningEdges, let_slopes_settle_whatever_the_shares_of_the_line_s_sides) {
    std::mt19937_64 random(1);
    for (std::size_t valence = 4; valence <= 10; ++valence)
        for (std::size_t triangles = 2; triangles < valence; ++triangles) {
            SCOPED_TRACE(std::to_string(triangles) + " of " + std::to_string(valence));
            const LayerModel model = fan(valence, triangles, random);
            const auto [early, early_slope] = slopes_at_middle(refined(model, 3));
            const auto [late, late_slope] = slopes_at_middle(refined(model, 6));
            EXPECT_LT(late, 0.55 * early + 1e-12) << "about 0.75 cubed";
            if (2 * triangles == valence) {
                EXPECT_NEAR(late_slope, early_slope, 0.3 * early_slope) << "the line is straight there";
            } else {
                EXPECT_LT(late_slope, 0.55 * early_slope) << "no slope but 0 fits a kink";
            }
        }
}

TEST(LeaningEdges, are_needed_where_the_layer_has_more_of_the_triangles) {
    std::mt19937_64 random(2);
    for (std::size_t valence = 4; valence <= 10; ++valence)
        for (std::size_t triangles = valence / 2 + 1; triangles < valence; ++triangles) {
            const LayerModel model = fan(valence, triangles, random);
            EXPECT_GT(slopes_at_middle(refined(model, 6, false)).first,
                      0.8 * slopes_at_middle(refined(model, 3, false)).first)
                << triangles << " of " << valence;
        }
}

TEST(LeaningEdges, are_none_where_both_sides_have_as_many_triangles) {
    std::mt19937_64 random(3);
    for (std::size_t half = 2; half <= 5; ++half) {
        const LayerModel model = fan(2 * half, half, random);
        for (const LeaningEdge& e : leaning_edges(model, 0, {})) EXPECT_NE(e.vertex, 0u);
    }
    const LayerModel model = fan(6, 4, random);
    std::size_t at_middle = 0;
    for (const LeaningEdge& e : leaning_edges(model, 0, {})) at_middle += e.vertex == 0;
    EXPECT_EQ(at_middle, 3u);
}

// A limit is where all further levels lead: what one level calls it, the next ones do too.
TEST(LeaningEdges, have_limits_that_do_not_depend_on_the_level) {
    std::mt19937_64 random(4);
    for (const auto& [valence, triangles] :
         {std::pair<std::size_t, std::size_t>{5, 3}, {6, 4}, {7, 5}, {8, 3}}) {
        const LayerModel model = fan(valence, triangles, random);
        const Fields fine = refined(model, 5);
        for (int levels = 0; levels < 5; ++levels) {
            const Fields coarse = refined(model, levels);
            for (std::size_t v = 0; v < coarse.thickness.size(); ++v)
                ASSERT_NEAR(coarse.thickness[v], fine.thickness[v], 1e-13) << levels << " " << v;
        }
    }
}

// What a layer leaves for others to take over where its crease is given up: never negative, and nothing beyond the triangles at the line.
TEST(LeaningEdges, thin_out_thickness_beside_the_line_only) {
    std::mt19937_64 random(5);
    for (const auto& [valence, triangles] :
         {std::pair<std::size_t, std::size_t>{5, 3}, {6, 4}, {7, 5}, {8, 3}}) {
        const LayerModel model = fan(valence, triangles, random);
        const Fields with = refined(model, 4), without = refined(model, 4, false);
        bool differs = false;
        for (std::size_t v = 0; v < with.thickness.size(); ++v) {
            EXPECT_LE(with.thickness[v], without.thickness[v] + 1e-15);
            EXPECT_GE(with.thickness[v], 0);
            differs |= with.thickness[v] < without.thickness[v] - 1e-6;
        }
        EXPECT_EQ(differs, !leaning_edges(model, 0, {}).empty());
        for (std::size_t v = 0; v < model.horizons[0].size(); ++v)
            EXPECT_EQ(with.thickness[v], without.thickness[v]) << "control vertices keep their limits";
    }
}

}  // namespace
}  // namespace stratareeb
