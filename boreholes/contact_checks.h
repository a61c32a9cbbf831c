// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "boreholes/audit.h"
#include "boreholes/contact_points.h"

namespace stratareeb {

//! Leave out the points of faults (units whose name has "fault" as a word), which bound no layers, with a
//! warning.
void drop_faults(ContactSet& contacts, Audit& audit);

//! Look for pairs of points of one unit that are close in plan (0.002 of the extent) yet on a face steeper
//! than 10 : 1 and higher than 0.02 of all heights. Stray ones (at most 0.5 % of all points, at most 100)
//! lose the point that fits its neighbours worse.
//! \throw InvalidInput otherwise, naming a place and both
//! heights: no height field can hold such a surface.
void refuse_overhangs(ContactSet& contacts, Audit& audit);

//! Points by place: the numbers of the points at each place with exactly the same x and y, ascending; places
//! in the order of their first points.
std::vector<std::vector<std::size_t>> points_by_place(const ContactSet& contacts);

//! The order of units from top to bottom: from points of different units at one place, and for pairs of units
//! that never share a place, from each point and its nearest neighbour of the other unit.
std::vector<std::size_t> inferred_contact_order(const ContactSet& contacts);

}  // namespace stratareeb
