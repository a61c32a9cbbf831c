// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/vertex_link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "mesh/triangle_soup.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

// Every edge at a vertex is either a lower one or in exactly one strand; a strand's exits are crossed edges of the link.
TEST(VertexLink, parts_the_edges_of_a_vertex_into_lower_ones_and_strands) {
    std::mt19937_64 random(3);
    auto shapes = shapes::solids();
    for (auto& shape : shapes::open_surfaces()) shapes.push_back(std::move(shape));
    for (const auto& shape : shapes) {
        if (shape.name.find("bius") != std::string::npos) continue;
        const TriMesh mesh = half_edge_mesh(shape.soup);
        std::vector<std::uint32_t> rank(mesh.n_vertices());
        std::iota(rank.begin(), rank.end(), 0u);
        for (std::size_t v = rank.size(); v > 1; --v) std::swap(rank[v - 1], rank[random() % v]);
        VertexLink link;
        for (std::uint32_t v = 0; v < rank.size(); ++v) {
            read_link(mesh, rank, v, link);
            std::vector<std::uint32_t> found, expected;
            const auto take = [&](const auto& part, bool upper) {
                for (const auto h : link.edges_of(part)) {
                    found.push_back(static_cast<std::uint32_t>(mesh.edge_handle(h).idx()));
                    EXPECT_EQ(rank[static_cast<std::size_t>(mesh.to_vertex_handle(h).idx())] > rank[v],
                              upper);
                }
            };
            for (const auto& strand : link.strands) take(strand, true);
            for (const auto& fan : link.lower_fans) take(fan, false);
            for (const auto e : mesh.ve_range(TriMesh::VertexHandle(static_cast<int>(v))))
                expected.push_back(static_cast<std::uint32_t>(e.idx()));
            std::ranges::sort(found);
            std::ranges::sort(expected);
            EXPECT_EQ(found, expected) << shape.name;
            std::size_t ends = 0;
            for (const auto& strand : link.strands)
                for (const auto exit : {strand.first_exit, strand.last_exit}) {
                    if (!exit.is_valid()) continue;
                    ++ends;
                    const auto a = rank[static_cast<std::size_t>(mesh.from_vertex_handle(exit).idx())];
                    const auto b = rank[static_cast<std::size_t>(mesh.to_vertex_handle(exit).idx())];
                    EXPECT_NE(a > rank[v], b > rank[v]) << "crossed just above the vertex";
                    const auto inner = mesh.opposite_halfedge_handle(exit);
                    EXPECT_EQ(mesh.to_vertex_handle(mesh.next_halfedge_handle(inner)).idx(),
                              static_cast<int>(v));
                }
            if (link.is_path || link.all_above) continue;
            EXPECT_EQ(ends, 2 * link.strands.size());
            EXPECT_EQ(link.lower_fans.size(), std::max<std::size_t>(link.strands.size(), 1));
        }
    }
}

}  // namespace
}  // namespace stratareeb
