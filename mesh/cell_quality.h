// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/volume_mesh.h"

namespace stratareeb {

//! Shape and size of a cell.
struct CellQuality {
    double volume = 0;
    double least_dihedral_deg = 0, largest_dihedral_deg = 0;  // between its plane faces
    //! Longest edge over the radius 3 V / S of a ball like those that touch all faces, in units of a regular tetrahedron
    //! (P. J. Frey and P.-L. George, "Mesh generation", 2000): 1 for that, larger for flat and long cells.
    double aspect = 0;
};

CellQuality cell_quality(const VolumeMesh& mesh, const VolumeCell& cell);
std::vector<CellQuality> cell_qualities(const VolumeMesh& mesh);

//! How a number is spread over cells.
struct Spread {
    double least = 0, hundredth = 0, median = 0, ninety_ninth = 0, largest = 0;
};
Spread spread_of(std::vector<double> values);

//! What a layer's cells come to.
struct LayerCells {
    std::size_t tetrahedra = 0, pyramids = 0, prisms = 0;
    double volume = 0;
    std::size_t cells() const { return tetrahedra + pyramids + prisms; }
};
std::vector<LayerCells> layer_cells(const VolumeMesh& mesh, const std::vector<CellQuality>& qualities);

}  // namespace stratareeb
