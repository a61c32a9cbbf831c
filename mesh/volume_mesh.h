// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "boreholes/point.h"
#include "mesh/layer_model.h"

namespace stratareeb {

enum class CellKind : std::uint8_t { Tetrahedron, Pyramid, Prism };

constexpr std::size_t corners_of(CellKind kind) {
    return kind == CellKind::Tetrahedron ? 4 : kind == CellKind::Pyramid ? 5 : 6;
}

//! A cell of one layer. Corners, in the order of gmsh:
//!  - tetrahedron: 0, 1, 2 counter-clockwise seen from 3;
//!  - pyramid: 0 … 3 its quadrangle, counter-clockwise seen from 4;
//!  - prism: 0, 1, 2 below, counter-clockwise seen from above, and 3, 4, 5 over them.
struct VolumeCell {
    CellKind kind = CellKind::Prism;
    std::uint16_t layer = 0;  // 0 = top
    std::uint32_t part = 0;   // of the layer, 0 = uppermost; see VolumeMeshOptions
    std::array<std::uint32_t, 6> node{};
};

//! Cells that fill the layers of a model and meet in whole faces, within a layer and across.
struct VolumeMesh {
    std::vector<Point3> points;         // relative to the model's origin, or map coordinates
    std::vector<std::uint32_t> column;  // the plan vertex that each point stands over
    std::vector<VolumeCell> cells;      // plan triangle by plan triangle, from the ground down
    std::vector<std::size_t> parts;     // of each layer
};

struct VolumeMeshOptions {
    bool tetrahedra = false;   // divide prisms and pyramids
    std::size_t parts = 1;     // each layer is divided into so many of equal thickness
    double max_thickness = 0;  // 0 = any; else a layer gets as many parts as its thickest place needs
    //! Where a layer is thinner than this at a point, it is left out there and its space goes to the layer below (the lowest one's
    //! to the one above): cells at thin edges are flat, and make simulations slow.
    double min_thickness = 0;
    bool map_coordinates = false;
};

//! Fill the space between horizons: a prism over each plan triangle and part of a layer, a pyramid where the thickness of one
//! corner is 0, a tetrahedron where that of two is. There is one point for each plan vertex and elevation, so that cells of
//! neighbouring layers use the same points and no cell has two corners in one place. Tetrahedra: each quadrangle is divided
//! through its lowest-numbered point, by both cells that share it (J. Dompierre, P. Labbé, M.-G. Vallet and R. Camarero, "How to
//! subdivide pyramids, prisms, and hexahedra into tetrahedra", 1999); all quadrangles are upright, hence plane, and tetrahedra fill
//! their cells exactly. \throw InvalidInput for no parts or more than 2^32 points; GeometryError naming the place if a cell would not
//! have a positive volume (exact predicates), as map coordinates can make of very thin ones.
VolumeMesh volume_mesh(const LayerModel& model, const VolumeMeshOptions& options = {});

//! The cell as tetrahedra: itself, two, or three.
std::vector<std::array<std::uint32_t, 4>> tetrahedra_of(const VolumeCell& cell);

}  // namespace stratareeb
