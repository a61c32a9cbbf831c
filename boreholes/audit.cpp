// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/audit.h"

#include <fmt/format.h>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

constexpr std::size_t kKept = 10000;  // findings of one severity that are stored
constexpr std::size_t kThrown = 200;  // errors listed in one exception

std::string left_out(std::size_t count) {
    return count == 0 ? "" : fmt::format("… and {} more\n", count);
}

}  // namespace

std::string finding_line(const Finding& finding) {
    std::string line = finding.file;
    if (finding.row > 0) line += fmt::format("{}{}", line.empty() ? "row " : ":", finding.row);
    if (!line.empty()) line += ": ";
    if (!finding.column.empty()) line += fmt::format("column {}: ", finding.column);
    return line + finding.text;
}

void Audit::add(Finding finding) {
    std::size_t& count = finding.severity == Severity::Error ? errors_ : warnings_;
    if (++count <= kKept) findings_.push_back(std::move(finding));
}

void Audit::add_warning(std::string file, std::size_t row, std::string column, std::string text) {
    add({Severity::Warning, std::move(file), row, std::move(column), std::move(text)});
}

void Audit::add_error(std::string file, std::size_t row, std::string column, std::string text) {
    add({Severity::Error, std::move(file), row, std::move(column), std::move(text)});
}

std::string Audit::text(std::size_t limit) const {
    std::string lines;
    const std::size_t shown = std::min(limit, findings_.size());
    for (std::size_t i = 0; i < shown; ++i) lines += finding_line(findings_[i]) + '\n';
    return lines + left_out(errors_ + warnings_ - shown);
}

void Audit::throw_if_errors() const {
    if (!has_errors()) return;
    std::string lines;
    std::size_t shown = 0;
    for (const Finding& finding : findings_) {
        if (finding.severity != Severity::Error || shown == kThrown) continue;
        lines += finding_line(finding) + '\n';
        ++shown;
    }
    lines += left_out(errors_ - shown);
    lines.pop_back();
    throw InvalidInput(lines);
}

}  // namespace stratareeb
