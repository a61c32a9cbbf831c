// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report_options.h"

namespace stratareeb {

void add_report_options(CLI::App& command, ReportChoices& choices) {
    command.add_option("--title", choices.title, "Over the report");
    command
        .add_option("--through", choices.fences,
                    "A further section, through boreholes: their names, with commas between; may be repeated")
        ->take_all();
    command.add_option("--seed", choices.seed, "Of the draws of held-out boreholes")->capture_default_str();
    command.add_flag("--no-validation", choices.no_validation,
                     "Leave the hold-out test out, which takes as long as ten models");
}

ReportOptions report_options(const ReportChoices& choices, const SavedRecord& record, Progress& progress) {
    ReportOptions options{.title = choices.title,
                          .validate = !choices.no_validation,
                          .seed = choices.seed,
                          .build_options = record.record.options};
    for (const std::string& fence : choices.fences) options.fences.push_back(CLI::detail::split(fence, ','));
    options.progress = [&progress](const std::string& step, double share) { progress.step(step, share); };
    return options;
}

}  // namespace stratareeb
