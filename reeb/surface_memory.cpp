// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/surface_memory.h"

namespace stratareeb {

namespace {

std::vector<double> key_of(std::span<const SheetRing> rings, const std::optional<Point3>& node,
                           std::size_t steps) {
    std::vector<double> key{static_cast<double>(steps), node ? 1.0 : 0.0};
    if (node) key.insert(key.end(), {node->x, node->y, node->z});
    for (const SheetRing& ring : rings) {
        key.push_back(static_cast<double>(ring.points.size()));
        key.push_back(ring.is_lower ? 1 : 0);
        key.push_back(ring.is_hole ? 1 : 0);
        for (const Point3& p : ring.points) key.insert(key.end(), {p.x, p.y, p.z});
    }
    return key;
}

}  // namespace

const std::optional<PlanSheet>& SheetMemory::sheet(std::span<const SheetRing> rings,
                                                   const std::optional<Point3>& node, std::size_t steps) {
    const auto [at, is_new] = made_.try_emplace(key_of(rings, node, steps));
    if (is_new) at->second = plan_sheet(rings, node, steps);
    return at->second;
}

}  // namespace stratareeb
