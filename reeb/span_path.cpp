// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/span_path.h"

namespace stratareeb {

std::vector<std::array<std::uint32_t, 3>> band_triangles(const SpanPath& path, std::uint32_t m,
                                                         std::uint32_t n) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangles.reserve(path.upper_advances.size());
    std::uint32_t i = path.upper, j = path.lower;
    for (const bool upper_advances : path.upper_advances) {
        const std::uint32_t start = upper_advances ? i : m + j;
        std::uint32_t& moving = upper_advances ? i : j;
        moving = moving + 1 == (upper_advances ? m : n) ? 0 : moving + 1;
        const std::uint32_t end = upper_advances ? i : m + j;
        if (start == end) continue;
        if (upper_advances)
            triangles.push_back({start, m + j, end});
        else
            triangles.push_back({start, end, i});
    }
    return triangles;
}

}  // namespace stratareeb
