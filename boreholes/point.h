// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace stratareeb {

//! A place in plan: x east, y north, in the units of the survey.
struct Point2 {
    double x = 0, y = 0;
    friend bool operator==(const Point2&, const Point2&) = default;
};

//! A place in space; z up.
struct Point3 {
    double x = 0, y = 0, z = 0;
    friend bool operator==(const Point3&, const Point3&) = default;
};

}  // namespace stratareeb
