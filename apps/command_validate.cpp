// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "apps/build_options.h"
#include "apps/choice.h"
#include "apps/command.h"
#include "apps/progress.h"
#include "boreholes/choose_interpolator.h"
#include "boreholes/errors.h"
#include "boreholes/validation.h"
#include "io/read_faults.h"
#include "io/read_raster.h"
#include "io/read_true_volumes.h"
#include "io/staged_folder.h"
#include "io/write_aside.h"
#include "io/write_choice.h"
#include "io/write_features.h"
#include "io/write_residual_drawing.h"
#include "io/write_table.h"
#include "io/write_validation.h"
#include "mesh/fault_blocks.h"

namespace stratareeb {
namespace {

struct ValidateArguments {
    TableArguments table;
    RuleArguments rules;
    std::string output, ground, faults, pinch_out = "half", truth, plots = "svg";
    std::vector<std::string> interpolators{std::string(name_of(kDefaultInterpolator))};
    std::size_t folds = 10, at_a_time = 0, suggestions = 5;
    double share = 30, confidence = 95;
    std::uint64_t seed = 1;
    MeanLaw law = MeanLaw::StudentT;
    bool leave_one_out = false, bare = false, json = false, quiet = false, overwrite = false;
};

std::vector<std::string> all_interpolators() {
    std::vector<std::string> names;
    for (const InterpolatorKind kind : interpolator_kinds()) names.emplace_back(name_of(kind));
    return names;
}

//! Hold-out tests of one survey, with reports.
class Validate {
 public:
    explicit Validate(const ValidateArguments& arguments)
        : arguments_(arguments),
          progress_("validate", arguments.quiet ? std::optional(false) : std::nullopt) {}

    void run() {
        std::optional<StagedFolder> folder;
        if (!arguments_.output.empty()) folder.emplace(arguments_.output, arguments_.overwrite);
        if (!arguments_.ground.empty()) terrain_ = read_raster(arguments_.ground);
        if (!arguments_.truth.empty()) return compare_with_truth(folder ? &*folder : nullptr);

        progress_.step("reading boreholes", 0);
        const BoreholeTable table = read(arguments_.table.tables);
        if (!arguments_.faults.empty())
            faults_ = fault_blocks_of(table.survey, read_faults(arguments_.faults));
        const std::vector<Draw> draws = draws_of(table.survey.holes.size());
        std::vector<NamedValidation> validations;
        for (const InterpolatorKind kind : kinds_for(table.survey))
            validations.push_back({std::string(name_of(kind)), validated(table.survey, draws, kind)});
        progress_.clear();
        const ValidationRecord record = record_of(table, draws, validations);
        if (folder) write_files(*folder, table.survey, validations, record);
        if (!arguments_.quiet)
            for (const std::string& warning : record.warnings) fmt::print(stderr, "warning: {}\n", warning);
        if (arguments_.json)
            fmt::print("{}\n", json_of(table.survey, validations, record).dump(2));
        else
            print(table.survey, validations, record);
    }

 private:
    std::vector<std::string> names() const {
        return arguments_.interpolators == std::vector<std::string>{"all"} ? all_interpolators()
                                                                           : arguments_.interpolators;
    }

    //! The interpolators asked for, each once; `auto` is what left-out holes choose.
    std::vector<InterpolatorKind> kinds_for(const Survey& survey) {
        std::vector<InterpolatorKind> kinds;
        for (const std::string& name : names()) {
            const InterpolatorKind kind = name == "auto" ? chosen_for(survey) : interpolator_kind(name);
            if (std::ranges::find(kinds, kind) == kinds.end()) kinds.push_back(kind);
        }
        return kinds;
    }

    InterpolatorKind chosen_for(const Survey& survey) {
        ChooseOptions options{
            .pinch_out = pinch_out_rule(arguments_.pinch_out),
            .terrain = terrain(),
            .rules = arguments_.rules.of(survey.units),
            .block = faults_.block_of,
            .ties = faults_.ties,
            .bare = arguments_.bare,
            .progress = [this](double share) { progress_.step("choosing the interpolator", share); }};
        choice_ = choose_interpolator(survey, options);
        return choice_->kind;
    }

    std::function<std::optional<double>(const Point2&)> terrain() const {
        if (!terrain_) return {};
        return [this](const Point2& p) { return terrain_->sample(p.x, p.y); };
    }

    BoreholeTable read(const std::vector<std::string>& tables) const {
        ReadBoreholesOptions options = arguments_.table.read;
        options.has_ground_raster = terrain_.has_value();
        return read_boreholes(tables, options);
    }

    std::vector<Draw> draws_of(std::size_t holes) const {
        if (arguments_.leave_one_out) return single_draws(holes);
        if (arguments_.at_a_time > 0)
            return repeated_draws(holes, arguments_.at_a_time, arguments_.share / 100, arguments_.seed);
        return fold_draws(holes, arguments_.folds, arguments_.seed);
    }

    std::string way(const std::vector<Draw>& draws) const {
        if (arguments_.leave_one_out) return "each borehole by itself";
        if (arguments_.at_a_time > 0)
            return fmt::format("{} boreholes at a time until {:g} % have been out, seed {}",
                               arguments_.at_a_time, arguments_.share, arguments_.seed);
        return fmt::format("{} folds, seed {}", draws.size(), arguments_.seed);
    }

    Validation validated(const Survey& survey, const std::vector<Draw>& draws, InterpolatorKind kind) {
        ValidationOptions options;
        options.hold_out.prediction.interpolator = kind;
        options.hold_out.prediction.pinch_out = pinch_out_rule(arguments_.pinch_out);
        options.hold_out.prediction.rules = arguments_.rules.of(survey.units);
        options.hold_out.prediction.terrain = terrain();
        options.hold_out.bare = arguments_.bare;
        options.hold_out.block = faults_.block_of;
        options.hold_out.ties = faults_.ties;
        options.hold_out.progress = [this, kind](double share) {
            progress_.step(fmt::format("predicting by {}", name_of(kind)), share);
        };
        options.confidence = arguments_.confidence / 100;
        options.law = arguments_.law;
        options.suggestions = arguments_.suggestions;
        return validate(survey, draws, options);
    }

    ValidationRecord record_of(const BoreholeTable& table, const std::vector<Draw>& draws,
                               const std::vector<NamedValidation>& validations) const {
        ValidationRecord record{.hold_out = way(draws),
                                .confidence = arguments_.confidence / 100,
                                .law = arguments_.law == MeanLaw::Normal ? "normal" : "t"};
        for (const Finding& finding : table.audit.findings())
            record.warnings.push_back(finding_line(finding));
        record.warnings.insert(record.warnings.end(), faults_.notes.begin(), faults_.notes.end());
        const auto few = [](const ItemValidation& item) { return item.errors.count > 0 && !item.certain; };
        const Validation& first = validations.front().result;
        if (std::ranges::any_of(first.layers, few) || std::ranges::any_of(first.horizons, few))
            record.warnings.push_back(
                fmt::format("some layers are known by too few held-out holes for intervals of {:g} %; the "
                            "largest error is taken",
                            arguments_.confidence));
        return record;
    }

    nlohmann::ordered_json json_of(const Survey& survey, const std::vector<NamedValidation>& validations,
                                   const ValidationRecord& record) const {
        auto json = validation_json(survey, validations, record);
        if (choice_) json["auto"] = choice_json(*choice_);
        return json;
    }

    void write_files(StagedFolder& folder, const Survey& survey,
                     const std::vector<NamedValidation>& validations, const ValidationRecord& record) const {
        const NamedValidation& first = validations.front();
        write_aside(folder.add("validation.json"), [&](std::ostream& stream) {
            stream << json_of(survey, validations, record).dump(2) << '\n';
        });
        write_table(folder.add("errors.csv"), errors_table(validations));
        if (choice_) write_table(folder.add("auto.csv"), choice_table(*choice_));
        write_table(folder.add("residuals.csv"), residuals_table(survey, first));
        write_table(folder.add("units.csv"), unit_match_table(survey, first));
        write_table(folder.add("next_boreholes.csv"), next_boreholes_table(first));
        write_features(folder.add("residuals.geojson"), residual_features(survey, first),
                       {.table = "residuals"});
        write_residual_map(folder.add("residual_map." + arguments_.plots), survey, first);
        write_residual_scatter(folder.add("scatter." + arguments_.plots), survey, first);
        folder.commit({});
    }

    void print(const Survey& survey, const std::vector<NamedValidation>& validations,
               const ValidationRecord& record) const {
        const Validation& first = validations.front().result;
        fmt::print("{} boreholes, {} held out ({}), lengths in {}; errors are predicted - actual\n",
                   survey.holes.size(), first.held.size(), record.hold_out, survey.length_unit);
        if (choice_) fmt::print("\n{}", choice_text(*choice_));
        print_items(validations.front(), record);
        print_pooled(first, record);
        if (validations.size() > 1) print_comparison(validations);
        print_next(first);
        if (!arguments_.output.empty()) fmt::print("written to {}\n", arguments_.output);
    }

    void print_items(const NamedValidation& validation, const ValidationRecord& record) const {
        const std::string interval = fmt::format("{:g} % of mean", 100 * record.confidence);
        fmt::print("\n{}\n{:<10} {:<22} {:>6} {:>9} {:>9} {:>9} {:>9} {:>8} {:>21} {:>8} {:>9}\n",
                   validation.name, "", "", "holes", "mean", "RMSE", "MAE", "median", "Z", interval,
                   "covered", "±");
        const auto print_item = [](const char* quantity, const ItemValidation& item) {
            if (item.errors.count == 0) return fmt::print("{:<10} {:<22} {:>6}\n", quantity, item.name, 0);
            fmt::print(
                "{:<10} {:<22} {:>6} {:>9.4g} {:>9.4g} {:>9.4g} {:>9.4g} {:>8.3f} {:>10.4g} {:>10.4g} "
                "{:>6.1f} % {:>9.4g}\n",
                quantity, item.name, item.errors.count, item.errors.mean, item.errors.rmse, item.errors.mae,
                item.errors.median, item.z.z, item.bias.low, item.bias.high, 100 * item.coverage(),
                item.mean_half_width);
        };
        for (const ItemValidation& item : validation.result.layers) print_item("thickness", item);
        for (const ItemValidation& item : validation.result.horizons) print_item("elevation", item);
    }

    static void print_pooled(const Validation& result, const ValidationRecord& record) {
        fmt::print(
            "\nall layers, boreholes as units: mean {:.4g}, {:g} % interval {:.4g} to {:.4g}, p = {:.3g}{}\n",
            result.pooled.mean, 100 * record.confidence, result.pooled.low, result.pooled.high,
            result.pooled.p, result.pooled.contains_zero() ? "" : ": biased");
        fmt::print("values within their intervals: {:.1f} %; horizons that cross: {}\n",
                   100 * result.coverage, result.crossings);
        if (!result.layers.empty())
            fmt::print("unit right at depth: {:.1f} % of the drilled length\n",
                       100 * result.units.share_right());
    }

    static void print_comparison(const std::vector<NamedValidation>& validations) {
        fmt::print("\nRMSE{:<29}", "");
        for (const NamedValidation& validation : validations) fmt::print(" {:>17}", validation.name);
        const auto print_row = [&](const char* quantity, std::vector<ItemValidation> Validation::*items,
                                   std::size_t i) {
            fmt::print("\n{:<10} {:<22}", quantity, (validations.front().result.*items)[i].name);
            for (const NamedValidation& validation : validations)
                fmt::print(" {:>17.4g}", (validation.result.*items)[i].errors.rmse);
        };
        for (std::size_t i = 0; i < validations.front().result.layers.size(); ++i)
            print_row("thickness", &Validation::layers, i);
        for (std::size_t k = 0; k < validations.front().result.horizons.size(); ++k)
            print_row("elevation", &Validation::horizons, k);
        fmt::print("\n");
    }

    static void print_next(const Validation& result) {
        if (result.next.empty()) return;
        fmt::print("\nfurther boreholes that would help most:\n");
        for (const NextBorehole& next : result.next)
            fmt::print("  {:.12g} {:.12g}  expected error {:.4g} over {:.4g}\n", next.at.x, next.at.y,
                       next.expected_error, next.area);
    }

    void compare_with_truth(StagedFolder* folder) {
        const TrueVolumes truth = read_true_volumes(arguments_.truth);
        std::vector<ComparedModel> models;
        for (const std::string& file : arguments_.table.tables) {
            progress_.step("building " + file, static_cast<double>(models.size()) /
                                                   static_cast<double>(arguments_.table.tables.size()));
            const BoreholeTable table = read({file});
            LayerModelOptions options;
            options.interpolator = kinds_for(table.survey).front();
            options.pinch_out = pinch_out_rule(arguments_.pinch_out);
            options.rules = arguments_.rules.of(table.survey.units);
            if (arguments_.bare) options.spacing = 0;
            options.terrain = terrain();
            models.push_back(
                compare_volumes(std::filesystem::path(file).stem().string(), table.survey, truth, options));
        }
        progress_.clear();
        if (folder) {
            write_table(folder->add("volumes.csv"), volumes_table(truth, models));
            write_aside(folder->add("volumes.json"),
                        [&](std::ostream& stream) { stream << volumes_json(truth, models).dump(2) << '\n'; });
            folder->commit({});
        }
        arguments_.json ? fmt::print("{}\n", volumes_json(truth, models).dump(2))
                        : print_volumes(truth, models);
    }

    static void print_volumes(const TrueVolumes& truth, const std::vector<ComparedModel>& models) {
        fmt::print("{:<22} {:>14}", "layer", "actual");
        for (const ComparedModel& model : models) fmt::print(" {:>24}", fmt::format("{} holes", model.holes));
        const auto print_row = [&](const std::string& name, double actual, auto&& volume_of) {
            fmt::print("\n{:<22} {:>14.7g}", name, actual);
            for (const ComparedModel& model : models)
                fmt::print(" {:>14.7g} {:>+7.2f} %", volume_of(model),
                           actual == 0 ? 0.0 : 100 * (volume_of(model) - actual) / actual);
        };
        double sum = 0;
        for (std::size_t i = 0; i < truth.codes.size(); ++i) {
            print_row(truth.codes[i], truth.volumes[i],
                      [i](const ComparedModel& model) { return model.volumes[i]; });
            sum += truth.volumes[i];
        }
        print_row("all", sum, [](const ComparedModel& model) { return model.envelope; });
        fmt::print("\n");
    }

    const ValidateArguments& arguments_;
    Progress progress_;
    std::optional<Raster> terrain_;
    std::optional<InterpolatorChoice> choice_;  // by `auto`
    FaultBlocks faults_;                        // as `build` parts the holes' hull; empty = no faults
};

void add_hold_out_options(CLI::App& command, ValidateArguments& arguments) {
    auto* folds =
        command.add_option("--folds", arguments.folds, "Leave every borehole out once, in so many draws")
            ->check(CLI::Range(2, 1'000'000'000, "2 or more"))
            ->capture_default_str();
    auto* at_a_time = command
                          .add_option("--leave-out", arguments.at_a_time,
                                      "Boreholes left out at a time, until --share of all have been out")
                          ->check(CLI::Range(1, 1'000'000'000, "1 or more"));
    command.add_option("--share", arguments.share, "Per cent of the boreholes, with --leave-out")
        ->check(CLI::Range(0.001, 100.0))
        ->needs(at_a_time)
        ->capture_default_str();
    auto* single = command.add_flag("--leave-one-out", arguments.leave_one_out, "Each borehole by itself");
    folds->excludes(at_a_time)->excludes(single);
    at_a_time->excludes(single);
    command.add_option("--seed", arguments.seed, "Another seed, other draws")->capture_default_str();
    command.add_option("--confidence", arguments.confidence, "Of intervals, in per cent")
        ->check(CLI::Range(50.0, 99.9))
        ->capture_default_str();
    add_choice<MeanLaw>(command, "--quantiles", arguments.law,
                        {{"t", MeanLaw::StudentT}, {"normal", MeanLaw::Normal}}, "Law of means in tests (t)");
}

void add_model_options(CLI::App& command, ValidateArguments& arguments) {
    std::vector<std::string> names = all_interpolators();
    names.emplace_back("auto");
    names.emplace_back("all");
    command
        .add_option(
            "--interpolator", arguments.interpolators,
            fmt::format("Prediction between holes, several with commas between: {} (auto: by left-out "
                        "holes; default {})",
                        fmt::join(names, ", "), name_of(kDefaultInterpolator)))
        ->delimiter(',')
        ->check(CLI::IsMember(names));
    command
        .add_option("--pinch-out", arguments.pinch_out,
                    "Where a layer ends between a hole that lacks it and one that has it")
        ->check(CLI::IsMember({"at-hole", "quarter", "third", "half"}))
        ->capture_default_str();
    command.add_flag("--bare", arguments.bare,
                     "Predict on the bare triangulation of the holes, as with --spacing none");
    command.add_option("--ground", arguments.ground,
                       "Elevation raster of the ground (GeoTIFF, ESRI ASCII, …)");
    command.add_option("--faults", arguments.faults,
                       "Lines of vertical faults in plan; no hole is predicted from across one");
}

}  // namespace

void add_validate_command(CLI::App& program) {
    auto arguments = std::make_shared<ValidateArguments>();
    CLI::App* command =
        program.add_subcommand("validate", "Hold-out tests: how well boreholes predict boreholes");
    add_table_options(*command, arguments->table);
    add_rule_options(*command, arguments->rules);
    add_hold_out_options(*command, *arguments);
    add_model_options(*command, *arguments);
    command
        ->add_option(
            "--truth", arguments->truth,
            "True volumes, as sample writes them: build a model of each TABLE and compare its volumes "
            "instead")
        ->excludes("--faults");
    command->add_option("--suggest", arguments->suggestions, "How many places for further boreholes to name")
        ->check(CLI::Range(0, 10'000))
        ->capture_default_str();
    command->add_option("-o,--output", arguments->output, "Folder for tables, plots and maps");
    command->add_option("--plots", arguments->plots, "Format of the plots")
        ->check(CLI::IsMember({"svg", "png", "pdf"}))
        ->capture_default_str();
    command->add_flag("--overwrite", arguments->overwrite,
                      "Write into a folder that holds something already");
    command->add_flag("--json", arguments->json, "Print everything but the residuals as JSON");
    command->add_flag("--quiet", arguments->quiet, "No progress and no warnings on standard error");
    command->callback([arguments] { Validate(*arguments).run(); });
}

}  // namespace stratareeb
