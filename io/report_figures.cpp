// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/report_figures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "boreholes/choose_interpolator.h"
#include "boreholes/errors.h"
#include "io/map_drawing.h"
#include "io/write_graph_drawing.h"
#include "io/write_model.h"
#include "io/write_picture.h"
#include "io/write_residual_drawing.h"
#include "io/write_section.h"
#include "mesh/plan_areas.h"
#include "reeb/arc_index.h"
#include "reeb/readable_graph.h"

namespace stratareeb {
namespace {

constexpr std::size_t kMostBases = 12;      // layers whose bases are mapped too
constexpr std::size_t kReadableNodes = 60;  // of a graph
constexpr std::size_t kFolds = 10;
constexpr double kNearSection = 0.02;           // of a section's length: holes that are drawn
constexpr std::uintmax_t kMostBytes = 300'000;  // of a drawing of lines: a heavier one is shown as pixels

class Figures {
 public:
    Figures(const SavedModel& saved, const ReportOptions& options,
            const std::function<std::filesystem::path(const std::string&)>& add)
        : saved_(saved), model_(saved.model), options_(options), add_(add) {}

    ReportFigures all() {
        draw_solids();
        draw_sections();
        draw_maps();
        draw_graphs();
        if (validates()) draw_errors();
        return std::move(figures_);
    }

 private:
    void step(const std::string& what, double share) const {
        if (options_.progress) options_.progress(what, share);
    }

    std::string unit_file(const char* folder, std::size_t unit, const std::string& ending) const {
        return fmt::format("{}/{}{}", folder, numbered_name(unit + 1, model_.units[unit].name), ending);
    }

    //! Write a figure's further formats, each by its function.
    void deliver(
        ReportFigure& figure, const std::string& name,
        std::initializer_list<std::pair<const char*, std::function<void(const std::filesystem::path&)>>>
            others) const {
        if (!options_.for_delivery) return;
        for (const auto& [ending, write] : others) {
            figure.others.push_back(name + ending);
            write(add_(figure.others.back()));
        }
    }

    //! A drawing as SVG, or as PNG where lines and holes are so many that a page of them would load slowly.
    ReportFigure drawn(const std::string& name, const std::string& caption,
                       const std::function<void(const std::filesystem::path&)>& write) const {
        ReportFigure figure{name + ".svg", caption};
        const std::filesystem::path lines = add_(figure.file);
        write(lines);
        if (std::filesystem::file_size(lines) <= kMostBytes) return figure;
        if (options_.for_delivery) figure.others.push_back(figure.file);
        figure.file = name + ".png";
        write(add_(figure.file));
        return figure;
    }

    PictureOptions picture_options(int width, int height) const {
        PictureOptions options;
        options.width = width;
        options.height = height;
        options.length_unit = model_.length_unit;
        return options;
    }

    void draw_solids() {
        figures_.layers.resize(model_.units.size());
        for (std::size_t i = 0; i < model_.units.size(); ++i) {
            step("drawing layers", 0.2 * static_cast<double>(i) / static_cast<double>(model_.units.size()));
            solids_.push_back(build_layer_solid(model_, i));
            if (solids_.back().surface.n_faces() == 0) continue;
            const std::string file = unit_file("pictures", i, ".png");
            write_picture(add_(file), {&solids_.back(), 1}, picture_options(720, 450));
            figures_.layers[i] = {file, model_.units[i].name};
        }
        PictureOptions options = picture_options(1400, 875);
        for (std::size_t h = 0; h < model_.columns.sites.size(); ++h) {
            const auto v = model_.plan.hole_vertex[h];
            if (v == PlanMesh::kNoVertex) continue;
            const Point2& at = model_.columns.sites[h];
            options.holes.push_back({{at.x, at.y, model_.horizons.front()[v]}, model_.horizons.back()[v]});
        }
        figures_.model = {"pictures/model.png", "All layers, pulled apart, with the boreholes"};
        write_picture(add_(figures_.model.file), solids_, options);
    }

    void draw_sections() {
        step("drawing sections", 0.2);
        const auto outline = plan_outline(model_);
        Point2 low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
        for (const auto& ring : outline)
            for (const Point2& p : ring) {
                low = {std::min(low.x, p.x), std::min(low.y, p.y)};
                high = {std::max(high.x, p.x), std::max(high.y, p.y)};
            }
        const Point2 middle = middle_of_holes({(low.x + high.x) / 2, (low.y + high.y) / 2});
        draw_section("west_east", "West to east through the middle of the boreholes",
                     {{low.x, middle.y}, {high.x, middle.y}}, kNearSection);
        draw_section("south_north", "South to north through the middle of the boreholes",
                     {{middle.x, low.y}, {middle.x, high.y}}, kNearSection);
        for (std::size_t i = 0; i < options_.fences.size(); ++i)
            draw_section(fmt::format("fence_{}", i + 1),
                         fmt::format("Fence through {}", fmt::join(options_.fences[i], ", ")),
                         line_through(saved_.survey, options_.fences[i]), 1e-6);
    }

    Point2 middle_of_holes(const Point2& otherwise) const {
        if (saved_.survey.holes.empty()) return otherwise;
        std::vector<double> x, y;
        for (const Borehole& hole : saved_.survey.holes) x.push_back(hole.at.x), y.push_back(hole.at.y);
        std::ranges::sort(x);
        std::ranges::sort(y);
        return {x[x.size() / 2], y[y.size() / 2]};
    }

    void draw_section(const std::string& name, const std::string& caption, const std::vector<Point2>& line,
                      double within) {
        const VerticalSection section = vertical_section(model_, locator_, line);
        const std::string file = "sections/" + name;
        const SectionDrawingOptions drawing{
            .title = caption,
            .length_unit = model_.length_unit,
            .holes = holes_along(section, saved_.survey, within * section.length())};
        const auto draw = [&](const auto& to) { write_section_drawing(to, section, model_.units, drawing); };
        ReportFigure figure = drawn(file, caption, draw);
        deliver(figure, file,
                {{".pdf", draw}, {".dxf", [&](const auto& to) {
                                      write_features(
                                          to, section_features(section_polygons(section), model_.units),
                                          {.table = "section"});
                                  }}});
        figures_.sections.push_back(std::move(figure));
    }

    void draw_maps() {
        step("drawing maps", 0.3);
        const auto areas = geology_areas(model_);
        add_map("geology", geology_drawing(saved_, areas), "The units at the ground",
                area_features(areas, model_.units));
        add_contours("ground", MapSubject::Ground, 0, "The ground");
        for (std::size_t i = 0; i < model_.units.size(); ++i) {
            if (solids_[i].surface.n_faces() == 0) continue;
            const std::string& name = model_.units[i].name;
            add_contours(numbered_name(i + 1, name) + "_thickness", MapSubject::Thickness, i,
                         "Thickness of " + name);
            if (model_.units.size() <= kMostBases)
                add_contours(numbered_name(i + 1, name) + "_base", MapSubject::Base, i, "Base of " + name);
        }
    }

    void add_contours(const std::string& name, MapSubject subject, std::size_t layer,
                      const std::string& caption) {
        const ContourMap map = contour_map(model_, subject, layer);
        add_map(name, drawn_map(saved_, map), caption, line_features(model_, map));
    }

    void add_map(const std::string& name, const PlanMap& map, const std::string& caption,
                 const std::vector<MapFeature>& features) {
        const std::string file = "maps/" + name;
        const auto draw = [&](const auto& to) { write_plan_map(to, map); };
        ReportFigure figure = drawn(file, caption, draw);
        const auto write_gis = [&](const auto& to) {
            write_features(to, features, {.table = name, .crs = options_.crs, .flat = false});
        };
        deliver(figure, file, {{".pdf", draw}, {".gpkg", write_gis}, {".dxf", write_gis}});
        figures_.maps.push_back(std::move(figure));
    }

    void draw_graphs() {
        for (std::size_t i = 0; i < solids_.size(); ++i) {
            step("Reeb graphs", 0.4 + 0.1 * static_cast<double>(i) / static_cast<double>(solids_.size()));
            const TriMesh& solid = solids_[i].surface;
            if (solid.n_faces() == 0) continue;
            const ScalarField height = height_field(solid);
            const ReadableGraph readable = readable_graph(solid, height, kReadableNodes);
            const ArcIndex index(solid, height, readable.fine);
            const ArcMembers members = arc_members(readable.fine, readable.graph);
            const std::string left_out =
                readable.share == 0
                    ? ""
                    : fmt::format(", features below {:g} % of its height left out", 100 * readable.share);
            const std::string caption =
                fmt::format("Reeb graph of the height of {}: {} nodes, {} loops{}", model_.units[i].name,
                            readable.graph.nodes.size(), readable.graph.loops(), left_out);
            const std::string file =
                unit_file("graphs", i, ".png");  // contours have too many points for lines
            write_graph_drawing(add_(file), {solid, height, readable.fine, index, readable.graph, members},
                                {.title = caption,
                                 .value_label = fmt::format("z [{}]", model_.length_unit),
                                 .most_nodes = readable.graph.nodes.size()});
            figures_.graphs.push_back({file, caption});
        }
    }

    //! Or why not.
    bool validates() {
        const std::size_t holes = saved_.survey.holes.size();
        if (!options_.validate)
            figures_.validation_note = "Not asked for.";
        else if (holes < 2 * kFolds)
            figures_.validation_note =
                fmt::format("Too few boreholes ({}) to hold some out; {} are needed.", holes, 2 * kFolds);
        else if (holes > options_.most_validated)
            figures_.validation_note = fmt::format(
                "Not made for more than {} boreholes here; the command validate takes any number.",
                options_.most_validated);
        else
            return true;
        return false;
    }

    std::string option(const std::string& name, const std::string& otherwise) const {
        const auto found = options_.build_options.find(name);
        return found == options_.build_options.end() || found->second.empty() ? otherwise : found->second;
    }

    void draw_errors() {
        step("holding boreholes out", 0.5);
        ValidationOptions options;
        CompletionOptions& prediction = options.hold_out.prediction;
        prediction.pinch_out = pinch_out_rule(option("pinch_out", "half"));
        const std::string name = option("interpolator", std::string(name_of(prediction.interpolator)));
        prediction.interpolator =
            name == "auto" ? choose_interpolator(saved_.survey, {.pinch_out = prediction.pinch_out}).kind
                           : interpolator_kind(name);
        options.hold_out.bare = option("spacing", "auto") == "none";
        options.hold_out.progress = [this](double share) {
            step("holding boreholes out", 0.5 + 0.5 * share);
        };
        try {
            const auto draws = without_last_contacts(
                saved_.survey, fold_draws(saved_.survey.holes.size(), kFolds, options_.seed));
            figures_.validation = NamedValidation{std::string(name_of(prediction.interpolator)),
                                                  validate(saved_.survey, draws, options)};
        } catch (const InvalidInput& error) {
            figures_.validation_note = fmt::format("Not possible: {}", error.what());
            return;
        }
        figures_.validation_note = fmt::format(
            "Each borehole was left out once, a tenth of all at a time (seed {}), and predicted from the "
            "rest by the "
            "interpolator {}, as the model does it.{}",
            options_.seed, figures_.validation->name,
            option("ground", "").empty() ? "" : " The ground was predicted from the boreholes alone.");
        figures_.errors = {
            drawn("validation/residual_map", "Errors at the boreholes held out",
                  [&](const auto& to) { write_residual_map(to, saved_.survey, *figures_.validation); }),
            drawn("validation/scatter", "Predicted against actual, with 95 % intervals",
                  [&](const auto& to) { write_residual_scatter(to, saved_.survey, *figures_.validation); })};
    }

    const SavedModel& saved_;
    const LayerModel& model_;
    const ReportOptions& options_;
    const std::function<std::filesystem::path(const std::string&)>& add_;
    PlanLocator locator_{saved_.model.plan.surface};
    std::vector<LayerSolid> solids_;
    ReportFigures figures_;
};

}  // namespace

ReportFigures write_report_figures(const SavedModel& saved, const ReportOptions& options,
                                   const std::function<std::filesystem::path(const std::string&)>& add) {
    return Figures(saved, options, add).all();
}

}  // namespace stratareeb
