// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "boreholes/borehole.h"
#include "boreholes/point.h"
#include "io/mesh_part.h"

namespace stratareeb {

//! A filled area of a map: rings as in LevelPolygon, map coordinates.
struct MapArea {
    std::vector<std::vector<Point2>> rings;
    std::size_t entry = 0;  // of the legend
};

//! A line of a map; its label stands in it where it is long enough.
struct MapLine {
    std::vector<Point2> points;
    bool closed = false;
    std::string label;
    bool bold = false;
};

struct MapPoint {
    Point2 at;
    std::string label;
};

//! What a map shows.
struct PlanMap {
    std::string title, note;  // over and under it
    std::string length_unit = "m";
    struct Entry {
        std::string name;
        Rgb color{};
    };
    std::vector<Entry> legend;
    std::vector<MapArea> areas;
    std::vector<MapLine> lines;
    std::vector<MapPoint> points;              // boreholes
    std::vector<std::vector<Point2>> outline;  // of the footprint; the map covers it
};

//! Draw a map as .svg, .pdf or .png: true to scale, north up, with a frame of coordinates, a scale bar and a legend.
//! \throw IoError for another extension or if the file can't be written; InvalidInput if there is no outline
void write_plan_map(const std::filesystem::path& file, const PlanMap& map);

}  // namespace stratareeb
