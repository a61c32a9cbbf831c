// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/loop_handles.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace stratareeb {

namespace {

//! The triangles of each arc.
class TrianglesByArc {
 public:
    explicit TrianglesByArc(const ReebGraph& graph) : first_(graph.arcs.size() + 1, 0) {
        for (const std::uint32_t arc : graph.triangle_arc)
            if (arc != ReebGraph::kNone) ++first_[arc + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        triangles_.resize(first_.back());
        auto next = first_;
        for (std::uint32_t t = 0; t < graph.triangle_arc.size(); ++t)
            if (graph.triangle_arc[t] != ReebGraph::kNone) triangles_[next[graph.triangle_arc[t]]++] = t;
    }

    std::size_t count(const std::vector<std::uint32_t>& arcs) const {
        std::size_t sum = 0;
        for (const std::uint32_t arc : arcs) sum += first_[arc + 1] - first_[arc];
        return sum;
    }

    std::vector<std::uint32_t> of(const std::vector<std::uint32_t>& arcs) const {
        std::vector<std::uint32_t> result;
        for (const std::uint32_t arc : arcs)
            result.insert(result.end(), triangles_.begin() + static_cast<std::ptrdiff_t>(first_[arc]),
                          triangles_.begin() + static_cast<std::ptrdiff_t>(first_[arc + 1]));
        std::ranges::sort(result);
        return result;
    }

 private:
    std::vector<std::size_t> first_;
    std::vector<std::uint32_t> triangles_;
};

void set_box(const TriMesh& mesh, const ReebGraph& graph, LoopHandle& handle) {
    std::vector<TriMesh::VertexHandle> corners;
    for (const std::uint32_t t : handle.triangles)
        for (const auto v : mesh.fv_range(TriMesh::FaceHandle(static_cast<int>(t)))) corners.push_back(v);
    if (corners.empty())
        for (const std::uint32_t node : {handle.cycle.pair.lower, handle.cycle.pair.upper})
            corners.emplace_back(static_cast<int>(graph.nodes[node].vertex));
    TriMesh::Point low = mesh.point(corners[0]), high = low;
    for (const auto v : corners) {
        low.minimize(mesh.point(v));
        high.maximize(mesh.point(v));
    }
    handle.box_min = {low[0], low[1], low[2]};
    handle.box_max = {high[0], high[1], high[2]};
}

}  // namespace

std::vector<LoopHandle> loop_handles(const TriMesh& mesh, const ReebGraph& graph) {
    const TrianglesByArc triangles(graph);
    std::vector<LoopHandle> handles;
    for (LoopCycle& cycle : loop_cycles(graph)) {
        const std::array<std::size_t, 2> count{triangles.count(cycle.sides[0]),
                                               triangles.count(cycle.sides[1])};
        const bool second = count[0] == 0 || (count[1] > 0 && count[1] < count[0]);
        LoopHandle handle{.cycle = std::move(cycle), .triangles = {}, .box_min = {}, .box_max = {}};
        handle.triangles = triangles.of(handle.cycle.sides[second ? 1 : 0]);
        set_box(mesh, graph, handle);
        handles.push_back(std::move(handle));
    }
    return handles;
}

}  // namespace stratareeb
