// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_soup.h"

namespace stratareeb {

//! Pairs of triangles that meet anywhere but in the vertices and edges that they share.
struct SelfIntersections {
    std::size_t count = 0;
    std::vector<std::array<std::uint32_t, 2>>
        first;  // the lowest pairs in lexicographic order, as many as asked for
};

inline constexpr std::size_t kNamedPairs = 3;

//! All self-intersections of a soup, by exact predicates; any soup will do, non-manifold too. Triangles
//! without area are left out. Corners that coincide without sharing an index count as meeting, so weld first
//! what belongs together. Near-linear where few boxes overlap; runs on several threads, with the same result
//! as on one.
//! \param named how many pairs to name
SelfIntersections self_intersections(const TriangleSoup& soup, std::size_t named = kNamedPairs);

//! Only pairs of which one triangle at least is asked for: quick where few are.
//! \pre one entry of `asked` for each triangle
SelfIntersections self_intersections_of(const TriangleSoup& soup, const std::vector<bool>& asked,
                                        std::size_t named = kNamedPairs);

}  // namespace stratareeb
