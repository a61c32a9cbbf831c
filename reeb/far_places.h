// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "mesh/surface_distance.h"
#include "mesh/tri_mesh.h"
#include "reeb/reeb_graph.h"
#include "reeb/surface_construction.h"
#include "reeb/sweep_graph.h"

namespace stratareeb {

//! A place on an edge of a graph: the edge, and how many of its contours are below.
using GraphPlace = std::pair<std::uint32_t, std::size_t>;

//! Where a surface made of a mesh's graph is far from the mesh, or the mesh from it.
class FarPlaces {
 public:
    //! \param first_filled triangle, of those that close the mesh's boundaries and don't count
    //! \pre all outlive this
    FarPlaces(const TriMesh& mesh, std::size_t first_filled, const ReebGraph& graph, const SweepGraph& sweep);

    //! \param distance from which on a place is far
    //! \param bound above it, that no place is to exceed: the surfaces are asked as closely as that takes, but no closer than a 1000th of the mesh's
    //! box
    //! \param heights by edge: of its contours, ascending
    std::set<GraphPlace> beyond(double distance, double bound, const ConstructedSurface& surface,
                                const std::vector<std::vector<double>>& heights) const;

 private:
    struct Sample {
        Point3 place;
        std::uint32_t triangle;
    };

    std::vector<Sample> far_samples(const TriangleSoup& from, const SurfaceDistance& to, double distance,
                                    double bound) const;
    void add_places_on_edges(const Sample& sample, const std::vector<std::vector<double>>& heights,
                             std::set<GraphPlace>& places) const;

    const ReebGraph& graph_;
    const SweepGraph& sweep_;
    TriangleSoup mesh_;
    SurfaceDistance to_mesh_;
    double finest_;
    std::vector<std::vector<std::uint32_t>> edges_;  // by arc of the Reeb graph
};

}  // namespace stratareeb
