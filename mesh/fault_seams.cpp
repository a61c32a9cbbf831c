// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/fault_seams.h"

#include <algorithm>

namespace stratareeb {

namespace {

using Place = std::pair<double, double>;

std::uint32_t number(TriMesh::VertexHandle v) {
    return static_cast<std::uint32_t>(v.idx());
}

Place place_of(const TriMesh& plan, TriMesh::VertexHandle v) {
    const auto& p = plan.point(v);
    return {p[0], p[1]};
}

//! Over common edges from the first triangle that has none yet.
void number_blocks(const TriMesh& plan, FaultSeams& seams) {
    constexpr std::uint32_t kNone = ~0U;
    seams.block.assign(plan.n_faces(), kNone);
    std::vector<TriMesh::FaceHandle> todo;
    for (const auto start : plan.faces()) {
        if (seams.block[static_cast<std::size_t>(start.idx())] != kNone) continue;
        const auto block = static_cast<std::uint32_t>(seams.blocks++);
        seams.block[static_cast<std::size_t>(start.idx())] = block;
        todo.push_back(start);
        while (!todo.empty()) {
            const auto face = todo.back();
            todo.pop_back();
            for (const auto next : plan.ff_range(face)) {
                auto& known = seams.block[static_cast<std::size_t>(next.idx())];
                if (known != kNone) continue;
                known = block;
                todo.push_back(next);
            }
        }
    }
}

void collect_levels(const TriMesh& plan, const std::vector<std::vector<double>>& horizons,
                    FaultSeams& seams) {
    std::map<Place, std::vector<std::uint32_t>> at;
    for (const auto v : plan.vertices())
        if (plan.is_boundary(v)) at[place_of(plan, v)].push_back(number(v));
    seams.levels.resize(plan.n_vertices());
    for (const auto& [place, vertices] : at) {
        if (vertices.size() < 2) continue;
        std::vector<double> levels;
        for (const std::uint32_t v : vertices)
            for (const auto& horizon : horizons) levels.push_back(horizon[v]);
        std::ranges::sort(levels);
        levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
        for (const std::uint32_t v : vertices) seams.levels[v] = levels;
    }
}

void match_edges(const TriMesh& plan, FaultSeams& seams) {
    std::map<std::pair<Place, Place>, TriMesh::HalfedgeHandle>
        inside;  // half-edges with the outside to the right
    for (const auto h : plan.halfedges())
        if (!plan.is_boundary(h) && plan.is_boundary(plan.opposite_halfedge_handle(h)))
            inside[{place_of(plan, plan.from_vertex_handle(h)), place_of(plan, plan.to_vertex_handle(h))}] =
                h;
    for (const auto& [ends, h] : inside) {
        const auto other = inside.find({ends.second, ends.first});
        if (other == inside.end()) continue;
        seams.across[{number(plan.from_vertex_handle(h)), number(plan.to_vertex_handle(h))}] = {
            number(plan.to_vertex_handle(other->second)), number(plan.from_vertex_handle(other->second))};
    }
}

}  // namespace

FaultSeams seams_of_pieces(const TriMesh& plan, const std::vector<std::vector<double>>& horizons) {
    FaultSeams seams;
    number_blocks(plan, seams);
    collect_levels(plan, horizons, seams);
    match_edges(plan, seams);
    return seams;
}

}  // namespace stratareeb
