// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boreholes/point.h"
#include "mesh/tri_mesh.h"
#include "reeb/level_set.h"
#include "reeb/scalar_field.h"

namespace stratareeb {

//! One surface of a set, with the field that is swept, the same for all: say, height.
struct LayerSurface {
    const TriMesh* mesh = nullptr;
    const ScalarField* field = nullptr;
};

//! A piece of one layer's level set at a node's value.
struct LayerContour {
    std::uint32_t layer = 0;  // index of the surface
    std::uint32_t arc = 0;    // of that surface's own Reeb graph
    Contour contour;          // one point at a minimum or maximum
    Point3 center;
};

//! All layers' contours at one value.
struct LayeredNode {
    double value = 0;
    Point3
        center;  // the mean of the contours' centres, each weighing its length; of points alone, their mean
    std::vector<LayerContour> contours;  // by layer, then by arc
};

//! A layer's way from a node to the next one above at which it has contours.
struct LayeredArc {
    std::uint32_t lower = 0, upper = 0;  // nodes
    std::uint32_t layer = 0;
};

//! The Reeb graph of a set of surfaces (thesis, section 3.1): where a single surface's node stands for one critical point, a
//! node here stands for one height and carries the contours of all layers there.
struct LayeredReebGraph {
    std::vector<LayeredNode> nodes;  // from bottom to top
    std::vector<LayeredArc> arcs;    // by layer, from bottom to top
};

struct LayeredReebGraphOptions {
    double simplify = 0;  // leave out critical values of pairs below this share of a layer's range
    std::vector<double> further_levels;  // nodes at these values too, where a layer has contours
};

//! Nodes at the critical values of all layers, plateaus as one. A vertex at a node's value counts as above it, so a node's
//! contours are those just below; a minimum stands for itself as a point.
//! \throw InvalidInput if a field does not fit its mesh
LayeredReebGraph layered_reeb_graph(std::span<const LayerSurface> layers,
                                    const LayeredReebGraphOptions& options = {});

}  // namespace stratareeb
