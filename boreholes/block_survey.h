// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "boreholes/borehole.h"

namespace stratareeb {

//! The part of a survey that stands in one block between faults. What a block's own holes know counts alone; of a unit of
//! which none of them says anything, the other blocks' holes lend its thickness (of contact points, the elevation), with a note.
//! \param holes numbers of the block's holes; they come first, in that order
Survey survey_of_block(const Survey& survey, std::span<const std::uint32_t> holes,
                       std::vector<std::string>& notes);

}  // namespace stratareeb
