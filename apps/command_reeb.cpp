// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/command.h"
#include "apps/field_option.h"
#include "apps/input_mesh.h"
#include "apps/keep_existing.h"
#include "io/write_graph.h"
#include "mesh/analysis.h"
#include "reeb/reeb_graph.h"

namespace stratareeb {
namespace {

struct ReebArguments {
    std::string mesh, output, field = "z";
    bool overwrite = false, json = false, repair = false;
};

void run(const ReebArguments& arguments) {
    if (!arguments.output.empty()) keep_existing(arguments.output, arguments.overwrite);
    const InputMesh input = read_input_mesh(arguments.mesh, arguments.repair);
    const TriMesh& mesh = input.mesh;
    const ScalarField field = field_of(input, arguments.field);
    const auto start = std::chrono::steady_clock::now();
    const ReebGraph graph = reeb_graph(mesh, field);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!arguments.output.empty()) write_graph(arguments.output, graph, mesh);

    int minima = 0, saddles = 0, maxima = 0;
    for (const CriticalPoint& point : critical_points(mesh, field)) {
        minima += point.type == CriticalType::Minimum;
        saddles += point.type == CriticalType::Saddle ? point.multiplicity : 0;
        maxima += point.type == CriticalType::Maximum;
    }
    const MeshReport report = analyze(mesh, {.self_intersections = false});
    const nlohmann::ordered_json json{
        {"vertices", report.vertices},
        {"triangles", report.triangles},
        {"components", report.components},
        {"boundary_loops", report.boundary_loops},
        {"genus", report.genus.value_or(0)},
        {"nodes", graph.nodes.size()},
        {"arcs", graph.arcs.size()},
        {"loops", graph.loops()},
        {"critical", {{"minimum", minima}, {"saddle", saddles}, {"maximum", maxima}}},
        {"seconds", seconds}};
    if (arguments.json) {
        fmt::print("{}\n", json.dump(2));
        return;
    }
    fmt::print("{} triangles in {} components, genus {}, {} boundary loops\n", report.triangles,
               report.components, report.genus.value_or(0), report.boundary_loops);
    fmt::print("Reeb graph: {} nodes, {} arcs, {} loops\n", graph.nodes.size(), graph.arcs.size(),
               graph.loops());
    fmt::print("critical points: {} minima, {} saddles, {} maxima\n", minima, saddles, maxima);
}

}  // namespace

void add_reeb_command(CLI::App& program) {
    auto arguments = std::make_shared<ReebArguments>();
    CLI::App* command = program.add_subcommand("reeb", "Reeb graph of a mesh");
    command->add_option("MESH", arguments->mesh, "Mesh file, an oriented 2-manifold with or without boundary")
        ->required();
    command->add_option("-o,--output", arguments->output, "File for the graph, .json, .dot or .graphml");
    add_field_option(*command, arguments->field);
    add_repair_option(*command, arguments->repair);
    command->add_flag("--overwrite", arguments->overwrite, "Replace a file that is there");
    command->add_flag("--json", arguments->json, "Print JSON");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace stratareeb
