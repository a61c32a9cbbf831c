// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! The points of a polyline in a tree of runs, each with its chord and how far its points are from that: how near does the
//! polyline's nearest point come to a place or a line?
class PointRunTree {
 public:
    explicit PointRunTree(std::span<const Point3> points);

    //! A lower bound of the distance between `place`, or the line through it if `direction` (of length 1) is not zero, and the
    //! nearest point; too low by the share `tolerance` at most. `guess` is any point that may be near.
    double distance(const Point3& place, const Point3& direction, std::uint32_t guess,
                    double tolerance) const;

 private:
    struct Run {
        Point3 start, chord;
        double deviation = 0;
    };

    void build(std::size_t run, std::size_t first, std::size_t last);
    double bound(std::size_t run, const Point3& place, const Point3& direction) const;

    std::span<const Point3> points_;
    std::vector<Run> runs_;  // a binary heap's layout: run r has the halves 2r + 1, 2r + 2
};

}  // namespace stratareeb
