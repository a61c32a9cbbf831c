// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! Where rings that merge meet: the middle of the shortest line between two of them, of those lines whose middle is
//! `allowed`, or of all if none is. Of more than two rings those gaps count that join them all with least length: the
//! mean of their middles if that is allowed, else the middle nearest to it. Lines start at corners of one of the rings
//! (not at all of them where rings have thousands).
//! \pre two rings or more, none empty
Point2 ring_gap(std::span<const std::vector<Point2>> rings,
                const std::function<bool(const Point2&)>& allowed);

}  // namespace stratareeb
