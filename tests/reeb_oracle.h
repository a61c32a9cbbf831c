// SPDX-License-Identifier: GPL-3.0-or-later
// The Reeb graph straight from its definition, for small meshes: components of the level set between each two vertices in
// order, followed from level to level. Knows nothing of links, strands or names.
#pragma once

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <vector>

#include "mesh/tri_mesh.h"
#include "reeb/scalar_field.h"

namespace stratareeb::testing {

struct OracleGraph {
    // vertex, arcs from below, arcs upwards; and arcs as pairs of vertices. Both ascending.
    std::vector<std::tuple<std::uint32_t, std::size_t, std::size_t>> nodes;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> arcs;
};

class ReebOracle {
 public:
    ReebOracle(const TriMesh& mesh, const ScalarField& field) : mesh_(mesh), rank_(field.size()) {
        order_.resize(field.size());
        std::iota(order_.begin(), order_.end(), 0u);
        std::sort(order_.begin(), order_.end(), [&](auto a, auto b) { return is_below(field, a, b); });
        for (std::uint32_t r = 0; r < order_.size(); ++r) rank_[order_[r]] = r;
    }

    OracleGraph graph() {
        std::map<std::uint32_t, std::uint32_t>
            lower_node;  // by component of the level below: the vertex its arc starts at
        std::map<std::uint32_t, std::uint32_t> below;  // edge -> component
        for (std::uint32_t r = 0; r < order_.size(); ++r) {
            const auto above = components(r);
            std::map<std::uint32_t, std::uint32_t> next_node;
            std::set<std::uint32_t> down, up;
            for (const auto e : mesh_.ve_range(TriMesh::VertexHandle(static_cast<int>(order_[r])))) {
                const auto edge = static_cast<std::uint32_t>(e.idx());
                if (below.contains(edge)) down.insert(below.at(edge));
                if (above.contains(edge)) up.insert(above.at(edge));
            }
            for (const auto& [edge, component] : above)  // what does not touch the vertex goes on
                if (!up.contains(component) && below.contains(edge))
                    next_node[component] = lower_node[below.at(edge)];
            if (down.size() == 1 && up.size() == 1) {
                next_node[*up.begin()] = lower_node[*down.begin()];
            } else {
                graph_.nodes.emplace_back(order_[r], down.size(), up.size());
                for (const auto component : down) graph_.arcs.emplace_back(lower_node[component], order_[r]);
                for (const auto component : up) next_node[component] = order_[r];
            }
            below = above;
            lower_node = next_node;
        }
        std::sort(graph_.nodes.begin(), graph_.nodes.end());
        std::sort(graph_.arcs.begin(), graph_.arcs.end());
        return graph_;
    }

 private:
    //! Component of each crossed edge of the level between rank and rank + 1, named by its least edge.
    std::map<std::uint32_t, std::uint32_t> components(std::uint32_t rank) const {
        std::map<std::uint32_t, std::uint32_t> name;
        const auto crossed = [&](auto e) {
            const auto h = mesh_.halfedge_handle(e, 0);
            return (rank_[static_cast<std::size_t>(mesh_.from_vertex_handle(h).idx())] > rank) !=
                   (rank_[static_cast<std::size_t>(mesh_.to_vertex_handle(h).idx())] > rank);
        };
        for (const auto e : mesh_.edges())
            if (crossed(e)) name[static_cast<std::uint32_t>(e.idx())] = static_cast<std::uint32_t>(e.idx());
        for (bool changed = true; changed;) {
            changed = false;
            for (const auto f : mesh_.faces()) {
                std::vector<std::uint32_t> here;
                for (const auto e : mesh_.fe_range(f))
                    if (crossed(e)) here.push_back(static_cast<std::uint32_t>(e.idx()));
                if (here.size() != 2 || name[here[0]] == name[here[1]]) continue;
                name[here[0]] = name[here[1]] = std::min(name[here[0]], name[here[1]]);
                changed = true;
            }
        }
        return name;
    }

    const TriMesh& mesh_;
    std::vector<std::uint32_t> order_, rank_;
    OracleGraph graph_;
};

}  // namespace stratareeb::testing
