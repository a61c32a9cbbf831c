// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/surface_fairing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>

#include "io/read_contour_stack.h"
#include "io/read_enhanced_graph.h"
#include "mesh/analysis.h"
#include "reeb/collapse_plateaus.h"
#include "reeb/graph_of_stack.h"
#include "reeb/least_bending.h"
#include "reeb/link_signs.h"
#include "reeb/surface_construction.h"
#include "reeb/terrain_stack.h"
#include "tests/arc_heights.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

//! Vertices from the contours below a saddle to those above it, by height.
std::vector<bool> beside_saddles(const EnhancedReebGraph& graph, const TriangleSoup& soup) {
    std::map<std::uint32_t, int> ends;
    for (const EnhancedEdge& edge : graph.edges) {
        ++ends[edge.from];
        ++ends[edge.to];
    }
    std::vector<bool> result(soup.points.size(), false);
    for (const auto& [node, count] : ends) {
        if (count < 3) continue;
        const double z = graph.nodes[node].position.z;
        double low = -1e300, high = 1e300;
        for (const auto& contour : graph.contours) {
            const double own =
                contour.curve.kind == CurveKind::Circle ? contour.curve.center.z : contour.curve.points[0].z;
            if (own < z) low = std::max(low, own);
            if (own > z) high = std::min(high, own);
        }
        for (std::size_t v = 0; v < result.size(); ++v)
            if (soup.points[v].z >= low && soup.points[v].z <= high) result[v] = true;
    }
    return result;
}

//! Root mean square of the angles between neighbouring triangles at edges beside saddles, weighted by length: radians.
double mean_bend(const TriangleSoup& soup, const std::vector<bool>& asked) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> sides;
    std::vector<Point3> normals;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        const auto& t = soup.triangles[i];
        const Point3 &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
        const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
        Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
        const double length = std::hypot(n.x, n.y, n.z);
        normals.push_back({n.x / length, n.y / length, n.z / length});
        for (std::size_t k = 0; k < 3; ++k)
            if (asked[t[k]] && asked[t[(k + 1) % 3]]) sides[std::minmax(t[k], t[(k + 1) % 3])].push_back(i);
    }
    double sum = 0, weight = 0;
    for (const auto& [edge, two] : sides) {
        if (two.size() != 2) continue;
        const Point3 &p = soup.points[edge.first], &q = soup.points[edge.second], &m = normals[two[0]],
                     &n = normals[two[1]];
        const double length = std::hypot(p.x - q.x, p.y - q.y, p.z - q.z),
                     angle = std::acos(std::clamp(m.x * n.x + m.y * n.y + m.z * n.z, -1.0, 1.0));
        sum += length * angle * angle;
        weight += length;
    }
    return std::sqrt(sum / weight);
}

struct Case {
    EnhancedReebGraph graph;
    bool terrain = false;
};

Case case_of(const std::string& name) {
    const std::string examples = STRATAREEB_SOURCE_DIR "/examples/";
    if (name == "st_helens") {
        Case result{graph_of_stack(read_contour_stack(examples + "st_helens/contours.json")).graph, true};
        EXPECT_TRUE(is_terrain(result.graph));
        return result;
    }
    return {read_enhanced_graph(examples + "graphs/" + name + ".json"), false};
}

// Bending beside saddles falls, given contours and the Reeb graph stay, and nothing new crosses.
TEST(SurfaceFairing, bends_less_beside_saddles_and_keeps_contours_and_graph) {
    for (const std::string name :
         {"merge", "divide", "double_torus", "torus", "monkey", "nested_merge", "st_helens"}) {
        SCOPED_TRACE(name);
        const auto [graph, terrain] = case_of(name);
        const auto rough = construct_surface(graph, {.fairing = false, .terrain = terrain}),
                   faired = construct_surface(graph, {.terrain = terrain});
        const MeshReport report = analyze(faired.soup);
        EXPECT_TRUE(report.watertight);
        EXPECT_TRUE(faired.crossings.empty());
        const TriMesh mesh = half_edge_mesh(faired.soup);
        EXPECT_EQ(testing::arcs_of(collapse_plateaus(reeb_graph(mesh, height_field(mesh)))),
                  testing::arcs_of(graph));
        std::set<std::tuple<double, double, double>> places;
        for (const Point3& p : faired.soup.points) places.emplace(p.x, p.y, p.z);
        for (const auto& contour : graph.contours)
            for (const Point3& p : contour.curve.points)
                EXPECT_TRUE(contour.curve.kind != CurveKind::Polyline || places.contains({p.x, p.y, p.z}));
        const auto before = beside_saddles(graph, rough.soup), after = beside_saddles(graph, faired.soup);
        const double energy_before = bending_energy(rough.soup, before, WeightSpace::Space),
                     energy_after = bending_energy(faired.soup, after, WeightSpace::Space);
        EXPECT_LT(energy_after, 0.8 * energy_before);
        EXPECT_LT(mean_bend(faired.soup, after), 0.98 * mean_bend(rough.soup, before));
        std::printf("%-14s energy %10.3f -> %10.3f, bend %.4f -> %.4f\n", name.c_str(), energy_before,
                    energy_after, mean_bend(rough.soup, before), mean_bend(faired.soup, after));
    }
}

// A dent in a sphere goes; nothing else moves.
TEST(SurfaceFairing, moves_free_vertices_alone_and_makes_no_critical_points) {
    std::mt19937_64 random(4);
    TriangleSoup soup = shapes::uv_sphere(2, 40, 60);
    const TriangleSoup smooth = soup;
    FreeVertices free{.freedom = std::vector<Freedom>(soup.points.size(), Freedom::None),
                      .group = std::vector<std::uint32_t>(soup.points.size(), 0)};
    for (std::size_t v = 0; v < soup.points.size(); ++v) {
        if (std::abs(soup.points[v].z) > 1) continue;
        free.freedom[v] = Freedom::Space;
        for (double* x : {&soup.points[v].x, &soup.points[v].y})
            *x += 0.05 * (static_cast<double>(random() % 1000) / 1000 - 0.5);
    }
    const TriangleSoup rough = soup;
    const std::vector<bool> all(soup.points.size(), true);
    fair_surface(soup, free, {});
    EXPECT_EQ(link_signs(soup, all), link_signs(rough, all));
    EXPECT_LT(bending_energy(soup, all, WeightSpace::Space),
              bending_energy(rough, all, WeightSpace::Space) / 2);
    for (std::size_t v = 0; v < soup.points.size(); ++v)
        EXPECT_TRUE(free.freedom[v] != Freedom::None || soup.points[v] == smooth.points[v]);
    TriangleSoup same = rough;
    fair_surface(same, free, {0});
    EXPECT_EQ(same.points, rough.points);
}

}  // namespace
}  // namespace stratareeb
