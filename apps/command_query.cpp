// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/keep_existing.h"
#include "apps/mesh_report.h"
#include "boreholes/errors.h"
#include "io/read_model.h"
#include "io/read_places.h"
#include "io/write_table.h"
#include "mesh/model_column.h"

namespace stratareeb {
namespace {

using nlohmann::json;

struct QueryArguments {
    std::string folder, points, output;
    std::vector<double> at;
    bool json = false, overwrite = false;
};

json column_json(const LayerModel& model, const Place& place, const std::optional<ModelColumn>& column) {
    json result{
        {"x", place.at.x}, {"y", place.at.y}, {"inside", column.has_value()}, {"units", json::array()}};
    for (std::size_t i = 0; column && i < model.units.size(); ++i)
        result["units"].push_back({{"order", i + 1},
                                   {"code", model.units[i].code},
                                   {"name", model.units[i].name},
                                   {"top", column->horizons[i]},
                                   {"base", column->horizons[i + 1]},
                                   {"thickness", column->thickness(i)}});
    if (!place.z) return result;
    const auto layer = column ? column->layer_at(*place.z) : std::nullopt;
    result["z"] = *place.z;
    result["unit"] = layer ? json(model.units[*layer].code) : json();
    return result;
}

std::string unit_words(const LayerModel& model, const ModelColumn& column, double z) {
    if (const auto layer = column.layer_at(z)) return model.units[*layer].name;
    return z > column.horizons.front() ? "above the ground" : "below the model";
}

void print_column(const LayerModel& model, const Place& place, const std::optional<ModelColumn>& column) {
    fmt::print("x {:.10g}, y {:.10g}", place.at.x, place.at.y);
    if (!column) {
        fmt::print(": outside the model's footprint\n");
        return;
    }
    const std::string& u = model.length_unit;
    fmt::print(": ground {:.6g} {}\n{:>3}  {:<24} {:>12} {:>12} {:>12}\n", column->horizons.front(), u, "",
               "layer", "top [" + u + "]", "base [" + u + "]", "thickness");
    for (std::size_t i = 0; i < model.units.size(); ++i)
        if (column->thickness(i) > 0)
            fmt::print("{:>3}  {:<24} {:>12.6g} {:>12.6g} {:>12.6g}\n", i + 1, model.units[i].name,
                       column->horizons[i], column->horizons[i + 1], column->thickness(i));
    if (place.z) fmt::print("at z {:.10g}: {}\n", *place.z, unit_words(model, *column, *place.z));
}

//! One row a place: what was asked, the unit at z, the ground, and each layer's thickness; empty outside the footprint.
OutputTable answers(const LayerModel& model, const std::vector<Place>& places) {
    const bool with_z = std::ranges::any_of(places, [](const Place& p) { return p.z.has_value(); });
    OutputTable table{.columns = {"id", "x", "y"}, .rows = {}};
    if (with_z) table.columns.insert(table.columns.end(), {"z", "unit"});
    table.columns.emplace_back("ground");
    for (const Unit& unit : model.units) table.columns.push_back(unit.code);
    table.columns.emplace_back("base");
    const ColumnQuery query(model);
    table.rows.reserve(places.size());
    for (const Place& place : places) {
        const auto column = query.column(place.at);
        std::vector<OutputCell> row{place.id, place.at.x, place.at.y};
        if (with_z) {
            const auto layer = column && place.z ? column->layer_at(*place.z) : std::nullopt;
            row.push_back(place.z ? OutputCell(*place.z) : OutputCell());
            row.push_back(layer ? OutputCell(model.units[*layer].code) : OutputCell());
        }
        row.push_back(column ? OutputCell(column->horizons.front()) : OutputCell());
        for (std::size_t i = 0; i < model.units.size(); ++i)
            row.push_back(column ? OutputCell(column->thickness(i)) : OutputCell());
        row.push_back(column ? OutputCell(column->horizons.back()) : OutputCell());
        table.rows.push_back(std::move(row));
    }
    return table;
}

void query_one(const LayerModel& model, const QueryArguments& arguments) {
    if (arguments.at.size() < 2 || arguments.at.size() > 3)
        throw CLI::ValidationError("--at", "takes x,y or x,y,z");
    for (const double value : arguments.at)
        if (!std::isfinite(value)) throw CLI::ValidationError("--at", "takes finite numbers");
    Place place{.id = "", .at = {arguments.at[0], arguments.at[1]}, .z = std::nullopt};
    if (arguments.at.size() == 3) place.z = arguments.at[2];
    const auto column = ColumnQuery(model).column(place.at);
    if (arguments.json)
        std::fputs(json_text(column_json(model, place, column)).c_str(), stdout);
    else
        print_column(model, place, column);
    if (!column) {
        if (arguments.json) std::fputs("stratareeb: the place lies outside the model's footprint\n", stderr);
        throw CommandFailed();
    }
}

void query_many(const LayerModel& model, const QueryArguments& arguments) {
    const std::vector<Place> places = read_places(arguments.points);
    if (arguments.json) {
        json list = json::array();
        const ColumnQuery query(model);
        for (const Place& place : places) {
            list.push_back(column_json(model, place, query.column(place.at)));
            if (!place.id.empty()) list.back()["id"] = place.id;
        }
        std::fputs(json_text(list).c_str(), stdout);
        return;
    }
    if (arguments.output.empty())
        throw CLI::ValidationError("--points", "needs -o FILE (.csv or .xlsx) for the answers, or --json");
    keep_existing(arguments.output, arguments.overwrite);
    write_table(arguments.output, answers(model, places));
    fmt::print("{} places in {}\n", places.size(), arguments.output);
}

void run(const QueryArguments& arguments) {
    if (arguments.at.empty() == arguments.points.empty())
        throw CLI::ValidationError("query", "give either --at x,y[,z] or --points FILE");
    const SavedModel saved = read_model(arguments.folder);
    if (arguments.points.empty())
        query_one(saved.model, arguments);
    else
        query_many(saved.model, arguments);
}

}  // namespace

void add_query_command(CLI::App& program) {
    const auto arguments = std::make_shared<QueryArguments>();
    CLI::App* command = program.add_subcommand("query", "Say what a model has at a place");
    command->add_option("DIR", arguments->folder, "Folder that build wrote")->required();
    command
        ->add_option("--at", arguments->at, "Map coordinates x,y for the log there, x,y,z for the unit too")
        ->delimiter(',');
    command->add_option("--points", arguments->points,
                        "Table of places: columns x, y and, if wanted, z and id");
    command->add_option("-o,--output", arguments->output, "Table of answers for --points: .csv or .xlsx");
    command->add_flag("--json", arguments->json, "Print JSON: an object for --at, a list for --points");
    command->add_flag("--overwrite", arguments->overwrite, "Replace a file that is there");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace stratareeb
