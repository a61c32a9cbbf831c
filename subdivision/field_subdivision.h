// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "subdivision/control_topology.h"

namespace stratareeb {

//! Loop subdivision of numbers at the vertices of triangles: heights, thicknesses, coordinates. Fields that bend along the same
//! creases share one of these. Control vertices keep their numbers among the refined ones.
class FieldSubdivision {
 public:
    using Triangle = std::array<std::uint32_t, 3>;

    //! Outlines are creases by themselves, and smooth curves between sharp corners.
    //! \throw InvalidInput as ControlTopology does
    FieldSubdivision(std::span<const Triangle> triangles, std::size_t vertices,
                     std::span<const Crease> creases, std::span<const SharpCorner> sharp_corners, int levels);

    std::size_t refined_vertices() const;
    //! Triangle t of the control mesh has the refined triangles 4^levels t up to 4^levels (t + 1).
    std::vector<Triangle> refined_triangles() const;

    //! Values at refined vertices: the control mesh of that level, not yet on the limit surface.
    std::vector<double> refined(std::span<const double> control) const;
    //! Limit values at refined vertices, from control values.
    std::vector<double> limit(std::span<const double> control) const;

    //! `refined` as sparse rows, one a refined vertex: worth it from some fifty fields on (see row_sums).
    SparseRows stencils() const;

    //! One row for each of these control vertices: its limit as weights of control values, none negative, that add up to one.
    //! \pre all sharpness is infinite
    SparseRows limit_stencils(std::span<const std::uint32_t> control_vertices) const;

 private:
    ControlTopology topology_;
};

}  // namespace stratareeb
