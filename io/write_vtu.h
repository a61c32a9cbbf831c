// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "boreholes/borehole.h"
#include "mesh/cell_quality.h"
#include "mesh/volume_mesh.h"

namespace stratareeb {

//! What a file of cells says beside them.
struct CellRecord {
    std::vector<Unit> units;  // of all layers, top first
    Point3 origin;            // to be added for map coordinates
};

//! Write cells as a VTK unstructured grid (.vtu, appended raw data, double coordinates) for ParaView and OpenGeoSys. Cell data:
//! MaterialIDs (0 = top layer, as OpenGeoSys wants them), layer (1 = top), part, volume, least_dihedral_deg and aspect. Field data:
//! origin and layer_codes. Prisms have VTK's own order of corners: the upper triangle first.
//! \throw IoError if the file can't be written
void write_vtu(const std::filesystem::path& file, const VolumeMesh& mesh,
               const std::vector<CellQuality>& qualities, const CellRecord& record);

}  // namespace stratareeb
