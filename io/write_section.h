// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "boreholes/borehole.h"
#include "mesh/section_holes.h"
#include "mesh/vertical_section.h"

namespace stratareeb {

struct SectionDrawingOptions {
    std::string title = {};
    std::string length_unit = "m";
    double exaggeration = 0;  // of heights; 0 = a round factor that fills the page, stated in the drawing
    std::vector<SectionHole> holes = {};
};

//! Draw a vertical section as .svg, .pdf or .png: the layers in their colours, the holes near the line as columns of
//! their own logs, axes in map units, the line's corners with their coordinates, a legend, and the vertical exaggeration.
//! \throw IoError for another extension or if the file can't be written; InvalidInput for an exaggeration that is not
//! above 0.
void write_section_drawing(const std::filesystem::path& file, const VerticalSection& section,
                           const std::vector<Unit>& units, const SectionDrawingOptions& options = {});

}  // namespace stratareeb
