// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/keep_existing.h"
#include "apps/level_section.h"
#include "apps/mesh_report.h"
#include "boreholes/errors.h"
#include "io/drawing_page.h"
#include "io/map_drawing.h"
#include "io/mesh_format.h"
#include "io/read_model.h"
#include "io/write_features.h"
#include "io/write_mesh.h"
#include "io/write_section.h"
#include "mesh/fence_mesh.h"
#include "mesh/vertical_section.h"

namespace stratareeb {
namespace {

using nlohmann::json;

std::vector<Point2> line_of(const SectionArguments& arguments, const SavedModel& saved) {
    if (!arguments.through.empty()) {
        if (saved.survey.holes.empty())
            throw InvalidInput(arguments.folder +
                               ": no boreholes.json; build the model again to cut through holes");
        return line_through(saved.survey, arguments.through);
    }
    std::vector<Point2> line;
    for (std::size_t i = 0; i + 1 < arguments.along.size(); i += 2)
        line.push_back({arguments.along[i], arguments.along[i + 1]});
    return line;
}

//! Holes near enough to be of interest: those on the line of a fence; else within a fiftieth of its length.
std::vector<SectionHole> holes_of(const SectionArguments& arguments, const SavedModel& saved,
                                  const VerticalSection& section) {
    const double usual = section.length() / (arguments.through.empty() ? 50 : 1e6);
    return holes_along(section, saved.survey, arguments.holes_within >= 0 ? arguments.holes_within : usual);
}

json section_json(const SavedModel& saved, const VerticalSection& section,
                  const std::vector<SectionPolygon>& polygons, const std::vector<SectionHole>& holes) {
    const auto& units = saved.model.units;
    std::vector<double> areas(units.size(), 0);
    std::vector<json> outlines(units.size(), json::array());
    for (const SectionPolygon& polygon : polygons) {
        areas[polygon.layer] += area(polygon);
        json outline = json::array();
        for (const Point2& p : polygon.outline) outline.push_back({p.x, p.y});
        outlines[polygon.layer].push_back(std::move(outline));
    }
    json result{{"length", section.length()},
                {"length_unit", saved.model.length_unit},
                {"envelope_area", envelope_area(section)},
                {"line", json::array()},
                {"units", json::array()},
                {"holes", json::array()}};
    for (const Point2& p : section.line) result["line"].push_back({p.x, p.y});
    for (std::size_t i = 0; i < units.size(); ++i)
        result["units"].push_back({{"order", i + 1},
                                   {"code", units[i].code},
                                   {"name", units[i].name},
                                   {"color", units[i].color},
                                   {"area", areas[i]},
                                   {"polygons", std::move(outlines[i])}});
    for (const SectionHole& hole : holes)
        result["holes"].push_back({{"id", hole.id}, {"along", hole.along}, {"aside", hole.aside}});
    return result;
}

void print_section(const SavedModel& saved, const VerticalSection& section,
                   const std::vector<SectionPolygon>& polygons) {
    const auto& model = saved.model;
    const std::string& u = model.length_unit;
    fmt::print("section of {:.6g} {}, {} piece{} inside the footprint\n{:>3}  {:<24} {:>14} polygons\n",
               section.length(), u, section.runs.size(), section.runs.size() == 1 ? "" : "s", "", "layer",
               fmt::format("area [{}²]", u));
    for (std::size_t i = 0; i < model.units.size(); ++i) {
        double sum = 0;
        std::size_t count = 0;
        for (const SectionPolygon& polygon : polygons)
            if (polygon.layer == i) {
                sum += area(polygon);
                ++count;
            }
        fmt::print("{:>3}  {:<24} {:>14.7g} {:>8}\n", i + 1, model.units[i].name, sum, count);
    }
    fmt::print("{:>3}  {:<24} {:>14.7g}\n", "", "all", envelope_area(section));
}

void check_usage(const SectionArguments& arguments) {
    const int ways = !arguments.along.empty() + !arguments.through.empty() + arguments.at_z.has_value() +
                     arguments.critical;
    const bool is_level = arguments.at_z || arguments.critical;
    if (ways != 1)
        throw CLI::ValidationError(
            "section",
            "give one of --along x,y,x,y,…, --through HOLE,HOLE,… and, for levels, --at-z z or --critical");
    if (arguments.along.size() % 2 != 0)
        throw CLI::ValidationError("--along", "has an odd number of coordinates; it takes x,y,x,y,…");
    for (const std::string& output : arguments.outputs)
        if (!is_drawing_file(output) && !is_feature_file(output) && (is_level || !is_mesh_file(output)))
            throw CLI::ValidationError(
                "-o", fmt::format("{}: {} are written as .svg, .pdf, .png, .gpkg, .dxf, .geojson{}", output,
                                  is_level ? "levels" : "sections",
                                  is_level ? "" : " or, in space, .ply, .obj, .glb, .stl, .off, .3mf"));
}

//! The section in space, a part for each layer.
void write_fence(const std::string& file, const VerticalSection& section, const LayerModel& model) {
    const std::vector<TriMesh> meshes = fence_meshes(section, model.units.size(), model.origin);
    std::vector<MeshPart> parts;
    for (std::size_t i = 0; i < meshes.size(); ++i)
        if (meshes[i].n_faces() > 0) parts.push_back({model.units[i].name, model.units[i].color, &meshes[i]});
    write_meshes(file, parts);
}

void run(const SectionArguments& arguments) {
    check_usage(arguments);
    if (!arguments.critical)  // its drawings get numbers
        for (const std::string& output : arguments.outputs) keep_existing(output, arguments.overwrite);
    const SavedModel saved = read_model(arguments.folder);
    if (arguments.at_z || arguments.critical) return run_level_sections(arguments, saved);
    const LayerModel& model = saved.model;
    const VerticalSection section =
        vertical_section(model, PlanLocator(model.plan.surface), line_of(arguments, saved));
    const auto polygons = section_polygons(section);
    const auto holes = holes_of(arguments, saved, section);
    for (const std::string& output : arguments.outputs) {
        if (is_drawing_file(output))
            write_section_drawing(output, section, model.units,
                                  {.title = arguments.title,
                                   .length_unit = model.length_unit,
                                   .exaggeration = arguments.exaggeration,
                                   .holes = holes});
        else if (is_mesh_file(output))
            write_fence(output, section, model);
        else
            write_features(output, section_features(polygons, model.units), {.table = "section", .crs = ""});
    }
    if (arguments.json)
        std::fputs(json_text(section_json(saved, section, polygons, holes)).c_str(), stdout);
    else
        print_section(saved, section, polygons);
}

}  // namespace

void add_section_command(CLI::App& program) {
    const auto arguments = std::make_shared<SectionArguments>();
    CLI::App* command =
        program.add_subcommand("section", "Cut a built model along a line, through boreholes or at a level");
    command->add_option("DIR", arguments->folder, "Folder that build wrote")->required();
    command->add_option("--along", arguments->along, "The line: x,y,x,y,… in map coordinates")
        ->delimiter(',');
    command->add_option("--through", arguments->through, "A fence: names of boreholes, in order")
        ->delimiter(',');
    command->add_option("--at-z", arguments->at_z, "A level instead: a horizontal section at this elevation");
    command->add_flag("--critical", arguments->critical,
                      "Levels at all heights at which the contours of a layer come, go, part or join");
    command->add_option("--crs", arguments->crs,
                        "Coordinate reference system of the model, for the polygons of a level, as "
                        "EPSG:27700 (the model's own)");
    command->add_option(
        "-o,--output", arguments->outputs,
        "Drawing (.svg, .pdf, .png), polygons for CAD and GIS (.dxf, .gpkg, .geojson), or the upright panel "
        "in space as a mesh (.ply, .obj, .glb, …); may be repeated");
    command
        ->add_option("--exaggeration", arguments->exaggeration,
                     "How much taller heights are drawn (a round factor that fills the page)")
        ->check(CLI::PositiveNumber);
    command
        ->add_option(
            "--holes-within", arguments->holes_within,
            "Draw boreholes no farther from the line than this (a 50th of its length; on a fence its own)")
        ->check(CLI::NonNegativeNumber);
    command->add_option("--title", arguments->title, "Over the drawing");
    command->add_flag("--json", arguments->json, "Print areas and polygons as JSON");
    command->add_flag("--overwrite", arguments->overwrite, "Replace files that are there");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace stratareeb
