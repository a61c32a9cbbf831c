// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reeb/reeb_graph.h"

namespace stratareeb {

enum class PairKind {
    Join,  // a minimum, and the node at which its piece of the graph below joins one with a lower minimum
    Split,  // the same upside down: the node at which a maximum's piece joins one with a higher maximum, and that maximum
    Loop,      // the node at which a loop opens, and the one at which it closes
    Component  // the lowest and the highest node of a component
};

//! Two nodes of a Reeb graph that come and go together.
struct PersistencePair {
    PairKind kind = PairKind::Component;
    std::uint32_t lower = 0, upper = 0;  // nodes; the same one for a component of one node
    double persistence = 0;              // difference of their values

    bool operator==(const PersistencePair&) const = default;
};

//! Extended persistence of the graph with its field (P. Agarwal, H. Edelsbrunner, J. Harer, Y. Wang 2006). Nodes are
//! taken in their order, so ties need no cases; a pair may have persistence 0. A node with d arcs down and u arcs up is
//! the upper node of d - 1 pairs Join or Loop (if d > 0) and the lower one of u - 1 pairs Split or Loop (if u > 0); a
//! minimum is in one more, Join or Component, a maximum in one more, Split or Component. There is one pair Loop for each
//! independent cycle of the graph: each node that closes cycles is paired with the highest nodes that can be lowest on
//! them. Hidden loops (see ReebGraph) have persistence 0 and are left out. Time: O(n log n).
//! \return most persistent first; then by lower node, upper node, kind.
std::vector<PersistencePair> persistence_pairs(const ReebGraph& graph);

//! A pair Loop with a cycle of the graph that stands for it: two ways from the lower node to the upper one.
struct LoopCycle {
    PersistencePair pair;
    std::array<std::vector<std::uint32_t>, 2> sides;  // arcs in order from pair.lower to pair.upper
};

//! A cycle for each pair Loop of at least this persistence. Its nodes lie between those of the pair, none is met twice,
//! and all cycles together are independent. Mostly both sides rise all the way, but they need not: a handle may rise,
//! sink and rise again, so that there is no rising way. Of all cycles that close at a node, the one is given whose ways
//! stay highest; it need not have the fewest arcs. Time: that of the pairs, and the number of arcs returned, which can be
//! quadratic: ask for the persistent ones.
//! \return in the order of persistence_pairs.
std::vector<LoopCycle> loop_cycles(const ReebGraph& graph, double min_persistence = 0);

//! Do both sides rise all the way?
bool is_monotone(const LoopCycle& cycle, const ReebGraph& graph);

}  // namespace stratareeb
