// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "boreholes/borehole.h"
#include "mesh/footprint.h"

namespace stratareeb {

//! Vertical faults by their traces in plan: open or closed lines, each with at least two points.
using FaultTraces = std::vector<std::vector<Point2>>;

//! A footprint parted along fault traces. Neighbours have the points of their common border in common, to the last bit.
struct FaultBlocks {
    std::vector<Footprint> outline;       // by block
    std::vector<std::uint32_t> block_of;  // by hole
    std::vector<std::string> notes;       // what had to be assumed, for people
};

//! Part a footprint along traces. A trace that ends inside is led on straight to the next trace or the outline; an end that
//! only just crosses another trace (by less than 2 % of the footprint's extent) is cut there. A part without a hole goes with
//! the neighbour with which it shares the longest border. Holes outside of the footprint belong to the closest block.
//! \pre the footprint came from checked_footprint.
//! \throw InvalidInput for a trace that is no line, and where a hole stands on a trace
FaultBlocks fault_blocks(const Footprint& footprint, const FaultTraces& traces,
                         const std::vector<Point2>& holes);

//! The same for a survey's holes, over a footprint in map coordinates, or their hull. For predictions alone (HoldOutOptions::block).
FaultBlocks fault_blocks_of(const Survey& survey, const FaultTraces& traces,
                            const std::optional<Footprint>& footprint = {});

//! Traces with their loose ends cut or led on, and a note on each that was led on.
struct JoinedTraces {
    FaultTraces traces;
    std::vector<std::string> notes;
};
JoinedTraces joined_traces(const Footprint& footprint, FaultTraces traces);

}  // namespace stratareeb
