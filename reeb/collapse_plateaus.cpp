// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/collapse_plateaus.h"

#include <utility>

#include "mesh/soup_topology.h"

namespace stratareeb {

namespace {

constexpr std::uint32_t kNone = ReebGraph::kNone;

class Collapse {
 public:
    explicit Collapse(const ReebGraph& graph)
        : graph_(graph), plateaus_(graph.nodes.size()), arc_(graph.arcs.size(), kNone) {
        arcs_down_.resize(graph.nodes.size());
        arcs_up_.resize(graph.nodes.size());
    }

    ReebGraph run() {
        for (const ReebArc& arc : graph_.arcs)
            if (is_level(arc)) plateaus_.unite(arc.lower, arc.upper);
        for (std::uint32_t a = 0; a < graph_.arcs.size(); ++a) {
            const ReebArc& arc = graph_.arcs[a];
            if (is_level(arc)) continue;
            arcs_up_[root(arc.lower)].push_back(a);
            arcs_down_[root(arc.upper)].push_back(a);
        }
        make_nodes();
        make_arcs();
        result_.vertex_arc = renamed(graph_.vertex_arc);
        result_.triangle_arc = renamed(graph_.triangle_arc);
        result_.components = graph_.components;
        result_.hidden_loops = 0;
        result_.hidden_loops = graph_.loops() - result_.loops();
        return std::move(result_);
    }

 private:
    bool is_level(const ReebArc& arc) const {
        return graph_.nodes[arc.lower].value == graph_.nodes[arc.upper].value;
    }

    //! The lowest node of a plateau stands for it.
    std::uint32_t root(std::uint32_t node) { return plateaus_.find(node); }

    bool is_passed(std::uint32_t node) const {
        return arcs_down_[node].size() == 1 && arcs_up_[node].size() == 1;
    }

    void make_nodes() {
        new_node_.assign(graph_.nodes.size(), kNone);
        for (std::uint32_t n = 0; n < graph_.nodes.size(); ++n) {
            if (root(n) != n || is_passed(n)) continue;
            new_node_[n] = static_cast<std::uint32_t>(result_.nodes.size());
            ReebNode node = graph_.nodes[n];
            node.down = static_cast<std::uint32_t>(arcs_down_[n].size());
            node.up = static_cast<std::uint32_t>(arcs_up_[n].size());
            node.type = node.down == 0 ? CriticalType::Minimum
                        : node.up == 0 ? CriticalType::Maximum
                                       : CriticalType::Saddle;
            result_.nodes.push_back(node);
        }
    }

    //! From each node up, through what is no node any more.
    void make_arcs() {
        for (std::uint32_t n = 0; n < graph_.nodes.size(); ++n) {
            if (new_node_[n] == kNone) continue;
            for (const std::uint32_t first : arcs_up_[n]) {
                const auto made = static_cast<std::uint32_t>(result_.arcs.size());
                std::uint32_t last = first;
                arc_[last] = made;
                while (new_node_[end_of(last)] == kNone) {
                    last = arcs_up_[end_of(last)].front();
                    arc_[last] = made;
                }
                ReebArc arc = graph_.arcs[last];
                arc.lower = new_node_[n];
                arc.upper = new_node_[end_of(last)];
                result_.arcs.push_back(arc);
            }
        }
    }

    std::uint32_t end_of(std::uint32_t arc) { return root(graph_.arcs[arc].upper); }

    std::vector<std::uint32_t> renamed(const std::vector<std::uint32_t>& arcs) {
        std::vector<std::uint32_t> to(graph_.arcs.size());
        for (std::uint32_t a = 0; a < to.size(); ++a) {
            const std::uint32_t node = root(graph_.arcs[a].lower);
            to[a] = !is_level(graph_.arcs[a])   ? arc_[a]
                    : !arcs_up_[node].empty()   ? arc_[arcs_up_[node].front()]
                    : !arcs_down_[node].empty() ? arc_[arcs_down_[node].front()]
                                                : kNone;
        }
        std::vector<std::uint32_t> result(arcs.size(), kNone);
        for (std::size_t i = 0; i < arcs.size(); ++i)
            if (arcs[i] != kNone) result[i] = to[arcs[i]];
        return result;
    }

    const ReebGraph& graph_;
    DisjointSets plateaus_;  // of nodes
    std::vector<std::uint32_t> new_node_;
    std::vector<std::uint32_t> arc_;  // new arc of each old one that is not level
    std::vector<std::vector<std::uint32_t>> arcs_down_, arcs_up_;
    ReebGraph result_;
};

}  // namespace

ReebGraph collapse_plateaus(const ReebGraph& graph) {
    return Collapse(graph).run();
}

}  // namespace stratareeb
