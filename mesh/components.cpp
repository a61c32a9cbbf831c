// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/components.h"

#include "mesh/soup_topology.h"

namespace stratareeb {
namespace {

constexpr auto kNone = SoupTopology::kNone;

struct Parts {
    std::vector<TriangleSoup> soups;
    std::vector<std::vector<std::uint32_t>> vertices;  // of the whole mesh, for each vertex of a part
};

Parts cut(const TriangleSoup& soup) {
    DisjointSets sets(soup.points.size());
    std::vector<bool> used(soup.points.size(), false);
    for (const auto& t : soup.triangles) {
        sets.unite(t[0], t[1]);
        sets.unite(t[0], t[2]);
        used[t[0]] = used[t[1]] = used[t[2]] = true;
    }
    Parts parts;
    std::vector<std::uint32_t> part_of_set(soup.points.size(), kNone), local(soup.points.size(), kNone);
    for (const auto& t : soup.triangles) {
        auto& part = part_of_set[sets.find(t[0])];
        if (part == kNone) {
            part = static_cast<std::uint32_t>(parts.soups.size());
            parts.soups.emplace_back();
        }
    }
    parts.vertices.resize(parts.soups.size());
    for (std::uint32_t v = 0; v < soup.points.size(); ++v) {
        if (!used[v]) continue;
        const auto part = part_of_set[sets.find(v)];
        local[v] = static_cast<std::uint32_t>(parts.vertices[part].size());
        parts.vertices[part].push_back(v);
        parts.soups[part].points.push_back(soup.points[v]);
    }
    for (const auto& t : soup.triangles)
        parts.soups[part_of_set[sets.find(t[0])]].triangles.push_back(
            {local[t[0]], local[t[1]], local[t[2]]});
    return parts;
}

}  // namespace

std::vector<TriangleSoup> connected_components(const TriangleSoup& soup) {
    return cut(soup).soups;
}

std::vector<TriMesh> connected_components(const TriMesh& mesh) {
    std::vector<TriMesh::VertexHandle> handles;
    for (const auto v : mesh.vertices()) handles.push_back(v);
    const auto parts = cut(triangle_soup(mesh));
    std::vector<TriMesh> meshes;
    for (std::size_t i = 0; i < parts.soups.size(); ++i) {
        auto& part = meshes.emplace_back(half_edge_mesh(parts.soups[i]));
        for (const auto v : part.vertices())
            part.set_normal(v, mesh.normal(handles[parts.vertices[i][static_cast<std::size_t>(v.idx())]]));
    }
    return meshes;
}

}  // namespace stratareeb
