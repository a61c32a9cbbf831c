// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "subdivision/control_topology.h"
#include "subdivision/loop_topology.h"

namespace stratareeb {

//! An edge at a vertex on creases. From level 1 on, the new vertex on what is left of it takes `far` of the other end (3/8 by Loop's rule),
//! 1/8 of each corner across and the rest of the vertex: the less far, the closer the field keeps to its value at the vertex (H. Biermann,
//! A. Levin and D. Zorin, Piecewise smooth subdivision surfaces with normal control, 2000). Limits at control vertices and beyond the
//! triangles around the vertex are as without.
struct LeaningEdge {
    std::uint32_t edge = 0, vertex = 0;  // of the control mesh
    double far = 0.375;                  // 0 … 3/8, so that no weight is negative
    friend bool operator==(const LeaningEdge&, const LeaningEdge&) = default;
};

//! Where a field over a control mesh is not smooth: infinitely sharp edges and vertices. The rim is a crease
//! always and need not be named. Where three creases or more meet is a corner; where one ends the field is smooth.
struct FieldCreases {
    std::vector<std::uint32_t> edges;    // of the control mesh, in ascending order
    std::vector<std::uint32_t> corners;  // vertices whose value stays, in ascending order
    std::vector<LeaningEdge> leaning;    // none of them a crease
    friend bool operator==(const FieldCreases&, const FieldCreases&) = default;
};

//! Values at the vertices of the finest level, by C. Loop's rules with the creases of H. Hoppe et al. 1994, as
//! OpenSubdiv has them (but for leaning edges): at a fraction of its time for many fields with creases of their own on one topology.
std::vector<double> refined_values(const LoopTopology& topology, const FieldCreases& creases,
                                   const std::vector<double>& control);

//! The same, then moved onto the limit surface. All weights are positive or 0, so no value leaves the range of
//! those around it.
std::vector<double> limit_values(const LoopTopology& topology, const FieldCreases& creases,
                                 const std::vector<double>& control);

//! The limit value of each control vertex as weights of control values; row v has column v.
SparseRows limit_rows(const LoopLevel& control, const FieldCreases& creases);

}  // namespace stratareeb
