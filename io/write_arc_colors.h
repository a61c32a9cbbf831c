// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "mesh/tri_mesh.h"
#include "reeb/loop_handles.h"

namespace stratareeb {

//! Write a mesh as binary PLY with each vertex and face in the colour of its arc (see arc_colors; grey where it has none), and the
//! arc's number as the faces' int property `arc` (-1 = none). Vertices and faces keep their numbers.
//! \throw IoError if the file can't be written or is no .ply
void write_arc_colors(const std::filesystem::path& file, const TriMesh& mesh, const ReebGraph& graph);

//! Write the triangles of loops' handles, a part a loop in a colour of its own, in the format of the file's extension (see write_meshes).
//! \throw IoError if the extension is unknown or the file can't be written
void write_loop_handles(const std::filesystem::path& file, const TriMesh& mesh,
                        std::span<const LoopHandle> handles);

}  // namespace stratareeb
