// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "boreholes/point.h"
#include "io/smooth_bodies.h"
#include "mesh/layer_model.h"
#include "mesh/layer_solid.h"

namespace stratareeb {

enum class StepKind { Faceted, Smooth };

struct StepOptions {
    std::string length_unit =
        "m";  // of the coordinates: "m", "ft" or "us-ft"; stated in the file, so sizes are true
    Point3 origin =
        {};  // map coordinates of the local zero; recorded in the products' description, not applied
};

struct StepReport {
    std::size_t solids = 0;
    std::size_t faces = 0;                 // planar ones after coplanar neighbours were merged
    std::vector<SmoothBodyReport> bodies;  // of smooth files: one a solid, in their order
    std::vector<std::string> notes;        // of smooth files: which bodies have facets, and why
};

//! Write one STEP solid (AP214, boundary representation) per body, named after its unit (", body 2" and so on
//! where a layer has several) and in the unit's colour. Faces are planar: coplanar neighbouring triangles
//! become one polygon. A shell that faces inwards becomes a cavity of the body around it. Absent layers are
//! left out. The file appears whole or not at all; the same input gives the same bytes.
//! \throw InvalidInput
//! if no layer has a body, a surface is open, or the unit is not one of the three;
//!        GeometryError where a body can't be made; IoError if the file can't be written.
StepReport write_step(const std::filesystem::path& path, std::span<const LayerSolid> solids,
                      const StepOptions& options = {});

//! The same of few smooth faces, as smooth_bodies makes them, in the model's unit and with its origin on record.
//! \throw as write_step.
StepReport write_smooth_step(const std::filesystem::path& path, const LayerModel& model,
                             const SmoothBodiesOptions& options = {});

}  // namespace stratareeb
