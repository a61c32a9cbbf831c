// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/layered_reeb_graph.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "reeb/arc_curves.h"
#include "reeb/arc_index.h"
#include "reeb/collapse_plateaus.h"
#include "reeb/simplify.h"

namespace stratareeb {

namespace {

//! What is asked of one layer: its critical values and its contours at any.
class Layer {
 public:
    Layer(const LayerSurface& surface, std::uint32_t number, double simplify_share)
        : number_(number),
          mesh_(*surface.mesh),
          graph_(reeb_graph(mesh_, *surface.field)),
          kept_(collapse_plateaus(graph_)),
          index_(mesh_, *surface.field, graph_) {
        if (simplify_share > 0) kept_ = simplify(kept_, *surface.field, simplify_share).graph;
        arcs_down_.resize(graph_.nodes.size());
        for (std::uint32_t a = 0; a < graph_.arcs.size(); ++a) arcs_down_[graph_.arcs[a].upper].push_back(a);
    }

    void add_critical_values(std::vector<double>& values) const {
        for (const ReebNode& node : kept_.nodes) values.push_back(node.value);
    }

    void add_contours_at(double value, LayeredNode& node) const {
        for (const std::uint32_t arc : index_.arcs_at(value)) {
            Contour contour = index_.contour(arc, value);
            const Point3 center = center_of(contour);
            node.contours.push_back({number_, arc, std::move(contour), center});
        }
        for (const ReebNode& minimum : minima_at(value)) {
            const auto& p = mesh_.point(TriMesh::VertexHandle(static_cast<int>(minimum.vertex)));
            const Point3 point{p[0], p[1], p[2]};
            node.contours.push_back({number_, graph_.vertex_arc[minimum.vertex],
                                     Contour{.points = {point}, .closed = true}, point});
        }
    }

    //! Does any piece of the layer reach from one value up to another?
    bool spans(double low, double high) const {
        std::vector<std::uint32_t> arcs = index_.arcs_at(high);
        std::vector<bool> seen(graph_.nodes.size());
        while (!arcs.empty()) {
            const std::uint32_t node = graph_.arcs[arcs.back()].lower;
            arcs.pop_back();
            if (graph_.nodes[node].value <= low) return true;
            if (seen[node]) continue;
            seen[node] = true;
            arcs.insert(arcs.end(), arcs_down_[node].begin(), arcs_down_[node].end());
        }
        return false;
    }

 private:
    std::vector<ReebNode> minima_at(double value) const {
        std::vector<ReebNode> minima;
        const auto [first, last] = std::ranges::equal_range(kept_.nodes, value, {}, &ReebNode::value);
        std::copy_if(first, last, std::back_inserter(minima),
                     [](const ReebNode& node) { return node.down == 0; });
        return minima;
    }

    std::uint32_t number_;
    const TriMesh& mesh_;
    const ReebGraph graph_;
    ReebGraph kept_;  // plateaus as nodes, and simplified
    const ArcIndex index_;
    std::vector<std::vector<std::uint32_t>> arcs_down_;
};

Point3 common_center(const std::vector<LayerContour>& contours) {
    double weight = 0, total = 0;
    for (const LayerContour& piece : contours) total += piece.contour.length();
    Point3 sum{0, 0, 0};
    const Point3 origin = contours.front().center;
    for (const LayerContour& piece : contours) {
        const double w = total > 0 ? piece.contour.length() : 1;
        weight += w;
        sum.x += w * (piece.center.x - origin.x);
        sum.y += w * (piece.center.y - origin.y);
        sum.z += w * (piece.center.z - origin.z);
    }
    return {origin.x + sum.x / weight, origin.y + sum.y / weight, origin.z + sum.z / weight};
}

void add_arcs_of(const Layer& layer, std::uint32_t number, LayeredReebGraph& graph) {
    std::uint32_t before = ReebGraph::kNone;
    for (std::uint32_t n = 0; n < graph.nodes.size(); ++n) {
        const auto is_own = [&](const LayerContour& piece) { return piece.layer == number; };
        if (std::ranges::none_of(graph.nodes[n].contours, is_own)) continue;
        if (before != ReebGraph::kNone && layer.spans(graph.nodes[before].value, graph.nodes[n].value))
            graph.arcs.push_back({before, n, number});
        before = n;
    }
}

}  // namespace

LayeredReebGraph layered_reeb_graph(std::span<const LayerSurface> surfaces,
                                    const LayeredReebGraphOptions& options) {
    std::vector<std::unique_ptr<Layer>> layers;
    std::vector<double> values = options.further_levels;
    for (std::uint32_t k = 0; k < surfaces.size(); ++k) {
        layers.push_back(std::make_unique<Layer>(surfaces[k], k, options.simplify));
        layers.back()->add_critical_values(values);
    }
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());

    LayeredReebGraph graph;
    for (const double value : values) {
        LayeredNode node{.value = value, .center = {}, .contours = {}};
        for (const auto& layer : layers) layer->add_contours_at(value, node);
        if (node.contours.empty()) continue;
        node.center = common_center(node.contours);
        graph.nodes.push_back(std::move(node));
    }
    for (std::uint32_t k = 0; k < layers.size(); ++k) add_arcs_of(*layers[k], k, graph);
    return graph;
}

}  // namespace stratareeb
