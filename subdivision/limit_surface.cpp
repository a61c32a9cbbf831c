// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/limit_surface.h"

#include <cmath>

#include "subdivision/feature_edges.h"

namespace stratareeb {
namespace {

ControlMesh control_mesh(const PolygonMesh& mesh, const RefineOptions& options) {
    return {.scheme = options.scheme,
            .vertices = mesh.points.size(),
            .corners = mesh.corners,
            .sizes = mesh.sizes,
            .points = mesh.points};
}

void append_outline_corners(const FeatureEdges& edges, const RefineOptions& options,
                            std::vector<SharpCorner>& corners) {
    if (options.boundary == BoundaryRule::Smooth) return;
    const auto found = options.boundary == BoundaryRule::Fixed
                           ? edges.outline_vertices()
                           : edges.outline_corners(options.corner_angle_deg);
    corners.insert(corners.end(), found.begin(), found.end());
}

void normalize(Point3& p) {
    const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    p = length > 0 ? Point3{p.x / length, p.y / length, p.z / length} : Point3{0, 0, 1};
}

// Normal of the corner of a face, as long as the angle is wide: sums do not depend on how a flat part is cut.
Point3 corner_normal(const Point3& before, const Point3& at, const Point3& after) {
    const Point3 u{after.x - at.x, after.y - at.y, after.z - at.z};
    const Point3 v{before.x - at.x, before.y - at.y, before.z - at.z};
    const Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    const double sine = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    if (!(sine > 0)) return {0, 0, 0};
    const double angle = std::atan2(sine, u.x * v.x + u.y * v.y + u.z * v.z) / sine;
    return {n.x * angle, n.y * angle, n.z * angle};
}

}  // namespace

SharpFeatures sharp_features(const PolygonMesh& control, const RefineOptions& options) {
    require_faces(control_mesh(control, options), 0);
    SharpFeatures features{options.creases, options.sharp_corners};
    if (options.boundary == BoundaryRule::Smooth && !options.crease_angle_deg) return features;
    const FeatureEdges edges(control);
    if (options.crease_angle_deg) {
        const auto found = edges.creases(*options.crease_angle_deg);
        features.creases.insert(features.creases.begin(), found.begin(),
                                found.end());  // named ones have the last word
    }
    append_outline_corners(edges, options, features.corners);
    return features;
}

ControlTopology refined_topology(const PolygonMesh& control, const SharpFeatures& features,
                                 const RefineOptions& options, LimitsWanted limits) {
    ControlMesh mesh = control_mesh(control, options);
    mesh.creases = features.creases;
    mesh.sharp_corners = features.corners;
    return {mesh, options.levels, limits};
}

PolygonMesh refined_mesh(const ControlTopology& topology, const PolygonMesh& control) {
    const int level = topology.levels();
    PolygonMesh mesh{topology.refined(control.points), topology.corners(level), control.sizes};
    const std::size_t faces = topology.face_count(level), corners = mesh.corners.size();
    if (level > 0) mesh.sizes.clear();
    if (level > 0 && corners == 4 * faces) mesh.sizes.assign(faces, 4);
    start_at_short_diagonals(mesh);
    return mesh;
}

LimitSurface shaded_limit(const ControlTopology& topology, const PolygonMesh& refined) {
    LimitSurface surface = topology.limit_surface(refined.points);
    std::vector<bool> sharp(refined.points.size());
    const auto kinds = topology.kinds();
    for (std::size_t v = 0; v < sharp.size(); ++v)
        sharp[v] = kinds[v] == VertexKind::Crease || kinds[v] == VertexKind::Corner;
    const auto for_each_sharp = [&](auto visit) {
        for (std::size_t v = 0; v < sharp.size(); ++v)
            if (sharp[v]) visit(surface.normals[v]);
    };
    for_each_sharp([](Point3& n) { n = {0, 0, 0}; });
    for_each_face(refined, [&](std::size_t, std::span<const std::uint32_t> corners) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if (!sharp[corners[i]]) continue;
            const auto before = corners[i > 0 ? i - 1 : corners.size() - 1];
            const auto after = corners[i + 1 < corners.size() ? i + 1 : 0];
            const Point3 n =
                corner_normal(surface.points[before], surface.points[corners[i]], surface.points[after]);
            auto& sum = surface.normals[corners[i]];
            sum = {sum.x + n.x, sum.y + n.y, sum.z + n.z};
        }
    });
    for_each_sharp(normalize);
    return surface;
}

}  // namespace stratareeb
