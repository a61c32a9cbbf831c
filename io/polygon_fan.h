// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace stratareeb {

//! Cut a polygon into triangles that all start at its first corner.
inline void append_fan(std::span<const std::uint32_t> corners,
                       std::vector<std::array<std::uint32_t, 3>>& triangles) {
    for (std::size_t i = 2; i < corners.size(); ++i)
        triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

}  // namespace stratareeb
