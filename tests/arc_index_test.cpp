// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/arc_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/shapes.h"

namespace stratareeb {
namespace {

using Points = std::vector<std::tuple<double, double, double>>;

//! A closed contour may start anywhere (and touch itself in a vertex at the level): the least of all its rotations.
Points canonical(const Contour& contour) {
    Points points, least;
    for (const Point3& p : contour.points) points.emplace_back(p.x, p.y, p.z);
    least = points;
    for (std::size_t k = 0; contour.closed && k < points.size(); ++k) {
        std::rotate(points.begin(), points.begin() + 1, points.end());
        least = std::min(least, points);
    }
    return least;
}

std::vector<Points> as_set(const LevelSet& set) {
    std::vector<Points> all;
    for (const Contour& contour : set.contours) all.push_back(canonical(contour));
    std::ranges::sort(all);
    return all;
}

void expect_levels_of_sweep(const TriMesh& mesh, const ScalarField& field, const std::string& name) {
    const ReebGraph graph = reeb_graph(mesh, field);
    const ArcIndex index(mesh, field, graph);
    std::vector<double> levels = even_levels(field, 17);
    for (std::size_t v = 0; v < field.size(); v += 1 + field.size() / 20) levels.push_back(field[v]);
    levels.push_back(*std::ranges::max_element(field) + 1);
    const auto swept = level_sets(mesh, field, levels);
    for (std::size_t k = 0; k < levels.size(); ++k) {
        ASSERT_EQ(as_set(index.level_set(levels[k])), as_set(swept[k])) << name << " at " << levels[k];
        for (const std::uint32_t arc : index.arcs_at(levels[k])) {
            ASSERT_LT(graph.nodes[graph.arcs[arc].lower].value, levels[k]);
            ASSERT_GE(graph.nodes[graph.arcs[arc].upper].value, levels[k]);
        }
    }
}

TEST(ArcIndex, gives_the_contours_that_a_sweep_gives) {
    auto all = shapes::solids();
    for (auto& shape : shapes::open_surfaces()) all.push_back(std::move(shape));
    std::mt19937_64 random(8);
    for (const auto& shape : all) {
        if (shape.name.find("bius") != std::string::npos) continue;
        const TriMesh mesh = half_edge_mesh(shape.soup);
        expect_levels_of_sweep(mesh, height_field(mesh, {0.3, 0.2, 1}), shape.name);
        expect_levels_of_sweep(mesh, height_field(mesh), shape.name + " (plateaus)");
        ScalarField field(mesh.n_vertices());
        for (const unsigned range : {4u, 1'000'000u}) {
            for (double& value : field) value = static_cast<double>(random() % range);
            expect_levels_of_sweep(mesh, field, shape.name + " (random)");
        }
    }
}

TEST(ArcIndex, has_one_contour_an_arc) {
    const TriMesh mesh = half_edge_mesh(shapes::plate_with_holes(3));
    const ScalarField field = height_field(mesh, {1, 0.1, 0.01});
    const ReebGraph graph = reeb_graph(mesh, field);
    const ArcIndex index(mesh, field, graph);
    for (const double level : even_levels(field, 50))
        EXPECT_EQ(index.arcs_at(level).size(), index.level_set(level).contours.size()) << level;
}

}  // namespace
}  // namespace stratareeb
