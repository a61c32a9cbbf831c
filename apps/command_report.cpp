// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/keep_existing.h"
#include "apps/progress.h"
#include "apps/report_options.h"
#include "io/base64.h"
#include "io/staged_folder.h"
#include "io/text_scanner.h"
#include "io/write_aside.h"
#include "io/write_report.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;

struct ReportArguments {
    ReportChoices choices;
    std::string folder, output;
    bool overwrite = false;
};

//! A figure as a data URL, so that the report is one file.
std::string data_url(const fs::path& file) {
    const char* type = file.extension() == ".png" ? "image/png" : "image/svg+xml";
    return fmt::format("data:{};base64,{}", type, base64(file_content(file)));
}

void run(const ReportArguments& arguments) {
    const fs::path folder = arguments.folder;
    const fs::path output = arguments.output.empty() ? folder / "report.html" : fs::path(arguments.output);
    keep_existing(output, arguments.overwrite);
    Progress progress("report");
    progress.step("reading the model", 0);
    const SavedModel saved = read_model(folder);
    const SavedRecord record = read_record(folder);
    StagedFolder scratch(output.string() + ".figures", true);  // never put in place
    std::map<std::string, fs::path> places;
    const ReportFigures figures =
        write_report_figures(saved, report_options(arguments.choices, record, progress),
                             [&](const std::string& file) { return places[file] = scratch.add(file); });
    ReportParts parts{.saved = saved, .record = record, .figures = figures, .title = arguments.choices.title};
    if (fs::exists(output.parent_path() / "model.html")) parts.links = {"model.html"};
    const std::string html =
        report_html(parts, [&](const std::string& file) { return data_url(places.at(file)); });
    write_aside(output, [&](std::ostream& stream) { stream << html; });
    progress.clear();
    fmt::print("{}: {} figures, {:.1f} MB\n", output.string(), places.size(),
               static_cast<double>(html.size()) / 1e6);
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
