// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/simplify.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>

#include "boreholes/errors.h"
#include "reeb/close_loop.h"
#include "reeb/folded_graph.h"
#include "reeb/persistence.h"

namespace stratareeb {

namespace {

//! Cancels the branches that end on one side: minima for Down, maxima for Up. Nodes are met in order, away from that
//! side; pieces of the graph met so far are known by their eldest node (elder rule). When a branch is cancelled, those
//! within it already are: it has no other end, and the piece it joins has none that is younger. So any way along that
//! side leads to its end, or past it in the other piece. Glued along two such ways, nothing else changes: the ways meet
//! in the node, and beyond it were in different pieces.
class BranchPruner {
 public:
    BranchPruner(FoldedGraph& graph, Side side, double threshold)
        : graph_(graph), side_(side), threshold_(threshold), parent_(graph.node_count()) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }

    std::size_t run() {
        const std::uint32_t count = graph_.node_count();
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t node = side_ == Down ? i : count - 1 - i;
            if (graph_.is_node(node) && !graph_.arcs(node, side_).empty()) visit(node);
        }
        return cancelled_;
    }

 private:
    bool is_elder(std::uint32_t a, std::uint32_t b) const { return side_ == Down ? a < b : a > b; }

    std::uint32_t eldest(std::uint32_t n) {
        while (parent_[n] != n) n = parent_[n] = parent_[parent_[n]];
        return n;
    }

    void visit(std::uint32_t node) {
        pieces_.clear();
        for (const std::uint32_t arc : graph_.arcs(node, side_))
            pieces_.emplace_back(eldest(graph_.end(arc, side_)), arc);
        std::ranges::sort(pieces_, [&](const auto& a, const auto& b) {
            return a.first != b.first ? is_elder(a.first, b.first) : a.second < b.second;
        });
        std::uint32_t trunk = pieces_[0].second;
        const std::uint32_t elder = pieces_[0].first;
        parent_[node] = elder;
        for (std::size_t i = 1; i < pieces_.size(); ++i) {
            const auto [younger, branch] = pieces_[i];
            if (parent_[younger] == elder) continue;  // another arc of a piece that was seen
            parent_[younger] = elder;
            if (graph_.persistence(younger, node) >= threshold_) continue;
            trunk = cancel(branch, trunk, younger);
            ++cancelled_;
        }
        graph_.tidy(node);
    }

    //! Glue a branch to the trunk, from the node in which these two arcs meet, until only a leaf is left of it, which is pruned.
    //! \return the node's arc that is the trunk now.
    std::uint32_t cancel(std::uint32_t branch, std::uint32_t trunk, std::uint32_t tip) {
        std::uint32_t first = FoldedGraph::kNone;
        for (;;) {
            if (graph_.end(branch, side_) == tip && graph_.arcs(tip, opposite(side_)).size() == 1) {
                graph_.prune(branch, side_);
                return first == FoldedGraph::kNone ? trunk : first;
            }
            const std::uint32_t below = pass_nodes(branch, trunk);
            const auto fork = graph_.zip(branch, below, side_);
            if (first == FoldedGraph::kNone) first = below == trunk ? fork.nearer : trunk;
            branch = longest_but(fork.node, fork.rest);
            trunk = fork.rest;
            if (branch == FoldedGraph::kNone) return first;
        }
    }

    //! Let a branch slide along the trunk to the last node before its own end.
    //! \return the trunk's arc from there on.
    std::uint32_t pass_nodes(std::uint32_t branch, std::uint32_t trunk) {
        const std::uint32_t end = graph_.end(branch, side_);
        std::uint32_t node = FoldedGraph::kNone, arc = trunk;
        while (is_elder(end, graph_.end(arc, side_))) {
            node = graph_.end(arc, side_);
            arc = longest_but(node, FoldedGraph::kNone);
        }
        if (node != FoldedGraph::kNone) graph_.slide(branch, node, trunk, side_);
        return arc;
    }

    //! Of a node's arcs on this side, the one that leads farthest, another one left out.
    std::uint32_t longest_but(std::uint32_t node, std::uint32_t other) const {
        std::uint32_t best = FoldedGraph::kNone;
        for (const std::uint32_t arc : graph_.arcs(node, side_))
            if (arc != other &&
                (best == FoldedGraph::kNone || is_elder(graph_.end(arc, side_), graph_.end(best, side_))))
                best = arc;
        return best;
    }

    FoldedGraph& graph_;
    Side side_;
    double threshold_;
    std::vector<std::uint32_t> parent_;                            // by node, towards the eldest of its piece
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pieces_;  // at a node: eldest, arc
    std::size_t cancelled_ = 0;
};

//! Loops below the threshold, the least persistent first.
std::vector<PersistencePair> short_loops(const FoldedGraph& graph, double threshold) {
    std::vector<std::uint32_t> nodes;
    std::vector<PersistencePair> pairs = persistence_pairs(graph.skeleton(nodes));
    std::erase_if(pairs, [&](const PersistencePair& pair) {
        return pair.kind != PairKind::Loop || pair.persistence >= threshold;
    });
    for (PersistencePair& pair : pairs) {
        pair.lower = nodes[pair.lower];
        pair.upper = nodes[pair.upper];
    }
    std::ranges::stable_sort(pairs, {}, [](const PersistencePair& pair) {
        return std::tuple(pair.persistence, pair.upper, ~pair.lower);
    });
    return pairs;
}

std::size_t close_short_loops(FoldedGraph& graph, double threshold) {
    std::size_t closed = 0;
    LoopCloser closer(graph);
    for (const PersistencePair& loop : short_loops(graph, threshold))
        if (closer.close(loop.lower, loop.upper)) ++closed;
    return closed;
}

double range(const ReebGraph& graph) {
    return graph.nodes.empty() ? 0 : graph.nodes.back().value - graph.nodes.front().value;
}

void check(const ReebGraph& graph, const ScalarField& field, double relative_persistence) {
    if (!(relative_persistence >= 0 && relative_persistence < 1))
        throw InvalidInput(
            fmt::format("can't simplify by {} of the field's range (expected at least 0 and less than 1)",
                        relative_persistence));
    if (field.size() != graph.vertex_arc.size())
        throw InvalidInput(
            fmt::format("the field has {} values for the {} vertices of the Reeb graph (expected the field "
                        "that the graph is of)",
                        field.size(), graph.vertex_arc.size()));
}

SimplifiedGraph simplified(const ReebGraph& graph, const TriMesh* mesh, const ScalarField& field,
                           double relative_persistence) {
    check(graph, field, relative_persistence);
    SimplifiedGraph result;
    result.threshold = relative_persistence * range(graph);
    FoldedGraph folded(graph, field);
    for (std::uint32_t n = 0; n < folded.node_count(); ++n) folded.tidy(n);
    for (std::size_t closed = 1; closed > 0; result.closed_loops += closed) {
        result.pruned_branches += BranchPruner(folded, Down, result.threshold).run();
        result.pruned_branches += BranchPruner(folded, Up, result.threshold).run();
        closed = close_short_loops(folded, result.threshold);
    }
    result.graph = folded.result(mesh);
    return result;
}

}  // namespace

SimplifiedGraph simplify(const ReebGraph& graph, const ScalarField& field, double relative_persistence) {
    return simplified(graph, nullptr, field, relative_persistence);
}

SimplifiedGraph simplify(const ReebGraph& graph, const TriMesh& mesh, const ScalarField& field,
                         double relative_persistence) {
    return simplified(graph, &mesh, field, relative_persistence);
}

}  // namespace stratareeb
