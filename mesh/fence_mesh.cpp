// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/fence_mesh.h"

#include "mesh/normals.h"

namespace stratareeb {
namespace {

using Vertex = TriMesh::VertexHandle;

//! Adds one layer's part of a run: quadrilaterals between stations, triangles where it ends.
void add_run(TriMesh& mesh, const std::vector<SectionStation>& run, std::size_t layer, const Point3& origin) {
    const auto place = [&](const SectionStation& station, double z) {
        return mesh.add_vertex({station.at.x - origin.x, station.at.y - origin.y, z - origin.z});
    };
    const auto is_there = [&](const SectionStation& station) {
        return station.horizons[layer] > station.horizons[layer + 1];
    };
    Vertex top, base;  // of the station before; the same where the layer has no thickness
    for (std::size_t i = 0; i < run.size(); ++i) {
        const bool from = i > 0 && (is_there(run[i - 1]) || is_there(run[i]));
        const bool onward = i + 1 < run.size() && (is_there(run[i]) || is_there(run[i + 1]));
        if (!from && !onward) continue;
        const Vertex old_top = top, old_base = base;
        top = place(run[i], run[i].horizons[layer]);
        base = is_there(run[i]) ? place(run[i], run[i].horizons[layer + 1]) : top;
        if (!from) continue;
        if (old_top != old_base) mesh.add_face(old_top, old_base, base);
        if (top != base) mesh.add_face(old_top, base, top);
    }
}

}  // namespace

std::vector<TriMesh> fence_meshes(const VerticalSection& section, std::size_t layers, const Point3& origin) {
    std::vector<TriMesh> meshes(layers);
    for (std::size_t i = 0; i < layers; ++i) {
        for (const auto& run : section.runs) add_run(meshes[i], run, i, origin);
        update_vertex_normals(meshes[i], NormalWeight::Uniform);
    }
    return meshes;
}

}  // namespace stratareeb
