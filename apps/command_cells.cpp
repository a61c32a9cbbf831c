// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/keep_existing.h"
#include "apps/mesh_report.h"
#include "boreholes/errors.h"
#include "io/read_model.h"
#include "io/write_msh.h"
#include "io/write_vtu.h"
#include "mesh/cell_faces.h"
#include "mesh/layer_volumes.h"

namespace stratareeb {
namespace {

using nlohmann::json;

struct CellsArguments {
    std::string folder;
    std::vector<std::string> outputs;
    VolumeMeshOptions mesh;
    bool json = false, overwrite = false;
};

bool is_vtu(const std::string& file) {
    return std::filesystem::path(file).extension() == ".vtu";
}

//! Each layer's cells fill it: the largest difference to a layer's own volume, in shares of the whole model.
double volume_error(const LayerModel& model, const std::vector<LayerCells>& layers) {
    const std::vector<double> expected = layer_volumes(model);
    double worst = 0;
    for (std::size_t i = 0; i < layers.size(); ++i)
        worst = std::max(worst, std::abs(layers[i].volume - expected[i]));
    return worst / std::max(envelope_volume(model), 1e-300);
}

json spread_json(const Spread& spread) {
    return {{"least", spread.least},
            {"hundredth", spread.hundredth},
            {"median", spread.median},
            {"ninety_ninth", spread.ninety_ninth},
            {"largest", spread.largest}};
}

Spread spread(const std::vector<CellQuality>& qualities, double CellQuality::*value) {
    std::vector<double> values;
    for (const CellQuality& quality : qualities) values.push_back(quality.*value);
    return spread_of(std::move(values));
}

json cells_json(const LayerModel& model, const VolumeMesh& mesh, const std::vector<CellQuality>& qualities) {
    const auto layers = layer_cells(mesh, qualities);
    const std::vector<double> expected = layer_volumes(model);
    json result{{"points", mesh.points.size()},
                {"cells", mesh.cells.size()},
                {"outer_faces", boundary_faces(mesh).size()},
                {"length_unit", model.length_unit},
                {"volume_error", volume_error(model, layers)},
                {"least_dihedral_deg", spread_json(spread(qualities, &CellQuality::least_dihedral_deg))},
                {"largest_dihedral_deg", spread_json(spread(qualities, &CellQuality::largest_dihedral_deg))},
                {"aspect", spread_json(spread(qualities, &CellQuality::aspect))},
                {"layers", json::array()}};
    for (std::size_t i = 0; i < layers.size(); ++i)
        result["layers"].push_back({{"layer", i + 1},
                                    {"code", model.units[i].code},
                                    {"parts", mesh.parts[i]},
                                    {"prisms", layers[i].prisms},
                                    {"pyramids", layers[i].pyramids},
                                    {"tetrahedra", layers[i].tetrahedra},
                                    {"volume", layers[i].volume},
                                    {"model_volume", expected[i]}});
    return result;
}

void print_spread(const char* name, const json& spread) {
    fmt::print("{:<24} {:>10.4g} {:>10.4g} {:>10.4g} {:>10.4g} {:>10.4g}\n", name,
               spread["least"].get<double>(), spread["hundredth"].get<double>(),
               spread["median"].get<double>(), spread["ninety_ninth"].get<double>(),
               spread["largest"].get<double>());
}

void print_cells(const json& cells) {
    fmt::print("{:>5}  {:<24} {:>6} {:>10} {:>10} {:>10} {:>14} {:>14}\n", "layer", "unit", "parts", "prisms",
               "pyramids", "tetrahedra", "volume", "in the model");
    for (const auto& layer : cells["layers"])
        fmt::print("{:>5}  {:<24} {:>6} {:>10} {:>10} {:>10} {:>14.7g} {:>14.7g}\n",
                   layer["layer"].get<std::size_t>(), layer["code"].get<std::string>(),
                   layer["parts"].get<std::size_t>(), layer["prisms"].get<std::size_t>(),
                   layer["pyramids"].get<std::size_t>(), layer["tetrahedra"].get<std::size_t>(),
                   layer["volume"].get<double>(), layer["model_volume"].get<double>());
    fmt::print("\n{:<24} {:>10} {:>10} {:>10} {:>10} {:>10}\n", "quality", "least", "1 %", "median", "99 %",
               "largest");
    print_spread("least dihedral angle [°]", cells["least_dihedral_deg"]);
    print_spread("largest dihedral [°]", cells["largest_dihedral_deg"]);
    print_spread("aspect (1 = regular)", cells["aspect"]);
    fmt::print(
        "\n{} points, {} cells, all of positive volume, {} outer faces; volumes differ from the layers' own "
        "by "
        "{:.1e} of the whole at most\n",
        cells["points"].get<std::size_t>(), cells["cells"].get<std::size_t>(),
        cells["outer_faces"].get<std::size_t>(), cells["volume_error"].get<double>());
}

void check_outputs(const CellsArguments& arguments) {
    for (const std::string& output : arguments.outputs) {
        if (!is_vtu(output) && std::filesystem::path(output).extension() != ".msh")
            throw CLI::ValidationError("-o", output + ": cells are written as .vtu or .msh");
        keep_existing(output, arguments.overwrite);
    }
}

void run(const CellsArguments& arguments) {
    check_outputs(arguments);
    const SavedModel saved = read_model(arguments.folder);
    const VolumeMesh mesh = volume_mesh(saved.model, arguments.mesh);
    const auto qualities = cell_qualities(mesh);
    const json result = cells_json(saved.model, mesh, qualities);
    const CellRecord record{.units = saved.model.units,
                            .origin = arguments.mesh.map_coordinates ? Point3{} : saved.model.origin};
    for (const std::string& output : arguments.outputs)
        is_vtu(output) ? write_vtu(output, mesh, qualities, record) : write_msh(output, mesh, record);
    if (arguments.json)
        std::fputs(json_text(result).c_str(), stdout);
    else
        print_cells(result);
}

}  // namespace

void add_cells_command(CLI::App& program) {
    const auto arguments = std::make_shared<CellsArguments>();
    CLI::App* command =
        program.add_subcommand("cells", "A built model as cells for simulation: prisms or tetrahedra");
    command->add_option("DIR", arguments->folder, "Folder that build wrote")->required();
    command
        ->add_option("-o,--output", arguments->outputs,
                     "File to write: .vtu (ParaView, OpenGeoSys) or .msh (gmsh); may be repeated")
        ->required();
    command->add_flag("--tetrahedra", arguments->mesh.tetrahedra, "Divide prisms and pyramids");
    command
        ->add_option("--sublayers", arguments->mesh.parts,
                     "Divide every layer into so many of equal thickness")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command
        ->add_option("--max-thickness", arguments->mesh.max_thickness,
                     "Divide a layer so that none of its parts is thicker than this")
        ->check(CLI::PositiveNumber);
    command
        ->add_option("--min-thickness", arguments->mesh.min_thickness,
                     "Leave a layer out where it is thinner than this; its space goes to its neighbour")
        ->check(CLI::PositiveNumber);
    command->add_flag("--map-coordinates", arguments->mesh.map_coordinates,
                      "Write map coordinates, not ones relative to the model's origin");
    command->add_flag("--json", arguments->json, "Print numbers of cells, volumes and quality as JSON");
    command->add_flag("--overwrite", arguments->overwrite, "Replace files that are there");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace stratareeb
