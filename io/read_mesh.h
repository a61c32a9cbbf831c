// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "io/mesh_part.h"
#include "mesh/polygon_mesh.h"
#include "mesh/triangle_soup.h"

namespace stratareeb {

//! Read any mesh, sound or not: PLY (ASCII and binary), OBJ, STL (ASCII and binary), OFF, GLB and 3MF, by
//! extension. Polygons become fans of triangles. STL corners are welded where they are exactly equal. Parts
//! come one after another. GLB, which is y up, is turned z up.
//! \throw IoError if the file can't be read or
//! has an unknown extension; InvalidInput naming line or offset if its content is damaged: cut off, an index
//! out of range, a coordinate that is not a finite number.
TriangleSoup read_mesh(const std::filesystem::path& file);

//! The same with parts kept apart: the objects of an OBJ or 3MF, the nodes of a GLB; one part for other
//! formats. A part without a name takes that of the file.
std::vector<PartData> read_mesh_parts(const std::filesystem::path& file);

//! The same with polygons whole, where the format has them (PLY, OBJ, OFF), and all parts in one mesh.
PolygonMesh read_polygons(const std::filesystem::path& file);

}  // namespace stratareeb
