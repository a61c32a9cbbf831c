// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/layer_model.h"

namespace stratareeb {

//! A layer's connected part of a level: an outer ring, counter-clockwise, then the holes in it, clockwise; rings without a
//! repeated last point, in map coordinates.
struct LevelPolygon {
    std::size_t layer = 0;
    std::vector<std::vector<Point2>> rings;
};

//! What a model shows on a horizontal cut at elevation z (map coordinates): a layer is where its top is at z or above and
//! its base below. Polygons tile the part of the footprint between ground and lowest base: they share the numbers of their
//! borders. Layer by layer, top first. Time in proportion to the plan mesh, times the layers that the level meets in a triangle.
std::vector<LevelPolygon> horizontal_section(const LayerModel& model, double z);

//! Of the outer ring less the holes.
double area(const LevelPolygon& polygon);

}  // namespace stratareeb
