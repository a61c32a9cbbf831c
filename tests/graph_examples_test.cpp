// SPDX-License-Identifier: GPL-3.0-or-later
// The hand-written graphs in examples/graphs and the one in docs/graph_format.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "io/read_enhanced_graph.h"
#include "io/write_enhanced_graph.h"
#include "mesh/ring_crossings.h"
#include "reeb/arc_length.h"
#include "reeb/correspondence.h"
#include "reeb/graph_conditions.h"
#include "reeb/sliding_homotopy.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

std::map<std::string, EnhancedGraphFile> examples() {
    std::map<std::string, EnhancedGraphFile> result;
    for (const auto& entry : std::filesystem::directory_iterator(STRATAREEB_SOURCE_DIR "/examples/graphs"))
        if (entry.path().extension() == ".json")
            result[entry.path().stem().string()] =
                parse_enhanced_graph(content_of(entry.path()), entry.path().filename().string());
    return result;
}

//! The edges' degrees at each node, what is below first: two graphs of one topology have the same ones.
std::multiset<std::pair<int, int>> degrees(const EnhancedReebGraph& graph) {
    std::vector<std::pair<int, int>> at(graph.nodes.size());
    for (const EnhancedEdge& edge : graph.edges) {
        ++at[edge.from].second;
        ++at[edge.to].first;
    }
    return {at.begin(), at.end()};
}

TEST(GraphExamples, are_sound_and_have_the_loops_that_they_say) {
    const auto all = examples();
    EXPECT_GE(all.size(), 9u);
    for (const auto& [name, file] : all) {
        EXPECT_TRUE(faults_of(file.graph).empty()) << name;
        const auto said = file.comment.find(std::to_string(loops_of(file.graph)) + " loop");
        EXPECT_NE(said, std::string::npos) << name << ": " << file.comment;
    }
}

TEST(GraphExamples, read_as_they_were_written) {
    for (const auto& [name, file] : examples()) {
        const std::string text = enhanced_graph_text(file.graph, file.comment);
        const auto again = parse_enhanced_graph(text, name);
        EXPECT_EQ(again.graph, file.graph) << name;
        EXPECT_EQ(again.comment, file.comment) << name;
        EXPECT_EQ(enhanced_graph_text(again.graph, again.comment), text) << name;
    }
}

TEST(GraphExamples, show_every_kind_of_contour_edge_and_homotopy) {
    std::set<CurveKind> contours, edges;
    std::set<HomotopyKind> homotopies;
    for (const auto& [name, file] : examples()) {
        for (const auto& contour : file.graph.contours) contours.insert(contour.curve.kind);
        for (const auto& edge : file.graph.edges) {
            edges.insert(edge.curve.kind);
            homotopies.insert(edge.homotopy.kind);
        }
    }
    EXPECT_EQ(contours.size(), 6u);
    EXPECT_EQ(edges.size(), 3u);
    EXPECT_EQ(homotopies.size(), 6u);
}

TEST(GraphExamples, the_two_tori_have_one_reeb_graph_and_two_shapes) {
    const auto all = examples();
    const auto &torus = all.at("torus").graph, &distorted = all.at("torus_distorted").graph;
    ASSERT_EQ(torus.edges.size(), distorted.edges.size());
    for (std::size_t e = 0; e < torus.edges.size(); ++e) {
        EXPECT_EQ(torus.edges[e].from, distorted.edges[e].from);
        EXPECT_EQ(torus.edges[e].to, distorted.edges[e].to);
        EXPECT_NE(torus.edges[e].curve, distorted.edges[e].curve) << e;
    }
    EXPECT_NE(torus.contours, distorted.contours);
    EXPECT_EQ(degrees(torus), degrees(all.at("tilted_ring").graph));
    EXPECT_EQ(loops_of(all.at("double_torus").graph), 2u);
}

bool is_level(const SampledContour& contour) {
    return std::ranges::all_of(contour.points,
                               [&](const Point3& p) { return std::abs(p.z - contour.points[0].z) < 1e-9; });
}

//! The contours of one edge between its lowest and its highest; nothing if some are tilted.
std::optional<SlidingHomotopy> surface_of(const EnhancedReebGraph& graph, const EnhancedEdge& edge) {
    std::vector<SampledContour> contours;
    std::vector<double> heights;
    for (const std::uint32_t c : edge.contours) {
        contours.push_back(sample_contour(graph.contours[c].curve, 64));
        if (!is_level(contours.back())) return std::nullopt;
        heights.push_back(contours.back().points[0].z);
    }
    if (contours.size() < 2) return std::nullopt;
    return SlidingHomotopy(
        ContourHomotopy(corresponding_contours(std::move(contours)), heights, edge.homotopy),
        MonotoneEdge(curve_of(graph, edge)));
}

//! What must hold for a surface without self-intersection to come of a graph.
TEST(GraphExamples, no_contour_between_the_given_ones_crosses_another) {
    std::size_t compared = 0;
    for (const auto& [name, file] : examples()) {
        std::vector<std::optional<SlidingHomotopy>> surfaces;
        for (const EnhancedEdge& edge : file.graph.edges) surfaces.push_back(surface_of(file.graph, edge));
        for (int step = 0; step < 240; ++step) {
            const double z = 0.05 * step + 0.0123;
            std::vector<std::vector<Point2>> rings;
            for (const auto& surface : surfaces) {
                if (!surface) continue;
                const auto& heights = surface->homotopy().levels();
                if (z <= heights.front() || z >= heights.back()) continue;
                const HomotopyPlace place = homotopy_place(heights, z);
                auto& ring = rings.emplace_back();
                for (const Point3& p : surface->contour(place.interval, place.t).points)
                    ring.push_back({p.x, p.y});
            }
            compared += rings.size() > 1;
            for (const auto& crossing : ring_crossings(rings, {.most = 1}))
                ADD_FAILURE() << name << " at z = " << z << " near " << crossing.place.x << ", "
                              << crossing.place.y;
        }
    }
    EXPECT_GT(compared, 200u);
}

TEST(GraphExamples, the_page_on_the_format_shows_a_sound_graph) {
    const std::string page = content_of(STRATAREEB_SOURCE_DIR "/docs/graph_format.md");
    const std::string fence = "```json\n";
    const auto from = page.find(fence);
    ASSERT_NE(from, std::string::npos);
    const auto to = page.find("```", from + fence.size());
    const std::string text = page.substr(from + fence.size(), to - from - fence.size());
    const auto file = parse_enhanced_graph(text, "graph_format.md");
    EXPECT_EQ(file.graph.edges.size(), 3u);
    EXPECT_EQ(parse_enhanced_graph(enhanced_graph_text(file.graph), "again").graph, file.graph);
}

}  // namespace
}  // namespace stratareeb
