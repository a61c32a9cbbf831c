// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "boreholes/point.h"
#include "io/cad_body.h"

namespace stratareeb {

struct StepDocumentOptions {
    std::string length_unit = "m";      // of the coordinates: "m", "ft" or "us-ft"
    Point3 origin = {};                 // recorded in the products' description, not applied
    bool has_parameter_curves = false;  // edges' curves in the parameters of faces; planes need none
};

//! Write bodies as named, coloured products of one STEP file (AP214), numbers in full, colours in the order of the
//! bodies, no clock in the header: the same bodies give the same bytes. The file appears whole or not at all.
//! \throw InvalidInput if there is no body or the unit is not one of the three; GeometryError where OpenCASCADE
//! can't; IoError if the file can't be written.
void write_step_document(const std::filesystem::path& path, std::span<const CadBody> bodies,
                         const StepDocumentOptions& options);

}  // namespace stratareeb
