// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "apps/command.h"
#include "boreholes/errors.h"
#include "io/read_mesh.h"
#include "io/write_mesh.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;

struct ConvertOptions {
    std::vector<std::string> inputs;
    std::string output;
    bool overwrite = false;
};

void require_free(const fs::path& file) {
    if (fs::is_regular_file(file))
        throw IoError(fmt::format("{}: exists already; add --overwrite to replace it", file.string()));
}

// Several files become the parts of one, named by their stems; the parts of a single file keep their names.
std::vector<PartData> all_parts(const std::vector<std::string>& inputs) {
    std::vector<PartData> all;
    for (const auto& input : inputs) {
        auto parts = read_mesh_parts(input);
        const auto stem = fs::path(input).stem().string();
        for (auto& part : parts) {
            if (inputs.size() > 1) part.name = parts.size() > 1 ? stem + " " + part.name : stem;
            all.push_back(std::move(part));
        }
    }
    return all;
}

void convert(const ConvertOptions& options) {
    const fs::path output = options.output;
    const auto format = mesh_format(output);
    if (!options.overwrite) {
        require_free(output);
        if (format == MeshFormat::Obj) require_free(fs::path(output).replace_extension(".mtl"));
    }
    write_mesh_parts(output, all_parts(options.inputs));
}

}  // namespace

void add_convert_command(CLI::App& program) {
    const auto options = std::make_shared<ConvertOptions>();
    auto* const command =
        program.add_subcommand("convert", "Write meshes in another format, by the output's extension");
    command->add_option("IN", options->inputs, "Mesh files; several become the parts of one file")
        ->required();
    command->add_option("-o,--output", options->output, "File to write: .ply .obj .stl .off .glb .3mf")
        ->required();
    command->add_flag("--overwrite", options->overwrite, "Replace a file that is there");
    command->callback([options] { convert(*options); });
}

}  // namespace stratareeb
