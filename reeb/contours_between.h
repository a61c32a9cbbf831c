// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "boreholes/point.h"
#include "reeb/height_scale.h"
#include "reeb/homotopy_weights.h"
#include "reeb/mesh_contours.h"

namespace stratareeb {

//! What a homotopy of round pace makes at a height between contour k and the next of an edge, by the contours around.
std::vector<Point3> contour_between(const std::vector<LevelContour>& contours, std::size_t k, double z,
                                    const HeightScale& scale, HomotopyKind kind);

//! Does that cross itself, at one of three heights?
bool crosses_between(const std::vector<LevelContour>& contours, std::size_t k, const HeightScale& scale,
                     HomotopyKind kind);

//! Largest distance in plan from some points of one contour to the line of another.
double plan_deviation(const std::vector<Point3>& from, const std::vector<Point3>& to);

}  // namespace stratareeb
