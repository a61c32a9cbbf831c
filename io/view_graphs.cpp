// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/view_graphs.h"

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "io/graph_columns.h"
#include "reeb/arc_curves.h"
#include "reeb/arc_members.h"
#include "reeb/layered_reeb_graph.h"
#include "reeb/readable_graph.h"

namespace stratareeb {

namespace {

using nlohmann::json;

// Shares of the height below which features of the layered graph are left out, tried in turn.
constexpr std::array<double, 7> kShares{0, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2};

struct Layer {
    std::size_t index = 0;
    TriMesh solid;
    ScalarField height;
    ReebGraph fine, graph;
    double share = 0;
};

std::size_t triangles_over(const LayerModel& model, std::size_t layer) {
    std::size_t count = 0;
    for (const LayerSet& layers : model.regions.in_face) count += layers[layer];
    return count;
}

json numbers(const Point3& p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

const char* type_name(CriticalType type) {
    return type == CriticalType::Minimum ? "minimum" : type == CriticalType::Saddle ? "saddle" : "maximum";
}

//! Arcs of a solid's triangles, tops and bases (which alternate in the solid) first, as pairs of arc + 1 and run length.
std::vector<std::uint32_t> arc_runs(const ReebGraph& graph, std::size_t plan_triangles) {
    std::vector<std::uint32_t> runs;
    const auto take = [&](std::size_t face) {
        const std::uint32_t arc = graph.triangle_arc[face] + 1;  // kNone becomes 0
        if (runs.empty() || runs[runs.size() - 2] != arc) runs.insert(runs.end(), {arc, 0});
        ++runs.back();
    };
    for (std::size_t i = 0; i < plan_triangles; ++i) take(2 * i);
    for (std::size_t i = 0; i < plan_triangles; ++i) take(2 * i + 1);
    for (std::size_t i = 2 * plan_triangles; i < graph.triangle_arc.size(); ++i) take(i);
    return runs;
}

json graph_json(const Layer& layer, std::size_t plan_triangles, ViewStreams& streams) {
    const ReebGraph& graph = layer.graph;
    const ArcIndex index(layer.solid, layer.height, layer.fine);
    const auto curves =
        coarse_arc_curves(layer.solid, layer.fine, index, graph, arc_members(layer.fine, graph));
    std::vector<double> preferred;
    for (const auto& curve : curves) preferred.push_back(curve[curve.size() / 2].x);
    const GraphColumns columns = graph_columns(graph, preferred);
    json nodes = json::array(), arcs = json::array();
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        const auto& p = layer.solid.point(TriMesh::VertexHandle(static_cast<int>(graph.nodes[i].vertex)));
        nodes.push_back({{"at", numbers({p[0], p[1], p[2]})},
                         {"type", type_name(graph.nodes[i].type)},
                         {"column", static_cast<float>(columns.node_x[i])}});
    }
    for (std::size_t i = 0; i < graph.arcs.size(); ++i) {
        json curve = json::array();
        for (const Point3& p : curves[i]) curve.push_back(numbers(p));
        arcs.push_back({{"from", graph.arcs[i].lower},
                        {"to", graph.arcs[i].upper},
                        {"column", static_cast<float>(columns.arc_x[i])},
                        {"curve", std::move(curve)}});
    }
    return {{"layer", layer.index},
            {"share", layer.share},
            {"nodes", std::move(nodes)},
            {"arcs", std::move(arcs)},
            {"loops", graph.loops()},
            {"width", static_cast<float>(columns.width)},
            {"runs", streams.add(arc_runs(graph, plan_triangles))}};
}

json layered_json(const std::vector<Layer>& layers, std::size_t most_nodes) {
    std::vector<LayerSurface> surfaces;
    for (const Layer& layer : layers) surfaces.push_back({&layer.solid, &layer.height});
    LayeredReebGraph graph;
    double used = 0;
    for (const double share : kShares) {
        graph = layered_reeb_graph(surfaces, {.simplify = share, .further_levels = {}});
        used = share;
        if (graph.nodes.size() <= most_nodes) break;
    }
    json nodes = json::array(), arcs = json::array();
    for (const LayeredNode& node : graph.nodes) {
        json members = json::array();
        for (const LayerContour& contour : node.contours) {
            const std::size_t layer = layers[contour.layer].index;
            if (members.empty() || members.back() != layer) members.push_back(layer);
        }
        nodes.push_back(
            {{"z", node.value}, {"center", numbers(node.center)}, {"layers", std::move(members)}});
    }
    for (const LayeredArc& arc : graph.arcs)
        arcs.push_back({{"from", arc.lower}, {"to", arc.upper}, {"layer", layers[arc.layer].index}});
    return {{"share", used}, {"nodes", std::move(nodes)}, {"arcs", std::move(arcs)}};
}

}  // namespace

json view_graphs(const LayerModel& model, ViewStreams& streams, const ViewGraphOptions& options) {
    std::vector<Layer> layers;
    json list = json::array();
    for (std::size_t i = 0; i < model.units.size(); ++i) {
        const std::size_t triangles = triangles_over(model, i);
        if (triangles == 0) continue;
        Layer& layer = layers.emplace_back();
        layer.index = i;
        layer.solid = build_layer_solid(model, i).surface;
        layer.height = height_field(layer.solid);
        ReadableGraph readable = readable_graph(layer.solid, layer.height, options.most_nodes);
        layer.fine = std::move(readable.fine);
        layer.graph = std::move(readable.graph);
        layer.share = readable.share;
        list.push_back(graph_json(layer, triangles, streams));
    }
    return {{"layers", std::move(list)}, {"layered", layered_json(layers, options.most_nodes)}};
}

}  // namespace stratareeb
