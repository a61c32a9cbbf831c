// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "reeb/stack_level.h"

namespace stratareeb {

//! Contours of two neighbouring levels that become one another: one to one they go on, many to one they merge, one to
//! many they divide, many to none (or none to many) they end together.
struct StackTransition {
    std::vector<std::uint32_t> lower, upper;  // rings of the levels, ascending
    std::uint32_t sheet = 0;                  // that all of them border; several pieces may border one

    friend bool operator==(const StackTransition&, const StackTransition&) = default;
};

//! A pair that overlaps and was not taken for one that goes on.
struct DroppedOverlap {
    std::uint32_t lower = 0, upper = 0;
    double share = 0;  // of the overlap in what the smaller of both rings encloses
    std::uint32_t sheet = 0;

    friend bool operator==(const DroppedOverlap&, const DroppedOverlap&) = default;
};

struct StackTransitions {
    std::vector<StackTransition> pieces;  // every ring is in one
    std::vector<DroppedOverlap> dropped;
    std::vector<StackTransition>
        cells;  // sheets between several rings and several, none of which crosses another: instead of
                // their pieces, all become one another (see cell_graph)
};

constexpr double kLeastShare = 1e-9;  // of the smaller ring: what overlaps less touches, but for rounding

//! How the rings of one level become those of the next. Let each level's section stand upright half way to the other: what
//! is solid in just one of them is then a horizontal sheet, and the rings that border one connected sheet, or cross, belong
//! together. That is the Reeb graph of these stairs, so that holes, islands in them, rings that open and close need
//! no rules of their own: of a ring whose wall is cut open the outer and the inner contour border the cut and merge into one.
//!
//! A ring goes on in those of the other level with which it shares area on both its solid and its void side, and not too little. If several
//! rings so meet several, pairs are joined by the share of the overlap in the smaller ring, largest first (outer with outer and
//! hole with hole before others), as long as all pieces keep one ring on one side and could bound a body; the
//! rest is dropped. Rings left without partner end: with the rings of their holes if these end too.
//!
//! Wrong where levels are too far apart to tell: what moves sideways by its own width between two levels (a
//! slanted tip) ends and starts anew; and where rings that cross should take two steps (one that breaks into two halves at once), one of them is
//! dropped.
//! Time: n log n and the crossings, and for each ring the edges beside its leftmost point.
StackTransitions stack_transitions(const StackLevel& lower, const StackLevel& upper,
                                   double least_share = kLeastShare);

}  // namespace stratareeb
