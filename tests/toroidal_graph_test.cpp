// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/toroidal_graph.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "boreholes/errors.h"
#include "mesh/triangle_soup.h"
#include "tests/band_cases.h"

namespace stratareeb {
namespace {

using namespace band_cases;

//! The triangles' corners: upper points, then lower ones.
Points corners(const Points& upper, const Points& lower) {
    Points all = upper;
    all.insert(all.end(), lower.begin(), lower.end());
    return all;
}

double area(const Band& band, const Points& upper, const Points& lower) {
    const Points points = corners(upper, lower);
    double sum = 0;
    for (const auto& [a, b, c] : band.triangles) sum += triangle_area(points[a], points[b], points[c]);
    return sum;
}

//! The volume between the band and the origin.
double volume(const Band& band, const Points& upper, const Points& lower) {
    const Points points = corners(upper, lower);
    double sum = 0;
    for (const auto& [ia, ib, ic] : band.triangles) {
        const Point3 a = points[ia], b = points[ib], c = points[ic];
        sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
    }
    return sum / 6;
}

Points regular(std::size_t count, double radius, double z) {
    std::mt19937 unused;
    return wobbly_circle(count, radius, z, 0, 0, unused);
}

//! Each triangle has one edge on a contour, from its point to the next, and its third corner on the other contour; each edge
//! of both contours has one triangle; triangles share their spans two by two (at both ends of an open band: one has it).
void expect_band(const Band& band, std::uint32_t m, std::uint32_t n, bool closed) {
    std::set<std::uint32_t> upper_edges, lower_edges;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> spans;
    for (const auto& triangle : band.triangles) {
        std::vector<std::uint32_t> up, low;
        for (const std::uint32_t corner : triangle) (corner < m ? up : low).push_back(corner);
        ASSERT_FALSE(up.empty());
        ASSERT_FALSE(low.empty());
        if (up.size() == 2) {  // (i, lower, i + 1)
            ASSERT_GE(triangle[1], m);
            ASSERT_EQ(triangle[2], (triangle[0] + 1) % m);
            ASSERT_TRUE(upper_edges.insert(triangle[0]).second);
        } else {  // (j, j + 1, upper)
            ASSERT_LT(triangle[2], m);
            ASSERT_EQ(triangle[1] - m, (triangle[0] - m + 1) % n);
            ASSERT_TRUE(lower_edges.insert(triangle[0]).second);
        }
        for (const std::uint32_t u : up)
            for (const std::uint32_t l : low) ++spans[{u, l}];
    }
    EXPECT_EQ(upper_edges.size(), m == 1 ? 0 : m - (closed ? 0 : 1));
    EXPECT_EQ(lower_edges.size(), n == 1 ? 0 : n - (closed ? 0 : 1));
    int ends = 0;
    for (const auto& [span, uses] : spans) {
        if (uses == 1) ++ends;
        EXPECT_LE(uses, m > 2 && n > 2 ? 2 : 4);
    }
    EXPECT_EQ(ends, closed ? 0 : 2);
}

TEST(ToroidalGraph, bands_have_each_edge_once_and_triangles_on_one_contour_each) {
    std::mt19937 random(1);
    std::uniform_int_distribution<std::uint32_t> size(3, 20);
    for (int run = 0; run < 500; ++run)
        for (const bool closed : {true, false})
            for (const BandMethod method : {BandMethod::Exact, BandMethod::Greedy})
                for (const BandCost cost :
                     {BandCost::Area, BandCost::SpanLength, BandCost::ParameterDistance}) {
                    const std::uint32_t m = size(random), n = size(random);
                    const Points upper = grid_points(m, 1 + run % 6, random),
                                 lower = grid_points(n, 3, random);
                    const Band band =
                        toroidal_band(upper, lower, {.cost = cost, .method = method, .closed = closed});
                    ASSERT_EQ(band.triangles.size(), m + n - (closed ? 0 : 2));
                    ASSERT_NO_FATAL_FAILURE(expect_band(band, m, n, closed)) << run;
                    if (cost == BandCost::Area) {
                        EXPECT_NEAR(area(band, upper, lower), band.path.cost, 1e-12 * (1 + band.path.cost));
                    }
                }
}

TEST(ToroidalGraph, a_prism_is_made_of_its_own_sides) {
    for (const std::size_t n : {3, 4, 7, 100}) {
        const Points upper = regular(n, 2, 1.5), lower = regular(n, 2, 0);
        const double sides = static_cast<double>(n) * distance(upper[0], upper[1]) * 1.5;
        const Band band = toroidal_band(upper, lower);
        EXPECT_NEAR(area(band, upper, lower), sides, 1e-12 * sides);
    }
}

TEST(ToroidalGraph, triangles_face_outward) {
    // A frustum without its caps: the flux of (x, y, z) / 3 through its side, from the volume and the flux through the caps.
    for (const std::size_t m : {40, 55}) {
        const Points upper = regular(m, 1, 3), lower = regular(40, 1, 0);
        const Band band = toroidal_band(upper, lower);
        EXPECT_NEAR(volume(band, upper, lower), std::numbers::pi * 3 * (2.0 / 3), 0.05);
        for (const auto& [a, b, c] : band.triangles) {
            const Points points = corners(upper, lower);
            const double nx = (points[b].y - points[a].y) * (points[c].z - points[a].z) -
                              (points[b].z - points[a].z) * (points[c].y - points[a].y);
            const double ny = (points[b].z - points[a].z) * (points[c].x - points[a].x) -
                              (points[b].x - points[a].x) * (points[c].z - points[a].z);
            EXPECT_GT(nx * (points[a].x + points[b].x + points[c].x) +
                          ny * (points[a].y + points[b].y + points[c].y),
                      0);
        }
    }
}

TEST(ToroidalGraph, a_band_and_two_caps_are_a_closed_half_edge_mesh) {
    std::mt19937 random(2);
    for (int run = 0; run < 50; ++run) {
        const auto m = static_cast<std::uint32_t>(3 + run), n = static_cast<std::uint32_t>(3 + run % 7);
        const Points upper = wobbly_circle(m, 2, 1, 0.05, 0.02, random),
                     lower = wobbly_circle(n, 3, 0, 0.05, 0.02, random);
        TriangleSoup soup{.points = corners(upper, lower),
                          .triangles = toroidal_band(upper, lower).triangles};
        const Points top{{0, 0, 2}}, bottom{{0, 0, -1}};
        soup.points.push_back(top[0]);
        soup.points.push_back(bottom[0]);
        for (const auto& [a, b, c] : toroidal_band(top, upper).triangles)  // top is 0, upper starts at 1
            soup.triangles.push_back({a - 1, b - 1, m + n});
        for (const auto& [a, b, c] : toroidal_band(lower, bottom).triangles)
            soup.triangles.push_back({m + a, m + n + 1, m + c});
        const TriMesh mesh = half_edge_mesh(soup);
        for (const auto h : mesh.halfedges()) EXPECT_FALSE(mesh.is_boundary(h));
        EXPECT_EQ(static_cast<int>(mesh.n_vertices()) - static_cast<int>(mesh.n_edges()) +
                      static_cast<int>(mesh.n_faces()),
                  2);
    }
}

TEST(ToroidalGraph, open_polylines_have_the_least_cost_too) {
    std::mt19937 random(3);
    std::uniform_int_distribution<std::size_t> size(1, 25);
    for (int run = 0; run < 1000; ++run) {
        Problem p{.upper = grid_points(size(random), 1 + run % 5, random),
                  .lower = grid_points(size(random), 4, random),
                  .closed = false};
        p.s = length_parameters(p.upper, false);
        p.t = length_parameters(p.lower, false);
        for (const BandCost cost : {BandCost::Area, BandCost::SpanLength, BandCost::ParameterDistance}) {
            p.cost = cost;
            const Band band = toroidal_band(p.upper, p.lower, {.cost = cost, .closed = false});
            const double least = least_cost(p);
            EXPECT_NEAR(band.path.cost, least, 1e-12 * (1 + least));
            EXPECT_EQ(band.triangles.size(), p.upper.size() + p.lower.size() - 2);
        }
    }
}

TEST(ToroidalGraph, one_point_gives_a_fan_two_points_a_doubled_edge) {
    const Points polygon = regular(7, 1, 0), top{{0, 0, 2}}, edge{{-0.1, 0, 2}, {0.1, 0, 2}};
    const double slant = std::hypot(2, std::cos(std::numbers::pi / 7));
    const double cone = 7 * distance(polygon[0], polygon[1]) * slant / 2;
    const Band up = toroidal_band(top, polygon), down = toroidal_band(polygon, top);
    EXPECT_NEAR(up.path.cost, cone, 1e-12);
    EXPECT_NEAR(down.path.cost, cone, 1e-12);
    EXPECT_EQ(up.triangles.size(), 7u);
    expect_band(up, 1, 7, true);
    expect_band(down, 7, 1, true);
    EXPECT_EQ(toroidal_band(edge, polygon).triangles.size(), 9u);
    EXPECT_TRUE(toroidal_band(top, top).triangles.empty());
    EXPECT_EQ(toroidal_band(edge, top).triangles.size(), 2u);
    EXPECT_EQ(toroidal_band(top, polygon, {.closed = false}).triangles.size(), 6u);
    EXPECT_EQ(toroidal_band(top, polygon, {.method = BandMethod::Greedy}).triangles.size(), 7u);
}

TEST(ToroidalGraph, parametric_distance_joins_equal_parameters) {
    const Points upper = regular(24, 1, 1), lower = regular(24, 5, 0);
    std::vector<double> s = even_parameters(24, 0), t = even_parameters(24, 0.25);
    const Band band = toroidal_band(
        upper, lower, {.cost = BandCost::ParameterDistance, .upper_parameters = s, .lower_parameters = t});
    EXPECT_NEAR(band.path.cost, 24 * (1.0 / 24), 1e-12);  // every second span is off by one step
    std::size_t i = band.path.upper, j = band.path.lower;
    for (const bool up : band.path.upper_advances) {
        ++(up ? i : j);
        const double off = std::abs(s[i % 24] - t[j % 24]);
        EXPECT_LE(std::min(off, 1 - off), 1.0 / 24 + 1e-12);
    }
    for (double& parameter : s) parameter += 3;  // modulo 1
    EXPECT_NEAR(
        toroidal_band(upper, lower,
                      {.cost = BandCost::ParameterDistance, .upper_parameters = s, .lower_parameters = t})
            .path.cost,
        1, 1e-12);
}

TEST(ToroidalGraph, length_parameters_are_shares_of_the_perimeter) {
    const Points square{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}};
    EXPECT_EQ(length_parameters(square, true), (std::vector<double>{0, 0.375, 0.5, 0.875}));
    EXPECT_EQ(length_parameters(square, false), (std::vector<double>{0, 3.0 / 7, 4.0 / 7, 1}));
    EXPECT_EQ(length_parameters(Points(4), true), (std::vector<double>{0, 0.25, 0.5, 0.75}));
    EXPECT_EQ(length_parameters(Points(3), false), (std::vector<double>{0, 0.5, 1}));
    EXPECT_EQ(length_parameters(Points(1), false), std::vector<double>{0});
    EXPECT_TRUE(length_parameters(Points{}, true).empty());
}

std::string refusal(const Points& upper, const Points& lower, const BandOptions& options = {}) {
    try {
        toroidal_band(upper, lower, options);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "";
}

TEST(ToroidalGraph, says_what_is_wrong_with_its_input) {
    const Points square = regular(4, 1, 0), none;
    EXPECT_EQ(refusal(none, square), "the upper contour has no points (a cap needs one)");
    EXPECT_EQ(refusal(square, none), "the lower contour has no points (a cap needs one)");
    Points broken = square;
    broken[2].z = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(refusal(square, broken).find("point 2 of the lower contour"), std::string::npos);
    broken[2].z = 1e80;
    EXPECT_NE(refusal(broken, square).find("point 2 of the upper contour"), std::string::npos);
    const std::vector<double> three{0, 0.2, 0.4}, four{0, 0.2, 0.4, std::numeric_limits<double>::infinity()};
    EXPECT_EQ(refusal(square, square, {.lower_parameters = three}),
              "the lower contour has 4 points but 3 parameters (expected one each)");
    EXPECT_EQ(refusal(square, square, {.upper_parameters = four}),
              "parameter 3 of the upper contour is inf: expected a finite number");
    EXPECT_NE(refusal(square, square, {.method = BandMethod::Greedy, .first_span = std::array{4u, 0u}})
                  .find("(4, 0)"),
              std::string::npos);
}

}  // namespace
}  // namespace stratareeb
