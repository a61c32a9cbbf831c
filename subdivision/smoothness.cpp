// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/smoothness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stratareeb {

Smoothness smoothness_of(const LoopLevel& level, const std::vector<double>& x, const std::vector<double>& y,
                         const std::vector<double>& z, const std::vector<char>& bends) {
    using Vec = OpenMesh::Vec3d;
    Smoothness result;
    for (std::size_t e = 0; e < level.ends.size(); ++e) {
        if (level.is_rim(e) || bends[e]) continue;
        const auto at = [&](std::uint32_t v) { return Vec(x[v], y[v], z[v]); };
        const Vec a = at(level.ends[e][0]), along = at(level.ends[e][1]) - a;
        const Vec left = along % (at(level.across[e][0]) - a), right = (at(level.across[e][1]) - a) % along;
        const double angle = std::atan2((left % right).norm(), left | right);
        result.largest_jump_deg = std::max(result.largest_jump_deg, angle * 180 / std::numbers::pi);
        result.bending_energy += 6 * angle * angle * along.sqrnorm() / (left.norm() + right.norm());
    }
    return result;
}

}  // namespace stratareeb
