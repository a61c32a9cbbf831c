// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/sweep_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "boreholes/errors.h"
#include "mesh/soup_topology.h"

namespace stratareeb {

namespace {

constexpr std::uint32_t kNone = ReebGraph::kNone;

class Sweep {
 public:
    Sweep(const TriMesh& mesh, const ScalarField& field, const ReebGraph& graph)
        : mesh_(mesh), field_(field), graph_(graph), plateaus_(graph.nodes.size()) {}

    SweepGraph run() {
        gather_plateaus();
        attach_level_triangles();
        cut_arcs();
        drop_passed();
        sort_nodes();
        return std::move(result_);
    }

 private:
    bool is_level(const ReebArc& arc) const {
        return graph_.nodes[arc.lower].value == graph_.nodes[arc.upper].value;
    }

    //! A node for each plateau, which may be a single vertex.
    void gather_plateaus() {
        for (const ReebArc& arc : graph_.arcs)
            if (is_level(arc)) plateaus_.unite(arc.lower, arc.upper);
        node_.assign(graph_.nodes.size(), kNone);
        for (std::uint32_t n = 0; n < graph_.nodes.size(); ++n) {
            const std::uint32_t root = plateaus_.find(n);
            if (root == n) {
                node_[n] = add_node(graph_.nodes[n].vertex);
            } else {
                node_[n] = node_[root];
                result_.nodes[node_[n]].is_plateau = true;
            }
        }
    }

    std::uint32_t add_node(std::uint32_t vertex) {
        result_.nodes.push_back({.vertex = vertex,
                                 .value = field_[vertex],
                                 .down = {},
                                 .up = {},
                                 .level_triangles = {},
                                 .is_plateau = false});
        return static_cast<std::uint32_t>(result_.nodes.size() - 1);
    }

    std::array<std::uint32_t, 3> corners(TriMesh::FaceHandle face) const {
        std::array<std::uint32_t, 3> vertices{};
        std::size_t i = 0;
        for (const auto v : mesh_.fv_range(face)) vertices[i++] = static_cast<std::uint32_t>(v.idx());
        return vertices;
    }

    //! Those inside an arc get a node of their own, one for each level contour that has any.
    void attach_level_triangles() {
        for (const auto face : mesh_.faces()) {
            const auto [a, b, c] = corners(face);
            const double value = field_[a];
            if (field_[b] != value || field_[c] != value) continue;
            const auto f = static_cast<std::uint32_t>(face.idx());
            result_.nodes[node_of(graph_.triangle_arc[f], value, std::min({a, b, c}))]
                .level_triangles.push_back(f);
        }
    }

    std::uint32_t node_of(std::uint32_t a, double value, std::uint32_t vertex) {
        const ReebArc& arc = graph_.arcs[a];
        if (graph_.nodes[arc.lower].value == value) return node_[arc.lower];
        if (graph_.nodes[arc.upper].value == value) return node_[arc.upper];
        const auto [at, is_new] = cuts_[a].try_emplace(value, kNone);
        if (is_new) at->second = add_node(vertex);
        return at->second;
    }

    void cut_arcs() {
        for (std::uint32_t a = 0; a < graph_.arcs.size(); ++a) {
            const ReebArc& arc = graph_.arcs[a];
            if (is_level(arc)) continue;
            std::uint32_t from = node_[arc.lower];
            const auto cuts = cuts_.find(a);
            if (cuts != cuts_.end())
                for (const auto& [value, node] : cuts->second) {
                    add_edge(a, from, node);
                    from = node;
                }
            add_edge(a, from, node_[arc.upper]);
        }
        for (const SweepNode& node : result_.nodes)
            if (node.down.empty() && node.up.empty()) refuse_level_component(node);
    }

    [[noreturn]] void refuse_level_component(const SweepNode& node) const {
        const auto& p = mesh_.point(TriMesh::VertexHandle(static_cast<int>(node.vertex)));
        throw InvalidInput(
            fmt::format("a part of the mesh at ({:.7g}, {:.7g}, {:.7g}) is level as a whole, so it has no "
                        "contours; turn the mesh",
                        p[0], p[1], p[2]));
    }

    void add_edge(std::uint32_t arc, std::uint32_t from, std::uint32_t to) {
        const auto e = static_cast<std::uint32_t>(result_.edges.size());
        result_.edges.push_back({from, to, {{arc, result_.nodes[from].value, result_.nodes[to].value}}});
        result_.nodes[from].up.push_back(e);
        result_.nodes[to].down.push_back(e);
    }

    static bool is_passed(const SweepNode& node) {
        return node.down.size() == 1 && node.up.size() == 1 && node.level_triangles.empty();
    }

    //! The edge above takes over that below.
    void drop_passed() {
        std::vector<bool> is_dropped(result_.edges.size(), false);
        for (const auto& node : result_.nodes) {
            if (!is_passed(node)) continue;
            const std::uint32_t low = node.down.front(), high = node.up.front();
            SweepEdge &below = result_.edges[low], &above = result_.edges[high];
            above.segments.insert(above.segments.begin(), below.segments.begin(), below.segments.end());
            above.lower = below.lower;
            std::ranges::replace(result_.nodes[above.lower].up, low, high);
            is_dropped[low] = true;
        }
        std::vector<SweepEdge> edges;
        for (std::size_t e = 0; e < is_dropped.size(); ++e)
            if (!is_dropped[e]) edges.push_back(std::move(result_.edges[e]));
        result_.edges = std::move(edges);
    }

    void sort_nodes() {
        std::vector<SweepNode> nodes;
        std::vector<std::uint32_t> order, number(result_.nodes.size(), kNone);
        for (std::uint32_t n = 0; n < result_.nodes.size(); ++n)
            if (!is_passed(result_.nodes[n])) order.push_back(n);
        std::ranges::stable_sort(order, {}, [&](std::uint32_t n) { return result_.nodes[n].value; });
        for (const std::uint32_t n : order) {
            number[n] = static_cast<std::uint32_t>(nodes.size());
            nodes.push_back(std::move(result_.nodes[n]));
            nodes.back().down.clear();
            nodes.back().up.clear();
        }
        result_.nodes = std::move(nodes);
        for (SweepEdge& edge : result_.edges) {
            edge.lower = number[edge.lower];
            edge.upper = number[edge.upper];
        }
        std::ranges::stable_sort(result_.edges, {}, &SweepEdge::lower);
        for (std::uint32_t e = 0; e < result_.edges.size(); ++e) {
            result_.nodes[result_.edges[e].lower].up.push_back(e);
            result_.nodes[result_.edges[e].upper].down.push_back(e);
        }
    }

    const TriMesh& mesh_;
    const ScalarField& field_;
    const ReebGraph& graph_;
    DisjointSets plateaus_;
    std::vector<std::uint32_t> node_;                                // of each node of the Reeb graph
    std::map<std::uint32_t, std::map<double, std::uint32_t>> cuts_;  // arc -> value -> node
    SweepGraph result_;
};

}  // namespace

SweepGraph sweep_graph(const TriMesh& mesh, const ScalarField& field, const ReebGraph& graph) {
    return Sweep(mesh, field, graph).run();
}

}  // namespace stratareeb
