// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boreholes/point.h"
#include "reeb/contour_stack.h"
#include "reeb/interval_tree.h"

namespace stratareeb {

//! One height of a contour stack: its rings, which of them lies in which, and an index to ask what is around a place.
//! The plane's regions are named by the ring around them, the unbounded one kOutside: ring r parts region r, inside it,
//! from region parent(r).
class StackLevel {
 public:
    static constexpr std::uint32_t kOutside = ~0u;

    //! \pre the contours are of one height and apart, as sorted_stack leaves them; there may be none
    explicit StackLevel(std::span<const StackContour> contours);

    std::uint32_t size() const { return static_cast<std::uint32_t>(contours_.size()); }
    double z() const { return contours_.front().z; }
    const std::vector<Point2>& ring(std::uint32_t r) const { return contours_[r].points; }

    std::uint32_t parent(std::uint32_t r) const { return parent_[r]; }  // the ring around, or kOutside
    std::uint32_t depth(std::uint32_t r) const { return depth_[r]; }    // how many rings are around
    bool is_hole(std::uint32_t r) const { return depth_[r] % 2 == 1; }
    std::uint32_t solid_side(std::uint32_t r) const { return is_hole(r) ? parent_[r] : r; }
    std::uint32_t void_side(std::uint32_t r) const { return is_hole(r) ? r : parent_[r]; }

    //! A ring's edge and the place where it passes the line of height y.
    struct Passage {
        std::uint32_t ring = 0;
        long double x = 0;
    };
    //! Where edges (lower end excluded) pass through this y, in no order.
    std::vector<Passage> passages(double y) const;

    //! Is the place inside the body?
    bool is_solid(const Point2& place) const;

 private:
    struct Edge {
        Point2 low, high;
        std::uint32_t ring = 0;
    };
    static std::vector<Edge> edges_of(std::span<const StackContour> contours);
    static IntervalTree tree_of(const std::vector<Edge>& edges);

    std::span<const StackContour> contours_;
    std::vector<std::uint32_t> parent_, depth_;
    std::vector<Edge> edges_;
    IntervalTree tree_;  // of the edges' heights
};

}  // namespace stratareeb
