// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/triangle_soup.h"

namespace stratareeb {

//! A planar triangulation between rings, as paths along its edges see it.
struct PathRegion {
    static constexpr std::uint32_t kInside = ~0u;

    const TriangleSoup& plan;                // counter-clockwise; x and y count
    const std::vector<std::uint32_t>& ring;  // by vertex: the ring it is on, or kInside
};

//! A saddle and the rings that meet in it.
struct SheetSaddle {
    std::uint32_t vertex = 0;
    std::vector<std::uint32_t> rings;
};

//! Heights of a ring, of saddles, and of a last ring on the other side of them.
struct SaddleHeights {
    std::vector<double>
        ring;  // by ring; that of the last ring is on one side of `saddle`, all others' are on its other
    double saddle = 0;
};

//! Heights along paths that part a region with saddles in it into pieces whose border rises once and falls once: from each
//! saddle one path to each of its rings, and between any two of these one to the last ring, where paths may run together. Heights run evenly
//! along them. With these given, heights that have no minimum or maximum inside the region have the saddles where they are to be, and
//! no others: each piece is a disc whose levels are single lines.
//! \pre the saddles join all rings but the last as a tree
//! \return by vertex: the heights of rings, saddles and paths; nothing where the triangles leave no room for paths
std::optional<std::vector<std::optional<double>>> saddle_path_heights(const PathRegion& region,
                                                                      std::span<const SheetSaddle> saddles,
                                                                      const SaddleHeights& heights);

}  // namespace stratareeb
