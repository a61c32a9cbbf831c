// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "subdivision/control_mesh.h"

namespace stratareeb {

//! The limit of a dart, an inner vertex in which one crease ends, as weights of the vertex and its neighbours; they add up to one.
//! OpenSubdiv has its limit mask of a smooth vertex stand in, which is another point, and one that moves with the level.
struct DartLimit {
    double vertex = 0;
    std::vector<double> edges;  // ends of the edges in turn, the crease first
    std::vector<double>
        faces;  // Catmull-Clark: opposite corners of the quads; i is between edges i and i + 1
};

//! The left eigenvector of the local subdivision matrix for the eigenvalue 1.
//! \param valence edges at the vertex, at least 3
DartLimit dart_limit(SubdivisionScheme scheme, int valence);

}  // namespace stratareeb
