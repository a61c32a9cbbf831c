// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/mesh_report.h"
#include "boreholes/errors.h"
#include "io/model_prediction.h"
#include "io/read_areas.h"
#include "io/read_model.h"
#include "io/read_record.h"
#include "mesh/volume_between.h"
#include "mesh/volume_uncertainty.h"

namespace stratareeb {
namespace {

using nlohmann::json;

struct VolumeArguments {
    std::string folder, inside;
    std::vector<double> between, below_ground;
    bool no_uncertainty = false, json = false;
};

constexpr const char* kMethod =
    "boreholes left out, groups together, and predicted by the others, each standing for the area nearest to "
    "it; mean error "
    "times area, and RMSE times the root of the sum of squared areas, more where boreholes are far, times "
    "Student's t";

VolumeWindow window_of(const VolumeArguments& arguments) {
    VolumeWindow window;
    if (!arguments.between.empty()) window.elevations = {arguments.between[0], arguments.between[1]};
    if (!arguments.below_ground.empty())
        window.depths = {arguments.below_ground[0], arguments.below_ground[1]};
    if (!arguments.inside.empty()) window.areas = read_areas(arguments.inside);
    return window;
}

//! With no error found at any borehole where there is something, nothing is known of it.
bool is_known(const VolumeUncertainty& uncertainty, double volume) {
    return uncertainty.groups >= 2 && (uncertainty.rmse > 0 || volume == 0);
}

json uncertainty_json(const VolumeUncertainty& uncertainty) {
    return {{"holes", uncertainty.holes},
            {"groups", uncertainty.groups},
            {"rmse", uncertainty.rmse},
            {"mean_error", uncertainty.mean_error},
            {"standard_error", uncertainty.standard_error},
            {"half_width_95", uncertainty.half_width}};
}

json volumes_json(const SavedModel& saved, const VolumeWindow& window, const WindowVolumes& volumes,
                  const std::vector<VolumeUncertainty>& uncertainty) {
    const LayerModel& model = saved.model;
    const double area = volumes.area();
    json result{{"length_unit", model.length_unit},
                {"plan_area", area},
                {"volume", std::accumulate(volumes.layers.begin(), volumes.layers.end(), 0.0)},
                {"layers", json::array()}};
    if (window.elevations) result["between"] = *window.elevations;
    if (window.depths) result["below_ground"] = *window.depths;
    for (std::size_t i = 0; i < model.units.size(); ++i) {
        json layer{{"layer", i + 1},
                   {"code", model.units[i].code},
                   {"name", model.units[i].name},
                   {"volume", volumes.layers[i]},
                   {"mean_thickness", area > 0 ? volumes.layers[i] / area : 0}};
        if (!uncertainty.empty() && is_known(uncertainty[i], volumes.layers[i]))
            layer["uncertainty"] = uncertainty_json(uncertainty[i]);
        result["layers"].push_back(layer);
    }
    if (uncertainty.empty()) return result;
    result["uncertainty_method"] = kMethod;
    if (is_known(uncertainty.back(), result["volume"]))
        result["uncertainty"] = uncertainty_json(uncertainty.back());
    return result;
}

void print_row(const std::string& number, const std::string& name, const json& row, double area) {
    const double volume = row["volume"];
    fmt::print("{:>5}  {:<24} {:>14.7g} {:>14.5g}", number, name, volume, area > 0 ? volume / area : 0);
    if (row.contains("uncertainty")) {
        const json& uncertainty = row["uncertainty"];
        fmt::print(" {:>14.3g} {:>8} {:>10.3g} {:>12.3g}", uncertainty["half_width_95"].get<double>(),
                   uncertainty["holes"].get<std::size_t>(), uncertainty["rmse"].get<double>(),
                   uncertainty["mean_error"].get<double>());
    }
    fmt::print("\n");
}

void print_volumes(const json& result) {
    const std::string unit = result["length_unit"];
    const double area = result["plan_area"];
    const bool uncertain = result.contains("uncertainty_method");
    fmt::print("plan area {:.7g} {}²\n\n{:>5}  {:<24} {:>14} {:>14}", area, unit, "layer", "unit",
               "volume [" + unit + "³]", "mean thickness");
    if (uncertain) fmt::print(" {:>14} {:>8} {:>10} {:>12}", "± (95 %)", "holes", "RMSE", "mean error");
    fmt::print("\n");
    for (const json& layer : result["layers"])
        print_row(std::to_string(layer["layer"].get<std::size_t>()), layer["code"], layer, area);
    print_row("", "all", result, area);
    if (uncertain) fmt::print("\n±: {}\n", kMethod);
}

void run(const VolumeArguments& arguments) {
    const VolumeWindow window = window_of(arguments);
    const SavedModel saved = read_model(arguments.folder);
    const WindowVolumes volumes = volumes_between(saved.model, window);
    if (!window.areas.empty() && !(volumes.area() > 0))
        throw InvalidInput(arguments.inside +
                           ": lies outside the model's footprint; are its coordinates the model's?");
    std::vector<VolumeUncertainty> uncertainty;
    if (!arguments.no_uncertainty && saved.survey.holes.size() >= 4)
        uncertainty = volume_uncertainty(
            saved.model, saved.survey, window, volumes,
            {.prediction = model_prediction(saved.survey, read_record(arguments.folder).record.options)});
    const json result = volumes_json(saved, window, volumes, uncertainty);
    if (arguments.json)
        std::fputs(json_text(result).c_str(), stdout);
    else
        print_volumes(result);
}

}  // namespace

void add_volume_command(CLI::App& program) {
    const auto arguments = std::make_shared<VolumeArguments>();
    CLI::App* command =
        program.add_subcommand("volume", "Volumes of a built model's layers, and how far off they may be");
    command->add_option("DIR", arguments->folder, "Folder that build wrote")->required();
    auto* between = command->add_option("--between", arguments->between, "Between two elevations z1,z2 only")
                        ->delimiter(',')
                        ->expected(2);
    command
        ->add_option("--below-ground", arguments->below_ground,
                     "Between two depths d1,d2 below the ground only")
        ->delimiter(',')
        ->expected(2)
        ->excludes(between);
    command->add_option(
        "--inside", arguments->inside,
        "Inside the polygons of this file only (GeoPackage, shapefile, GeoJSON, …, or a table of x, y)");
    command->add_flag("--no-uncertainty", arguments->no_uncertainty,
                      "Volumes alone, without leaving boreholes out");
    command->add_flag("--json", arguments->json, "Print JSON");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace stratareeb
