// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/plan_locator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "boreholes/random_survey.h"
#include "mesh/layer_model.h"

namespace stratareeb {
namespace {

//! A plan mesh of very different triangle sizes: clustered holes, bare or refined.
TriMesh random_plan(std::uint64_t seed) {
    const Survey survey =
        random_survey({.holes = 40, .seed = seed, .plan = HolePlan::Clustered, .pinch_outs = true});
    LayerModelOptions options;
    if (seed % 2) options.spacing = 0;
    return build_layer_model(survey, options).plan.surface;
}

Point2 plan_point(const TriMesh& mesh, std::uint32_t v) {
    const auto& p = mesh.point(TriMesh::VertexHandle(static_cast<int>(v)));
    return {p[0], p[1]};
}

double doubled_area(const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

//! Over all triangles: the deepest that the place lies in one of them, as a share of its size.
double depth_in(const TriMesh& mesh, const Point2& p) {
    double deepest = -1;
    for (const auto f : mesh.faces()) {
        std::array<Point2, 3> c;
        std::size_t i = 0;
        for (const auto v : mesh.fv_range(f)) c[i++] = plan_point(mesh, static_cast<std::uint32_t>(v.idx()));
        const double all = doubled_area(c[0], c[1], c[2]);
        deepest = std::max(deepest, std::min({doubled_area(p, c[1], c[2]), doubled_area(p, c[2], c[0]),
                                              doubled_area(p, c[0], c[1])}) /
                                        all);
    }
    return deepest;
}

TEST(PlanLocator, finds_a_triangle_that_has_the_place_exactly_when_there_is_one) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const TriMesh mesh = random_plan(seed);
        const PlanLocator locator(mesh);
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> anywhere(-20, 320);
        for (int k = 0; k < 300; ++k) {
            const Point2 p{anywhere(random), anywhere(random)};
            const double depth = depth_in(mesh, p);
            if (std::abs(depth) < 1e-9) continue;  // within rounding of a border
            const auto place = locator.locate(p);
            ASSERT_EQ(place.has_value(), depth > 0) << p.x << ", " << p.y;
            if (!place) continue;
            double x = 0, y = 0, sum = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                EXPECT_GE(place->weight[i], 0);
                sum += place->weight[i];
                x += place->weight[i] * plan_point(mesh, place->vertex[i]).x;
                y += place->weight[i] * plan_point(mesh, place->vertex[i]).y;
            }
            EXPECT_NEAR(sum, 1, 1e-14);
            EXPECT_NEAR(x, p.x, 1e-10);
            EXPECT_NEAR(y, p.y, 1e-10);
        }
    }
}

TEST(PlanLocator, gives_a_vertex_its_own_value_to_the_last_bit) {
    const TriMesh mesh = random_plan(3);
    const PlanLocator locator(mesh);
    std::vector<double> value;
    for (std::size_t v = 0; v < mesh.n_vertices(); ++v) value.push_back(0.1 + 1.7 * static_cast<double>(v));
    for (std::uint32_t v = 0; v < mesh.n_vertices(); ++v) {
        const auto place = locator.locate(plan_point(mesh, v));
        ASSERT_TRUE(place);
        EXPECT_EQ(place->value(value), value[v]);
    }
}

TEST(PlanLocator, takes_the_outline_as_inside_and_nothing_beyond_it) {
    const TriMesh mesh = random_plan(2);
    const PlanLocator locator(mesh);
    for (const auto h : mesh.halfedges()) {
        if (!mesh.is_boundary(h)) continue;
        const auto a = plan_point(mesh, static_cast<std::uint32_t>(mesh.from_vertex_handle(h).idx()));
        const auto b = plan_point(mesh, static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx()));
        const Point2 middle{(a.x + b.x) / 2, (a.y + b.y) / 2};  // off the line by rounding
        EXPECT_TRUE(locator.locate(middle));
        const double out =
            1e-6 / std::hypot(b.x - a.x, b.y - a.y);  // the mesh lies right of a boundary halfedge
        EXPECT_FALSE(locator.locate({middle.x - out * (b.y - a.y), middle.y + out * (b.x - a.x)}));
    }
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(locator.locate({kNaN, 0}));
    EXPECT_FALSE(locator.locate({0, std::numeric_limits<double>::infinity()}));
    EXPECT_FALSE(PlanLocator(TriMesh()).locate({0, 0}));
}

TEST(PlanLocator, lists_all_triangles_whose_boxes_meet_a_box) {
    const TriMesh mesh = random_plan(5);
    const PlanLocator locator(mesh);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> anywhere(-20, 320);
    for (int k = 0; k < 50; ++k) {
        const auto [x0, x1] = std::minmax({anywhere(random), anywhere(random)});
        const auto [y0, y1] = std::minmax({anywhere(random), anywhere(random)});
        std::vector<std::uint32_t> expected;
        for (const auto f : mesh.faces()) {
            double low_x = 1e9, high_x = -1e9, low_y = 1e9, high_y = -1e9;
            for (const auto v : mesh.fv_range(f)) {
                const auto p = plan_point(mesh, static_cast<std::uint32_t>(v.idx()));
                low_x = std::min(low_x, p.x), high_x = std::max(high_x, p.x);
                low_y = std::min(low_y, p.y), high_y = std::max(high_y, p.y);
            }
            if (low_x <= x1 && high_x >= x0 && low_y <= y1 && high_y >= y0)
                expected.push_back(static_cast<std::uint32_t>(f.idx()));
        }
        EXPECT_EQ(locator.near({x0, y0}, {x1, y1}), expected);
    }
}

}  // namespace
}  // namespace stratareeb
