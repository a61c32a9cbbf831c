// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/planar_bodies.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "boreholes/errors.h"
#include "mesh/analysis.h"
#include "mesh/components.h"

namespace stratareeb {
namespace {

using Vec = OpenMesh::Vec3d;

std::array<Vec, 3> corners(const TriMesh& mesh, TriMesh::FaceHandle f, const Vec& origin) {
    auto v = mesh.cfv_iter(f);
    const Vec a = mesh.point(*v++) - origin, b = mesh.point(*v++) - origin;
    return {a, b, mesh.point(*v) - origin};
}

// Winding number: the sum of the solid angles that the triangles subtend (Van Oosterom and Strackee 1983).
bool is_inside(const TriMesh& mesh, const Vec& p) {
    double angle = 0;
    for (const auto f : mesh.faces()) {
        const auto [a, b, c] = corners(mesh, f, p);
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        angle += 2 * std::atan2(dot(a, cross(b, c)),
                                la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return angle > 2 * std::numbers::pi;
}

PlanarBody& body_around(std::vector<PlanarBody>& bodies, const std::vector<double>& volumes,
                        const PlanarShell& cavity) {
    const Vec p = cavity.mesh.point(TriMesh::VertexHandle(0));
    std::size_t best = bodies.size();
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if ((best == bodies.size() || volumes[i] < volumes[best]) && is_inside(bodies[i].outer.mesh, p))
            best = i;
    if (best < bodies.size()) return bodies[best];
    throw GeometryError(fmt::format(
        "the shell at ({:.3f}, {:.3f}, {:.3f}) faces inwards and no body is around it; turn it over", p[0],
        p[1], p[2]));
}

}  // namespace

std::vector<PlanarBody> planar_bodies(const TriMesh& mesh, const PlanarRegionOptions& options) {
    std::vector<PlanarBody> bodies;
    std::vector<double> volumes;
    std::vector<PlanarShell> cavities;
    for (auto& part : connected_components(mesh)) {
        PlanarShell shell{.mesh = std::move(part), .faces = {}};
        shell.faces = planar_regions(shell.mesh, options);
        const double part_volume = volume(shell.mesh);
        if (part_volume > 0) {
            bodies.push_back({.outer = std::move(shell), .cavities = {}});
            volumes.push_back(part_volume);
        } else {
            cavities.push_back(std::move(shell));
        }
    }
    for (auto& cavity : cavities) body_around(bodies, volumes, cavity).cavities.push_back(std::move(cavity));
    return bodies;
}

}  // namespace stratareeb
