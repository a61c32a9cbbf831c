// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! A place where another hole would help, and why.
struct NextBorehole {
    Point2 at;
    double expected_error = 0;                                // size of the error that is expected there now
    double area = 0;                                          // of the circle around it without a hole
    double benefit() const { return expected_error * area; }  // a volume
};

//! The places where one more hole would help most, one after the other, each as if those before it were drilled: in the gaps
//! between holes (the triangles of their Delaunay triangulation), the largest product of the expected error and the area of
//! the circle around the place that holds no hole. Fewer where no error is expected or holes stand in a line.
//! \param expected_error size of the prediction's error at a place, such as LocalError::at
std::vector<NextBorehole> next_boreholes(std::span<const Point2> holes, std::size_t count,
                                         const std::function<double(const Point2&)>& expected_error);

}  // namespace stratareeb
