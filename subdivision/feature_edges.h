// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "mesh/polygon_mesh.h"
#include "subdivision/control_mesh.h"

namespace stratareeb {

//! The edges of a mesh with their faces: what of it is an outline, and where it bends.
class FeatureEdges {
 public:
    //! \pre faces name vertices that are there
    explicit FeatureEdges(const PolygonMesh& mesh);

    //! Edges of two faces whose normals differ by more than the angle (degrees), as infinitely sharp creases. Faces without area
    //! have no normal and crease nowhere.
    std::vector<Crease> creases(double angle_deg) const;

    //! Vertices where an outline turns by more than the angle (degrees), and those with one outline edge or more than two.
    std::vector<SharpCorner> outline_corners(double angle_deg) const;

    //! All vertices of outlines.
    std::vector<SharpCorner> outline_vertices() const;

 private:
    struct Side {
        std::uint32_t high, face;
        friend auto operator<=>(const Side&, const Side&) = default;
    };
    std::vector<Point3> face_normals() const;
    template <class Visit>
    void for_each_edge(Visit visit) const;

    const PolygonMesh& mesh_;
    std::vector<std::size_t> first_;  // of each edge's lower vertex among the sides
    std::vector<Side> sides_;         // by edge
};

}  // namespace stratareeb
