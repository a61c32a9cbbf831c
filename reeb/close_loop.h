// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "reeb/folded_graph.h"

namespace stratareeb {

//! Finds and closes the loops of a graph one by one.
class LoopCloser {
 public:
    explicit LoopCloser(FoldedGraph& graph) : graph_(graph), marks_(graph.node_count()) {}

    //! Close a loop whose highest node is `upper` and that nowhere lies below `lower`: glue its sides, from the top down. If
    //! both rise all the way, the persistence pairs of the rest stay as they are; two rising sides are used if there are any.
    //! Otherwise the lowest rises on them are glued first, which may change other pairs.
    //! \return false if there is no such loop.
    bool close(std::uint32_t lower, std::uint32_t upper);

 private:
    using Run = std::vector<std::uint32_t>;  // arcs from a summit of the loop down to a hollow

    struct Mark {
        std::uint32_t search = 0;   // the search that wrote the rest
        std::uint32_t start = 0;    // the arc by which the search left its first node
        std::uint32_t arrival = 0;  // the arc by which it came here
        std::uint32_t from = 0;     // and the node at its other end
        bool done = false;
    };

    std::vector<Run> rising_sides(std::uint32_t lower, std::uint32_t upper);
    std::vector<Run> any_sides(std::uint32_t lower, std::uint32_t upper);
    std::vector<std::uint32_t> way_from(std::uint32_t upper, std::uint32_t node) const;
    std::vector<Run> runs_of(std::uint32_t upper, const std::vector<std::uint32_t>& cycle) const;
    void glue_lowest_rise(std::vector<Run>& runs);
    Run glue(const Run& shorter, const Run& other);

    FoldedGraph& graph_;
    std::vector<Mark> marks_;  // by node
    std::uint32_t search_ = 0;
    std::vector<std::uint32_t> touched_;
};

}  // namespace stratareeb
