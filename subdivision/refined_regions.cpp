// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/refined_regions.h"

namespace stratareeb {

LayerRegions refined_regions(const LayerRegions& control, const LoopTopology& topology) {
    LayerRegions regions{.in_face = {}, .zero_at = control.zero_at, .opened = control.opened};
    LayerSet all;
    for (const LayerSet& set : control.in_face) all |= set;
    for (const LayerSet& set : control.zero_at) all |= set;
    for (int k = 0; k < topology.levels(); ++k) {
        const LoopLevel& level = topology.level(k);
        regions.zero_at.resize(topology.level(k + 1).vertices);
        for (std::size_t e = 0; e < level.ends.size(); ++e)
            if (level.is_rim(e))
                regions.zero_at[level.vertices + e] =
                    regions.zero_at[level.ends[e][0]] & regions.zero_at[level.ends[e][1]];
    }
    const auto& triangles = topology.finest().triangles;
    const std::size_t children = control.in_face.empty() ? 1 : triangles.size() / control.in_face.size();
    regions.in_face.resize(triangles.size());
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        regions.in_face[f] = control.in_face[f / children];
        const LayerSet lacking = all & ~regions.in_face[f];
        if (lacking.none()) continue;
        for (const std::uint32_t v : triangles[f]) regions.zero_at[v] |= lacking;
    }
    return regions;
}

}  // namespace stratareeb
