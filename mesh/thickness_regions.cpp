// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/thickness_regions.h"

namespace stratareeb {

LayerRegions regions_of_thickness(const TriMesh& plan, const std::vector<std::vector<double>>& horizons) {
    const std::size_t layers = horizons.size() - 1;
    LayerRegions regions;
    regions.zero_at.resize(plan.n_vertices());
    regions.in_face.resize(plan.n_faces());
    for (std::size_t i = 0; i < layers; ++i)
        for (std::size_t v = 0; v < plan.n_vertices(); ++v)
            regions.zero_at[v][i] = horizons[i][v] == horizons[i + 1][v];
    for (const auto f : plan.faces()) {
        LayerSet absent;
        absent.set();
        for (const auto v : plan.fv_range(f)) absent &= regions.zero_at[static_cast<std::size_t>(v.idx())];
        for (std::size_t i = 0; i < layers; ++i)
            regions.in_face[static_cast<std::size_t>(f.idx())][i] = !absent[i];
    }
    return regions;
}

}  // namespace stratareeb
