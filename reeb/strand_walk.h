// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/tri_mesh.h"
#include "reeb/vertex_link.h"

namespace stratareeb {

//! Finds which strands above a vertex belong to one contour, by walking along the level set just above the vertex from all
//! ends of all strands in step, one triangle at a time, until all contours but one are closed (or end at the boundary on both
//! sides). Costs the length of the second longest contour, times the number of strands.
class StrandWalk {
 public:
    using Halfedge = TriMesh::HalfedgeHandle;

    StrandWalk(const TriMesh& mesh, const std::vector<std::uint32_t>& rank) : mesh_(mesh), rank_(rank) {}

    //! Number of contours; the rest of the questions are about the last call.
    //! \pre two strands or more
    std::size_t group_strands(const VertexLink& link);

    std::uint32_t group_of(std::size_t strand) const { return group_[strand]; }
    //! The contour that was not walked to its end; its edges are not known.
    std::uint32_t unfinished_group() const { return unfinished_; }
    //! How often a finished contour ends on the boundary: twice if it is open, else never.
    std::uint32_t ends_of(std::uint32_t group) const { return ends_[group]; }
    //! Call `visit(h)` for each edge, as one of its half-edges, that a finished contour crosses, those at the vertex left out.
    template <class Visit>
    void for_edges_of(std::uint32_t group, const Visit& visit) const {
        for (std::size_t w = 0; w < walker_count_; ++w)
            if (group_[walkers_[w].strand] == group)
                for (const Halfedge h : walkers_[w].crossed) visit(h);
    }

 private:
    struct Walker {
        Halfedge at;  // the crossed edge's half-edge in the triangle to come
        std::size_t strand = 0;
        bool done = false;
        std::vector<Halfedge> crossed;
    };

    void start(Halfedge exit, std::size_t strand);
    void step(Walker& walker);
    Walker* that_starts_at(Halfedge h);
    std::size_t root(std::size_t strand) const;
    bool one_is_open() const;
    std::span<Walker> walkers() { return std::span(walkers_).first(walker_count_); }
    std::span<const Walker> walkers() const { return std::span(walkers_).first(walker_count_); }

    const TriMesh& mesh_;
    const std::vector<std::uint32_t>& rank_;
    std::vector<Walker> walkers_;  // the first walker_count_ are in use; the rest keep their memory
    std::size_t walker_count_ = 0;
    std::vector<std::size_t> parent_;
    std::vector<std::uint32_t> group_, ends_;
    std::uint32_t rank_at_ = 0, unfinished_ = 0;
};

}  // namespace stratareeb
