// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/layer_model.h"
#include "mesh/plan_locator.h"

namespace stratareeb {

//! A place on a section's line.
struct SectionStation {
    double along = 0;              // distance from the line's start
    Point2 at;                     // map coordinates
    std::vector<double> horizons;  // elevations: ground, then the base of each layer
};

//! What a model shows on a vertical cut along a line. Between two stations of a run, every horizon is straight.
struct VerticalSection {
    std::vector<Point2> line;                       // as asked for, map coordinates
    std::vector<double> corners;                    // distance of each of its points from the start
    std::vector<std::vector<SectionStation>> runs;  // the parts inside the footprint, in order

    double length() const { return corners.empty() ? 0 : corners.back(); }
};

//! A layer's part of a section: a closed outline without a repeated last point, `x` = distance along the line, `y` =
//! elevation; counter-clockwise.
struct SectionPolygon {
    std::size_t layer = 0;
    std::vector<Point2> outline;
};

//! Cut a model along a polyline. Stations stand wherever the line crosses an edge of the plan mesh or turns. Time grows
//! with the triangles near the line.
//! \throw InvalidInput if the line has fewer than two different points, or lies outside the footprint.
VerticalSection vertical_section(const LayerModel& model, const PlanLocator& locator,
                                 const std::vector<Point2>& line);

//! The polygons of all layers, top layer first, from left to right. They tile the section: no gap, no overlap, the same
//! numbers on both sides of an interface.
std::vector<SectionPolygon> section_polygons(const VerticalSection& section);

double area(const SectionPolygon& polygon);

//! Area between ground and lowest base.
double envelope_area(const VerticalSection& section);

}  // namespace stratareeb
