// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/vertex_descent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "reeb/vertex_link.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

std::uint32_t highest_below(const TriMesh& mesh, const VertexOrder& order, std::uint32_t vertex) {
    std::uint32_t highest = 0;
    for (const auto w : mesh.vv_range(TriMesh::VertexHandle(static_cast<int>(vertex)))) {
        const std::uint32_t rank = order.rank[static_cast<std::size_t>(w.idx())];
        if (rank < order.rank[vertex]) highest = std::max(highest, rank);
    }
    return highest;
}

void expect_descent_of_links(const TriMesh& mesh, const std::vector<double>& field, const std::string& name) {
    const VertexOrder order = vertex_order(field);
    const VertexDescent descent = vertex_descent(mesh, order);
    std::size_t critical_count = 0;
    bool has_boundary = false;
    VertexLink link;
    for (std::uint32_t v = 0; v < field.size(); ++v) {
        read_link(mesh, order.rank, v, link);
        has_boundary |= link.is_path;
        const std::uint32_t rank = order.rank[v];
        const bool is_passed = link.lower_fans.size() == 1 && link.strands.size() == 1;
        ASSERT_EQ(descent.is_critical(rank), !is_passed) << name;
        if (is_passed) {
            EXPECT_EQ(descent.below[rank], highest_below(mesh, order, v)) << name;
            continue;
        }
        ++critical_count;
        const CriticalLink& critical = descent.critical_at(rank);
        ASSERT_EQ(critical.vertex, v);
        ASSERT_EQ(critical.fans, link.lower_fans.size());
        EXPECT_EQ(critical.strands, link.strands.size());
        EXPECT_EQ(critical.is_on_boundary(), link.is_path);
        for (std::uint32_t i = 0; i < critical.fans; ++i) {
            std::set<std::uint32_t> ranks;
            for (const auto h : link.edges_of(link.lower_fans[i]))
                ranks.insert(order.rank[static_cast<std::size_t>(mesh.to_vertex_handle(h).idx())]);
            EXPECT_EQ(descent.fan_below[critical.first_fan + i], *ranks.rbegin());
        }
    }
    EXPECT_EQ(descent.critical.size(), critical_count) << name;
    EXPECT_EQ(descent.has_boundary, has_boundary) << name;
}

TEST(VertexDescent, steps_to_the_highest_lower_neighbour_of_each_fan) {
    std::mt19937_64 random(23);
    auto all = shapes::solids();
    for (auto& shape : shapes::open_surfaces()) all.push_back(std::move(shape));
    for (const auto& shape : all) {
        if (shape.name.find("bius") != std::string::npos) continue;
        const TriMesh mesh = half_edge_mesh(shape.soup);
        for (const unsigned range : {3u, 1'000'000u}) {
            std::vector<double> field(mesh.n_vertices());
            for (double& value : field) value = static_cast<double>(random() % range);
            expect_descent_of_links(mesh, field, shape.name);
        }
    }
}

TEST(VertexDescent, joins_blocks_of_vertices) {
    std::mt19937_64 random(24);
    const TriMesh mesh = half_edge_mesh(shapes::terrain(200));  // 40,401 vertices
    std::vector<double> field(mesh.n_vertices());
    for (double& value : field) value = static_cast<double>(random() % 1000);
    expect_descent_of_links(mesh, field, "terrain");
}

}  // namespace
}  // namespace stratareeb
