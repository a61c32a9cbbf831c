// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

#include "boreholes/point.h"

namespace stratareeb {

//! An upright box in plan.
struct PlanBox {
    Point2 low, high;
    bool contains(const Point2& p) const {
        return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
    }
    //! Grow to have a place in it.
    void include(const Point2& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
};

//! What nothing is in.
inline constexpr PlanBox kEmptyPlanBox{
    {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()},
    {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}};

}  // namespace stratareeb
