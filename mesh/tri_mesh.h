// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace stratareeb {

//! Double coordinates (map coordinates near 5,000,000 leave float half a metre) and double vertex normals.
struct TriMeshTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
    VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::Status);
    HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
    EdgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status);
};

//! The half-edge triangle surface that everything here works on: layer surfaces, solids and any mesh from a file.
//! Faces are counter-clockwise seen from outside (solids) or from above (horizons).
using TriMesh = OpenMesh::TriMesh_ArrayKernelT<TriMeshTraits>;

}  // namespace stratareeb
