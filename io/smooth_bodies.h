// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "io/cad_body.h"
#include "mesh/layer_model.h"
#include "subdivision/smooth_brep.h"

namespace stratareeb {

struct SmoothBodiesOptions {
    SmoothBrepOptions fit;
    double volume_tolerance = 2e-3;  // share by which a body's volume may differ from its triangles'
    double most_edge_off = 1e-3;     // share of the size by which faces may miss the edge that they meet in
    double most_off =
        1e-2;  // share of the size that a face may be off the model's vertices, but for a thousandth
    double most_of_relief = 0.15;  // share of the range of the model's elevations that it may be off at most
    double facet_error = 1e-3;     // share of the size that facets may be off, where a body has some
    double worth_telling = 0.5;    // share of what a face may be off, from which on a note says so
    std::function<void(const char* step, double share)> progress = {};  // 0..1, from one thread at a time
};

struct SmoothBodyReport {
    std::string name;
    bool smooth = true;  // otherwise made of facets
    std::size_t faces = 0;
    double off = 0;          // largest distance of its faces from the model's vertices
    double edge_off = 0;     // and of its edges from the faces that meet there
    double volume = 0;       // of the CAD solid
    double mesh_volume = 0;  // of the model's triangles
};

struct SmoothBodies {
    std::vector<CadBody> bodies;            // layer by layer from the top
    std::vector<SmoothBodyReport> reports;  // [bodies]
    std::vector<std::string> notes;         // which bodies have facets, and why; which are far off somewhere
};

//! CAD solids of few smooth faces: top and base one trimmed B-spline face for each neighbour, the same face as
//! the neighbour's; upright walls along the sides of the footprint; pinch-outs end in an edge. A body whose
//! smooth solid is not sound (by OpenCASCADE's check), crosses itself or is too far from the model gets planar
//! facets instead, with a note; its neighbours stay smooth.
SmoothBodies smooth_bodies(const LayerModel& model, const SmoothBodiesOptions& options = {});

}  // namespace stratareeb
