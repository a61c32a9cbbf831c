// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/scalar_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "boreholes/errors.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

TEST(ScalarField, of_height_is_the_dot_product_with_the_direction) {
    const TriangleSoup soup = shapes::torus(3, 1, 12, 8);
    const TriMesh mesh = half_edge_mesh(soup);
    const ScalarField z = height_field(mesh), oblique = height_field(mesh, {2, -1, 0.5});
    for (std::size_t v = 0; v < soup.points.size(); ++v) {
        const Point3& p = soup.points[v];
        EXPECT_EQ(z[v], p.z);
        EXPECT_NEAR(oblique[v], 2 * p.x - p.y + 0.5 * p.z, 1e-14);
    }
    EXPECT_THROW(height_field(mesh, {0, 0, 0}), InvalidInput);
    EXPECT_THROW(height_field(mesh, {1, std::nan(""), 0}), InvalidInput);
}

TEST(ScalarField, of_distance_is_constant_on_a_sphere_around_the_place) {
    const TriMesh mesh = half_edge_mesh(shapes::moved(shapes::uv_sphere(2, 10, 14), 5e6, 6e6, 100));
    for (const double d : distance_field(mesh, {5e6, 6e6, 100})) EXPECT_NEAR(d, 2, 1e-8);
}

TEST(ScalarField, orders_equal_values_by_index) {
    const ScalarField field{1, 0, 1, -0.0};
    EXPECT_TRUE(is_below(field, 1, 0));
    EXPECT_TRUE(is_below(field, 0, 2));
    EXPECT_FALSE(is_below(field, 2, 0));
    EXPECT_TRUE(is_below(field, 1, 3)) << "zeros of either sign are one value";
    EXPECT_FALSE(is_below(field, 3, 1));
    EXPECT_FALSE(is_below(field, 2, 2));
}

TEST(ScalarField, must_have_a_finite_value_a_vertex) {
    const TriMesh mesh = half_edge_mesh(shapes::tetrahedron());
    EXPECT_NO_THROW(check_field(mesh, {1, 2, 3, 4}));
    EXPECT_THROW(check_field(mesh, {1, 2, 3}), InvalidInput);
    EXPECT_THROW(check_field(mesh, {1, 2, 3, std::numeric_limits<double>::infinity()}), InvalidInput);
}

}  // namespace
}  // namespace stratareeb
