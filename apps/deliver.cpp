// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/deliver.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>

#include "apps/progress.h"
#include "boreholes/errors.h"
#include "io/model_tables.h"
#include "io/staged_folder.h"
#include "io/write_aside.h"
#include "io/write_report.h"
#include "io/write_validation.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;

constexpr const char* kListFile = "files.txt";

void copy_model(const fs::path& model, const std::vector<std::string>& files, StagedFolder& folder) {
    for (const std::string& file : files) {
        if (!fs::exists(model / file))
            throw IoError(fmt::format("{}: model.json lists it, but it is gone; build the model again",
                                      (model / file).string()));
        fs::copy_file(model / file, folder.add("model/" + file));
    }
    if (fs::exists(model / "model.html")) fs::copy_file(model / "model.html", folder.add("model.html"));
}

void write_tables(const SavedModel& saved, const SavedRecord& record, const ReportFigures& figures,
                  StagedFolder& folder) {
    write_table(folder.add("tables/volumes.csv"), volumes_table(saved.model, record));
    if (saved.survey.holes.empty()) return;
    write_table(folder.add("tables/logs.csv"), logs_table(saved.survey));
    write_table(folder.add("tables/model_logs.csv"), model_logs_table(saved));
    if (!figures.validation) return;
    write_table(folder.add("validation/errors.csv"), errors_table({*figures.validation}));
    write_table(folder.add("validation/residuals.csv"), residuals_table(saved.survey, *figures.validation));
}

}  // namespace

void deliver(const DeliverArguments& arguments) {
    const fs::path model = arguments.folder;
    StagedFolder folder(arguments.output, arguments.overwrite);
    Progress progress("deliver", arguments.quiet ? std::optional(false) : std::nullopt);
    progress.step("reading the model", 0);
    const SavedModel saved = read_model(model);
    const SavedRecord record = read_record(model);
    ReportOptions options = report_options(arguments.choices, record, progress);
    options.for_delivery = true;
    options.crs = saved.crs_or(arguments.crs);
    const ReportFigures figures =
        write_report_figures(saved, options, [&](const std::string& file) { return folder.add(file); });
    progress.step("copying the model", 1);
    copy_model(model, record.record.files, folder);
    write_tables(saved, record, figures, folder);
    ReportParts parts{.saved = saved, .record = record, .figures = figures, .title = arguments.choices.title};
    for (const std::string& file : folder.files())
        if (file == "model.html" || file.starts_with("tables/") || file.starts_with("model/model."))
            parts.links.push_back(file);
    const std::string html = report_html(parts, [](const std::string& file) { return file; });
    write_aside(folder.add("index.html"), [&](std::ostream& stream) { stream << html; });
    const fs::path list = folder.add(kListFile);
    write_aside(list, [&](std::ostream& stream) {
        for (const std::string& file : folder.files()) stream << file << '\n';
    });
    folder.commit(listed_files(fs::path(arguments.output) / kListFile));
    progress.clear();
    if (!arguments.quiet)
        fmt::print("{} files in {}; start with index.html\n", folder.files().size(), arguments.output);
}

}  // namespace stratareeb
