// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/keep_existing.h"
#include "apps/mesh_report.h"
#include "boreholes/errors.h"
#include "io/read_model.h"
#include "io/write_grid.h"
#include "io/write_modflow.h"
#include "mesh/model_grid.h"

namespace stratareeb {
namespace {

using nlohmann::json;

struct GridArguments {
    std::string folder, output, modflow, crs;
    double cell = 0, thinnest = 0;
    bool json = false, overwrite = false;
};

//! Ground and bases, one band each.
void write_horizons(const GridArguments& arguments, const SavedModel& saved, const PlanGrid& plan) {
    const LayerModel& model = saved.model;
    std::vector<const std::vector<double>*> fields;
    for (const auto& horizon : model.horizons) fields.push_back(&horizon);
    auto values = rasterized(model, plan, fields);
    Grid grid{.north_west = plan.north_west,
              .cell = plan.cell,
              .columns = plan.columns,
              .rows = plan.rows,
              .bands = {}};
    for (std::size_t k = 0; k < values.size(); ++k) {
        for (double& z : values[k]) z += model.origin.z;
        grid.bands.push_back(
            {k == 0 ? "ground" : "base of " + model.units[k - 1].name, std::move(values[k])});
    }
    write_grid(arguments.output, grid, saved.crs_or(arguments.crs));
}

json grid_json(const LayerModel& model, const FlowGrid& grid) {
    const PlanGrid& plan = grid.plan;
    json result{{"columns", plan.columns},
                {"rows", plan.rows},
                {"cell", plan.cell},
                {"north_west", {plan.north_west.x, plan.north_west.y}},
                {"length_unit", model.length_unit},
                {"layers", json::array()}};
    for (std::size_t i = 0; i < model.units.size(); ++i) {
        std::size_t active = 0, passed = 0;
        double volume = 0;
        for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
            active += grid.idomain[i][cell] == 1;
            passed += grid.idomain[i][cell] == -1;
            if (grid.idomain[i][cell] == 1) volume += grid.thickness(i, cell) * plan.cell * plan.cell;
        }
        result["layers"].push_back({{"layer", i + 1},
                                    {"code", model.units[i].code},
                                    {"active_cells", active},
                                    {"pass_through_cells", passed},
                                    {"volume", volume}});
    }
    return result;
}

void print_grid(const json& grid) {
    fmt::print("{} columns, {} rows of cells of {:g} {}\n{:>5}  {:<24} {:>12} {:>13} {:>14}\n",
               grid["columns"].get<std::size_t>(), grid["rows"].get<std::size_t>(),
               grid["cell"].get<double>(), grid["length_unit"].get<std::string>(), "layer", "unit", "active",
               "pass-through", "volume");
    for (const auto& layer : grid["layers"])
        fmt::print("{:>5}  {:<24} {:>12} {:>13} {:>14.7g}\n", layer["layer"].get<std::size_t>(),
                   layer["code"].get<std::string>(), layer["active_cells"].get<std::size_t>(),
                   layer["pass_through_cells"].get<std::size_t>(), layer["volume"].get<double>());
}

void run(const GridArguments& arguments) {
    if (arguments.output.empty() && arguments.modflow.empty())
        throw CLI::ValidationError("grid", "give -o FILE.tif, --modflow DIR, or both");
    if (!arguments.output.empty() && !is_grid_file(arguments.output))
        throw CLI::ValidationError("-o", arguments.output + ": grids of all horizons are written as .tif");
    if (!arguments.output.empty()) keep_existing(arguments.output, arguments.overwrite);
    const SavedModel saved = read_model(arguments.folder);
    const PlanGrid plan = grid_over(saved.model, arguments.cell);
    const FlowGrid grid = flow_grid(saved.model, plan, arguments.thinnest);
    if (!arguments.output.empty()) write_horizons(arguments, saved, plan);
    if (!arguments.modflow.empty()) {
        StagedFolder folder(arguments.modflow, arguments.overwrite);
        write_modflow(folder, grid, saved.model);
        folder.commit({});
    }
    const json result = grid_json(saved.model, grid);
    if (arguments.json)
        std::fputs(json_text(result).c_str(), stdout);
    else
        print_grid(result);
}

}  // namespace

void add_grid_command(CLI::App& program) {
    const auto arguments = std::make_shared<GridArguments>();
    CLI::App* command =
        program.add_subcommand("grid", "A built model on square cells: horizons, MODFLOW arrays");
    command->add_option("DIR", arguments->folder, "Folder that build wrote")->required();
    command->add_option("--cell", arguments->cell, "Side of the cells, in the model's unit")
        ->required()
        ->check(CLI::PositiveNumber);
    command->add_option("-o,--output", arguments->output, "Ground and bases as bands of a GeoTIFF");
    command->add_option("--modflow", arguments->modflow,
                        "Folder for the DIS package of MODFLOW 6 and its arrays");
    command
        ->add_option("--thinnest", arguments->thinnest,
                     "Units thinner than this are passed through (0: absent ones only)")
        ->check(CLI::NonNegativeNumber);
    command->add_option(
        "--crs", arguments->crs,
        "Coordinate reference system of the model for GIS files, as EPSG:27700 (the model's own)");
    command->add_flag("--json", arguments->json, "Print size, cells and volumes as JSON");
    command->add_flag("--overwrite", arguments->overwrite, "Replace files that are there");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace stratareeb
