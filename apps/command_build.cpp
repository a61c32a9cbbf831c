// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>

#include "apps/build_options.h"
#include "apps/command.h"
#include "apps/deliver.h"
#include "apps/memory_guard.h"
#include "apps/progress.h"
#include "apps/report_page.h"
#include "boreholes/choose_interpolator.h"
#include "boreholes/errors.h"
#include "boreholes/plan_layout.h"
#include "io/faceted_bodies.h"
#include "io/map_reference.h"
#include "io/model_holes.h"
#include "io/read_faults.h"
#include "io/read_footprint.h"
#include "io/read_raster.h"
#include "io/smooth_bodies.h"
#include "io/staged_folder.h"
#include "io/step_document.h"
#include "io/write_aside.h"
#include "io/write_brep.h"
#include "io/write_choice.h"
#include "io/write_mesh.h"
#include "io/write_meshlab_project.h"
#include "io/write_model.h"
#include "io/write_picture.h"
#include "io/write_table.h"
#include "io/write_viewer.h"
#include "mesh/decimate_layers.h"
#include "mesh/fault_blocks.h"
#include "mesh/faulted_model.h"
#include "subdivision/refined_layers.h"

namespace stratareeb {
namespace {

// Shares of the whole run at which its parts end, for the time left.
constexpr double kReadEnd = 0.05, kModelEnd = 0.35, kRefineEnd = 0.5, kSolidsEnd = 0.9;
// Where smooth CAD solids are made too, which takes most of the time: the share of all before them, and with them.
constexpr double kBeforeSmooth = 0.15, kSmoothEnd = 0.95;

class Build {
 public:
    explicit Build(const BuildArguments& arguments)
        : arguments_(arguments), progress_("build", arguments.quiet ? std::optional(false) : std::nullopt) {}

    //! From table to files; should smooth surfaces come out unsound, the plain ones, with a warning.
    void run() {
        if (!arguments_.deliver.empty())
            StagedFolder(arguments_.deliver, arguments_.overwrite);  // may it be written?
        say("reading boreholes", 0);
        const BoreholeTable table = read_table();
        choose_interpolator_for(table.survey);
        const int levels = levels_for(table.survey.holes.size());
        try {
            build(table, levels);
        } catch (const GeometryError& error) {
            if (levels == 0 || arguments_.refine != "auto") throw;
            notes_.push_back(fmt::format("the surfaces are not refined: {}", error.what()));
            build(table, 0);
        }
    }

 private:
    //! The walk.
    void build(const BoreholeTable& table, int levels) {
        StagedFolder folder(arguments_.output, arguments_.overwrite);
        unrefined_.reset();
        is_smooth_made_ = false;
        ModelRecord record{
            .units = {}, .checks = {}, .warnings = {}, .options = arguments_.record(), .files = {}};
        record.choice = choice_;
        if (choice_) write_table(folder.add("auto.csv"), choice_table(*choice_));
        LayerModel model = model_of(table.survey, levels, record);
        record.crs = crs_of(table);
        record.warnings = warnings_of(table, model);
        write_horizons(folder, model, kHorizonsFolder);
        if (unrefined_) write_horizons(folder, *unrefined_, kUnrefinedFolder);
        const std::vector<LayerSolid> solids = write_layers(folder, model, table.survey, record);
        write_whole_model(folder, model, solids, record);
        write_model_holes(folder.add(kModelHolesFile), table.survey, model.plan.hole_vertex);
        say("checking", kSolidsEnd);
        record.checks = check_model(model, table.survey, record.units);
        fail_if_unsound(record);
        const std::string json = write_record(folder, model, table.survey, record);
        folder.commit(replaced_files());
        if (arguments_.wants("html")) write_report();
        progress_.clear();
        print_result(model, table.survey, record, json);
        if (!arguments_.deliver.empty())
            deliver({.folder = arguments_.output,
                     .output = arguments_.deliver,
                     .overwrite = arguments_.overwrite,
                     .quiet = arguments_.quiet || arguments_.json});
    }

    //! What an earlier model left, pages that `view` and `report` made of it too.
    std::vector<std::string> replaced_files() const {
        std::vector<std::string> files =
            listed_files(std::filesystem::path(arguments_.output) / "model.json");
        files.insert(files.end(), {"model.html", "report.html"});
        return files;
    }

    BoreholeTable read_table() {
        ReadBoreholesOptions options = arguments_.table.read;
        options.has_ground_raster = !arguments_.ground.empty();
        BoreholeTable table = read_boreholes(arguments_.table.tables, options);
        if (arguments_.footprint == "hull") {
            check_plan_layout(table.survey, table.audit);
            table.audit.throw_if_errors();
        }
        if (!arguments_.ground.empty()) terrain_ = read_raster(arguments_.ground);
        return table;
    }

    void choose_interpolator_for(const Survey& survey) {
        if (arguments_.interpolator != "auto") {
            interpolator_ = interpolator_kind(arguments_.interpolator);
            return;
        }
        say("choosing the interpolator", 0);
        const FaultBlocks blocks = blocks_between_faults(survey);
        ChooseOptions options{
            .pinch_out = pinch_out_rule(arguments_.pinch_out),
            .terrain = terrain(),
            .rules = arguments_.rules.of(survey.units),
            .block = blocks.block_of,
            .ties = blocks.ties,
            .bare = arguments_.spacing == "none",
            .progress = [this](double share) { say("choosing the interpolator", share * kReadEnd); }};
        choice_ = choose_interpolator(survey, options);
        interpolator_ = choice_->kind;
        notes_.push_back(choice_->reason);
    }

    FaultBlocks blocks_between_faults(const Survey& survey) const {
        if (arguments_.faults.empty()) return {};
        return fault_blocks_of(survey, read_faults(arguments_.faults), footprint(survey));
    }

    std::function<std::optional<double>(const Point2&)> terrain() const {
        if (!terrain_) return {};
        return [this](const Point2& p) { return terrain_->sample(p.x, p.y); };
    }

    int levels_for(std::size_t holes) {
        if (arguments_.refine != "auto") return arguments_.refine[0] - '0';
        if (arguments_.spacing == "none") return 0;
        const bool facets = arguments_.step == StepKind::Faceted;
        if (facets && makes_cad()) {
            notes_.push_back(
                "the surfaces are left as predicted, since CAD programs open so many facets slowly; "
                "--refine 1 or --step smooth makes them smooth");
            return 0;
        }
        const int levels = suitable_refinement(holes);
        if (levels == 0)
            notes_.push_back(
                fmt::format("the surfaces of so many holes ({}) are left as predicted; --refine 1 "
                            "makes them smooth, with four times the triangles",
                            holes));
        return levels;
    }

    //! Predicted, made smooth and thinned out; with faults block by block.
    LayerModel model_of(const Survey& survey, int levels, ModelRecord& record) {
        const LayerModelOptions options = model_options(survey, levels);
        const double whole = arguments_.faults.empty() ? 0 : footprint_area(survey);
        const auto finished = [&](LayerModel model) {
            const double share = whole > 0 ? plan_area(model) / whole : 1;
            refine(model, levels, record);
            decimate(model, share);
            return model;
        };
        if (arguments_.faults.empty()) return finished(build_layer_model(survey, options));
        if (arguments_.step == StepKind::Smooth)
            throw InvalidInput("--step smooth does not know faults yet; leave it out for faceted bodies");
        return build_faulted_model(survey, read_faults(arguments_.faults), options, finished);
    }

    void refine(LayerModel& model, int levels, ModelRecord& record) {
        if (levels == 0) return;
        if (arguments_.faults.empty()) unrefined_ = model;
        RefineLayersOptions options{.levels = levels};
        options.progress = [this](const char* step, double share) {
            say(step, kModelEnd + share * (kRefineEnd - kModelEnd));
        };
        RefinedLayers refined = refine_layers(model, options);
        model = std::move(refined.model);
        if (record.smoothness)
            add(*record.smoothness, refined.smoothness);
        else
            record.smoothness = refined.smoothness;
    }

    //! Of another block.
    static void add(SmoothnessReport& sum, const SmoothnessReport& block) {
        for (const auto& [of_all, of_block] :
             {std::pair(&sum.before, &block.before), std::pair(&sum.after, &block.after)}) {
            of_all->largest_jump_deg = std::max(of_all->largest_jump_deg, of_block->largest_jump_deg);
            of_all->bending_energy += of_block->bending_energy;
        }
        sum.straightened += block.straightened;
        sum.largest_misfit = std::max(sum.largest_misfit, block.largest_misfit);
        sum.thinnest = std::min(sum.thinnest, block.thinnest);
    }

    double footprint_area(const Survey& survey) const {
        std::vector<Point2> holes;
        for (const Borehole& hole : survey.holes) holes.push_back(hole.at);
        return area(checked_footprint(footprint(survey).value_or(hull_footprint(HoleTriangulation(holes)))));
    }

    static double plan_area(const LayerModel& model) {
        double sum = 0;
        for (const auto f : model.plan.surface.faces()) sum += model.plan.surface.calc_face_area(f);
        return sum;
    }

    //! A block between faults has its share of the triangles asked for.
    void decimate(LayerModel& model, double share) {
        if (arguments_.decimate < 0 && arguments_.decimate_to == 0) return;
        say("leaving out triangles", kRefineEnd);
        DecimateLayersOptions options;
        if (arguments_.decimate >= 0) options.max_error = arguments_.decimate;
        if (arguments_.decimate_to > 0)
            options.triangles = static_cast<std::size_t>(
                std::max(2.0, std::round(share * static_cast<double>(arguments_.decimate_to))));
        DecimatedLayers decimated = decimate_layers(model, options);
        model = std::move(decimated.model);
        notes_.push_back(decimated.note);
    }

    LayerModelOptions model_options(const Survey& survey, int levels) {
        LayerModelOptions options;
        options.interpolator = interpolator_;
        options.ring_holes = levels > 0;
        options.pinch_out = pinch_out_rule(arguments_.pinch_out);
        options.rules = arguments_.rules.of(survey.units);
        if (arguments_.spacing == "none")
            options.spacing = 0;
        else if (levels > 0 && arguments_.spacing == "auto")
            options.spacing_factor = 2;  // a coarse control mesh is smooth
        else if (arguments_.spacing != "auto")
            options.spacing = std::stod(arguments_.spacing);
        options.footprint = footprint(survey);
        options.terrain = terrain();
        options.progress = [this](const char* step, double share) {
            say(step, kReadEnd + share * (kModelEnd - kReadEnd));
        };
        options.before_meshing = [this, &survey, levels](double triangles) {
            const double refined = triangles * std::pow(4.0, levels);
            if (!arguments_.ignore_memory) check_memory(refined, survey.units.size(), keeps_solids());
        };
        return options;
    }

    std::optional<Footprint> footprint(const Survey& survey) const {
        if (arguments_.footprint == "hull") return std::nullopt;
        if (arguments_.footprint != "box") return read_footprint(arguments_.footprint);
        std::vector<Point2> holes;
        for (const Borehole& hole : survey.holes) holes.push_back(hole.at);
        const double margin =
            arguments_.margin >= 0 ? arguments_.margin : suitable_margin(HoleTriangulation(holes));
        return box_footprint(holes, margin);
    }

    //! As asked for, or as the tables or the ground's raster state it.
    std::string crs_of(const BoreholeTable& table) {
        const std::string of_ground = terrain_ ? terrain_->crs : "";
        std::string crs = reference_name(!arguments_.crs.empty() ? arguments_.crs
                                         : !table.crs.empty()    ? table.crs
                                                                 : of_ground);
        if (is_in_degrees(crs))
            notes_.push_back(
                fmt::format("x and y are degrees of {}; areas and volumes need a projected system", crs));
        if (!of_ground.empty() && !is_same_reference(crs, of_ground))
            notes_.push_back(
                fmt::format("the ground's raster is in {}, the model in {}; the raster is not projected anew",
                            reference_name(of_ground), crs));
        return crs;
    }

    std::vector<std::string> warnings_of(const BoreholeTable& table, const LayerModel& model) const {
        std::vector<std::string> warnings;
        for (const Finding& finding : table.audit.findings()) warnings.push_back(finding_line(finding));
        warnings.insert(warnings.end(), model.notes.begin(), model.notes.end());
        warnings.insert(warnings.end(), notes_.begin(), notes_.end());
        return warnings;
    }

    void write_horizons(StagedFolder& folder, const LayerModel& model, const std::string& where) {
        for (std::size_t k = 0; k < model.horizons.size(); ++k) {
            say("writing horizons", kRefineEnd);
            const TriMesh surface = horizon_surface(model, k, arguments_.normals);
            const Unit& unit = model.units[k == 0 ? 0 : k - 1];
            write_mesh(folder.add(where + numbered_name(k, k == 0 ? "ground" : unit.name) + ".ply"),
                       {unit.name, unit.color, &surface});
        }
    }

    //! One layer at a time, so that only formats that hold the whole model keep all solids in memory.
    std::vector<LayerSolid> write_layers(StagedFolder& folder, const LayerModel& model, const Survey& survey,
                                         ModelRecord& record) {
        std::vector<LayerSolid> kept;
        for (std::size_t i = 0; i < model.units.size(); ++i) {
            say("building solids", kRefineEnd + (kSolidsEnd - kRefineEnd) * static_cast<double>(i) /
                                                    static_cast<double>(model.units.size()));
            std::vector<LayerSolid> solids = build_block_solids(model, i, arguments_.normals);
            record.units.push_back(summarize_unit(model, i, solids, survey));
            record.solids.emplace_back();
            for (LayerSolid& solid : solids) {
                if (solid.surface.n_faces() == 0) continue;
                const std::string name = solid_name(solid);
                record.solids.back().push_back(name + ".ply");
                for (const char* format : {"ply", "stl", "off"})
                    if (arguments_.wants(format) || std::string_view(format) == "ply")
                        write_mesh(folder.add(name + "." + format),
                                   {solid.unit.name, solid.unit.color, &solid.surface});
                if (keeps_solids()) kept.push_back(std::move(solid));
            }
        }
        return kept;
    }

    //! Where a solid is written, without the ending.
    static std::string solid_name(const LayerSolid& solid) {
        const std::string name = "layers/" + numbered_name(solid.order, solid.unit.name);
        return solid.block == 0 ? name : fmt::format("{}_block_{}", name, solid.block);
    }

    bool makes_cad() const { return arguments_.wants("step") || arguments_.wants("brep"); }

    bool makes_smooth_cad() const { return makes_cad() && arguments_.step == StepKind::Smooth; }

    bool keeps_solids() const {
        return arguments_.wants("obj") || arguments_.wants("glb") || arguments_.wants("3mf") ||
               arguments_.wants("png") || arguments_.wants("mlp") || makes_cad();
    }

    //! STEP and BREP; which bodies had to have facets goes to the warnings.
    void write_cad(StagedFolder& folder, const LayerModel& model, const std::vector<LayerSolid>& solids,
                   ModelRecord& record) {
        if (!makes_cad()) return;
        say("making CAD solids", kSolidsEnd);
        std::vector<CadBody> bodies;
        if (makes_smooth_cad()) {
            SmoothBodiesOptions options;
            options.progress = [this](const char* step, double share) {
                progress_.step(step, std::lerp(kBeforeSmooth, kSmoothEnd, share));
            };
            SmoothBodies smooth = smooth_bodies(model, options);
            is_smooth_made_ = true;
            bodies = std::move(smooth.bodies);
            record.cad = std::move(smooth.reports);
            record.warnings.insert(record.warnings.end(), smooth.notes.begin(), smooth.notes.end());
        } else {
            for (const LayerSolid& solid : solids)
                for (CadBody& body : faceted_bodies(solid)) bodies.push_back(std::move(body));
        }
        say("writing CAD solids", kSolidsEnd);
        if (arguments_.wants("step"))
            write_step_document(folder.add("model.step"), bodies,
                                {.length_unit = model.length_unit,
                                 .origin = model.origin,
                                 .has_parameter_curves = makes_smooth_cad()});
        if (arguments_.wants("brep")) write_brep(folder.add("model.brep"), bodies);
    }

    void write_whole_model(StagedFolder& folder, const LayerModel& model,
                           const std::vector<LayerSolid>& solids, ModelRecord& record) {
        std::vector<MeshPart> parts;
        for (const auto& solid : solids) parts.push_back({solid.unit.name, solid.unit.color, &solid.surface});
        for (const std::string format : {"obj", "glb", "3mf"}) {
            if (!arguments_.wants(format)) continue;
            say("writing " + format, kSolidsEnd);
            write_meshes(folder.add("model." + format), parts);
            if (format == "obj") folder.add("model.mtl");
        }
        if (arguments_.wants("mlp")) write_meshlab_project(folder.add("model.mlp"), layer_files(solids));
        write_cad(folder, model, solids, record);
        if (arguments_.wants("png")) {
            say("drawing", kSolidsEnd);
            PictureOptions options;
            options.length_unit = model.length_unit;
            options.holes = picture_holes(model);
            write_picture(folder.add("model.png"), solids, options);
        }
    }

    static std::vector<std::pair<std::string, std::string>> layer_files(
        const std::vector<LayerSolid>& solids) {
        std::vector<std::pair<std::string, std::string>> files;
        for (const auto& solid : solids) files.emplace_back(solid.unit.name, solid_name(solid) + ".ply");
        return files;
    }

    static std::vector<PictureHole> picture_holes(const LayerModel& model) {
        std::vector<PictureHole> holes;
        for (std::size_t h = 0; h < model.columns.sites.size(); ++h) {
            const auto v = model.plan.hole_vertex[h];
            if (v == PlanMesh::kNoVertex) continue;
            const Point2& at = model.columns.sites[h];
            holes.push_back({{at.x, at.y, model.horizons.front()[v]}, model.horizons.back()[v]});
        }
        return holes;
    }

    std::string write_record(StagedFolder& folder, const LayerModel& model, const Survey& survey,
                             ModelRecord& record) {
        const auto path = folder.add("model.json");
        std::filesystem::path page;
        if (arguments_.wants("html")) page = folder.add("model.html");
        record.files = folder.files();
        std::string json = model_json(model, survey, record);
        write_aside(path, [&](std::ostream& stream) { stream << json; });
        if (!page.empty()) {
            say("writing the 3D page", kSolidsEnd);
            write_viewer(path.parent_path(), page, {.title = title(), .report = "report.html"});
        }
        return json;
    }

    //! The folder's name.
    std::string title() const {
        const auto name = std::filesystem::absolute(arguments_.output).lexically_normal();
        return (name.has_filename() ? name : name.parent_path()).filename().string();
    }

    void write_report() {
        ReportChoices choices;
        choices.title = title();
        write_report_page(arguments_.output, std::filesystem::path(arguments_.output) / "report.html",
                          choices, progress_);
    }

    // \param share of what is done without smooth CAD solids
    void say(std::string_view what, double share) {
        if (is_smooth_made_)
            share = kSmoothEnd;
        else if (makes_smooth_cad())
            share *= kBeforeSmooth / kSolidsEnd;
        progress_.step(what, share);
    }

    static void fail_if_unsound(const ModelRecord& record) {
        std::string failed;
        for (const ModelCheck& check : record.checks)
            if (!check.ok) failed += "\n  " + check.name + ": " + check.detail;
        if (!failed.empty())
            throw GeometryError("the model failed its own checks, nothing was written:" + failed);
    }

    void print_result(const LayerModel& model, const Survey& survey, const ModelRecord& record,
                      const std::string& json) const {
        if (!arguments_.quiet)
            for (const std::string& warning : record.warnings) fmt::print(stderr, "warning: {}\n", warning);
        if (arguments_.json) {
            std::fputs(json.c_str(), stdout);
            return;
        }
        const std::string& u = model.length_unit;
        fmt::print("{} boreholes, {} layers, {} plan triangles; lengths in {}, volumes in {}³\n",
                   survey.holes.size(), model.units.size(), model.plan.surface.n_faces(), u, u);
        fmt::print("{:>3}  {:<24} {:>14} {:>10} {:>10} {:>6} {:>6}  holes with/without/unknown\n", "",
                   "layer", "volume", "mean", "max", "bodies", "genus");
        for (std::size_t i = 0; i < record.units.size(); ++i) {
            const UnitSummary& unit = record.units[i];
            fmt::print("{:>3}  {:<24} {:>14.7g} {:>10.4g} {:>10.4g} {:>6} {:>6}  {}/{}/{}\n", i + 1,
                       model.units[i].name, unit.volume, unit.mean_thickness, unit.max_thickness,
                       unit.components, unit.genus, unit.holes_present, unit.holes_absent,
                       unit.holes_unknown);
        }
        fmt::print("{:>3}  {:<24} {:>14.7g}\n", "", "all", envelope_volume(model));
        for (const ModelCheck& check : record.checks) fmt::print("ok   {}: {}\n", check.name, check.detail);
        fmt::print("{} files in {}\n", record.files.size(), arguments_.output);
    }

    const BuildArguments& arguments_;
    Progress progress_;
    bool is_smooth_made_ = false;
    std::optional<LayerModel> unrefined_;  // what refinement began with, without faults
    std::optional<Raster> terrain_;
    InterpolatorKind interpolator_ = kDefaultInterpolator;
    std::optional<InterpolatorChoice> choice_;  // by `auto`
    std::vector<std::string> notes_;            // for people, beside those of the table and the model
};

}  // namespace

void add_build_command(CLI::App& program) {
    auto arguments = std::make_shared<BuildArguments>();
    CLI::App* command = program.add_subcommand("build", "Boreholes to watertight, conforming layer solids");
    add_build_options(*command, *arguments);
    command->callback([arguments] { Build(*arguments).run(); });
}

}  // namespace stratareeb
