// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "boreholes/borehole.h"
#include "io/write_features.h"
#include "io/write_plan_map.h"
#include "mesh/horizontal_section.h"
#include "mesh/layer_model.h"

namespace stratareeb {

//! What a map of a model is about.
enum class MapSubject { Ground, Top, Base, Thickness };

//! A quantity over the plan: the ground, the horizon above or below a layer, or its thickness; elevations, not from the
//! origin. The layer means nothing for the ground.
std::vector<double> mapped_field(const LayerModel& model, MapSubject subject, std::size_t layer);

//! A line of equal value; an open one ends where its layer does.
struct ContourLine {
    double value = 0;
    bool closed = false;
    std::vector<Point2> points;  // map coordinates
};

//! A round interval that gives about a dozen values among those used.
double suitable_interval(const std::vector<double>& field, const std::vector<char>& use);

//! Lines over the part of the plan where the layer is, at multiples of the interval, ascending.
//! \throw InvalidInput if the interval is not above 0, or so small that there would be more than 10,000 values
std::vector<ContourLine> contour_lines(const LayerModel& model, MapSubject subject, std::size_t layer,
                                       double interval);

//! The same of any field of the plan's vertices, over the part where a layer is, or over all of it.
std::vector<ContourLine> contour_lines(const LayerModel& model, const std::vector<double>& field,
                                       std::optional<std::size_t> layer, double interval);

//! The vertices of a layer's region, thickness 0 along its rim included.
std::vector<char> layer_vertices(const LayerModel& model, std::size_t layer);

//! The areas in which a layer is.
std::vector<MapArea> layer_areas(const LayerModel& model, std::size_t layer);

//! Words for titles: "thickness of clay [m]".
std::string subject_words(const LayerModel& model, MapSubject subject, std::size_t layer);

}  // namespace stratareeb
