// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/self_intersection.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/intersections.h>
#include <gtest/gtest.h>

#include <random>
#include <variant>

#include "mesh/triangle_contact.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

// The oracle: constructs the exact intersection of two triangles and asks whether all of it is shared. Slow,
// but there is nothing clever in it.
class Oracle {
 public:
    explicit Oracle(const TriangleSoup& soup) : soup_(soup) {}

    std::size_t count() const {
        const TriangleContact contact(soup_);
        std::size_t n = 0;
        for (std::uint32_t a = 0; a < soup_.triangles.size(); ++a)
            for (std::uint32_t b = 0; b < a; ++b)
                if (!contact.is_degenerate(a) && !contact.is_degenerate(b) && meet(a, b)) ++n;
        return n;
    }

 private:
    using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
    using Point = Kernel::Point_3;

    Point point(std::uint32_t v) const { return {soup_.points[v].x, soup_.points[v].y, soup_.points[v].z}; }

    Kernel::Triangle_3 triangle(std::uint32_t t) const {
        const auto& i = soup_.triangles[t];
        return {point(i[0]), point(i[1]), point(i[2])};
    }

    struct Shared {
        std::vector<Point> points;
        bool has(const Point& p) const { return std::find(points.begin(), points.end(), p) != points.end(); }
        bool operator()(const Point& p) const { return has(p); }
        bool operator()(const Kernel::Segment_3& s) const { return has(s.source()) && has(s.target()); }
        bool operator()(const Kernel::Triangle_3&) const { return false; }
        bool operator()(const std::vector<Point>&) const { return false; }
    };

    bool meet(std::uint32_t a, std::uint32_t b) const {
        const auto common = CGAL::intersection(triangle(a), triangle(b));
        if (!common) return false;
        Shared shared;
        for (const auto v : soup_.triangles[a])
            for (const auto w : soup_.triangles[b])
                if (v == w) shared.points.push_back(point(v));
        return !boost::apply_visitor([&](const auto& part) { return shared(part); }, *common);
    }

    const TriangleSoup& soup_;
};

TriangleSoup random_soup(std::mt19937& random, int vertices, int triangles, int grid) {
    std::uniform_int_distribution<int> coordinate(0, grid), corner(0, vertices - 1);
    TriangleSoup soup;
    for (int v = 0; v < vertices; ++v) {
        const auto next = [&] { return static_cast<double>(coordinate(random)); };
        soup.points.push_back({next(), next(), next()});
    }
    for (int t = 0; t < triangles; ++t) {
        const auto next = [&] { return static_cast<std::uint32_t>(corner(random)); };
        soup.triangles.push_back({next(), next(), next()});
    }
    return soup;
}

std::size_t cgal_count(const TriangleSoup& soup) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    CGAL::Surface_mesh<Kernel::Point_3> mesh;
    std::vector<CGAL::SM_Vertex_index> vertices;
    for (const auto& p : soup.points) vertices.push_back(mesh.add_vertex(Kernel::Point_3(p.x, p.y, p.z)));
    for (const auto& t : soup.triangles) mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    std::vector<std::pair<CGAL::SM_Face_index, CGAL::SM_Face_index>> pairs;
    CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
    return pairs.size();
}

// Points moved at random until the surface cuts through itself.
TriangleSoup shaken(TriangleSoup soup, double by, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-by, by);
    for (auto& p : soup.points) p = {p.x + shift(random), p.y + shift(random), p.z + shift(random)};
    return soup;
}

TEST(SelfIntersection, is_absent_from_sound_shapes) {
    for (const auto& shape : shapes::solids())
        EXPECT_EQ(self_intersections(shape.soup).count, 0u) << shape.name;
    for (const auto& shape : shapes::open_surfaces())
        EXPECT_EQ(self_intersections(shape.soup).count, 0u) << shape.name;
    EXPECT_EQ(self_intersections({}).count, 0u);
}

TEST(SelfIntersection, agrees_with_exact_constructions_on_random_soups) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 400; ++trial) {
        // Small grids make shared, coincident and coplanar corners common.
        const auto soup = random_soup(random, 6 + trial % 20, 4 + trial % 12, 1 + trial % 6);
        EXPECT_EQ(self_intersections(soup).count, Oracle(soup).count()) << "trial " << trial;
    }
}

TEST(SelfIntersection, agrees_with_exact_constructions_on_flat_soups) {
    std::mt19937 random(2);
    for (int trial = 0; trial < 200; ++trial) {
        auto soup = random_soup(random, 10, 8, 4);
        for (auto& p : soup.points) p.z = trial % 2 == 0 ? 0 : p.x + 2 * p.y;  // all in one plane
        EXPECT_EQ(self_intersections(soup).count, Oracle(soup).count()) << "trial " << trial;
    }
}

TEST(SelfIntersection, agrees_with_cgal_on_shaken_meshes) {
    std::size_t total = 0;
    for (unsigned seed = 0; seed < 6; ++seed) {
        for (const double by : {0.02, 0.2, 0.6}) {
            for (const auto& shape :
                 {shapes::torus(3, 1, 24, 12), shapes::uv_sphere(2, 12, 20), shapes::terrain(12)}) {
                const auto soup = shaken(shape, by, seed);
                const auto count = self_intersections(soup).count;
                EXPECT_EQ(count, cgal_count(soup));
                total += count;
            }
        }
    }
    EXPECT_GT(total, 1000u);  // the comparison was about something
}

TEST(SelfIntersection, sees_two_triangles_fold_onto_each_other) {
    TriangleSoup soup;
    soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.5, 0}};
    soup.triangles = {{0, 1, 2}, {1, 0, 3}};
    EXPECT_EQ(self_intersections(soup).count, 1u);
    soup.points[3] = {0.25, 0.5, 1e-300};  // however little apart, it is no overlap
    EXPECT_EQ(self_intersections(soup).count, 0u);
    soup.points[3] = {0.25, -0.5, 0};
    EXPECT_EQ(self_intersections(soup).count, 0u);
}

TEST(SelfIntersection, counts_copies_and_coincident_corners) {
    auto twice = shapes::tetrahedron();
    twice.triangles.push_back(twice.triangles[0]);
    EXPECT_EQ(self_intersections(twice).count, 1u);

    TriangleSoup touching;  // two triangles tip to tip, their tips not one vertex
    touching.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {-1, 0, 0}, {-1, 1, 0}};
    touching.triangles = {{0, 1, 2}, {3, 4, 5}};
    EXPECT_EQ(self_intersections(touching).count, 1u);
}

TEST(SelfIntersection, names_the_lowest_pairs) {
    auto soup = shapes::joined(shapes::cube(), shapes::moved(shapes::cube(), 0.5, 0.5, 0.5));
    const auto found = self_intersections(soup);
    EXPECT_EQ(found.count, Oracle(soup).count());
    ASSERT_EQ(found.first.size(), kNamedPairs);
    EXPECT_LT(found.first[0], found.first[1]);
    EXPECT_LT(found.first[1], found.first[2]);
    const TriangleContact contact(soup);
    for (std::uint32_t a = 0; a <= found.first[0][0]; ++a)
        for (std::uint32_t b = a + 1; b < soup.triangles.size(); ++b)
            if (std::array<std::uint32_t, 2>{a, b} < found.first[0]) {
                EXPECT_FALSE(contact.meet(a, b));
            }
}

TEST(SelfIntersection, of_a_large_mesh_is_the_same_on_every_run) {
    const auto soup = shaken(shapes::terrain(150), 0.45, 7);  // large enough for several threads
    const auto once = self_intersections(soup);
    EXPECT_GT(once.count, 0u);
    EXPECT_EQ(once.count, cgal_count(soup));
    for (int run = 0; run < 5; ++run) {
        const auto again = self_intersections(soup);
        EXPECT_EQ(again.count, once.count);
        EXPECT_EQ(again.first, once.first);
    }
}

TEST(SelfIntersection, far_from_the_origin_is_decided_exactly) {
    // Two layers a ten-millionth apart, near northing 5,000,000: apart is apart, and touching is touching.
    const auto top =
        shapes::moved(shapes::terrain(4, [](double, double) { return 0.0; }), 500000, 5000000, 1e-7);
    const auto base =
        shapes::moved(shapes::terrain(4, [](double, double) { return 0.0; }), 500000, 5000000, 0);
    EXPECT_EQ(self_intersections(shapes::joined(top, base)).count, 0u);
    EXPECT_GT(self_intersections(shapes::joined(base, base)).count, 0u);
}

TEST(SelfIntersection, is_the_same_however_flat) {
    TriangleSoup soup = shapes::joined(shapes::uv_sphere(1, 12, 16),
                                       shapes::moved(shapes::uv_sphere(1, 12, 16), 0.7, 0.2, 0.1));
    const auto expected = self_intersections(soup, 1000);
    EXPECT_GT(expected.count, 0u);
    for (int round = 0; round < 6; ++round) {
        for (Point3& p : soup.points) p = {p.y, p.z / 1024, p.x};  // exactly
        const auto found = self_intersections(soup, 1000);
        EXPECT_EQ(found.count, expected.count);
        EXPECT_EQ(found.first, expected.first);
    }
}

TEST(SelfIntersection, of_some_triangles_are_the_pairs_with_one_of_them) {
    std::mt19937 random(9);
    std::size_t total = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const auto soup = random_soup(random, 12, 30, 5);
        std::vector<bool> asked(soup.triangles.size());
        for (std::size_t t = 0; t < asked.size(); ++t) asked[t] = random() % 4 == 0;
        auto expected = self_intersections(soup, 1000).first;
        std::erase_if(expected, [&](const auto& pair) { return !asked[pair[0]] && !asked[pair[1]]; });
        const auto found = self_intersections_of(soup, asked, 1000);
        EXPECT_EQ(found.first, expected) << trial;
        EXPECT_EQ(found.count, expected.size()) << trial;
        total += expected.size();
    }
    EXPECT_GT(total, 200u);
}

}  // namespace
}  // namespace stratareeb
