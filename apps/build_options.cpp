// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/build_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "apps/choice.h"
#include "boreholes/errors.h"
#include "boreholes/interpolator.h"

namespace stratareeb {

namespace {

const std::set<std::string> kFormats{"ply", "stl",  "obj",  "off", "glb", "3mf",
                                     "mlp", "step", "brep", "png", "html"};
const std::set<std::string> kColumnRoles{"x", "y", "ground", "hole", "from", "to", "unit", "z", "depth"};

std::map<std::string, std::string> parsed_columns(const std::vector<std::string>& pairs) {
    std::map<std::string, std::string> columns;
    for (const std::string& pair : pairs) {
        const auto equals = pair.find('=');
        const std::string role = pair.substr(0, equals);
        if (equals == std::string::npos || !kColumnRoles.contains(role))
            throw CLI::ValidationError("--columns", fmt::format("{} is not ROLE=COLUMN with ROLE one of {}",
                                                                pair, fmt::join(kColumnRoles, ", ")));
        columns[role] = pair.substr(equals + 1);
    }
    return columns;
}

void add_unit_option(CLI::App& command, const std::string& name, std::string& unit, const std::string& help) {
    command.add_option(name, unit, help)->check(CLI::IsMember({"m", "ft", "us-ft"}));
}

}  // namespace

void add_table_options(CLI::App& command, TableArguments& arguments) {
    ReadBoreholesOptions& read = arguments.read;
    command
        .add_option(
            "TABLE", arguments.tables,
            "Borehole table: CSV, XLSX, XLS, ODS, GeoPackage or any OGR source; FILE:SHEET for one sheet")
        ->required();
    command.add_option("--collars", read.collars, "Table of hole, x, y and ground, for interval tables");
    add_choice<TableLayout>(command, "--layout", read.layout,
                            {{"auto", TableLayout::Auto},
                             {"wide", TableLayout::Wide},
                             {"intervals", TableLayout::Intervals},
                             {"points", TableLayout::Points},
                             {"samples", TableLayout::Samples}},
                            "Layout of the table (auto)");
    add_choice<TableValues>(command, "--values", read.values,
                            {{"auto", TableValues::Auto},
                             {"thickness", TableValues::Thickness},
                             {"depth", TableValues::Depth},
                             {"elevation", TableValues::Elevation}},
                            "What the numbers of layers are (auto)");
    command
        .add_option_function<std::vector<std::string>>(
            "--columns",
            [&read](const std::vector<std::string>& pairs) { read.columns = parsed_columns(pairs); },
            "Columns by role: x=Easting,y=Northing,ground=…,hole=…,from=…,to=…,unit=…,z=…,depth=…")
        ->delimiter(',');
    command.add_option("--order", read.order, "Units from top to bottom, with commas between")
        ->delimiter(',');
    add_choice<RepeatRule>(
        command, "--repeats", read.repeats, {{"absorb", RepeatRule::Absorb}, {"split", RepeatRule::Split}},
        "A unit that comes back lower down: absorbed by its neighbours, or a unit of its own (absorb)");
    add_choice<PointsMark>(command, "--points-mark", read.points_mark,
                           {{"auto", PointsMark::Auto}, {"top", PointsMark::Top}, {"base", PointsMark::Base}},
                           "Whether contact points lie on tops or bases of their units (auto)");
    add_unit_option(command, "--unit", read.length_unit,
                    "Unit of all lengths in the table, kept in the model (m)");
    add_unit_option(command, "--vertical-unit", read.vertical_unit,
                    "Unit of elevations, depths and thicknesses where it is another; converted");
    command.add_flag("--keep-far-holes", read.keep_far_holes, "Keep holes absurdly far from all others");
}

int suitable_refinement(std::size_t holes) {
    constexpr std::size_t kTwice = 400, kOnce = 4000;  // about 150,000 and 300,000 plan triangles
    return holes <= kTwice ? 2 : holes <= kOnce ? 1 : 0;
}

bool BuildArguments::wants(const std::string& format) const {
    return std::ranges::find(formats, format) != formats.end();
}

std::map<std::string, std::string> BuildArguments::record() const {
    std::map<std::string, std::string> words{
        {"tables", fmt::format("{}", fmt::join(table.tables, ", "))},
        {"collars", table.read.collars},
        {"ground", ground},
        {"footprint", footprint},
        {"spacing", spacing},
        {"interpolator", interpolator},
        {"pinch_out", pinch_out},
        {"refine", refine},
        {"step", step == StepKind::Smooth ? "smooth" : "faceted"},
        {"decimate", decimate < 0 ? "" : fmt::format("{}", decimate)},
        {"decimate_to", decimate_to == 0 ? "" : fmt::format("{}", decimate_to)},
        {"order", fmt::format("{}", fmt::join(table.read.order, ","))},
        {"repeats", table.read.repeats == RepeatRule::Absorb ? "absorb" : "split"},
        {"unit", table.read.length_unit},
        {"formats", fmt::format("{}", fmt::join(formats, ","))}};
    if (const std::string text = rules.record(); !text.empty()) words["rules"] = text;
    if (!faults.empty()) words["faults"] = faults;
    return words;
}

void add_build_options(CLI::App& command, BuildArguments& arguments) {
    add_table_options(command, arguments.table);
    command.add_option("-o,--output", arguments.output, "Folder for the model")->required();
    command.add_option("--ground", arguments.ground,
                       "Elevation raster of the ground (GeoTIFF, ESRI ASCII, …)");
    command.add_option(
        "--crs", arguments.crs,
        "Coordinate reference system of the coordinates, as EPSG:27700 (what the tables or the "
        "ground raster state)");
    command.add_option("--interpolator", arguments.interpolator, "Prediction between holes")
        ->check([](const std::string& name) {
            if (name == "auto") return std::string();
            try {
                interpolator_kind(name);
            } catch (const InvalidInput& error) {
                return std::string(error.what());
            }
            return std::string();
        })
        ->capture_default_str();
    command
        .add_option("--spacing", arguments.spacing,
                    "Edge length of the plan mesh; auto, or none for the bare triangulation of the holes")
        ->capture_default_str()
        ->check([](const std::string& text) {
            double number = 0;
            const bool sound =
                text == "auto" || text == "none" || (CLI::detail::lexical_cast(text, number) && number > 0);
            return sound ? std::string() : text + " is none of auto, none or a length above 0";
        });
    command
        .add_option(
            "--refine", arguments.refine,
            "Smooth surfaces through the contacts: levels of subdivision, 0 to 6, each with four times the "
            "triangles; 0 leaves them as predicted")
        ->check([](const std::string& text) {
            const bool sound = text == "auto" || (text.size() == 1 && text[0] >= '0' && text[0] <= '6');
            return sound ? std::string() : text + " is neither auto nor a number from 0 to 6";
        })
        ->capture_default_str();
    command
        .add_option("--decimate", arguments.decimate,
                    "Leave out triangles as long as no horizon moves up or down by more than this length")
        ->check(CLI::NonNegativeNumber);
    command
        .add_option("--decimate-to", arguments.decimate_to,
                    "Leave out triangles of the plan down to this number")
        ->check(CLI::PositiveNumber);
    add_choice<StepKind>(
        command, "--step", arguments.step, {{"smooth", StepKind::Smooth}, {"faceted", StepKind::Faceted}},
        "Faces of STEP and BREP files: few B-spline faces where they are sound, or the triangles (faceted)");
    command
        .add_option("--pinch-out", arguments.pinch_out,
                    "Where a layer ends between a hole that lacks it and one that has it")
        ->check(CLI::IsMember({"at-hole", "quarter", "third", "half"}))
        ->capture_default_str();
    add_rule_options(command, arguments.rules);
    command.add_option("--faults", arguments.faults,
                       "Lines of vertical faults in plan (GeoJSON, GeoPackage, DXF, CSV with WKT, …)");
    command
        .add_option("--footprint", arguments.footprint, "Plan outline: hull, box, or a file with a polygon")
        ->capture_default_str();
    command
        .add_option("--margin", arguments.margin,
                    "Around the holes, for --footprint box (half their mean spacing)")
        ->check(CLI::NonNegativeNumber);
    add_choice<NormalWeight>(
        command, "--normals", arguments.normals,
        {{"uniform", NormalWeight::Uniform}, {"area", NormalWeight::Area}, {"angle", NormalWeight::Angle}},
        "Weight of faces in vertex normals (uniform)");
    command
        .add_option("--formats", arguments.formats,
                    fmt::format("Files beside the PLY: {}", fmt::join(kFormats, ",")))
        ->delimiter(',')
        ->check(CLI::IsMember(kFormats));
    command.add_option("--deliver", arguments.deliver,
                       "Folder to hand over, made of the model as by the command deliver");
    command.add_flag("--overwrite", arguments.overwrite, "Replace a model that is there");
    command.add_flag("--json", arguments.json, "Print model.json to standard output instead of a table");
    command.add_flag("--quiet", arguments.quiet, "No progress and no notes on standard error");
    command.add_flag("--ignore-memory", arguments.ignore_memory,
                     "Start even if memory looks too small for the run");
}

}  // namespace stratareeb
