// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/command.h"
#include "apps/field_option.h"
#include "apps/input_mesh.h"
#include "apps/keep_existing.h"
#include "io/write_contours.h"
#include "reeb/contour_nesting.h"
#include "reeb/level_set.h"

namespace stratareeb {
namespace {

struct LevelsArguments {
    std::string mesh, output, field = "z";
    std::vector<double> at;
    std::size_t count = 0;
    bool repair = false, overwrite = false, json = false;
};

struct LevelSummary {
    std::size_t closed = 0, polygons = 0, holes = 0;
    double length = 0;
    double area =
        0;  // of the polygons with holes; contours in no plane: what they run around, seen from above
};

LevelSummary summary_of(const LevelSet& set, const std::optional<Point3>& direction) {
    LevelSummary summary;
    for (const Contour& contour : set.contours) {
        summary.closed += contour.closed;
        summary.length += contour.length();
        if (!direction) summary.area += contour.plan_area();
    }
    summary.area = std::abs(summary.area);
    if (!direction) return summary;
    const ContourNesting nesting = nest_contours(set, *direction);
    summary.polygons = nesting.polygons.size();
    for (const ContourPolygon& polygon : nesting.polygons) summary.holes += polygon.holes.size();
    summary.area = enclosed_area(set, nesting, *direction);
    return summary;
}

nlohmann::ordered_json json_of(const LevelSet& set, const LevelSummary& summary, bool nested) {
    nlohmann::ordered_json json{{"z", set.level},
                                {"contours", set.contours.size()},
                                {"closed", summary.closed},
                                {"length", summary.length},
                                {"area", summary.area}};
    if (nested) json.update({{"polygons", summary.polygons}, {"holes", summary.holes}});
    return json;
}

void run(const LevelsArguments& arguments) {
    if (!arguments.output.empty()) keep_existing(arguments.output, arguments.overwrite);
    const InputMesh input = read_input_mesh(arguments.mesh, arguments.repair);
    const ScalarField field = field_of(input, arguments.field);
    const auto direction = field_direction(arguments.field);
    const auto sets = level_sets(input.mesh, field,
                                 arguments.at.empty() ? even_levels(field, arguments.count) : arguments.at);
    if (!arguments.output.empty()) write_contours(arguments.output, sets, direction);
    nlohmann::ordered_json json{{"levels", nlohmann::ordered_json::array()}};
    for (const LevelSet& set : sets) {
        const LevelSummary summary = summary_of(set, direction);
        json["levels"].push_back(json_of(set, summary, direction.has_value()));
        if (!arguments.json)
            fmt::print("{:>14.7g}  {:>6} contours, {:>6} closed, {:>6} holes, length {:.7g}, area {:.7g}\n",
                       set.level, set.contours.size(), summary.closed, summary.holes, summary.length,
                       summary.area);
    }
    if (arguments.json) fmt::print("{}\n", json.dump(2));
}

}  // namespace

void add_levels_command(CLI::App& program) {
    auto arguments = std::make_shared<LevelsArguments>();
    CLI::App* command = program.add_subcommand("levels", "Contours of a mesh at given heights");
    command->add_option("MESH", arguments->mesh, "Mesh file")->required();
    command->add_option("-o,--output", arguments->output, "File for the contours, .json or .obj");
    auto* at = command->add_option("--at", arguments->at, "Levels, with commas between")->delimiter(',');
    command->add_option("--count", arguments->count, "Number of levels, evenly between lowest and highest")
        ->check(CLI::Range(1, 1'000'000))
        ->excludes(at);
    add_field_option(*command, arguments->field);
    add_repair_option(*command, arguments->repair);
    command->add_flag("--overwrite", arguments->overwrite, "Replace a file that is there");
    command->add_flag("--json", arguments->json, "Print JSON");
    command->callback([arguments] {
        if (arguments->at.empty() && arguments->count == 0) throw CLI::RequiredError("--at or --count");
        run(*arguments);
    });
}

}  // namespace stratareeb
