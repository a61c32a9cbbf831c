// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "apps/command.h"
#include "apps/keep_existing.h"
#include "apps/report_page.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;

struct ReportArguments {
    ReportChoices choices;
    std::string folder, output;
    bool overwrite = false;
};

void run(const ReportArguments& arguments) {
    const fs::path folder = arguments.folder;
    const fs::path output = arguments.output.empty() ? folder / "report.html" : fs::path(arguments.output);
    keep_existing(output, arguments.overwrite);
    Progress progress("report");
    const ReportPage page = write_report_page(folder, output, arguments.choices, progress);
    fmt::print("{}: {} figures, {:.1f} MB\n", output.string(), page.figures,
               static_cast<double>(page.bytes) / 1e6);
}

}  // namespace

void add_report_command(CLI::App& program) {
    const auto arguments = std::make_shared<ReportArguments>();
    CLI::App* command = program.add_subcommand("report", "One page about a built model, with its drawings");
    command->add_option("DIR", arguments->folder, "Folder that build wrote")->required();
    add_report_options(*command, arguments->choices);
    command->add_option("-o,--output", arguments->output, "HTML file (report.html in DIR)");
    command->add_flag("--overwrite", arguments->overwrite, "Replace a report that is there");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace stratareeb
