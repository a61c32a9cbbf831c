// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "subdivision/loop_topology.h"

namespace stratareeb {

//! How smooth a surface over the plan is, away from the edges along which it is meant to bend.
struct Smoothness {
    double largest_jump_deg = 0;  // between the normals of two triangles beside each other
    double bending_energy =
        0;  // sum over edges of 3 (angle * length)² / area of the triangles beside it; no unit
};

//! Bending energy after E. Grinspun, A. Hirani, M. Desbrun and P. Schröder, Discrete shells, 2003.
//! \param bends by edge; those edges are left out
Smoothness smoothness_of(const LoopLevel& level, const std::vector<double>& x, const std::vector<double>& y,
                         const std::vector<double>& z, const std::vector<char>& bends);

//! What refinement did to a layer model.
struct SmoothnessReport {
    int levels = 0;
    Smoothness before, after;      // the worst horizon's jump and the sum of all energies
    std::size_t straightened = 0;  // plan triangles left linear, since they would have folded
    double largest_misfit = 0;     // of the limit surface against the control horizons at holes
    double thinnest = 0;           // smallest thickness at vertices where a layer is there
};

}  // namespace stratareeb
