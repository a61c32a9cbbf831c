// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_layered_graph.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "boreholes/errors.h"
#include "tests/shapes.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

struct Case {
    TriMesh low = half_edge_mesh(shapes::uv_sphere(1, 8, 9)),
            high = half_edge_mesh(shapes::moved(shapes::uv_sphere(1, 8, 9), 4, 0, 0.5));
    ScalarField z_low = height_field(low), z_high = height_field(high);
    std::vector<LayerSurface> layers{{&low, &z_low}, {&high, &z_high}};
    std::vector<std::string> names{"sand", "clay \"grey\""};
    LayeredReebGraph graph = layered_reeb_graph(layers);
};

TEST(WriteLayeredGraph, loses_nothing_in_json) {
    const Case c;
    const TemporaryFolder folder;
    write_layered_graph(folder / "layers.json", c.graph, c.names);
    const auto json = nlohmann::json::parse(content_of(folder / "layers.json"));
    EXPECT_EQ(json["layers"].get<std::vector<std::string>>(), c.names);
    ASSERT_EQ(json["nodes"].size(), c.graph.nodes.size());
    for (std::size_t n = 0; n < c.graph.nodes.size(); ++n) {
        const auto& node = json["nodes"][n];
        EXPECT_EQ(node["value"].get<double>(), c.graph.nodes[n].value);
        EXPECT_EQ(node["center"][2].get<double>(), c.graph.nodes[n].center.z);
        ASSERT_EQ(node["contours"].size(), c.graph.nodes[n].contours.size());
        for (std::size_t k = 0; k < node["contours"].size(); ++k) {
            EXPECT_EQ(node["contours"][k]["layer"], c.graph.nodes[n].contours[k].layer);
            EXPECT_EQ(node["contours"][k]["points"].size(),
                      c.graph.nodes[n].contours[k].contour.points.size());
        }
    }
    ASSERT_EQ(json["arcs"].size(), c.graph.arcs.size());
    EXPECT_EQ(json["arcs"][0]["layer"], 0);
}

std::size_t count(const std::string& text, const std::string& word) {
    std::size_t found = 0;
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
    return found;
}

TEST(WriteLayeredGraph, writes_graphviz_and_lines) {
    const Case c;
    const TemporaryFolder folder;
    write_layered_graph(folder / "layers.dot", c.graph, c.names);
    write_layered_graph(folder / "layers.obj", c.graph, c.names);
    const std::string dot = content_of(folder / "layers.dot"), obj = content_of(folder / "layers.obj");
    EXPECT_EQ(count(dot, " -- "), c.graph.arcs.size());
    EXPECT_EQ(count(dot, "clay \\\"grey\\\""), 2u);
    EXPECT_EQ(count(obj, "g "), 4u);
    std::size_t lines = c.graph.arcs.size();
    for (const auto& node : c.graph.nodes)
        for (const auto& piece : node.contours) lines += piece.contour.points.size() > 1;
    EXPECT_EQ(count(obj, "l "), lines);
    EXPECT_THROW(write_layered_graph(folder / "layers.xyz", c.graph, c.names), IoError);
}

}  // namespace
}  // namespace stratareeb
