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
#include "io/read_mesh.h"
#include "io/text_scanner.h"
#include "mesh/measures.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct InfoOptions {
    std::vector<std::string> files;
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

json info(const std::string& file) {
    if (fs::is_directory(file)) return model_info(file);
    return mesh_info(file);
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

void run(const InfoOptions& options) {
    json results = json::array();
    bool failed = false;
    for (const auto& file : options.files) {
        try {
            results.push_back(info(file));
            if (options.json) continue;
            const auto& result = results.back();
            const auto text = result["kind"] == "model" ? model_text(result) : mesh_text(result);
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
    command->add_option("FILE", options->files, "Mesh files or folders with a model.json")->required();
    command->add_flag("--json", options->json, "Print one JSON list instead of text");
    command->callback([options] { run(*options); });
}

}  // namespace stratareeb
