// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/tri_mesh.h"
#include "reeb/reeb_graph.h"

namespace stratareeb {

//! Which way from a node: to its arcs down, or up. Of an arc: its lower or upper end.
enum Side : std::uint8_t { Down, Up };

inline Side opposite(Side side) {
    return side == Down ? Up : Down;
}

//! A Reeb graph while it is simplified: arcs are glued, equal values to equal values, or taken away. Nodes keep their numbers,
//! and with them their order. Each change takes constant time.
class FoldedGraph {
 public:
    static constexpr std::uint32_t kNone = ReebGraph::kNone;

    //! \param field outlives this and fits the graph's vertices.
    FoldedGraph(const ReebGraph& graph, const ScalarField& field);

    std::uint32_t node_count() const { return static_cast<std::uint32_t>(nodes_.size()); }
    bool is_node(std::uint32_t node) const { return nodes_[node].alive; }
    double value(std::uint32_t node) const { return graph_.nodes[node].value; }
    double persistence(std::uint32_t a, std::uint32_t b) const;
    const std::vector<std::uint32_t>& arcs(std::uint32_t node, Side side) const {
        return nodes_[node].arcs[side];
    }
    std::uint32_t end(std::uint32_t arc, Side side) const { return arcs_[arc].end[side]; }

    //! Where two arcs that were closed up from a node part again.
    struct Fork {
        std::uint32_t node = kNone;    // the nearer one of their ends
        std::uint32_t nearer = kNone;  // the arc that ended there, and now is both
        std::uint32_t rest =
            kNone;  // what is left of the other one, from that node on; none if both ended there
    };

    //! Glue two arcs on one side of a node, from there to the nearer one of their ends on that side.
    Fork zip(std::uint32_t a, std::uint32_t b, Side side);

    //! Hang an arc on a node farther along one side, nearer than its end there. What lay on it up to that node goes to an arc at
    //! the root it hung on before, given as well.
    void slide(std::uint32_t arc, std::uint32_t node, std::uint32_t root_arc, Side side);

    //! Take away an arc with the node at its end on that side, which has no other arc. What lay on it goes to the first arc left
    //! on that side of the root, or else on the other.
    void prune(std::uint32_t arc, Side side);

    //! Make one arc of two if the node has just one down and one up.
    void tidy(std::uint32_t node);

    //! The graph as it is now, with the arc of each vertex and, if a mesh is given, of each triangle.
    ReebGraph result(const TriMesh* mesh = nullptr);

    //! Nodes and arcs alone.
    ReebGraph skeleton(std::vector<std::uint32_t>& old_nodes) const;

 private:
    struct Node {
        bool alive = true;
        std::array<std::vector<std::uint32_t>, 2> arcs;
    };
    struct Cut {
        std::uint32_t node, arc;     // what was beyond the node belongs to that arc now
        std::uint32_t root = kNone;  // or rather to the arc's place at this node
    };
    struct Arc {
        std::array<std::uint32_t, 2> end;
        std::array<std::uint32_t, 2> slot;  // in the arcs of each end
        std::uint32_t next = kNone;         // the arc that has taken this one's place
        std::uint32_t root = kNone;         // of a pruned arc: the node it hung on
        std::uint32_t below_top = 0, top = 0;
        std::array<std::vector<Cut>, 2> cuts{};  // at each end, outermost first
    };

    std::uint32_t add_arc(const ReebArc& arc);
    void attach(std::uint32_t arc, Side end);
    void detach(std::uint32_t arc, Side end);
    bool is_alive(std::uint32_t arc) const { return arcs_[arc].next == kNone; }
    bool is_beyond(std::uint32_t vertex, std::uint32_t node, Side side) const;
    const Cut* cut_that_took(std::uint32_t vertex, const Arc& arc) const;
    std::uint32_t skip_plain(std::uint32_t arc);
    std::uint32_t arc_now(std::uint32_t arc, std::uint32_t vertex);
    std::vector<std::uint32_t> arcs_in_order() const;
    void fill_triangle_arcs(const TriMesh& mesh, const std::vector<std::uint32_t>& number, ReebGraph& to);

    const ReebGraph& graph_;
    const ScalarField& field_;
    std::vector<Node> nodes_;
    std::vector<Arc> arcs_;
};

}  // namespace stratareeb
