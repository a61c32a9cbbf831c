// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/level_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/keep_existing.h"
#include "apps/mesh_report.h"
#include "boreholes/errors.h"
#include "io/drawing_page.h"
#include "io/map_drawing.h"
#include "io/write_features.h"
#include "mesh/horizontal_section.h"
#include "reeb/readable_graph.h"

namespace stratareeb {
namespace {

using nlohmann::json;

constexpr std::size_t kMostNodes = 24;  // of a layer's graph: more levels than that nobody looks through

struct Level {
    double z = 0;
    std::vector<LevelPolygon> polygons;
};

//! Heights of the nodes of all layers' Reeb graphs, simplified until people can read them, ascending. Of those nearer to one another
//! than a thousandth of the range only the first stays.
std::vector<double> critical_heights(const LayerModel& model) {
    std::vector<double> heights;
    for (std::size_t i = 0; i < model.units.size(); ++i) {
        const TriMesh solid = build_layer_solid(model, i).surface;
        if (solid.n_faces() == 0) continue;
        for (const auto& node : readable_graph(solid, height_field(solid), kMostNodes).graph.nodes)
            heights.push_back(node.value + model.origin.z);
    }
    std::ranges::sort(heights);
    std::vector<double> apart;
    const double distance = heights.empty() ? 0 : (heights.back() - heights.front()) / 1000;
    for (const double z : heights)
        if (apart.empty() || z - apart.back() > distance) apart.push_back(z);
    return apart;
}

std::vector<Level> levels_of(const SectionArguments& arguments, const LayerModel& model) {
    std::vector<Level> levels;
    const std::vector<double> heights =
        arguments.at_z ? std::vector{*arguments.at_z} : critical_heights(model);
    for (const double z : heights)
        if (auto polygons = horizontal_section(model, z); !polygons.empty())
            levels.push_back({z, std::move(polygons)});
    if (levels.empty())
        throw InvalidInput(arguments.at_z
                               ? fmt::format("nothing of the model lies at z = {:.10g}", heights[0])
                               : std::string("the model has no level with anything in it"));
    return levels;
}

std::vector<MapArea> areas_of(const Level& level) {
    std::vector<MapArea> areas;
    for (const LevelPolygon& polygon : level.polygons) areas.push_back({polygon.rings, polygon.layer});
    return areas;
}

std::vector<double> sizes_of(const LayerModel& model, const Level& level) {
    std::vector<double> sizes(model.units.size(), 0);
    for (const LevelPolygon& polygon : level.polygons) sizes[polygon.layer] += area(polygon);
    return sizes;
}

json rings_json(const LevelPolygon& polygon) {
    json rings = json::array();
    for (const auto& ring : polygon.rings) {
        json points = json::array();
        for (const Point2& p : ring) points.push_back({p.x, p.y});
        rings.push_back(std::move(points));
    }
    return rings;
}

json level_json(const LayerModel& model, const Level& level) {
    json result{{"z", level.z}, {"length_unit", model.length_unit}, {"units", json::array()}};
    const auto sizes = sizes_of(model, level);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        json polygons = json::array();
        for (const LevelPolygon& polygon : level.polygons)
            if (polygon.layer == i) polygons.push_back(rings_json(polygon));
        result["units"].push_back({{"order", i + 1},
                                   {"code", model.units[i].code},
                                   {"name", model.units[i].name},
                                   {"color", model.units[i].color},
                                   {"area", sizes[i]},
                                   {"polygons", std::move(polygons)}});
    }
    return result;
}

void print_level(const LayerModel& model, const Level& level) {
    const auto sizes = sizes_of(model, level);
    fmt::print("level z = {:.10g} {}\n{:>3}  {:<24} {:>14}\n", level.z, model.length_unit, "", "layer",
               fmt::format("area [{}²]", model.length_unit));
    for (std::size_t i = 0; i < sizes.size(); ++i)
        if (sizes[i] > 0) fmt::print("{:>3}  {:<24} {:>14.7g}\n", i + 1, model.units[i].name, sizes[i]);
}

void draw(const std::string& file, const SectionArguments& arguments, const SavedModel& saved,
          const Level& level) {
    const std::string about = fmt::format("level z = {:.10g} {}", level.z, saved.model.length_unit);
    PlanMap map = map_of(saved, arguments.title.empty() ? about : arguments.title);
    map.note = arguments.title.empty() ? "" : about;
    map.areas = areas_of(level);
    write_plan_map(file, map);
}

//! "level.svg" and 3: "level_03.svg".
std::string numbered(const std::filesystem::path& file, std::size_t number) {
    return (file.parent_path() /
            fmt::format("{}_{:02}{}", file.stem().string(), number, file.extension().string()))
        .string();
}

std::vector<MapFeature> features_of(const std::vector<Level>& levels, const std::vector<Unit>& units) {
    std::vector<MapFeature> features;
    for (const Level& level : levels)
        for (MapFeature& feature : area_features(areas_of(level), units)) {
            feature.attributes.emplace_back("z", level.z);
            for (auto& part : feature.parts)
                for (Point3& p : part) p.z = level.z;
            features.push_back(std::move(feature));
        }
    return features;
}

}  // namespace

void run_level_sections(const SectionArguments& arguments, const SavedModel& saved) {
    const LayerModel& model = saved.model;
    const std::vector<Level> levels = levels_of(arguments, model);
    std::vector<std::string> files;  // in the order of outputs, of levels
    for (const std::string& output : arguments.outputs) {
        const bool each = arguments.critical && is_drawing_file(output);
        for (std::size_t i = 0; i < (each ? levels.size() : 1); ++i) {
            files.push_back(each ? numbered(output, i + 1) : output);
            keep_existing(files.back(), arguments.overwrite);
        }
    }
    auto file = files.begin();
    for (const std::string& output : arguments.outputs) {
        if (is_drawing_file(output))
            for (std::size_t i = 0; i < (arguments.critical ? levels.size() : 1); ++i)
                draw(*file++, arguments, saved, levels[i]);
        else
            write_features(
                *file++, features_of(levels, model.units),
                {.table = "level", .crs = saved.crs_or(arguments.crs), .flat = !arguments.critical});
    }
    if (!arguments.json) {
        for (const Level& level : levels) print_level(model, level);
        return;
    }
    json list = json::array();
    for (const Level& level : levels) list.push_back(level_json(model, level));
    std::fputs(json_text(arguments.critical ? json{{"levels", std::move(list)}} : list[0]).c_str(), stdout);
}

}  // namespace stratareeb
