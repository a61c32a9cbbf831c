// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "apps/command.h"
#include "apps/keep_existing.h"
#include "apps/mesh_report.h"
#include "io/write_viewer.h"

namespace stratareeb {
namespace {

struct ViewArguments {
    std::string folder, output, title;
    bool json = false, overwrite = false;
};

void run(const ViewArguments& arguments) {
    const std::string file = arguments.output.empty()
                                 ? (std::filesystem::path(arguments.folder) / "model.html").string()
                                 : arguments.output;
    keep_existing(file, arguments.overwrite);
    const std::size_t size = write_viewer(arguments.folder, file, {.title = arguments.title, .report = {}});
    if (arguments.json)
        std::fputs(json_text({{"file", file}, {"bytes", size}}).c_str(), stdout);
    else
        fmt::print("{}: {:.2f} MB; open it with a web browser\n", file, static_cast<double>(size) / 1e6);
}

}  // namespace

void add_view_command(CLI::App& program) {
    const auto arguments = std::make_shared<ViewArguments>();
    CLI::App* command = program.add_subcommand("view", "Write a model as a 3D page for any web browser");
    command->add_option("DIR", arguments->folder, "Folder that build wrote")->required();
    command->add_option("-o,--output", arguments->output, "The page; DIR/model.html if not given");
    command->add_option("--title", arguments->title, "Its title; the folder's name if not given");
    command->add_flag("--json", arguments->json, "Print JSON: file and size");
    command->add_flag("--overwrite", arguments->overwrite, "Replace a file that is there");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace stratareeb
