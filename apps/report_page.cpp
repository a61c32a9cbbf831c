// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report_page.h"

#include <fmt/format.h>

#include <map>
#include <ostream>
#include <string>

#include "io/base64.h"
#include "io/staged_folder.h"
#include "io/text_scanner.h"
#include "io/write_aside.h"
#include "io/write_report.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;

//! A figure as a data URL, so that the report is one file.
std::string data_url(const fs::path& file) {
    const char* type = file.extension() == ".png" ? "image/png" : "image/svg+xml";
    return fmt::format("data:{};base64,{}", type, base64(file_content(file)));
}

}  // namespace

ReportPage write_report_page(const fs::path& folder, const fs::path& file, const ReportChoices& choices,
                             Progress& progress, bool has_view) {
    progress.step("reading the model", 0);
    const SavedModel saved = read_model(folder);
    const SavedRecord record = read_record(folder);
    StagedFolder scratch(file.string() + ".figures", true);  // never put in place
    std::map<std::string, fs::path> places;
    const ReportFigures figures =
        write_report_figures(saved, report_options(choices, record, progress),
                             [&](const std::string& name) { return places[name] = scratch.add(name); });
    ReportParts parts{.saved = saved, .record = record, .figures = figures, .title = choices.title};
    if (has_view || fs::exists(file.parent_path() / "model.html")) parts.links = {"model.html"};
    ReportPage page;
    const std::string html = report_html(parts, [&](const std::string& name) {
        ++page.figures;
        return data_url(places.at(name));
    });
    page.bytes = html.size();
    write_aside(file, [&](std::ostream& stream) { stream << html; });
    progress.clear();
    return page;
}

}  // namespace stratareeb
