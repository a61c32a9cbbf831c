// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/planar_bodies.h"

#include <gtest/gtest.h>

#include "boreholes/errors.h"
#include "tests/planar_shapes.h"

namespace stratareeb {
namespace {

using test::add_slab;
using test::level;

TEST(PlanarBodies, each_connected_body_is_one) {
    TriMesh mesh;
    add_slab(mesh, {.n = 3});
    add_slab(mesh, {.n = 2, .x0 = 5});
    const auto bodies = planar_bodies(mesh);
    ASSERT_EQ(bodies.size(), 2u);
    for (const auto& body : bodies) {
        EXPECT_EQ(body.outer.faces.size(), 6u);
        EXPECT_TRUE(body.cavities.empty());
    }
}

TEST(PlanarBodies, a_body_inside_another_is_a_body_of_its_own) {
    TriMesh mesh;
    add_slab(mesh, {.n = 2, .size = 10, .top = level(10)});
    add_slab(mesh, {.n = 2, .size = 2, .x0 = 4, .y0 = 4, .top = level(6), .base = level(4)});
    EXPECT_EQ(planar_bodies(mesh).size(), 2u);
}

TEST(PlanarBodies, an_inward_shell_is_a_cavity_of_the_smallest_body_around_it) {
    TriMesh mesh;
    add_slab(mesh, {.n = 2, .size = 20, .x0 = -5, .y0 = -5, .top = level(15), .base = level(-5)});
    add_slab(mesh, {.n = 2, .size = 2, .x0 = 4, .y0 = 4, .top = level(6), .base = level(4), .inward = true});
    add_slab(mesh, {.n = 2, .size = 10, .top = level(10)});
    const auto bodies = planar_bodies(mesh);
    ASSERT_EQ(bodies.size(), 2u);
    EXPECT_TRUE(bodies[0].cavities.empty());
    ASSERT_EQ(bodies[1].cavities.size(), 1u);
    EXPECT_EQ(bodies[1].cavities[0].faces.size(), 6u);
}

TEST(PlanarBodies, an_inward_shell_without_a_body_around_it_is_refused) {
    TriMesh mesh;
    add_slab(mesh, {.n = 2, .inward = true});
    EXPECT_THROW(planar_bodies(mesh), GeometryError);
}

TEST(PlanarBodies, an_empty_mesh_has_none) {
    EXPECT_TRUE(planar_bodies({}).empty());
}

}  // namespace
}  // namespace stratareeb
