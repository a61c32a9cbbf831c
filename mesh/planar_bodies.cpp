// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/planar_bodies.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

using Vec = OpenMesh::Vec3d;

struct Component {
    std::vector<TriMesh::FaceHandle> triangles;
    double volume = 0;
    int body = -1;  // index of the body it is or belongs to
};

std::vector<int> component_of_vertices(const TriMesh& mesh, int& count) {
    std::vector<int> component(mesh.n_vertices(), -1);
    std::vector<TriMesh::VertexHandle> stack;
    count = 0;
    for (const auto seed : mesh.vertices()) {
        if (component[seed.idx()] >= 0 || mesh.is_isolated(seed)) continue;
        component[seed.idx()] = count;
        stack.push_back(seed);
        while (!stack.empty()) {
            const auto v = stack.back();
            stack.pop_back();
            for (const auto w : mesh.vv_range(v)) {
                if (component[w.idx()] >= 0) continue;
                component[w.idx()] = count;
                stack.push_back(w);
            }
        }
        ++count;
    }
    return component;
}

std::array<Vec, 3> corners(const TriMesh& mesh, TriMesh::FaceHandle f, const Vec& origin) {
    auto v = mesh.cfv_iter(f);
    const Vec a = mesh.point(*v++) - origin, b = mesh.point(*v++) - origin;
    return {a, b, mesh.point(*v) - origin};
}

Vec any_point(const TriMesh& mesh, const Component& component) {
    return mesh.point(*mesh.cfv_iter(component.triangles.front()));
}

double signed_volume(const TriMesh& mesh, const Component& component) {
    const Vec origin = any_point(mesh, component);
    double six = 0;
    for (const auto f : component.triangles) {
        const auto [a, b, c] = corners(mesh, f, origin);
        six += dot(a, cross(b, c));
    }
    return six / 6;
}

// Winding number: the sum of the solid angles that the triangles subtend (Van Oosterom and Strackee 1983).
bool is_inside(const TriMesh& mesh, const Component& component, const Vec& p) {
    double angle = 0;
    for (const auto f : component.triangles) {
        const auto [a, b, c] = corners(mesh, f, p);
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        angle += 2 * std::atan2(dot(a, cross(b, c)),
                                la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return angle > 2 * std::numbers::pi;
}

std::vector<Component> components(const TriMesh& mesh, const std::vector<int>& of_vertex, int count) {
    std::vector<Component> result(count);
    for (const auto f : mesh.faces()) result[of_vertex[mesh.cfv_iter(f)->idx()]].triangles.push_back(f);
    for (auto& component : result) component.volume = signed_volume(mesh, component);
    return result;
}

int body_around(const TriMesh& mesh, const std::vector<Component>& all, const Component& cavity) {
    const Vec p = any_point(mesh, cavity);
    const Component* best = nullptr;
    for (const auto& candidate : all)
        if (candidate.volume > -cavity.volume && (!best || candidate.volume < best->volume) &&
            is_inside(mesh, candidate, p))
            best = &candidate;
    if (!best)
        throw GeometryError(fmt::format(
            "the shell at ({:.3f}, {:.3f}, {:.3f}) faces inwards and no body is around it; turn it over",
            p[0], p[1], p[2]));
    return best->body;
}

}  // namespace

std::vector<PlanarBody> planar_bodies(const TriMesh& mesh, const PlanarRegionOptions& options) {
    auto regions = planar_regions(mesh, options);
    int count = 0;
    const auto of_vertex = component_of_vertices(mesh, count);
    auto parts = components(mesh, of_vertex, count);

    int bodies = 0;
    for (auto& part : parts)
        if (part.volume > 0) part.body = bodies++;
    std::vector<PlanarBody> result(bodies);
    std::vector<PlanarShell*> shell_of(count);
    std::vector<std::pair<int, PlanarShell>> cavities;
    cavities.reserve(count);  // pointers into it stay valid
    for (int i = 0; i < count; ++i) {
        if (parts[i].body >= 0) {
            shell_of[i] = &result[parts[i].body].outer;
        } else {
            cavities.emplace_back(body_around(mesh, parts, parts[i]), PlanarShell{});
            shell_of[i] = &cavities.back().second;
        }
    }
    for (auto& region : regions) shell_of[of_vertex[region.loops[0][0]]]->push_back(std::move(region));
    for (auto& [body, shell] : cavities) result[body].cavities.push_back(std::move(shell));
    return result;
}

}  // namespace stratareeb
