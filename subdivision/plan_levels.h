// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/layer_model.h"

namespace stratareeb {

//! Which horizons run together where: over each plan triangle, along each plan edge and at each plan vertex.
class PlanLevels {
 public:
    static constexpr std::uint32_t kNone = ~0u;

    //! Over a triangle: where the layer `above` lies directly on the layer `below`.
    struct Interface {
        std::uint32_t id = 0;  // counted over all triangles
        std::uint32_t above = kNone, below = kNone;
        std::uint32_t horizon = 0;  // the lowest of those that run together
    };

    explicit PlanLevels(const LayerModel& model);

    std::uint32_t layers() const { return layers_; }

    //! From the top; none where no layer is present.
    std::span<const Interface> interfaces(std::size_t face) const {
        return {interfaces_.data() + first_[face], first_[face + 1] - first_[face]};
    }

    //! A layer has thickness along an edge, though perhaps not at one of its ends.
    bool is_open(TriMesh::EdgeHandle e, std::uint32_t layer) const { return open_[index(e)][layer]; }
    bool is_zero(std::uint32_t vertex, std::uint32_t layer) const {
        return model_.regions.zero_at[vertex][layer];
    }

    //! No layer ends or begins along the edge.
    bool all_go_on_across(TriMesh::EdgeHandle e) const;

    //! The highest of the horizons that run together with one, along an edge and at a vertex.
    std::uint32_t on_edge(TriMesh::EdgeHandle e, std::uint32_t horizon) const;
    std::uint32_t at_vertex(std::uint32_t vertex, std::uint32_t horizon) const;

    //! A layer that is open along the edge has no thickness at its end.
    bool pinches_at(TriMesh::VertexHandle v, TriMesh::EdgeHandle e) const {
        return (open_[index(e)] & model_.regions.zero_at[index(v)]).any();
    }

    //! Connected parts, numbered in the order of their first triangle: of a layer (kNone where it is absent),
    //! of all interfaces (by their id).
    std::vector<std::uint32_t> layer_parts(std::uint32_t layer) const;
    std::vector<std::uint32_t> interface_parts() const;

 private:
    static std::size_t index(OpenMesh::BaseHandle h) { return static_cast<std::size_t>(h.idx()); }

    const LayerModel& model_;
    const TriMesh& plan_;
    std::uint32_t layers_;
    std::vector<LayerSet> open_;  // [plan edge]
    std::vector<Interface> interfaces_;
    std::vector<std::size_t> first_;  // [triangle], into interfaces_
};

}  // namespace stratareeb
