// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/mesh_report.h"
#include "boreholes/errors.h"
#include "io/mesh_format.h"
#include "io/read_boreholes.h"
#include "io/read_mesh.h"
#include "io/text_scanner.h"
#include "mesh/measures.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct InfoOptions {
    std::vector<std::string> files;
    std::string collars;
    bool json = false;
};

json list(const Point3& p) {
    return {p.x, p.y, p.z};
}

json mesh_info(const std::string& file) {
    json parts = json::array();
    for (const auto& part : read_mesh_parts(file)) {
        const auto box = bounding_box(part.soup.points);
        parts.push_back({{"name", part.name},
                         {"color", text_from_rgb(part.color)},
                         {"vertices", part.soup.points.size()},
                         {"triangles", part.soup.triangles.size()},
                         {"box", {list(box.min), list(box.max)}},
                         {"size", list(box.size())}});
    }
    return {{"file", file}, {"kind", "mesh"}, {"bytes", fs::file_size(file)}, {"parts", parts}};
}

// The main numbers of a model that `build` wrote, as its model.json has them.
json model_info(const std::string& folder) {
    const auto file = fs::path(folder) / "model.json";
    json model;
    try {
        model = json::parse(file_content(file));
    } catch (const json::exception& error) {
        throw InvalidInput(fmt::format("{}: damaged: {}", file.string(), error.what()));
    }
    if (!model.is_object()) throw InvalidInput(fmt::format("{}: not a model description", file.string()));
    json result = {{"file", folder}, {"kind", "model"}};
    for (const char* key : {"boreholes", "origin", "envelope_volume", "units", "misfit", "checks"})
        if (model.contains(key)) result[key] = model[key];
    return result;
}

const char* layout_name(TableLayout layout) {
    switch (layout) {
        case TableLayout::Wide:
            return "wide";
        case TableLayout::Intervals:
            return "intervals";
        case TableLayout::Points:
            return "points";
        case TableLayout::Samples:
            return "samples";
        case TableLayout::Auto:
            break;
    }
    return "unknown";
}

// How many holes have a unit, lack it, end in it, or say nothing of it.
json unit_info(const Survey& survey, std::size_t unit) {
    std::size_t present = 0, absent = 0, at_least = 0;
    for (const auto& hole : survey.holes) {
        if (unit >= hole.layers.size()) continue;
        const auto& fact = hole.layers[unit];
        present += fact.knowledge == Knowledge::Measured && !fact.is_absent();
        absent += fact.is_absent();
        at_least += fact.knowledge == Knowledge::AtLeast;
    }
    return {{"order", unit + 1},
            {"code", survey.units[unit].code},
            {"name", survey.units[unit].name},
            {"color", survey.units[unit].color},
            {"holes_present", present},
            {"holes_absent", absent},
            {"holes_ending_in_it", at_least},
            {"holes_unknown", survey.holes.size() - present - absent - at_least}};
}

json table_info(const std::string& file, const std::string& collars) {
    const auto table = read_boreholes({file}, {.collars = collars});
    std::vector<Point3> places;
    for (const auto& hole : table.survey.holes) places.push_back({hole.at.x, hole.at.y, 0});
    const auto box = bounding_box(places);
    json units = json::array();
    for (std::size_t i = 0; i < table.survey.units.size(); ++i) units.push_back(unit_info(table.survey, i));
    return {{"file", file},
            {"kind", "boreholes"},
            {"layout", layout_name(table.layout)},
            {"boreholes", table.survey.holes.size()},
            {"length_unit", table.survey.length_unit},
            {"box", {{box.min.x, box.min.y}, {box.max.x, box.max.y}}},
            {"units", units},
            {"warnings", table.audit.warning_count()}};
}

json info(const std::string& file, const std::string& collars) {
    if (fs::is_directory(file)) return model_info(file);
    return is_mesh_file(file) ? mesh_info(file) : table_info(file, collars);
}

// Numbers as people read them, "?" for what is missing.
std::string shown(const json& value, const char* key) {
    if (!value.is_object() || !value.contains(key)) return "?";
    const auto& item = value[key];
    return item.is_string()         ? item.get<std::string>()
           : item.is_number_float() ? fmt::format("{:.10g}", item.get<double>())
                                    : item.dump();
}

std::string mesh_text(const json& mesh) {
    std::string result = fmt::format("{}: mesh, {} bytes\n", shown(mesh, "file"), shown(mesh, "bytes"));
    for (const auto& part : mesh["parts"])
        result +=
            fmt::format("  {}: {} vertices, {} triangles, colour {}\n    box {}, size {} (input units)\n",
                        shown(part, "name"), shown(part, "vertices"), shown(part, "triangles"),
                        shown(part, "color"), shown(part, "box"), shown(part, "size"));
    return result;
}

std::string model_text(const json& model) {
    std::string result =
        fmt::format("{}: layer model of {} boreholes, envelope volume {}, origin {}\n", shown(model, "file"),
                    shown(model, "boreholes"), shown(model, "envelope_volume"), shown(model, "origin"));
    for (const auto& unit : model.value("units", json::array()))
        result += fmt::format("  {} {}: volume {}, components {}, genus {}\n", shown(unit, "order"),
                              shown(unit, "name"), shown(unit, "volume"), shown(unit, "components"),
                              shown(unit, "genus"));
    std::size_t failed = 0;
    const auto checks = model.value("checks", json::array());
    for (const auto& check : checks) failed += shown(check, "ok") != "true";
    return result + fmt::format("  {} checks, {} of them failed\n", checks.size(), failed);
}

std::string table_text(const json& table) {
    std::string result = fmt::format(
        "{}: {} table of {} boreholes, {} units, {} warnings\n  box {} (in {})\n", shown(table, "file"),
        shown(table, "layout"), shown(table, "boreholes"), table["units"].size(), shown(table, "warnings"),
        shown(table, "box"), shown(table, "length_unit"));
    for (const auto& unit : table["units"])
        result += fmt::format("  {} {}: in {} holes, absent from {}, {} end in it, {} do not say\n",
                              shown(unit, "order"), shown(unit, "name"), shown(unit, "holes_present"),
                              shown(unit, "holes_absent"), shown(unit, "holes_ending_in_it"),
                              shown(unit, "holes_unknown"));
    return result;
}

std::string info_text(const json& result) {
    if (result["kind"] == "model") return model_text(result);
    return result["kind"] == "mesh" ? mesh_text(result) : table_text(result);
}

void run(const InfoOptions& options) {
    json results = json::array();
    bool failed = false;
    for (const auto& file : options.files) {
        try {
            results.push_back(info(file, options.collars));
            if (options.json) continue;
            const auto text = info_text(results.back());
            std::fwrite(text.data(), 1, text.size(), stdout);
        } catch (const std::exception& error) {
            failed = true;
            std::fprintf(stderr, "stratareeb: %s\n", error.what());
            results.push_back({{"file", file}, {"error", error.what()}});
        }
    }
    if (options.json) std::fputs(json_text(results).c_str(), stdout);
    if (failed) throw CommandFailed();
}

}  // namespace

void add_info_command(CLI::App& program) {
    const auto options = std::make_shared<InfoOptions>();
    auto* const command =
        program.add_subcommand("info", "Say what is in a file or in a folder that build wrote");
    command->add_option("FILE", options->files, "Meshes, borehole tables, or folders that build wrote")
        ->required();
    command->add_option("--collars", options->collars, "Collar table that goes with an interval table");
    command->add_flag("--json", options->json, "Print one JSON list instead of text");
    command->callback([options] { run(*options); });
}

}  // namespace stratareeb
