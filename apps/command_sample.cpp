// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "apps/choice.h"
#include "apps/command.h"
#include "apps/keep_existing.h"
#include "boreholes/errors.h"
#include "boreholes/random_survey.h"
#include "io/write_aside.h"
#include "io/write_boreholes.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;

struct SampleArguments {
    std::string output;
    bool overwrite = false, no_corners = false;
    TableLayout layout = TableLayout::Wide;
    RandomSurveyOptions survey;
};

fs::path truth_file(const fs::path& table) {
    return table.parent_path() / (table.stem().string() + "_truth.json");
}

nlohmann::ordered_json truth_as_json(const RandomSurveyOptions& options, const Survey& survey) {
    const AnalyticTruth truth = random_truth(options);
    nlohmann::ordered_json json{
        {"seed", options.seed},
        {"holes", survey.holes.size()},
        {"box",
         {truth.corner.x, truth.corner.y, truth.corner.x + truth.extent, truth.corner.y + truth.extent}},
        {"units", nlohmann::ordered_json::array()}};
    double sum = 0;
    for (std::size_t i = 0; i < survey.units.size(); ++i) {
        json["units"].push_back(
            {{"order", i + 1}, {"code", survey.units[i].code}, {"volume", truth.volume(i)}});
        sum += truth.volume(i);
    }
    json["envelope_volume"] = sum;
    return json;
}

void run(const SampleArguments& arguments) {
    const fs::path table = arguments.output;
    std::vector<fs::path> files{table, truth_file(table)};
    if (arguments.layout == TableLayout::Intervals) files.insert(files.begin() + 1, collar_table(table));
    for (const fs::path& file : files) keep_existing(file, arguments.overwrite);
    RandomSurveyOptions options = arguments.survey;
    options.corners = !arguments.no_corners;
    const Survey survey = random_survey(options);
    write_boreholes(table, survey, arguments.layout);
    write_aside(truth_file(table),
                [&](std::ostream& stream) { stream << truth_as_json(options, survey).dump(2) << '\n'; });
    fmt::print(stderr, "{} holes in {} layers:\n", survey.holes.size(), survey.units.size());
    for (const fs::path& file : files) fmt::print("{}\n", file.string());
}

const CLI::Validator kPositive(
    [](const std::string& text) {
        double number = 0;
        const bool sound = CLI::detail::lexical_cast(text, number) && number > 0 && std::isfinite(number);
        return sound ? std::string() : fmt::format("{} is not a number above 0", text);
    },
    "");

}  // namespace

void add_sample_command(CLI::App& program) {
    auto arguments = std::make_shared<SampleArguments>();
    RandomSurveyOptions& survey = arguments->survey;
    CLI::App* command = program.add_subcommand("sample", "Random boreholes drilled into a known truth");
    command
        ->add_option("-o,--output", arguments->output,
                     "Table to write, .csv or .xlsx; its true volumes go to *_truth.json")
        ->required();
    command->add_option("--holes", survey.holes, "Number of holes")
        ->check(CLI::Range(3, 10'000'000, "3 or more"))
        ->capture_default_str();
    command->add_option("--layers", survey.layers, "Number of layers")
        ->check(CLI::Range(1, 10'000, "1 or more"))
        ->capture_default_str();
    command
        ->add_option("--seed", survey.seed, "Another seed, another survey")

        ->capture_default_str();
    command->add_option("--extent", survey.extent, "Side of the square that is drilled")
        ->check(kPositive)
        ->capture_default_str();
    command->add_option("--thickness", survey.thickness, "Thickness of a layer")
        ->check(kPositive)
        ->capture_default_str();
    add_choice<TableLayout>(
        *command, "--layout", arguments->layout,
        {{"wide", TableLayout::Wide}, {"intervals", TableLayout::Intervals}, {"points", TableLayout::Points}},
        "Layout of the table (wide)");
    add_choice<TruthKind>(*command, "--truth", survey.truth,
                          {{"slab", TruthKind::Slab},
                           {"dipping", TruthKind::Dipping},
                           {"wedge", TruthKind::Wedge},
                           {"dome", TruthKind::Dome},
                           {"lens", TruthKind::Lens},
                           {"random", TruthKind::Random}},
                          "Shape of the layers (random)");
    add_choice<HolePlan>(*command, "--plan", survey.plan,
                         {{"random", HolePlan::Random},
                          {"clustered", HolePlan::Clustered},
                          {"grid", HolePlan::Grid},
                          {"line", HolePlan::Line}},
                         "How the holes are spread (random)");
    command->add_flag("--pinch-outs", survey.pinch_outs,
                      "All layers but the first end somewhere (random truth)");
    command->add_flag("--no-corners", arguments->no_corners, "No holes in the corners of the square");
    command->add_flag("--overwrite", arguments->overwrite, "Replace files that are there");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace stratareeb
