// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/reeb_graph.h"

#include <algorithm>
#include <numeric>

#include "reeb/strand_walk.h"
#include "reeb/vertex_link.h"

namespace stratareeb {

namespace {

//! Names of contours, merged when contours merge. The arc of a name is that of its root.
class ContourNames {
 public:
    std::uint32_t fresh(std::uint32_t arc) {
        parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
        arc_.push_back(arc);
        return parent_.back();
    }
    std::uint32_t root(std::uint32_t name) {
        while (parent_[name] != name) name = parent_[name] = parent_[parent_[name]];
        return name;
    }
    void merge(std::uint32_t a, std::uint32_t b) { parent_[root(a)] = root(b); }
    std::uint32_t& arc(std::uint32_t name) { return arc_[root(name)]; }

 private:
    std::vector<std::uint32_t> parent_, arc_;
};

class Sweep {
 public:
    Sweep(const TriMesh& mesh, const ScalarField& field)
        : mesh_(mesh), field_(field), rank_(field.size()), name_(mesh.n_edges()), walk_(mesh, rank_) {
        order_.resize(field.size());
        std::iota(order_.begin(), order_.end(), 0u);
        std::ranges::sort(order_, [&](std::uint32_t a, std::uint32_t b) { return is_below(field, a, b); });
        for (std::uint32_t r = 0; r < order_.size(); ++r) rank_[order_[r]] = r;
        graph_.vertex_arc.assign(field.size(), ReebGraph::kNone);
        has_boundary_ = std::ranges::any_of(mesh.edges(), [&](auto e) { return mesh.is_boundary(e); });
    }

    ReebGraph run() {
        for (const std::uint32_t v : order_) visit(v);
        count_components();
        return std::move(graph_);
    }

 private:
    void visit(std::uint32_t v) {
        read_link(mesh_, rank_, v, link_);
        lower_.clear();
        for (const std::uint32_t edge : link_.lower_edges) {
            const std::uint32_t name = names_.root(name_[edge]);
            if (std::ranges::find(lower_, name) == lower_.end()) lower_.push_back(name);
        }
        if (lower_.size() == 1 && link_.strands.size() == 1) return pass(v, lower_[0]);

        // Closed contours that all differ become one. Open ones may exchange their ends instead, so on a mesh with boundary
        // that is looked at.
        const bool may_split = link_.strands.size() > 1 && !lower_.empty() &&
                               (lower_.size() < link_.lower_fans || has_boundary_);
        const std::size_t groups = link_.strands.empty() ? 0
                                   : may_split           ? walk_.group_strands(link_)
                                                         : walk_.one_group(link_);
        count_hidden_loops(groups);
        if (lower_.size() == 1 && groups == 1) return pass(v, lower_[0]);
        make_node(v, static_cast<std::uint32_t>(groups));
    }

    //! A saddle of multiplicity m is m simple saddles at one place. Parted, they would form a piece of graph with m nodes of
    //! degree three and d + u ends, whose cycles number 1 + (m - d - u) / 2.
    void count_hidden_loops(std::size_t groups) {
        if (has_boundary_ || lower_.empty() || groups == 0) return;
        graph_.hidden_loops += (link_.lower_fans + 1 - lower_.size() - groups) / 2;
    }

    //! A contour moves over v and stays what it is.
    void pass(std::uint32_t v, std::uint32_t name) {
        graph_.vertex_arc[v] = names_.arc(name);
        for (const Strand& strand : link_.strands)
            for (const std::uint32_t edge : strand.edges) name_[edge] = name;
    }

    void make_node(std::uint32_t v, std::uint32_t groups) {
        const auto node = static_cast<std::uint32_t>(graph_.nodes.size());
        const auto type = lower_.empty() ? CriticalType::Minimum
                          : groups == 0  ? CriticalType::Maximum
                                         : CriticalType::Saddle;
        graph_.nodes.push_back({v, field_[v], type, static_cast<std::uint32_t>(lower_.size()), groups});
        for (const std::uint32_t name : lower_) {
            graph_.arcs[names_.arc(name)].upper = node;
            graph_.vertex_arc[v] = names_.arc(name);
        }
        for (std::size_t i = 1; i < lower_.size(); ++i) names_.merge(lower_[i], lower_[0]);
        for (std::uint32_t group = 0; group < groups; ++group) start_arc(v, node, group);
    }

    //! The group whose walk was not finished keeps the name of the contours below; the others are named anew, edge by edge.
    void start_arc(std::uint32_t v, std::uint32_t node, std::uint32_t group) {
        const auto arc = static_cast<std::uint32_t>(graph_.arcs.size());
        graph_.arcs.push_back({node, node});
        graph_.vertex_arc[v] = arc;
        std::uint32_t name = 0;
        if (!lower_.empty() && group == walk_.unfinished_group()) {
            name = names_.root(lower_[0]);
            names_.arc(name) = arc;
        } else {
            name = names_.fresh(arc);
            for (const std::uint32_t edge : walk_.edges_of(group)) name_[edge] = name;
        }
        for (std::size_t s = 0; s < link_.strands.size(); ++s)
            if (walk_.group_of(s) == group)
                for (const std::uint32_t edge : link_.strands[s].edges) name_[edge] = name;
    }

    void count_components() {
        std::vector<std::uint32_t> parent(graph_.nodes.size());
        std::iota(parent.begin(), parent.end(), 0u);
        const auto root = [&](std::uint32_t n) {
            while (parent[n] != n) n = parent[n] = parent[parent[n]];
            return n;
        };
        graph_.components = graph_.nodes.size();
        for (const ReebArc& arc : graph_.arcs) {
            const auto a = root(arc.lower), b = root(arc.upper);
            if (a == b) continue;
            parent[a] = b;
            --graph_.components;
        }
    }

    const TriMesh& mesh_;
    const ScalarField& field_;
    std::vector<std::uint32_t> order_, rank_;
    std::vector<std::uint32_t> name_;  // by edge, of the contour that crosses it; set while it is crossed
    bool has_boundary_ = false;
    StrandWalk walk_;
    ContourNames names_;
    VertexLink link_;
    std::vector<std::uint32_t> lower_;  // names of the contours that end at the vertex being visited
    ReebGraph graph_;
};

}  // namespace

ReebGraph reeb_graph(const TriMesh& mesh, const ScalarField& field) {
    check_field(mesh, field);
    return Sweep(mesh, field).run();
}

}  // namespace stratareeb
