// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/reeb_graph.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "mesh/soup_topology.h"
#include "reeb/strand_walk.h"
#include "reeb/vertex_descent.h"
#include "reeb/vertex_link.h"
#include "reeb/vertex_order.h"

namespace stratareeb {

namespace {

constexpr std::uint32_t kNone = ReebGraph::kNone;

//! What became of an arc's contours when it ended: they are those of the arc they merged into, or, where one was split, of
//! the arc of the piece that was not walked.
class ArcSuccessors {
 public:
    void add_arc() { next_.push_back(static_cast<std::uint32_t>(next_.size())); }
    void set(std::uint32_t arc, std::uint32_t successor) { next_[arc] = successor; }
    std::uint32_t last(std::uint32_t arc) {
        while (next_[arc] != arc) arc = next_[arc] = next_[next_[arc]];
        return arc;
    }

 private:
    std::vector<std::uint32_t> next_;
};

class Sweep {
 public:
    Sweep(const TriMesh& mesh, const ScalarField& field)
        : mesh_(mesh),
          field_(field),
          order_(vertex_order(field)),
          descent_(vertex_descent(mesh, order_)),
          arc_at_(field.size(), kNone),
          fan_arc_(descent_.fan_below.size(), kNone),
          walk_(mesh, order_.rank) {}

    ReebGraph run() {
        for (std::uint32_t rank = 0; rank < arc_at_.size(); ++rank)
            if (descent_.is_critical(rank))
                visit_critical(rank);
            else
                arc_at_[rank] = successors_.last(arc_below(arc_at_[rank], descent_.below[rank]));
        count_components();
        fill_vertex_arcs();
        fill_triangle_arcs();
        return std::move(graph_);
    }

 private:
    //! The arc of an edge's contour: as a walk has set it, or that of the edge's lower end.
    std::uint32_t arc_below(std::uint32_t set, std::uint32_t lower_end) const {
        return set == kNone ? arc_at_[lower_end] : set;
    }

    void visit_critical(std::uint32_t rank) {
        const CriticalLink& critical = descent_.critical_at(rank);
        lower_.clear();
        for (std::uint32_t f = critical.first_fan; f < critical.first_fan + critical.fans; ++f) {
            fan_arc_[f] = successors_.last(arc_below(fan_arc_[f], descent_.fan_below[f]));
            if (std::ranges::find(lower_, fan_arc_[f]) == lower_.end()) lower_.push_back(fan_arc_[f]);
        }
        const std::uint32_t groups = group_strands(critical);
        count_hidden_loops(critical, groups);
        if (lower_.size() == 1 && groups == 1) {
            arc_at_[rank] = lower_[0];
            ends_[lower_[0]] = ends_above(critical);
        } else {
            make_node(rank, critical, groups);
        }
    }

    //! The number of contours that leave a vertex upwards.
    std::uint32_t group_strands(const CriticalLink& critical) {
        if (critical.strands < 2) return critical.strands;
        // Contours that all differ, at most one of them open, become one. Open ones exchange their ends instead.
        const auto open = std::ranges::count_if(lower_, [&](std::uint32_t arc) { return ends_[arc] > 0; });
        if (lower_.size() == critical.fans && open < 2 && !critical.is_on_boundary()) return 1;
        read_link(mesh_, order_.rank, critical.vertex, link_);
        return static_cast<std::uint32_t>(walk_.group_strands(link_));
    }

    //! Ends on the boundary of all contours that leave a vertex upwards together.
    std::uint32_t ends_above(const CriticalLink& critical) const {
        std::uint32_t ends = 0;
        for (const std::uint32_t arc : lower_) ends += ends_[arc];
        return ends + critical.ends_above - critical.ends_below;
    }

    //! A saddle of multiplicity m is m simple saddles at one place. Parted, they would form a piece of graph with m nodes of
    //! degree three and d + u ends, whose cycles number 1 + (m - d - u) / 2.
    void count_hidden_loops(const CriticalLink& critical, std::uint32_t groups) {
        if (descent_.has_boundary || lower_.empty() || groups == 0) return;
        graph_.hidden_loops += (critical.fans + 1 - lower_.size() - groups) / 2;
    }

    void make_node(std::uint32_t rank, const CriticalLink& critical, std::uint32_t groups) {
        const auto node = static_cast<std::uint32_t>(graph_.nodes.size());
        const auto type = lower_.empty() ? CriticalType::Minimum
                          : groups == 0  ? CriticalType::Maximum
                                         : CriticalType::Saddle;
        graph_.nodes.push_back({critical.vertex, field_[critical.vertex], type,
                                static_cast<std::uint32_t>(lower_.size()), groups});
        for (std::uint32_t f = critical.first_fan + critical.fans; f-- > critical.first_fan;) {
            ReebArc& arc = graph_.arcs[fan_arc_[f]];
            arc.upper = node;
            arc.below_top = order_.vertices[descent_.fan_below[f]];
            arc.top = critical.vertex;
        }
        const auto first_arc = static_cast<std::uint32_t>(graph_.arcs.size());
        for (std::uint32_t group = 0; group < groups; ++group) {
            graph_.arcs.push_back({node, node});
            successors_.add_arc();
            ends_.push_back(0);
        }
        if (groups == 0) {
            arc_at_[rank] = lower_.empty() ? kNone : lower_[0];
            return;
        }
        // Whatever is not told otherwise goes on with the contour that was not walked to its end.
        const std::uint32_t kept = groups > 1 ? walk_.unfinished_group() : 0;
        arc_at_[rank] = first_arc + kept;
        for (const std::uint32_t arc : lower_) successors_.set(arc, first_arc + kept);
        std::uint32_t ends = ends_above(critical);
        for (std::uint32_t group = 0; group < groups; ++group) {
            if (group == kept) continue;
            name_edges(group, first_arc + group);
            ends_[first_arc + group] = walk_.ends_of(group);
            ends -= walk_.ends_of(group);
        }
        ends_[first_arc + kept] = ends;
    }

    void name_edges(std::uint32_t group, std::uint32_t arc) {
        walk_.for_edges_of(group, [&](TriMesh::HalfedgeHandle h) { name_edge(h, arc); });
        for (std::size_t s = 0; s < link_.strands.size(); ++s)
            if (walk_.group_of(s) == group)
                for (const auto h : link_.edges_of(link_.strands[s])) name_edge(h, arc);
    }

    //! Vertices ask for the contour of one edge below, or of one in each lower fan; of other edges nobody asks.
    void name_edge(TriMesh::HalfedgeHandle h, std::uint32_t arc) {
        const auto rank_of = [&](auto v) { return order_.rank[static_cast<std::size_t>(v.idx())]; };
        const auto [low, high] =
            std::minmax({rank_of(mesh_.from_vertex_handle(h)), rank_of(mesh_.to_vertex_handle(h))});
        if (descent_.below[high] == low) {
            arc_at_[high] = arc;
        } else if (descent_.is_critical(high)) {
            const CriticalLink& critical = descent_.critical_at(high);
            for (std::uint32_t f = critical.first_fan; f < critical.first_fan + critical.fans; ++f)
                if (descent_.fan_below[f] == low) fan_arc_[f] = arc;
        }
    }

    void count_components() {
        DisjointSets pieces(graph_.nodes.size());
        graph_.components = graph_.nodes.size();
        for (const ReebArc& arc : graph_.arcs) {
            if (pieces.find(arc.lower) == pieces.find(arc.upper)) continue;
            pieces.unite(arc.lower, arc.upper);
            --graph_.components;
        }
    }

    void fill_vertex_arcs() {
        graph_.vertex_arc.resize(arc_at_.size());
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, arc_at_.size(), 1 << 14),
                          [&](const auto& range) {
                              for (std::size_t v = range.begin(); v < range.end(); ++v)
                                  graph_.vertex_arc[v] = arc_at_[order_.rank[v]];
                          });
    }

    //! Just below its middle vertex, a triangle is crossed by that vertex's contour; at a critical vertex, by that of the fan.
    void fill_triangle_arcs() {
        graph_.triangle_arc.resize(mesh_.n_faces());
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh_.n_faces(), 1 << 14),
                          [&](const auto& range) {
                              for (std::size_t f = range.begin(); f < range.end(); ++f)
                                  graph_.triangle_arc[f] = arc_at_[middle_rank(f)];
                          });
        for (const CriticalLink& critical : descent_.critical) {
            if (critical.fans == 0 || critical.strands == 0) continue;  // the middle of no triangle
            read_link(mesh_, order_.rank, critical.vertex, link_);
            for (std::uint32_t i = 0; i < critical.fans; ++i)
                name_side_triangles(link_.lower_fans[i], fan_arc_[critical.first_fan + i]);
        }
    }

    std::uint32_t middle_rank(std::size_t face) const {
        auto h = mesh_.halfedge_handle(TriMesh::FaceHandle(static_cast<int>(face)));
        std::array<std::uint32_t, 3> rank{};
        for (auto& r : rank) {
            r = order_.rank[static_cast<std::size_t>(mesh_.to_vertex_handle(h).idx())];
            h = mesh_.next_halfedge_handle(h);
        }
        return std::max(std::min(rank[0], rank[1]), std::min(std::max(rank[0], rank[1]), rank[2]));
    }

    //! The triangles at either side of a fan, between a neighbour below and one above.
    void name_side_triangles(const LowerFan& fan, std::uint32_t arc) {
        const auto edges = link_.edges_of(fan);
        const auto before = mesh_.face_handle(edges.front()),
                   after = mesh_.face_handle(mesh_.opposite_halfedge_handle(edges.back()));
        for (const auto face : {before, after})
            if (face.is_valid()) graph_.triangle_arc[static_cast<std::size_t>(face.idx())] = arc;
    }

    const TriMesh& mesh_;
    const ScalarField& field_;
    const VertexOrder order_;
    const VertexDescent descent_;
    std::vector<std::uint32_t>
        arc_at_;  // by rank: of the contour through the vertex; before its visit, if set, of the
                  // edge below it
    std::vector<std::uint32_t> fan_arc_;  // the same for each lower fan of critical vertices
    StrandWalk walk_;
    ArcSuccessors successors_;
    VertexLink link_;
    std::vector<std::uint32_t> ends_;   // by arc: how often its contour ends on the boundary, twice or never
    std::vector<std::uint32_t> lower_;  // arcs that end at the vertex being visited
    ReebGraph graph_;
};

}  // namespace

ReebGraph reeb_graph(const TriMesh& mesh, const ScalarField& field) {
    check_field(mesh, field);
    return Sweep(mesh, field).run();
}

}  // namespace stratareeb
