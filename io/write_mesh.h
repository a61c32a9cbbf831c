// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "io/mesh_format.h"
#include "io/mesh_part.h"
#include "mesh/polygon_mesh.h"
#include "mesh/tri_mesh.h"

namespace stratareeb {

struct MeshPart {
    std::string name;   // of the object, group, node or solid in the file; any UTF-8
    std::string color;  // "#rrggbb"; empty = light grey
    const TriMesh* mesh = nullptr;
};

//! Write meshes to one file, in the format of its extension; a file that is there is replaced once the new
//! one is whole. OBJ (with an MTL file beside it), GLB and 3MF keep parts apart by name and colour; PLY and
//! OFF hold all parts with coloured vertices, STL without. PLY, OBJ and OFF keep every bit of the
//! coordinates; STL, GLB and 3MF are float, GLB and 3MF around the middle of the box. Vertex normals are
//! those of the mesh; where none are set, they are computed.
//! \throw IoError if the extension is unknown or
//! the file can't be written; InvalidInput for a colour that is none
void write_meshes(const std::filesystem::path& file, std::span<const MeshPart> parts);

//! The same for one mesh.
void write_mesh(const std::filesystem::path& file, const MeshPart& part);

//! The same for triangles of any kind, non-manifold too. Empty normals are computed.
void write_mesh_parts(const std::filesystem::path& file, std::vector<PartData> parts);

//! The same for polygons, one a face in PLY, OBJ and OFF (more than 255 corners: fans in PLY), fans of triangles in the others. Empty
//! normals are computed.
void write_polygons(const std::filesystem::path& file, const std::string& name, const PolygonMesh& mesh,
                    std::vector<Point3> normals = {});

}  // namespace stratareeb
