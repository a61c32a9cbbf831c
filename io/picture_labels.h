// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/mesh_part.h"

namespace stratareeb {

struct LegendEntry {
    std::string name;
    Rgb color;
};

//! What stands around the model in a picture.
struct PictureLabels {
    std::string title;
    std::vector<LegendEntry> legend;
    std::string length_unit;
    double exaggeration = 1;
    double pixels_along = 1;  // of one unit of length, left to right
    double pixels_up = 1;     // of one unit of elevation, as drawn
    std::array<double, 2> north{
        0, 1};  // the ground's north as it appears, x right and y up, length 1 seen from above
    bool has_holes = false;
};

//! Pixels that the legend takes at the right, margins included.
double legend_width(const PictureLabels& labels, int width, int height);

//! Put the labels over the pixels (0xffRRGGBB, rows from the top) and encode the result as PNG.
//! \throw IoError if the drawing library refuses
std::string labelled_png(std::vector<std::uint32_t> pixels, int width, int height,
                         const PictureLabels& labels);

}  // namespace stratareeb
