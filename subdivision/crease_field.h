// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "subdivision/control_topology.h"
#include "subdivision/loop_topology.h"

namespace stratareeb {

//! Where a field over a control mesh is not smooth: infinitely sharp edges and vertices. The rim is a crease
//! always and need not be named. Where three creases or more meet is a corner; where one ends the field is smooth.
struct FieldCreases {
    std::vector<std::uint32_t> edges;    // of the control mesh, in ascending order
    std::vector<std::uint32_t> corners;  // vertices whose value stays, in ascending order
    friend bool operator==(const FieldCreases&, const FieldCreases&) = default;
};

//! Values at the vertices of the finest level, by C. Loop's rules with the creases of H. Hoppe et al. 1994, as
//! OpenSubdiv has them: at a fraction of its time for many fields with creases of their own on one topology.
std::vector<double> refined_values(const LoopTopology& topology, const FieldCreases& creases,
                                   const std::vector<double>& control);

//! The same, then moved onto the limit surface. All weights are positive or 0, so no value leaves the range of
//! those around it.
std::vector<double> limit_values(const LoopTopology& topology, const FieldCreases& creases,
                                 const std::vector<double>& control);

//! The limit value of each control vertex as weights of control values; row v has column v.
SparseRows limit_rows(const LoopLevel& control, const FieldCreases& creases);

}  // namespace stratareeb
