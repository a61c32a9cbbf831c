// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/refine.h"

#include <fmt/format.h>

#include <utility>

#include "boreholes/errors.h"
#include "mesh/triangle_soup.h"
#include "subdivision/limit_surface.h"

namespace stratareeb {

RefinedMesh refine(const PolygonMesh& control, const RefineOptions& options) {
    if (options.levels < 1) throw InvalidInput(fmt::format("{} levels; give 1 or more", options.levels));
    const SharpFeatures features = sharp_features(control, options);
    const ControlTopology topology =
        refined_topology(control, features, options, options.limit ? LimitsWanted::Yes : LimitsWanted::No);
    RefinedMesh refined{
        refined_mesh(topology, control), {}, features.creases.size(), features.corners.size()};
    if (!options.limit) return refined;
    LimitSurface surface = shaded_limit(topology, refined.mesh);
    refined.mesh.points = std::move(surface.points);
    refined.normals = std::move(surface.normals);
    return refined;
}

TriMesh refine(const TriMesh& control, const RefineOptions& options) {
    const RefinedMesh refined = refine(polygon_mesh(triangle_soup(control)), options);
    TriMesh mesh = half_edge_mesh(triangle_fans(refined.mesh));
    for (std::size_t v = 0; v < refined.normals.size(); ++v) {
        const auto& n = refined.normals[v];
        mesh.set_normal(TriMesh::VertexHandle(static_cast<int>(v)), {n.x, n.y, n.z});
    }
    return mesh;
}

}  // namespace stratareeb
