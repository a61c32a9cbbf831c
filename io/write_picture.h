// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "boreholes/point.h"
#include "mesh/layer_solid.h"

namespace stratareeb {

//! A borehole as the picture shows it: a thin pin that sticks out of the ground and crosses the gaps between
//! layers.
struct PictureHole {
    Point3 collar;
    double bottom = 0;  // elevation
};

struct PictureOptions {
    int width = 1600, height = 1000;  // pixels
    double azimuth_deg = -35;  // where the eye stands: 0 = south of the model, looking north; 90 = east of it
    double elevation_deg = 28;  // of the eye above the horizon; 90 looks straight down
    double vertical_exaggeration =
        0;  // 0 = chosen so that the model is neither a sheet nor a tower; stated in the picture
    double explode = 0.15;  // gap between layers, as a fraction of the model's height
    std::string title = {};
    std::string length_unit = "m";  // for the scale bars: "m", "ft" or "us-ft"
    std::vector<PictureHole> holes = {};
};

//! Draw layer solids as a PNG: parallel projection, soft light, dark outlines, legend, scale bars and north
//! arrow. Needs no screen and no graphics card. The same input gives the same bytes (with the same fonts
//! installed).
//! \throw InvalidInput if there is nothing to draw or an option is out of range; IoError if the
//! file can't be written.
void write_picture(const std::filesystem::path& png, std::span<const LayerSolid> solids,
                   const PictureOptions& options = {});

}  // namespace stratareeb
