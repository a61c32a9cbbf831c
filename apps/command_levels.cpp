// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/command.h"
#include "apps/field_option.h"
#include "io/write_contours.h"
#include "reeb/level_set.h"

namespace stratareeb {
namespace {

struct LevelsArguments {
    std::string mesh, output, field = "z";
    std::vector<double> at;
    std::size_t count = 0;
    bool overwrite = false, json = false;
};

struct LevelSummary {
    std::size_t closed = 0;
    double length = 0, area = 0;
};

LevelSummary summary_of(const LevelSet& set) {
    LevelSummary summary;
    for (const Contour& contour : set.contours) {
        summary.closed += contour.closed;
        summary.length += contour.length();
        summary.area += contour.plan_area();
    }
    return summary;
}

void run(const LevelsArguments& arguments) {
    if (!arguments.output.empty()) keep_existing(arguments.output, arguments.overwrite);
    const TriMesh mesh = half_edge_mesh_of(arguments.mesh);
    const ScalarField field = field_of(mesh, arguments.field);
    const auto sets =
        level_sets(mesh, field, arguments.at.empty() ? even_levels(field, arguments.count) : arguments.at);
    if (!arguments.output.empty()) write_contours(arguments.output, sets);
    nlohmann::ordered_json json{{"levels", nlohmann::ordered_json::array()}};
    for (const LevelSet& set : sets) {
        const LevelSummary summary = summary_of(set);
        json["levels"].push_back({{"z", set.level},
                                  {"contours", set.contours.size()},
                                  {"closed", summary.closed},
                                  {"length", summary.length},
                                  {"area", summary.area}});
        if (!arguments.json)
            fmt::print("{:>14.7g}  {:>6} contours, {:>6} closed, length {:.7g}, area in plan {:.7g}\n",
                       set.level, set.contours.size(), summary.closed, summary.length, summary.area);
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
    command->add_flag("--overwrite", arguments->overwrite, "Replace a file that is there");
    command->add_flag("--json", arguments->json, "Print JSON");
    command->callback([arguments] {
        if (arguments->at.empty() && arguments->count == 0) throw CLI::RequiredError("--at or --count");
        run(*arguments);
    });
}

}  // namespace stratareeb
