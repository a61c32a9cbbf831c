// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/layer_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "boreholes/errors.h"
#include "tests/plan_cases.h"

namespace stratareeb {
namespace {

using testing::PlanCase;

struct Built {
    ThicknessField field;
    PlanMesh plan;
    LayerRegions regions;
};

Built build(const PlanCase& c) {
    ThicknessField field = thickness_field(c);
    PlanMesh plan = testing::plan_mesh(field, c.spacing);
    LayerRegions regions = build_layer_regions(plan, field);
    return {std::move(field), std::move(plan), std::move(regions)};
}

std::array<std::size_t, 3> corners(const TriMesh& mesh, OpenMesh::FaceHandle f) {
    std::array<std::size_t, 3> result{};
    auto corner = mesh.cfv_ccwbegin(f);
    for (auto& v : result) v = static_cast<std::size_t>((*corner++).idx());
    return result;
}

double region_area(const Built& built, std::size_t layer) {
    double sum = 0;
    for (const auto f : built.plan.surface.faces())
        if (built.regions.in_face[static_cast<std::size_t>(f.idx())][layer])
            sum += built.plan.surface.calc_face_area(f);
    return sum;
}

//! The body over a region as a bare list of triangles: top 2v, base 2v + 1, the same 2v where it has no
//! thickness. It knows nothing of half-edges.
using Triangles = std::vector<std::array<std::size_t, 3>>;

Triangles body(const Built& built, std::size_t layer) {
    const auto& mesh = built.plan.surface;
    const auto in = [&](OpenMesh::FaceHandle f) {
        return built.regions.in_face[static_cast<std::size_t>(f.idx())][layer];
    };
    const auto base = [&](std::size_t v) { return 2 * v + (built.regions.zero_at[v][layer] ? 0 : 1); };
    Triangles triangles;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    };
    for (const auto f : mesh.faces()) {
        if (!in(f)) continue;
        const auto [a, b, c] = corners(mesh, f);
        triangles.push_back({2 * a, 2 * b, 2 * c});
        triangles.push_back({base(a), base(c), base(b)});
    }
    for (const auto h : mesh.halfedges()) {
        if (mesh.is_boundary(h) || !mesh.is_boundary(mesh.opposite_halfedge_handle(h)) ||
            !in(mesh.face_handle(h)))
            continue;
        const auto a = static_cast<std::size_t>(mesh.from_vertex_handle(h).idx());
        const auto b = static_cast<std::size_t>(mesh.to_vertex_handle(h).idx());
        add(2 * a, base(a), base(b));
        add(2 * a, base(b), 2 * b);
    }
    return triangles;
}

//! Every edge has two triangles, one each way, and the triangles around every vertex form one ring.
void expect_closed_manifold(const Triangles& triangles) {
    std::map<std::pair<std::size_t, std::size_t>, int> edges;
    std::map<std::size_t, std::map<std::size_t, std::size_t>> link;  // vertex -> from -> to
    for (const auto& [a, b, c] : triangles) {
        ASSERT_TRUE(a != b && b != c && c != a) << "a triangle without area";
        for (const auto& [u, v, w] : {std::array{a, b, c}, {b, c, a}, {c, a, b}}) {
            ASSERT_EQ(++edges[std::pair(u, v)], 1) << "an edge run along twice the same way";
            link[u][v] = w;
        }
    }
    for (const auto& [edge, count] : edges)
        ASSERT_TRUE(edges.contains({edge.second, edge.first})) << "an edge with one triangle only";
    for (const auto& [vertex, next] : link) {
        std::size_t steps = 0;
        const std::size_t start = next.begin()->first;
        for (std::size_t at = start; steps == 0 || at != start; ++steps) {
            ASSERT_LT(steps, next.size());
            at = next.at(at);
        }
        ASSERT_EQ(steps, next.size()) << "several rings around vertex " << vertex;
    }
}

long long euler(const Triangles& triangles) {
    std::set<std::size_t> vertices;
    std::set<std::pair<std::size_t, std::size_t>> edges;
    for (const auto& t : triangles)
        for (int k = 0; k < 3; ++k) {
            vertices.insert(t[k]);
            edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
        }
    return static_cast<long long>(vertices.size()) - static_cast<long long>(edges.size()) +
           static_cast<long long>(triangles.size());
}

void expect_sound(const Built& built) {
    for (std::size_t layer = 0; layer < built.field.layers(); ++layer) {
        SCOPED_TRACE("layer " + std::to_string(layer));
        expect_closed_manifold(body(built, layer));
    }
    for (const auto f : built.plan.surface.faces()) {
        const auto [a, b, c] = corners(built.plan.surface, f);
        const auto& zero = built.regions.zero_at;
        ASSERT_TRUE(
            (built.regions.in_face[static_cast<std::size_t>(f.idx())] & zero[a] & zero[b] & zero[c]).none())
            << "a layer without thickness all over a triangle that has it";
    }
}

PlanCase grid_of_nine(const std::string& present, double fraction, double spacing = 0) {
    PlanCase c;
    for (const double y : {0.0, 10.0, 20.0})
        for (const double x : {0.0, 10.0, 20.0}) c.sites.push_back({x, y});
    c.present = {present};
    c.fraction = fraction;
    c.spacing = spacing;
    return c;
}

TEST(LayerRegions, of_a_layer_everywhere_are_all_triangles) {
    const Built built = build(grid_of_nine("111111111", 0.5, 4));
    EXPECT_NEAR(region_area(built, 0), 400, 1e-9);
    for (const auto& zero : built.regions.zero_at) EXPECT_TRUE(zero.none());
    EXPECT_EQ(built.regions.opened, 0u);
    EXPECT_EQ(euler(body(built, 0)), 2);
}

TEST(LayerRegions, of_a_layer_nowhere_are_empty) {
    const Built built = build(grid_of_nine("000000000", 0.5));
    EXPECT_EQ(region_area(built, 0), 0);
    for (const auto& zero : built.regions.zero_at) EXPECT_TRUE(zero[0]);
}

TEST(LayerRegions, of_an_island_are_a_ring) {
    for (const double spacing : {0.0, 2.0}) {
        const Built built = build(grid_of_nine("111101111", 0.5, spacing));
        expect_sound(built);
        EXPECT_EQ(euler(body(built, 0)), 0) << "a solid ring has genus 1";
        const auto centre = built.plan.hole_vertex[4];
        EXPECT_TRUE(built.regions.zero_at[centre][0]);
        EXPECT_EQ(built.regions.opened, 0u);
        // The triangles around the centre, scaled by a half.
        double around = 0;
        for (const auto& t : built.field.holes().triangles())
            if (std::ranges::count(t, 4u)) {
                const auto& s = built.field.holes().sites();
                around += std::abs((s[t[1]].x - s[t[0]].x) * (s[t[2]].y - s[t[0]].y) -
                                   (s[t[1]].y - s[t[0]].y) * (s[t[2]].x - s[t[0]].x)) /
                          2;
            }
        EXPECT_NEAR(region_area(built, 0), 400 - around / 4, 1e-9);
    }
}

TEST(LayerRegions, of_a_lens_are_half_the_triangles_around_it_in_length) {
    for (const double fraction : {0.0, 0.25, 1.0 / 3, 0.5}) {
        PlanCase c{{{0, 0}, {20, 0}, {20, 20}, {0, 20}, {10, 10}}, {"00001"}, fraction, 0};
        const Built built = build(c);
        expect_sound(built);
        const double scale = 1 - fraction;
        EXPECT_NEAR(region_area(built, 0), 400 * scale * scale, 1e-9);
        EXPECT_EQ(euler(body(built, 0)), 2);
    }
}

// With the layer reaching up to the holes without it, two parts meet in the middle hole.
TEST(LayerRegions, are_opened_where_two_parts_touch_at_a_hole) {
    const PlanCase c{{{0, 10}, {20, 10}, {10, 0}, {10, 20}, {10, 10}}, {"11000"}, 0, 0};
    const Built built = build(c);
    expect_sound(built);
    EXPECT_GT(built.regions.opened, 0u);
    const auto centre = OpenMesh::VertexHandle(static_cast<int>(built.plan.hole_vertex[4]));
    for (const auto f : built.plan.surface.vf_range(centre))
        EXPECT_FALSE(built.regions.in_face[static_cast<std::size_t>(f.idx())][0]);
    EXPECT_EQ(euler(body(built, 0)), 4) << "two bodies";
    EXPECT_LT(region_area(built, 0), 200);
    EXPECT_GT(region_area(built, 0), 100);
}

TEST(LayerRegions, an_island_with_the_layer_up_to_the_hole_is_opened_around_it) {
    const Built built = build(grid_of_nine("111101111", 0));
    expect_sound(built);
    EXPECT_EQ(built.regions.opened, 1u);
    EXPECT_EQ(euler(body(built, 0)), 0);
}

TEST(LayerRegions, opening_is_the_share_of_the_way_that_is_left_out) {
    PlanCase c = grid_of_nine("111101111", 0);
    const ThicknessField field = thickness_field(c);
    double last = 401;
    for (const double opening : {0.05, 0.1, 0.2, 0.4}) {
        PlanMesh plan = testing::plan_mesh(field, 0);
        const LayerRegions regions = build_layer_regions(plan, field, {.opening = opening});
        const Built built{thickness_field(c), std::move(plan), regions};
        const double area = region_area(built, 0);
        EXPECT_LT(area, last);
        EXPECT_GT(area, 400 - 400 * opening * opening - 1e-9);
        last = area;
    }
}

// A hexagon around one hole with the layer, triangulated without that hole: all corners are on the
// pinch-out line, and all inner edges join two of its places.
TEST(LayerRegions, edges_from_line_to_line_are_cut_in_the_middle) {
    PlanCase c{{{0, 0}}, {"1"}, 0.5, 0};
    for (const Point2 p : {Point2{20, 0}, {10, 20}, {-10, 20}, {-20, 0}, {-10, -20}, {10, -20}}) {
        c.sites.push_back(p);
        c.present[0] += '0';
    }
    const ThicknessField field = thickness_field(c);
    PlanMesh plan;
    std::vector<OpenMesh::VertexHandle> ring;
    for (std::size_t i = 1; i < c.sites.size(); ++i)
        ring.push_back(plan.surface.add_vertex({c.sites[i].x / 2, c.sites[i].y / 2, 0}));
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) plan.surface.add_face(ring[0], ring[i], ring[i + 1]);
    constexpr double kArea = 300;  // two trapezoids of (20 + 10) / 2 * 10
    const LayerRegions regions = build_layer_regions(plan, field);
    const Built built{thickness_field(c), std::move(plan), regions};
    EXPECT_GT(built.plan.surface.n_vertices(), 6u + 2u) << "three chords cut at least";
    EXPECT_NEAR(region_area(built, 0), kArea, 1e-9);
    expect_sound(built);
    EXPECT_EQ(euler(body(built, 0)), 2);
}

TEST(LayerRegions, agree_with_the_thickness_field_where_nothing_was_opened) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        PlanCase c = testing::random_plan_case(seed);
        if (c.fraction == 0) c.fraction = 0.5;
        const Built built = build(c);
        if (built.regions.opened > 0) continue;
        for (const auto f : built.plan.surface.faces()) {
            const auto middle = built.plan.surface.calc_face_centroid(f);
            const Point2 p{middle[0], middle[1]};
            const auto l = built.field.holes().locate(std::span(&p, 1))[0];
            for (std::size_t layer = 0; layer < built.field.layers(); ++layer)
                EXPECT_EQ(built.regions.in_face[static_cast<std::size_t>(f.idx())][layer],
                          built.field.is_present(layer, l))
                    << "seed " << seed;
        }
    }
}

class RandomRegions : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomRegions, make_closed_2_manifold_bodies) {
    for (std::uint64_t seed = 40 * GetParam() + 1; seed <= 40 * GetParam() + 40; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const PlanCase c = testing::random_plan_case(seed);
        const Built built = build(c);
        expect_sound(built);
        for (std::size_t h = 0; h < c.sites.size(); ++h)
            for (std::size_t layer = 0; layer < c.present.size(); ++layer)
                EXPECT_EQ(built.regions.zero_at[built.plan.hole_vertex[h]][layer], c.present[layer][h] == '0')
                    << "hole " << h << " layer " << layer;
        if (HasFatalFailure()) break;
    }
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomRegions, ::testing::Range<std::uint64_t>(0, 5));

TEST(LayerRegions, refuse_more_layers_than_fit) {
    PlanCase c{{{0, 0}, {10, 0}, {0, 10}}, {}, 0.5, 0};
    c.present.assign(kMaxLayers, "111");
    EXPECT_NO_THROW(build(c));
    c.present.emplace_back("111");
    try {
        build(c);
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("257 layers are more than the 256"), std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace stratareeb
