// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/footprint.h"
#include "mesh/pinch_lines.h"

namespace stratareeb {

//! Point-in-footprint by the even-odd rule, over a list of ring edges per row: quick for outlines of many
//! corners.
class InsideTest {
 public:
    explicit InsideTest(const Footprint& footprint);
    bool operator()(const Point2& p) const;

 private:
    struct Side {
        Point2 a, b;
    };
    double y0_ = 0, row_height_ = 1;
    std::vector<std::vector<Side>> rows_;
};

//! The parts of line work that lie inside a footprint. Where a line meets a ring it ends in a new point,
//! unless one of its ends is within `tolerance`: no piece is shorter than that.
PlanLines clipped_lines(const PlanLines& lines, const Footprint& footprint, double tolerance);

}  // namespace stratareeb
