// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "boreholes/block_ties.h"
#include "boreholes/borehole.h"
#include "mesh/footprint.h"

namespace stratareeb {

//! Vertical faults by their traces in plan: open or closed lines, each with at least two points.
using FaultTraces = std::vector<std::vector<Point2>>;

//! The way on from the tip of a fault that dies out, straight to the next trace or the outline. No fault: it parts blocks only.
struct WayOn {
    Point2 tip, end;

    //! Is a segment part of it? Places within `tolerance` of the way are on it.
    bool holds(const Point2& a, const Point2& b, double tolerance) const;
};

//! A footprint parted along fault traces. Neighbours have the points of their common border in common, to the last bit.
struct FaultBlocks {
    std::vector<Footprint> outline;       // by block
    std::vector<std::uint32_t> block_of;  // by hole
    std::vector<WayOn> ways_on;           // borders along these are no faults
    std::vector<BlockTie> ties;           // beside ways on
    std::vector<std::string> notes;       // what had to be assumed, for people
};

//! Part a footprint along traces. A trace that ends inside dies out there: blocks to its sides are tied together along the way on.
//! An end that stops short of another trace or the outline by less than 2 % of the footprint's extent is led on to it, and one
//! that only just crosses another trace is cut there. A part without a hole goes with
//! the neighbour with which it shares the longest border. Holes outside of the footprint belong to the closest block.
//! \pre the footprint came from checked_footprint.
//! \throw InvalidInput for a trace that is no line, and where a hole stands on a trace
FaultBlocks fault_blocks(const Footprint& footprint, const FaultTraces& traces,
                         const std::vector<Point2>& holes);

//! The same for a survey's holes, over a footprint in map coordinates, or their hull. For predictions alone (HoldOutOptions::block).
FaultBlocks fault_blocks_of(const Survey& survey, const FaultTraces& traces,
                            const std::optional<Footprint>& footprint = {});

//! Traces with their loose ends cut or led on, which ways on are no faults, and a note on each end that was led on.
struct JoinedTraces {
    FaultTraces traces;
    std::vector<WayOn> ways_on;
    std::vector<std::string> notes;
};
//! Ways on turn a little where they would meet one of the holes.
JoinedTraces joined_traces(const Footprint& footprint, FaultTraces traces,
                           const std::vector<Point2>& holes = {});

}  // namespace stratareeb
