// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "apps/command.h"
#include "apps/keep_existing.h"
#include "apps/mesh_report.h"
#include "apps/report_page.h"
#include "io/write_viewer.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;

struct ViewArguments {
    std::string folder, output, title;
    bool json = false, overwrite = false, no_report = false;
};

//! Beside the page in the model's folder, unless there is a report.
fs::path report_beside(const ViewArguments& arguments) {
    fs::path file = fs::path(arguments.folder) / "report.html";
    if (arguments.no_report || !arguments.output.empty() || fs::exists(file)) return {};
    Progress progress("view");
    write_report_page(arguments.folder, file, {.title = arguments.title}, progress, true);
    return file;
}

void run(const ViewArguments& arguments) {
    const std::string file =
        arguments.output.empty() ? (fs::path(arguments.folder) / "model.html").string() : arguments.output;
    keep_existing(file, arguments.overwrite);
    const fs::path report = report_beside(arguments);
    const std::size_t size = write_viewer(arguments.folder, file, {.title = arguments.title, .report = {}});
    if (arguments.json) {
        nlohmann::json said{{"file", file}, {"bytes", size}};
        if (!report.empty()) said["report"] = report.string();
        std::fputs(json_text(said).c_str(), stdout);
        return;
    }
    fmt::print("{}: {:.2f} MB; open it with a web browser\n", file, static_cast<double>(size) / 1e6);
    if (!report.empty()) fmt::print("{}: what went in, sections, maps, errors\n", report.string());
}

}  // namespace

void add_view_command(CLI::App& program) {
    const auto arguments = std::make_shared<ViewArguments>();
    CLI::App* command = program.add_subcommand(
        "view", "Write a model as a 3D page for any web browser, and a report beside it");
    command->add_option("DIR", arguments->folder, "Folder that build wrote")->required();
    command->add_option("-o,--output", arguments->output, "The page; DIR/model.html if not given");
    command->add_option("--title", arguments->title, "Its title; the folder's name if not given");
    command->add_flag("--no-report", arguments->no_report,
                      "Write no report.html beside DIR/model.html (one that is there stays in any case)");
    command->add_flag("--json", arguments->json, "Print JSON: file and size");
    command->add_flag("--overwrite", arguments->overwrite, "Replace a file that is there");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace stratareeb
