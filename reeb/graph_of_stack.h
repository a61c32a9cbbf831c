// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "reeb/contour_stack.h"
#include "reeb/enhanced_reeb_graph.h"

namespace stratareeb {

enum class StackEnds {
    Domes,  // a contour without partner ends in a point at 3/4 of the spacing beyond it: a quarter-ellipse dome of that
    // height holds half a spacing's prism, so that the body keeps "area times spacing"
    Flat,  // it is repeated at half the spacing beyond, and the body closed flat there
};

struct StackGraphOptions {
    StackEnds ends = StackEnds::Domes;
    //! Distance from the first and from the last level to the next ones, if there were any. None: that to their
    //! neighbours. A single level needs it: the height of its body.
    std::optional<double> end_spacing;
    //! Levels further apart than this are not joined: all that is known is that there is an empty one between.
    std::optional<double> most_spacing;
    //! Contours that share less than this part of the smaller one have nothing to do with each other. The default leaves
    //! out what only touches; hand-drawn outlines may want more.
    double least_share = 1e-9;
    HomotopyOptions homotopy;  // of all edges
};

//! Two contours that overlap in plan and yet are on no common edge or node.
struct DroppedContourOverlap {
    std::uint32_t lower = 0, upper = 0;  // contours of the graph
    double share = 0;                    // of the smaller contour's inside
};

struct StackGraph {
    EnhancedReebGraph graph;
    std::vector<std::uint32_t> source;  // by contour: its place in the stack
    std::vector<DroppedContourOverlap>
        dropped;  // where more contours meet, and cross, than a merge or a division takes
    std::size_t levels = 0;
};

//! The enhanced Reeb graph of a body from its horizontal sections (after Y. Shinagawa and T. L. Kunii 1991, with the rule of
//! stack_transitions for what becomes what). Contours are named 1, 2, ... by height, then from left to right; nodes from bottom
//! to top; edges are straight.
//! - Merges and divisions: halfway between both levels, in the gap between the contours that merge (ring_gap), where just
//!   one of the levels is solid.
//! - Where several contours become several others, and none crosses another in plan: saddles one by one, with contours between, as on
//!   a harmonic surface (cell_graph).
//! - Ends: over or under the contours that end, well inside what they enclose (inner_point). A ring that ends all at once, outer
//!   contour and holes, has one node and as many edges: with one hole it ends in a ridge
//!   around that, with StackEnds::Flat too; with several it is closed flat.
//! - What ends beside contours that overlap or touch it and go on, or end from the other side, ends before the middle.
//! \throw InvalidInput as sorted_stack; if there is no contour; if there is a single level and no spacing; if the spacing is
//! not a positive number.
StackGraph graph_of_stack(const ContourStack& stack, const StackGraphOptions& options = {});

}  // namespace stratareeb
