// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/link_signs.h"

namespace stratareeb {

std::vector<int> link_signs(const TriangleSoup& soup, const std::vector<bool>& is_asked) {
    const auto is_below = [&](std::uint32_t a, std::uint32_t b) {
        const double low = soup.points[a].z, high = soup.points[b].z;
        return low != high ? low < high : a < b;
    };
    std::vector<int> signs(soup.points.size(), 0);
    std::vector<bool> has_lower(soup.points.size(), false);
    for (const auto& t : soup.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            if (!is_asked[t[i]]) continue;
            const bool first = is_below(t[(i + 1) % 3], t[i]), second = is_below(t[(i + 2) % 3], t[i]);
            if (first != second) ++signs[t[i]];
            if (first) has_lower[t[i]] = true;
        }
    for (std::size_t v = 0; v < signs.size(); ++v)
        if (signs[v] == 0 && !has_lower[v]) signs[v] = kLowest;
    return signs;
}

}  // namespace stratareeb
