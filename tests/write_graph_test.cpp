// SPDX-License-Identifier: GPL-3.0-or-later
// Graphs as JSON, GraphViz and GraphML, and as lines in space: what is written is read back.
#include "io/write_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "boreholes/errors.h"
#include "io/write_graph_lines.h"
#include "reeb/arc_members.h"
#include "reeb/collapse_plateaus.h"
#include "tests/shapes.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

using Ends = std::multiset<std::pair<std::uint32_t, std::uint32_t>>;

Ends ends_of(const ReebGraph& graph) {
    Ends ends;
    for (const ReebArc& arc : graph.arcs) ends.emplace(arc.lower, arc.upper);
    return ends;
}

Ends ends_found(const std::string& text, const std::string& pattern) {
    Ends ends;
    const std::regex regex(pattern);
    for (std::sregex_iterator i(text.begin(), text.end(), regex), end; i != end; ++i)
        ends.emplace(std::stoul((*i)[1]), std::stoul((*i)[2]));
    return ends;
}

//! A torus lying down by its side: two of its four arcs join the same two nodes.
class WriteGraph : public ::testing::Test {
 protected:
    std::string written(const std::string& name, const GraphDetails& details = {}) const {
        write_graph(folder_ / name, graph_, mesh_, details);
        return content_of(folder_ / name);
    }
    std::string lines(const std::string& name, const std::vector<std::vector<Point3>>& curves) const {
        write_graph_lines(folder_ / name, graph_, mesh_, curves);
        return content_of(folder_ / name);
    }
    std::vector<std::vector<Point3>> curves(std::size_t samples) const {
        const ArcIndex index(mesh_, field_, graph_);
        return coarse_arc_curves(mesh_, graph_, index, graph_, arc_members(graph_, graph_), samples);
    }

    TemporaryFolder folder_;
    TriMesh mesh_ = half_edge_mesh(shapes::torus(3, 1, 60, 30));
    ScalarField field_ = height_field(mesh_, {1, 0.1, 0.05});
    ReebGraph graph_ = reeb_graph(mesh_, field_);
};

TEST_F(WriteGraph, the_case_has_two_arcs_between_the_same_nodes) {
    const Ends ends = ends_of(graph_);
    EXPECT_EQ(ends.size(), 4u);
    EXPECT_EQ(ends.count({1, 2}), 2u);
}

TEST_F(WriteGraph, edges_survive_in_every_text_format) {
    EXPECT_EQ(ends_found(written("g.dot"), R"(n(\d+) -- n(\d+);)"), ends_of(graph_));
    const std::string graphml = written("g.graphml");
    EXPECT_EQ(ends_found(graphml, R"re(source="n(\d+)" target="n(\d+)")re"), ends_of(graph_));
    std::set<std::string> ids;
    const std::regex id(R"re(<edge id="(e\d+)")re");
    for (std::sregex_iterator i(graphml.begin(), graphml.end(), id), end; i != end; ++i) ids.insert((*i)[1]);
    EXPECT_EQ(ids.size(), 4u);
    Ends ends;
    const auto json = nlohmann::json::parse(written("g.json"));
    for (const auto& arc : json["arcs"]) ends.emplace(arc["from"], arc["to"]);
    EXPECT_EQ(ends, ends_of(graph_));
}

TEST_F(WriteGraph, json_says_all_of_nodes_and_arcs) {
    const auto json = nlohmann::json::parse(written("g.json"));
    ASSERT_EQ(json["nodes"].size(), graph_.nodes.size());
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
        const auto& node = json["nodes"][i];
        const Point3 p = node_place(mesh_, graph_.nodes[i]);
        EXPECT_EQ(node["id"], i);
        EXPECT_EQ(node["vertex"], graph_.nodes[i].vertex);
        EXPECT_EQ(node["position"], (nlohmann::json{p.x, p.y, p.z}));
        EXPECT_EQ(node["value"], graph_.nodes[i].value);
        EXPECT_EQ(node["down"], graph_.nodes[i].down);
        EXPECT_EQ(node["up"], graph_.nodes[i].up);
    }
    EXPECT_EQ(json["nodes"][0]["type"], "minimum");
    EXPECT_EQ(json["nodes"][3]["type"], "maximum");
    std::size_t vertices = 0, triangles = 0;
    for (const auto& arc : json["arcs"]) {
        vertices += std::size_t(arc["vertices"]);
        triangles += std::size_t(arc["triangles"]);
    }
    EXPECT_EQ(vertices, mesh_.n_vertices());
    EXPECT_EQ(triangles, mesh_.n_faces());
    EXPECT_FALSE(json.contains("pairs"));
    EXPECT_FALSE(json.contains("loops"));
}

TEST_F(WriteGraph, json_holds_pairs_and_loops_if_asked) {
    const auto json = nlohmann::json::parse(
        written("g.json", {.pairs = persistence_pairs(graph_), .loops = loop_handles(mesh_, graph_)}));
    ASSERT_EQ(json["pairs"].size(), 2u);
    EXPECT_EQ(json["pairs"][0]["kind"], "component");
    EXPECT_EQ(json["pairs"][1]["kind"], "loop");
    EXPECT_EQ(json["pairs"][1]["lower"], 1);
    ASSERT_EQ(json["loops"].size(), 1u);
    const auto& loop = json["loops"][0];
    EXPECT_EQ(loop["nodes"], (nlohmann::json{1, 2}));
    EXPECT_EQ(loop["persistence"], graph_.nodes[2].value - graph_.nodes[1].value);
    ASSERT_EQ(loop["arcs"].size(), 2u);
    EXPECT_NE(loop["arcs"][0], loop["arcs"][1]);
    EXPECT_GT(loop["triangles"], 100);
    for (int k = 0; k < 3; ++k) EXPECT_LT(loop["box"][0][k], loop["box"][1][k]);
}

TEST_F(WriteGraph, ply_lines_are_the_arcs_curves) {
    const auto arcs = curves(7);
    const std::string text = lines("g.ply", arcs);
    std::istringstream in(text.substr(text.find("end_header\n") + 11));
    EXPECT_NE(text.find("element vertex 32\n"), std::string::npos);  // 4 nodes, 4 arcs of 7 inner points
    EXPECT_NE(text.find("element edge 32\n"), std::string::npos);
    std::vector<Point3> points(32);
    for (Point3& p : points) {
        int r = -1, g = -1, b = -1;
        in >> p.x >> p.y >> p.z >> r >> g >> b;
        EXPECT_TRUE(r >= 0 && g >= 0 && b >= 0 && b < 256);
    }
    std::vector<std::vector<Point3>> found(4);
    std::size_t a = 0, b = 0, arc = 0;
    while (in >> a >> b >> arc) {
        ASSERT_LT(arc, 4u);
        if (found[arc].empty()) found[arc].push_back(points.at(a));
        EXPECT_EQ(found[arc].back(), points.at(a));
        found[arc].push_back(points.at(b));
    }
    EXPECT_EQ(found, arcs);
}

TEST_F(WriteGraph, obj_has_a_line_an_arc_even_between_the_same_nodes) {
    for (const std::size_t samples : {0u, 3u}) {
        std::istringstream in(lines("g.obj", curves(samples)));
        Ends ends;
        std::size_t points = 0;
        for (std::string line; std::getline(in, line);) {
            points += line.starts_with("v ");
            if (!line.starts_with("l ")) continue;
            std::istringstream words(line.substr(2));
            std::vector<std::uint32_t> numbers;
            for (std::uint32_t n = 0; words >> n;) numbers.push_back(n);
            EXPECT_EQ(numbers.size(), samples + 2);
            EXPECT_LE(*std::ranges::max_element(numbers), points);
            ends.emplace(numbers.front() - 1, numbers.back() - 1);
        }
        EXPECT_EQ(points, 4 + 4 * samples);
        EXPECT_EQ(ends, ends_of(graph_));
    }
}

TEST_F(WriteGraph, curves_of_the_torus_run_through_the_middle_of_its_tube) {
    const ScalarField height = height_field(mesh_, {1, 0, 0});
    const ReebGraph graph = reeb_graph(mesh_, height);
    const ReebGraph collapsed = collapse_plateaus(graph);
    const ArcIndex index(mesh_, height, graph);
    const auto found = coarse_arc_curves(mesh_, graph, index, collapsed, arc_members(graph, collapsed), 9);
    ASSERT_EQ(found.size(), 4u);
    for (std::size_t a = 0; a < 4; ++a) {
        ASSERT_EQ(found[a].size(), 11u);
        const double low = collapsed.nodes[collapsed.arcs[a].lower].value,
                     high = collapsed.nodes[collapsed.arcs[a].upper].value;
        for (std::size_t k = 1; k <= 9; ++k) {
            EXPECT_NEAR(found[a][k].x, low + double(k) / 10 * (high - low), 1e-9);
            EXPECT_NEAR(found[a][k].z, 0, 1e-9);  // the torus is alike above and below
        }
    }
}

TEST_F(WriteGraph, other_formats_and_curves_that_do_not_fit_are_refused) {
    EXPECT_THROW(write_graph("graph.txt", {}, TriMesh()), IoError);
    EXPECT_THROW(write_graph_lines("graph.stl", {}, TriMesh(), {}), IoError);
    EXPECT_THROW(write_graph_lines(folder_ / "g.obj", graph_, mesh_, {}), InvalidInput);
    auto bare = curves(1);
    bare[2].resize(1);
    EXPECT_THROW(write_graph_lines(folder_ / "g.obj", graph_, mesh_, bare), InvalidInput);
    EXPECT_THROW(write_graph(folder_ / "none" / "g.json", graph_, mesh_), IoError);
    EXPECT_EQ(folder_.size(), 0u);
}

TEST_F(WriteGraph, a_graph_without_anything_is_a_file_too) {
    write_graph(folder_ / "e.json", {}, TriMesh());
    const auto json = nlohmann::json::parse(content_of(folder_ / "e.json"));
    EXPECT_TRUE(json["nodes"].empty() && json["arcs"].empty());
    write_graph_lines(folder_ / "e.ply", {}, TriMesh(), {});
    EXPECT_NE(content_of(folder_ / "e.ply").find("element edge 0"), std::string::npos);
}

}  // namespace
}  // namespace stratareeb
