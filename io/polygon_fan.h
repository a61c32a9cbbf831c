// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "io/mesh_part.h"
#include "mesh/triangle_soup.h"

namespace stratareeb {

//! How many triangles in a row are a polygon each, a fan around its first corner; empty = each one is.
using Fans = std::vector<std::uint32_t>;

//! A part of a file and the polygons that its triangles were.
struct PolygonPart {
    PartData part;
    Fans fans;
};

//! Cut a polygon into triangles that all start at its first corner.
inline void append_fan(std::span<const std::uint32_t> corners,
                       std::vector<std::array<std::uint32_t, 3>>& triangles) {
    for (std::size_t i = 2; i < corners.size(); ++i)
        triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

//! The same, keeping how many triangles each polygon became; `fans` stays empty as long as all are triangles.
inline void append_fan(std::span<const std::uint32_t> corners,
                       std::vector<std::array<std::uint32_t, 3>>& triangles, Fans& fans) {
    if (fans.empty() && corners.size() > 3) fans.assign(triangles.size(), 1);
    if (!fans.empty() || corners.size() > 3) fans.push_back(static_cast<std::uint32_t>(corners.size() - 2));
    append_fan(corners, triangles);
}

//! Call `visit(corners)` for each polygon that was cut into fans; for each triangle if there are none.
template <class Visit>
void for_each_polygon(const TriangleSoup& soup, const Fans& fans, Visit visit) {
    if (fans.empty())
        for (const auto& triangle : soup.triangles) visit(std::span<const std::uint32_t>(triangle));
    std::vector<std::uint32_t> corners;
    std::size_t begin = 0;
    for (const auto size : fans) {
        corners.assign({soup.triangles[begin][0], soup.triangles[begin][1]});
        for (std::size_t i = 0; i < size; ++i) corners.push_back(soup.triangles[begin + i][2]);
        visit(std::span<const std::uint32_t>(corners));
        begin += size;
    }
}

}  // namespace stratareeb
