// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "apps/command.h"
#include "apps/input_mesh.h"
#include "apps/keep_existing.h"
#include "apps/progress.h"
#include "io/write_mesh.h"
#include "mesh/decimate_mesh.h"

namespace stratareeb {
namespace {

struct DecimateArguments {
    std::string mesh, output;
    std::optional<std::size_t> triangles;
    std::optional<double> max_error;
    bool repair = false, overwrite = false, json = false;
};

void run(const DecimateArguments& arguments) {
    keep_existing(arguments.output, arguments.overwrite);
    const InputMesh input = read_input_mesh(arguments.mesh, arguments.repair);
    DecimatedMesh result;
    {
        Progress progress("decimate");
        result = decimate_mesh(
            input.mesh, {.triangles = arguments.triangles,
                         .max_error = arguments.max_error,
                         .progress = [&](const char* step, double share) { progress.step(step, share); }});
    }
    write_mesh(arguments.output, {.name = input.file, .color = "", .mesh = &result.mesh});
    if (!arguments.json) {
        fmt::print("{}: {}\n", arguments.output, result.note);
        return;
    }
    const nlohmann::ordered_json json{{"triangles_before", result.triangles_before},
                                      {"triangles", result.mesh.n_faces()},
                                      {"distance", result.deviation},
                                      {"target_reached", result.target_reached}};
    fmt::print("{}\n", json.dump(2));
}

}  // namespace

void add_decimate_command(CLI::App& program) {
    auto arguments = std::make_shared<DecimateArguments>();
    CLI::App* command = program.add_subcommand("decimate", "Fewer triangles for a mesh, near the same shape");
    command->add_option("MESH", arguments->mesh, "Mesh file")->required();
    command->add_option("-o,--output", arguments->output, "File to write: .ply .obj .stl .off .glb .3mf")
        ->required();
    command->add_option("--triangles", arguments->triangles, "Stop at that number of triangles")
        ->check(CLI::PositiveNumber);
    command
        ->add_option("--max-error", arguments->max_error,
                     "How far the two surfaces may be apart anywhere, in the mesh's unit")
        ->check(CLI::NonNegativeNumber);
    add_repair_option(*command, arguments->repair);
    command->add_flag("--overwrite", arguments->overwrite, "Replace a file that is there");
    command->add_flag("--json", arguments->json, "Print JSON");
    command->callback([arguments] {
        if (!arguments->triangles && !arguments->max_error)
            throw CLI::RequiredError("--triangles or --max-error");
        run(*arguments);
    });
}

}  // namespace stratareeb
