// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "io/model_maps.h"
#include "io/read_model.h"
#include "io/write_features.h"
#include "io/write_plan_map.h"
#include "mesh/error_spread.h"
#include "mesh/vertical_section.h"

namespace stratareeb {

//! A map of a model with its outline, legend of all units, and boreholes, ready for areas and lines.
PlanMap map_of(const SavedModel& saved, const std::string& title);

//! Polygons of a section for GIS and CAD: x = distance along the line, y = elevation.
std::vector<MapFeature> section_features(const std::vector<SectionPolygon>& polygons,
                                         const std::vector<Unit>& units);

//! Areas with their unit as polygons for GIS.
std::vector<MapFeature> area_features(const std::vector<MapArea>& areas, const std::vector<Unit>& units);

//! Lines of equal value of the ground, a horizon or a thickness, with what a map of them shows.
struct ContourMap {
    MapSubject subject = MapSubject::Ground;
    std::size_t layer = 0;
    double interval = 0;
    std::vector<double> field;  // mapped_field of it, or how far off it may be
    std::string about;          // words for it, with its unit
    bool is_elevation = true;   // lines lie at their heights
    std::vector<ContourLine> lines;
    std::vector<MapArea> areas;  // where the layer is; none for the ground
};

//! `interval` 0: a round one that gives about a dozen lines.
//! \throw InvalidInput if the layer is absent everywhere, or as contour_lines does
ContourMap contour_map(const LayerModel& model, MapSubject subject, std::size_t layer, double interval = 0);

//! How far off the ground, a horizon or a thickness may be (error_spread).
//! \throw as contour_map; InvalidInput if too few boreholes know it
ContourMap spread_map(const SavedModel& saved, MapSubject subject, std::size_t layer, Spread spread,
                      const ErrorSpreadOptions& options, double interval = 0);

//! The map with its lines labelled, every fifth bold. An empty title: what it is about.
PlanMap drawn_map(const SavedModel& saved, const ContourMap& contours, const std::string& title = "");

//! The units at the ground.
PlanMap geology_drawing(const SavedModel& saved, const std::vector<MapArea>& areas,
                        const std::string& title = "");

//! The areas in which each layer is the topmost.
std::vector<MapArea> geology_areas(const LayerModel& model);

//! The lines for GIS and CAD, at their heights; those of what is no elevation at 0.
std::vector<MapFeature> line_features(const LayerModel& model, const ContourMap& contours);

//! The unit of a code or name, or its number from 1.
//! \throw InvalidInput naming the model's units
std::size_t unit_by_name(const LayerModel& model, const std::string& name);

}  // namespace stratareeb
