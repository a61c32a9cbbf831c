// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/keep_existing.h"
#include "apps/mesh_report.h"
#include "boreholes/errors.h"
#include "io/axis_ticks.h"
#include "io/drawing_page.h"
#include "io/map_drawing.h"
#include "io/model_prediction.h"
#include "io/read_record.h"
#include "io/write_grid.h"
#include "mesh/model_grid.h"
#include "mesh/plan_areas.h"
#include "mesh/ring_stitching.h"

namespace stratareeb {
namespace {

using nlohmann::json;

struct MapArguments {
    std::string folder, show = "geology", unit, uncertainty, title, crs;
    std::uint64_t seed = 1;
    std::vector<std::string> outputs;
    double interval = 0, cell = 0;
    bool json = false, overwrite = false;
};

MapSubject subject_of(const std::string& show) {
    return show == "top"         ? MapSubject::Top
           : show == "base"      ? MapSubject::Base
           : show == "thickness" ? MapSubject::Thickness
                                 : MapSubject::Ground;
}

//! One map, from what was asked to files.
class MapRun {
 public:
    MapRun(const MapArguments& arguments, const SavedModel& saved)
        : arguments_(arguments),
          saved_(saved),
          model_(saved.model),
          is_geology_(arguments.show == "geology") {
        if (!arguments.unit.empty()) layer_ = unit_by_name(model_, arguments.unit);
        if (is_geology_)
            areas_ = geology_areas(model_);
        else if (arguments.uncertainty.empty())
            contours_ = contour_map(model_, subject_of(arguments.show), layer_, arguments.interval);
        else
            contours_ = uncertain();
    }

    void write(const std::string& file) const {
        if (is_drawing_file(file))
            write_plan_map(file, is_geology_ ? geology_drawing(saved_, areas_, arguments_.title)
                                             : drawn_map(saved_, contours_, arguments_.title));
        else if (is_feature_file(file))
            write_features(
                file, is_geology_ ? area_features(areas_, model_.units) : line_features(model_, contours_),
                {.table = arguments_.show, .crs = saved_.crs_or(arguments_.crs), .flat = false});
        else
            write_grid(file, gridded(), saved_.crs_or(arguments_.crs));
    }

    void print() const {
        if (arguments_.json)
            std::fputs(json_text(as_json()).c_str(), stdout);
        else if (is_geology_)
            print_areas();
        else
            fmt::print("{}: {} lines, every {:g} {}\n", contours_.about, contours_.lines.size(),
                       contours_.interval, model_.length_unit);
    }

 private:
    ContourMap uncertain() const {
        const auto options = read_record(arguments_.folder).record.options;
        return spread_map(saved_, subject_of(arguments_.show), layer_,
                          arguments_.uncertainty == "deviation" ? Spread::Deviation : Spread::Interval,
                          {.prediction = model_prediction(saved_.survey, options), .seed = arguments_.seed},
                          arguments_.interval);
    }

    Grid gridded() const {
        if (is_geology_) return unit_grid();
        const PlanGrid plan = plan_grid();
        auto values = rasterized(model_, plan, {&contours_.field});
        if (contours_.subject == MapSubject::Top || contours_.subject == MapSubject::Base)
            hide_absent(plan, values[0]);
        return {.north_west = plan.north_west,
                .cell = plan.cell,
                .columns = plan.columns,
                .rows = plan.rows,
                .bands = {{contours_.about, std::move(values[0])}}};
    }

    //! Top and base mean nothing where the layer is not.
    void hide_absent(const PlanGrid& plan, std::vector<double>& values) const {
        const std::vector<double> thickness = mapped_field(model_, MapSubject::Thickness, layer_);
        const auto there = rasterized(model_, plan, {&thickness});
        for (std::size_t i = 0; i < values.size(); ++i)
            if (!(there[0][i] > 0)) values[i] = std::numeric_limits<double>::quiet_NaN();
    }

    //! The number of the topmost unit, from 1.
    Grid unit_grid() const {
        const PlanGrid plan = plan_grid();
        std::vector<std::vector<double>> thickness;
        std::vector<const std::vector<double>*> fields;
        for (std::size_t i = 0; i < model_.units.size(); ++i)
            thickness.push_back(mapped_field(model_, MapSubject::Thickness, i));
        for (const auto& field : thickness) fields.push_back(&field);
        const auto values = rasterized(model_, plan, fields);
        std::vector<double> top(plan.columns * plan.rows, std::numeric_limits<double>::quiet_NaN());
        for (std::size_t i = model_.units.size(); i-- > 0;)
            for (std::size_t cell = 0; cell < top.size(); ++cell)
                if (values[i][cell] > 0) top[cell] = static_cast<double>(i + 1);
        return {.north_west = plan.north_west,
                .cell = plan.cell,
                .columns = plan.columns,
                .rows = plan.rows,
                .bands = {{"topmost unit, 1 = " + model_.units[0].name, std::move(top)}}};
    }

    PlanGrid plan_grid() const {
        if (arguments_.cell > 0) return grid_over(model_, arguments_.cell);
        constexpr double kCells = 500;  // on the longer side
        const auto outline = plan_outline(model_);
        double x0 = HUGE_VAL, x1 = -HUGE_VAL, y0 = HUGE_VAL, y1 = -HUGE_VAL;
        for (const auto& ring : outline)
            for (const Point2& p : ring) {
                x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
                y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
            }
        return grid_over(model_, round_step(std::max(x1 - x0, y1 - y0) / kCells));
    }

    std::vector<double> sizes() const {
        std::vector<double> sizes(model_.units.size(), 0);
        for (const MapArea& area : areas_)
            for (const auto& ring : area.rings) sizes[area.entry] += ring_area(ring);
        return sizes;
    }

    void print_areas() const {
        const std::string unit = fmt::format("area [{}²]", model_.length_unit);
        fmt::print("{:>3}  {:<24} {:>14}\n", "", "unit at the ground", unit);
        const auto sizes = this->sizes();
        for (std::size_t i = 0; i < sizes.size(); ++i)
            if (sizes[i] > 0) fmt::print("{:>3}  {:<24} {:>14.7g}\n", i + 1, model_.units[i].name, sizes[i]);
    }

    json as_json() const {
        json result{{"show", arguments_.show}, {"length_unit", model_.length_unit}};
        if (is_geology_) {
            result["units"] = json::array();
            const auto sizes = this->sizes();
            for (std::size_t i = 0; i < sizes.size(); ++i)
                result["units"].push_back(
                    {{"order", i + 1}, {"code", model_.units[i].code}, {"area", sizes[i]}});
            return result;
        }
        if (!arguments_.uncertainty.empty()) result["uncertainty"] = arguments_.uncertainty;
        if (contours_.subject != MapSubject::Ground) result["unit"] = model_.units[layer_].code;
        result["interval"] = contours_.interval;
        result["lines"] = json::array();
        for (const ContourLine& line : contours_.lines) {
            json points = json::array();
            for (const Point2& p : line.points) points.push_back({p.x, p.y});
            result["lines"].push_back({{"value", line.value}, {"closed", line.closed}, {"points", points}});
        }
        return result;
    }

    const MapArguments& arguments_;
    const SavedModel& saved_;
    const LayerModel& model_;
    bool is_geology_;
    std::size_t layer_ = 0;
    ContourMap contours_;
    std::vector<MapArea> areas_;  // of the geological map
};

void check_usage(const MapArguments& arguments) {
    const bool needs_unit = arguments.show != "geology" && arguments.show != "ground";
    if (needs_unit && arguments.unit.empty())
        throw CLI::ValidationError("--unit", fmt::format("is needed to show a unit's {}", arguments.show));
    if (!needs_unit && !arguments.unit.empty())
        throw CLI::ValidationError("--unit", "goes with --show top, base or thickness");
    if (!arguments.uncertainty.empty() && arguments.show == "geology")
        throw CLI::ValidationError("--uncertainty", "goes with --show ground, top, base or thickness");
    for (const std::string& output : arguments.outputs)
        if (!is_drawing_file(output) && !is_feature_file(output) && !is_grid_file(output))
            throw CLI::ValidationError(
                "-o", output + ": maps are written as .svg, .pdf, .png, .gpkg, .dxf, .geojson, .tif or .asc");
}

void run(const MapArguments& arguments) {
    check_usage(arguments);
    for (const std::string& output : arguments.outputs) keep_existing(output, arguments.overwrite);
    const SavedModel saved = read_model(arguments.folder);
    const MapRun map(arguments, saved);
    for (const std::string& output : arguments.outputs) map.write(output);
    map.print();
}

}  // namespace

void add_map_command(CLI::App& program) {
    const auto arguments = std::make_shared<MapArguments>();
    CLI::App* command = program.add_subcommand(
        "map", "Map a built model: geology, contours of horizons and thickness, grids");
    command->add_option("DIR", arguments->folder, "Folder that build wrote")->required();
    command->add_option("--show", arguments->show, "What the map is about")
        ->check(CLI::IsMember({"geology", "ground", "top", "base", "thickness"}))
        ->capture_default_str();
    command->add_option("--unit", arguments->unit,
                        "Code, name or number of the unit, for top, base and thickness");
    command
        ->add_option(
            "--uncertainty", arguments->uncertainty,
            "How far off that may be, from boreholes left out: its standard deviation, or half its 95 "
            "% interval")
        ->check(CLI::IsMember({"deviation", "interval"}));
    command->add_option("--seed", arguments->seed, "Of the draws of left-out boreholes")
        ->capture_default_str();
    command->add_option("-o,--output", arguments->outputs,
                        "Drawing (.svg, .pdf, .png), lines or areas (.gpkg, .dxf, .geojson), grid (.tif, "
                        ".asc); may be repeated");
    command
        ->add_option("--interval", arguments->interval,
                     "Between contour lines (a round one that gives a dozen)")
        ->check(CLI::PositiveNumber);
    command
        ->add_option("--cell", arguments->cell, "Side of a grid's cells (a round one that gives about 500)")
        ->check(CLI::PositiveNumber);
    command->add_option(
        "--crs", arguments->crs,
        "Coordinate reference system of the model for GIS files, as EPSG:27700 (the model's own)");
    command->add_option("--title", arguments->title, "Over the drawing");
    command->add_flag("--json", arguments->json, "Print areas or lines as JSON");
    command->add_flag("--overwrite", arguments->overwrite, "Replace files that are there");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace stratareeb
