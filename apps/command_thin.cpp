// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/build_options.h"
#include "apps/command.h"
#include "apps/keep_existing.h"
#include "apps/progress.h"
#include "boreholes/audit.h"
#include "boreholes/thin_survey.h"
#include "io/write_boreholes.h"

namespace stratareeb {
namespace {

struct ThinArguments {
    TableArguments table;
    std::string output;
    std::optional<double> error;
    std::optional<std::size_t> count;
    bool json = false, quiet = false, overwrite = false;
};

void run(const ThinArguments& arguments) {
    if (!arguments.error && !arguments.count)
        throw CLI::ValidationError("thin", "give --error, --count or both");
    keep_existing(arguments.output, arguments.overwrite);
    Progress progress("thin", arguments.quiet ? std::optional(false) : std::nullopt);
    progress.step("reading boreholes", 0);
    BoreholeTable table = read_boreholes(arguments.table.tables, arguments.table.read);
    const double holes = static_cast<double>(table.survey.holes.size());
    const ThinnedSurvey thinned = thin_survey(
        table.survey,
        {.error = arguments.error.value_or(0), .count = arguments.count, .progress = [&](std::size_t kept) {
             progress.step("choosing boreholes", static_cast<double>(kept) / holes);
         }});
    Survey kept = table.survey;
    kept.holes.clear();
    for (const std::size_t h : thinned.kept) kept.holes.push_back(table.survey.holes[h]);
    write_boreholes(arguments.output, kept, kept.contact_points ? TableLayout::Points : TableLayout::Wide);
    progress.clear();
    if (!arguments.quiet)
        for (const Finding& finding : table.audit.findings())
            fmt::print(stderr, "warning: {}\n", finding_line(finding));
    if (arguments.json)
        fmt::print("{}\n", nlohmann::ordered_json{{"boreholes", table.survey.holes.size()},
                                                  {"kept", thinned.kept.size()},
                                                  {"largest_error", thinned.largest_error},
                                                  {"rms_error", thinned.rms_error},
                                                  {"length_unit", kept.length_unit}}
                               .dump(2));
    else
        fmt::print(
            "{} of {} boreholes kept; those left out are missed by {:.4g} {} at most, {:.4g} root mean "
            "square\n",
            thinned.kept.size(), table.survey.holes.size(), thinned.largest_error, kept.length_unit,
            thinned.rms_error);
}

}  // namespace

void add_thin_command(CLI::App& program) {
    const auto arguments = std::make_shared<ThinArguments>();
    CLI::App* command =
        program.add_subcommand("thin", "Fewer boreholes that say the same, within a stated error");
    add_table_options(*command, arguments->table);
    command->add_option("-o,--output", arguments->output, "Table of the boreholes that stay (.csv, .xlsx)")
        ->required();
    command
        ->add_option("--error", arguments->error,
                     "Keep boreholes until those left out are missed by no more, in the table's unit")
        ->check(CLI::NonNegativeNumber);
    command->add_option("--count", arguments->count, "Keep so many at most, the most telling first")
        ->check(CLI::Range(3, 1'000'000'000, "3 or more"));
    command->add_flag("--json", arguments->json, "Print the result as JSON");
    command->add_flag("--quiet", arguments->quiet, "No progress and no warnings on standard error");
    command->add_flag("--overwrite", arguments->overwrite, "Replace a table that is there");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace stratareeb
