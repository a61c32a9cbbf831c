// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "boreholes/point.h"
#include "mesh/layer_model.h"

namespace stratareeb {

//! A part of space in which volumes are asked for. Without members set: all of it.
struct VolumeWindow {
    std::optional<std::array<double, 2>> elevations;  // from, to; map coordinates
    std::optional<std::array<double, 2>> depths;      // from, to, below the ground; not with elevations
    std::vector<std::vector<Point2>> areas;           // see for_each_piece

    //! How much of a column's layer between these horizons lies in the window's range.
    double thickness(double ground, double top, double base) const;
};

struct WindowVolumes {
    std::vector<double> layers;     // top first
    std::vector<double> plan_area;  // of the window in each plan triangle
    double area() const;
};

//! Volume of each layer inside a window: the exact integral, piece by piece, of horizons that are linear over each plan
//! triangle. Windows that tile a larger one have volumes that add up to its own, but for rounding.
//! \throw InvalidInput if a range is upside down or not finite, or both ranges are given
WindowVolumes volumes_between(const LayerModel& model, const VolumeWindow& window);

}  // namespace stratareeb
