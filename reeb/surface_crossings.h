// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "mesh/self_intersection.h"
#include "mesh/triangle_soup.h"

namespace stratareeb {

//! Where surfaces cross themselves (see self_intersections) that are made one after the other and differ in places only: pairs of triangles
//! that were both in the surface before are not looked at again.
class CrossingSearch {
 public:
    SelfIntersections of(const TriangleSoup& soup, std::size_t named);

 private:
    using Corners = std::array<Point3, 3>;  // the first one is the least
    using Order = std::vector<std::pair<std::uint64_t, std::uint32_t>>;

    void remember(std::vector<Corners> triangles, Order order, const SelfIntersections& found);

    std::vector<Corners> triangles_;                      // of the surface before
    Order order_;                                         // these by their hashes
    std::vector<std::array<std::uint32_t, 2>> crossing_;  // all pairs of these, by number
    bool is_known_ = false;                               // are these all pairs?
};

}  // namespace stratareeb
