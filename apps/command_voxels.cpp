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
#include "io/read_model.h"
#include "io/write_voxels.h"
#include "mesh/layer_volumes.h"
#include "mesh/voxel_block.h"

namespace stratareeb {
namespace {

using nlohmann::json;

struct VoxelsArguments {
    std::string folder, output, crs;
    double cell = 0, height = 0;
    bool json = false, overwrite = false;
};

json block_json(const LayerModel& model, const VoxelBlock& block) {
    json result{
        {"columns", block.plan.columns}, {"rows", block.plan.rows},
        {"levels", block.levels},        {"cell", block.plan.cell},
        {"height", block.height},        {"north_west", {block.plan.north_west.x, block.plan.north_west.y}},
        {"bottom", block.bottom},        {"length_unit", model.length_unit},
        {"layers", json::array()}};
    const auto volumes = voxel_volumes(block, model.units.size()), exact = layer_volumes(model);
    const double one = block.plan.cell * block.plan.cell * block.height;
    for (std::size_t i = 0; i < volumes.size(); ++i)
        result["layers"].push_back({{"layer", i + 1},
                                    {"code", model.units[i].code},
                                    {"cells", std::llround(volumes[i] / one)},
                                    {"volume", volumes[i]},
                                    {"exact_volume", exact[i]},
                                    {"error", volumes[i] - exact[i]}});
    return result;
}

void print_block(const json& block) {
    fmt::print(
        "{} columns, {} rows, {} levels of cells of {:g} by {:g} {}\n\n{:>5}  {:<24} {:>12} {:>14} {:>14} "
        "{:>10}\n",
        block["columns"].get<std::size_t>(), block["rows"].get<std::size_t>(),
        block["levels"].get<std::size_t>(), block["cell"].get<double>(), block["height"].get<double>(),
        block["length_unit"].get<std::string>(), "layer", "unit", "cells", "volume", "exact volume", "error");
    for (const json& layer : block["layers"]) {
        const double exact = layer["exact_volume"];
        fmt::print("{:>5}  {:<24} {:>12} {:>14.7g} {:>14.7g} {:>8.2f} %\n", layer["layer"].get<std::size_t>(),
                   layer["code"].get<std::string>(), layer["cells"].get<std::size_t>(),
                   layer["volume"].get<double>(), exact,
                   exact > 0 ? 100 * layer["error"].get<double>() / exact : 0);
    }
}

void run(const VoxelsArguments& arguments) {
    if (!is_voxel_file(arguments.output))
        throw CLI::ValidationError("-o", arguments.output + ": blocks are written as .nc or .tif");
    keep_existing(arguments.output, arguments.overwrite);
    const SavedModel saved = read_model(arguments.folder);
    const VoxelBlock block =
        voxel_block(saved.model, arguments.cell, arguments.height > 0 ? arguments.height : arguments.cell);
    write_voxels(arguments.output, block, saved.model.units, saved.model.length_unit,
                 saved.crs_or(arguments.crs));
    const json result = block_json(saved.model, block);
    if (arguments.json)
        std::fputs(json_text(result).c_str(), stdout);
    else
        print_block(result);
}

}  // namespace

void add_voxels_command(CLI::App& program) {
    const auto arguments = std::make_shared<VoxelsArguments>();
    CLI::App* command =
        program.add_subcommand("voxels", "A built model as a block of cells of one unit each");
    command->add_option("DIR", arguments->folder, "Folder that build wrote")->required();
    command
        ->add_option("-o,--output", arguments->output, "File to write: .nc (NetCDF) or .tif (a band a level)")
        ->required();
    command->add_option("--cell", arguments->cell, "Side of the cells in plan, in the model's unit")
        ->required()
        ->check(CLI::PositiveNumber);
    command->add_option("--height", arguments->height, "Their height; as the side if left out")
        ->check(CLI::PositiveNumber);
    command->add_option(
        "--crs", arguments->crs,
        "Coordinate reference system of the model for GIS files, as EPSG:27700 (the model's own)");
    command->add_flag("--json", arguments->json, "Print size, cells and volumes as JSON");
    command->add_flag("--overwrite", arguments->overwrite, "Replace a file that is there");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace stratareeb
