// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "subdivision/smooth_brep.h"

namespace stratareeb {

//! Lines of equal x along which the faces of sheets are to be cut so that strips have no more than so many spans: clear of corners and
//! turns of edges by some of a span, so a strip may have a few spans more; none where there is no room. Sheets share lines where they can.
//! \param sheets [sheet] whose faces are to be cut
//! \return [sheet] ascending
std::vector<std::vector<double>> strip_lines(const SmoothBrep& brep, const std::vector<char>& sheets,
                                             std::size_t spans);

}  // namespace stratareeb
