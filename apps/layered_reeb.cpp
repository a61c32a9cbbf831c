// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/layered_reeb.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "apps/field_option.h"
#include "apps/input_mesh.h"
#include "apps/keep_existing.h"
#include "apps/mesh_report.h"
#include "apps/progress.h"
#include "apps/reeb_report.h"
#include "boreholes/errors.h"
#include "io/write_layered_graph.h"
#include "reeb/layered_reeb_graph.h"

namespace stratareeb {

namespace {

struct Layer {
    std::string name;
    InputMesh input;
    ScalarField field;
    AskedGraph asked;
};

//! Files by their stems; those that share one by all they are called.
std::vector<std::string> layer_names(const std::vector<std::string>& files) {
    const auto stem = [](const std::string& file) { return std::filesystem::path(file).stem().string(); };
    std::vector<std::string> names;
    for (const std::string& file : files) {
        const auto same =
            std::ranges::count_if(files, [&](const std::string& other) { return stem(other) == stem(file); });
        names.push_back(same > 1 ? file : stem(file));
    }
    return names;
}

void check_output(const ReebArguments& arguments) {
    if (arguments.output.empty()) return;
    const std::string extension = std::filesystem::path(arguments.output).extension().string();
    if (extension != ".json" && extension != ".dot" && extension != ".obj")
        throw IoError(arguments.output + ": the graph of several meshes is written as .json, .dot or .obj");
    keep_existing(arguments.output, arguments.overwrite);
}

std::vector<Layer> read_layers(const ReebArguments& arguments, Progress& progress) {
    const auto names = layer_names(arguments.meshes);
    std::vector<Layer> layers(names.size());
    for (std::size_t i = 0; i < layers.size(); ++i) {
        progress.step("layer " + names[i], 0.6 * static_cast<double>(i) / static_cast<double>(names.size()));
        Layer& layer = layers[i];
        layer.name = names[i];
        layer.input = read_input_mesh(arguments.meshes[i], arguments.repair);
        layer.field = field_of(layer.input, arguments.field);
        layer.asked = asked_graph(layer.input.mesh, layer.field,
                                  {.simplify = arguments.simplify, .plateaus = arguments.plateaus});
    }
    return layers;
}

std::size_t contours_of(const LayeredReebGraph& graph) {
    std::size_t count = 0;
    for (const LayeredNode& node : graph.nodes) count += node.contours.size();
    return count;
}

void print_json(const std::vector<Layer>& layers, const LayeredReebGraph& graph, double seconds) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Layer& layer : layers) {
        nlohmann::ordered_json entry{{"name", layer.name}};
        entry.update(reeb_json(layer.input.mesh, layer.field, layer.asked));
        list.push_back(std::move(entry));
    }
    const nlohmann::ordered_json json{{"layers", list},
                                      {"nodes", graph.nodes.size()},
                                      {"arcs", graph.arcs.size()},
                                      {"contours", contours_of(graph)},
                                      {"seconds", seconds}};
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

void print_text(const std::vector<Layer>& layers, const LayeredReebGraph& graph) {
    for (const Layer& layer : layers)
        fmt::print("{}\n{}\n", layer.name, reeb_text(layer.input.mesh, layer.field, layer.asked));
    fmt::print("layered Reeb graph: {}, {}, {}\n", counted(graph.nodes.size(), "node"),
               counted(graph.arcs.size(), "arc"), counted(contours_of(graph), "contour"));
}

}  // namespace

void run_layered_reeb(const ReebArguments& arguments) {
    check_output(arguments);
    Progress progress("reeb");
    const std::vector<Layer> layers = read_layers(arguments, progress);
    std::vector<LayerSurface> surfaces;
    std::vector<std::string> names;
    for (const Layer& layer : layers) {
        surfaces.push_back({&layer.input.mesh, &layer.field});
        names.push_back(layer.name);
    }
    progress.step("layered graph", 0.6);
    const auto start = std::chrono::steady_clock::now();
    const LayeredReebGraph graph =
        layered_reeb_graph(surfaces, {.simplify = arguments.simplify.value_or(0), .further_levels = {}});
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    progress.step("writing", 0.8);
    if (!arguments.output.empty()) write_layered_graph(arguments.output, graph, names);
    progress.clear();
    arguments.json ? print_json(layers, graph, seconds) : print_text(layers, graph);
}

}  // namespace stratareeb
