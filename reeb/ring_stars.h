// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "reeb/stack_level.h"
#include "reeb/stack_transition.h"

namespace stratareeb {

//! A ring of the lower level and one of the upper that overlap.
struct RingLink {
    std::uint32_t lower = 0, upper = 0;
    double share = 0;
};

using RingStars = StackTransitions;

//! Join linked rings to pieces with one ring on one side at least, by share, largest first; rings of one kind (outer or
//! hole) before others, which may join where a ring opens or closes. All rings of a piece's many hang together over
//! regions that they border, and the outermost of them is of the kind of the one: otherwise no body would have them.
//! Links between different pieces are dropped; ties go by ring.
RingStars ring_stars(const StackLevel& lower, const StackLevel& upper, std::vector<RingLink> links);

}  // namespace stratareeb
