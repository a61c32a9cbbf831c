// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>

#include "reeb/stack_level.h"

namespace stratareeb {

//! Area in plan that a region of one level shares with a region of another: by (lower region, upper region).
using RegionOverlaps = std::map<std::pair<std::uint32_t, std::uint32_t>, double>;

//! Overlaps of the regions that some rings of each level part; all other rings are taken as not there. What is around them
//! all overlaps infinitely. Summed over slabs between all heights y of corners, at least 256: exact but where edges of
//! the two levels cross within a slab (and with more than 4096 corners where slabs are cut evenly).
//! \pre the rings of each level hang together: from ring to ring over regions that both border. Neither set is empty.
RegionOverlaps region_overlaps(const StackLevel& lower, std::span<const std::uint32_t> lower_rings,
                               const StackLevel& upper, std::span<const std::uint32_t> upper_rings);

}  // namespace stratareeb
