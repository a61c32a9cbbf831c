// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_boreholes.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <optional>

#include "boreholes/errors.h"
#include "boreholes/length_unit.h"
#include "boreholes/listed_layers.h"
#include "boreholes/plan_layout.h"
#include "boreholes/unit_colors.h"
#include "io/ags_file.h"
#include "io/collars.h"
#include "io/read_ags.h"
#include "io/read_intervals.h"
#include "io/read_points.h"
#include "io/read_table.h"
#include "io/read_wide.h"

namespace stratareeb {
namespace {

void check_stated_roles(const ReadBoreholesOptions& options) {
    const auto& roles = stated_role_names();
    for (const auto& [role, column] : options.columns)
        if (std::find(roles.begin(), roles.end(), role) == roles.end())
            throw InvalidInput(fmt::format("--columns {}={}: no such role; roles are {}", role, column,
                                           fmt::join(roles, ", ")));
}

//! A table with what it was recognised as.
struct ReadableTable {
    TableShape shape;
    TableLayout layout = TableLayout::Auto;  // Auto = none
    std::optional<WideColumns> wide;
    std::optional<IntervalColumns> intervals;
    std::optional<PointColumns> points;
    bool collars = false;
};

ReadableTable recognised(const TextTable& table, const ReadBoreholesOptions& options) {
    ReadableTable result;
    result.shape = table_shape(table, options.columns);
    if (result.shape.first_row >= table.row_count()) return result;
    const auto wanted = [&](TableLayout layout) {
        return options.layout == TableLayout::Auto || options.layout == layout;
    };
    if (wanted(TableLayout::Intervals))
        result.intervals = find_interval_columns(result.shape, options.values);
    const bool point_like = wanted(TableLayout::Points) || wanted(TableLayout::Samples);
    if (point_like && !result.intervals) result.points = find_point_columns(result.shape, options.values);
    result.collars = is_collar_table(result.shape);
    if (wanted(TableLayout::Wide) && !result.intervals && !result.points)
        result.wide = find_wide_columns(result.shape, options);
    if (result.intervals) result.layout = TableLayout::Intervals;
    if (result.wide) result.layout = TableLayout::Wide;
    if (result.points) {
        const bool samples =
            options.layout == TableLayout::Auto && looks_like_samples(result.shape, *result.points);
        result.layout =
            samples || options.layout == TableLayout::Samples ? TableLayout::Samples : TableLayout::Points;
    }
    return result;
}

std::string columns_of(const TableShape& shape) {
    std::vector<std::string> shown(
        shape.names.begin(),
        shape.names.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(shape.names.size(), 20)));
    return fmt::format("{}{}{}", shape.has_header ? "columns " : "no header, columns ",
                       fmt::join(shown, ", "), shape.names.size() > shown.size() ? ", …" : "");
}

bool uses_all_stated(const ReadableTable& table, const ReadBoreholesOptions& options) {
    return std::all_of(options.columns.begin(), options.columns.end(), [&](const auto& stated) {
        return stated.second.empty() || column_by_name(table.shape, stated.second);
    });
}

//! Everything that was opened; the tables stay alive for the shapes that look into them.
class Library {
 public:
    explicit Library(const ReadBoreholesOptions& options, Audit& audit) : options_(options), audit_(audit) {}

    void open_sources(const std::vector<std::string>& sources) {
        for (const std::string& source : sources) choose(source, open(source));
        check_one_layout(sources);
    }

    void open_collars() {
        if (options_.collars.empty()) return;
        const auto tables = open(options_.collars);
        const auto fits =
            std::find_if(tables.begin(), tables.end(), [](const ReadableTable& t) { return t.collars; });
        collars_ = fits != tables.end() ? *fits : tables.front();
    }

    void check_stated_columns() const {
        for (const auto& [role, column] : options_.columns) {
            if (column.empty()) continue;
            bool found = collars_ && column_by_name(collars_->shape, column);
            for (const ReadableTable& table : chosen_) found = found || column_by_name(table.shape, column);
            if (!found)
                throw InvalidInput(fmt::format("--columns {}={}: no such column; {}", role, column,
                                               columns_of(chosen_.front().shape)));
        }
    }

    const std::vector<ReadableTable>& chosen() const { return chosen_; }
    const std::optional<ReadableTable>& collars() const { return collars_; }

    //! Of the places, where a layer of points has them.
    std::string crs() const {
        if (collars_ && !collars_->shape.table->crs.empty()) return collars_->shape.table->crs;
        for (const ReadableTable& table : chosen_)
            if (!table.shape.table->crs.empty()) return table.shape.table->crs;
        return "";
    }

 private:
    std::vector<ReadableTable> open(const std::string& source) {
        std::vector<ReadableTable> result;
        for (TextTable& table : read_tables(source)) {
            tables_.push_back(std::move(table));
            result.push_back(recognised(tables_.back(), options_));
        }
        return result;
    }

    void choose(const std::string& source, const std::vector<ReadableTable>& tables) {
        const ReadableTable* best = nullptr;
        for (const ReadableTable& table : tables) {
            if (table.collars && may_be_collars(table, tables)) {
                collars_ = table;
                continue;
            }
            if (table.layout == TableLayout::Auto) continue;
            const auto worth = [&](const ReadableTable& t) {
                return std::pair(uses_all_stated(t, options_), t.shape.row_count());
            };
            if (!best || worth(table) > worth(*best)) best = &table;
        }
        if (best) {
            if (tables.size() > 1)
                audit_.add_warning(source, 0, "",
                                   fmt::format("of {} sheets or layers, {} is read", tables.size(),
                                               best->shape.table->sheet));
            return chosen_.push_back(*best);
        }
        const bool only_collars =
            std::any_of(tables.begin(), tables.end(), [](const ReadableTable& t) { return t.collars; });
        if (!only_collars) refuse(source, tables);
    }

    //! A table of places and nothing else, wanted because none was named.
    bool may_be_collars(const ReadableTable& table, const std::vector<ReadableTable>& siblings) const {
        if (!options_.collars.empty() || collars_) return false;
        if (table.intervals || table.points) return false;
        return !table.wide || options_.layout == TableLayout::Intervals ||
               std::any_of(siblings.begin(), siblings.end(),
                           [](const ReadableTable& t) { return t.intervals.has_value(); }) ||
               std::any_of(chosen_.begin(), chosen_.end(),
                           [](const ReadableTable& t) { return t.intervals.has_value(); });
    }

    [[noreturn]] void refuse(const std::string& source, const std::vector<ReadableTable>& tables) const {
        const bool empty = std::all_of(tables.begin(), tables.end(), [](const ReadableTable& t) {
            return t.shape.first_row >= t.shape.row_count();
        });
        if (empty) throw InvalidInput(source + ": has no rows of data");
        throw InvalidInput(
            fmt::format("{}: no borehole table is recognised ({}). Wide: x, y, ground, then code and "
                        "thickness pairs or a column per layer. "
                        "Intervals: hole, from, to, unit. Points: x, y, z, unit. Name columns with --columns "
                        "x=NAME,unit=NAME,…, the "
                        "layout with --layout",
                        source, columns_of(tables.front().shape)));
    }

    void check_one_layout(const std::vector<std::string>& sources) {
        if (chosen_.empty())
            throw InvalidInput(
                fmt::format("{}: places of holes, but no layers; name the table of intervals as well",
                            fmt::join(sources, ", ")));
        if (std::any_of(chosen_.begin(), chosen_.end(),
                        [](const ReadableTable& t) { return t.intervals.has_value(); })) {
            const auto place = std::find_if(chosen_.begin(), chosen_.end(), [](const ReadableTable& t) {
                return t.collars && t.wide && !t.intervals;
            });
            if (place != chosen_.end() && !collars_ && options_.collars.empty()) {
                collars_ = *place;
                chosen_.erase(place);
            }
        }
        for (const ReadableTable& table : chosen_)
            if (table.layout != chosen_.front().layout)
                throw InvalidInput(
                    fmt::format("{} and {} have different layouts; read them one by one, or state --layout",
                                chosen_.front().shape.table->source, table.shape.table->source));
    }

    const ReadBoreholesOptions& options_;
    Audit& audit_;
    std::deque<TextTable> tables_;
    std::vector<ReadableTable> chosen_;
    std::optional<ReadableTable> collars_;
};

ListedValue listed_value(TableValues values) {
    if (values == TableValues::Depth) return ListedValue::BaseDepth;
    return values == TableValues::Elevation ? ListedValue::BaseElevation : ListedValue::Thickness;
}

Survey wide_survey(const Library& library, const CollarTable* collars, TableContext& context,
                   TableValues& values) {
    ListedSet listed;
    values = library.chosen().front().wide->values;
    listed.value = listed_value(values);
    listed.of_tops = context.options.points_mark == PointsMark::Top && values != TableValues::Thickness;
    for (const ReadableTable& table : library.chosen())
        read_wide(table.shape, *table.wide, collars, listed, context);
    context.audit.throw_if_errors();
    return build_survey(std::move(listed), {context.options.order, context.options.repeats}, context.audit);
}

void warn_of_empty_holes(const LogSet& logs, Audit& audit) {
    for (const HoleLog& hole : logs.holes)
        if (hole.intervals.empty())
            audit.add_warning(
                logs.files[hole.file], hole.row, "",
                fmt::format("hole {} has no intervals; {}", hole.id,
                            hole.ground ? "only its ground is used" : "nothing is known of it"));
}

Survey interval_survey(const Library& library, const CollarTable* collars, TableContext& context,
                       TableValues& values) {
    LogSet logs;
    values = library.chosen().front().intervals->elevations ? TableValues::Elevation : TableValues::Depth;
    for (const ReadableTable& table : library.chosen())
        read_intervals(table.shape, *table.intervals, collars, logs, context);
    context.audit.throw_if_errors();
    warn_of_empty_holes(logs, context.audit);
    return build_survey(std::move(logs), {context.options.order, context.options.repeats}, context.audit);
}

Survey sample_survey(const Library& library, const CollarTable* collars, TableContext& context) {
    LogSet logs;
    for (const ReadableTable& table : library.chosen())
        read_samples(table.shape, *table.points, collars, logs, context);
    context.audit.throw_if_errors();
    context.audit.add_warning(
        library.chosen().front().shape.table->source, 0, "",
        "rows are samples: each stands for the stretch half way to its neighbours in the hole");
    return build_survey(std::move(logs), {context.options.order, context.options.repeats}, context.audit);
}

Survey point_survey(const Library& library, const CollarTable* collars, TableContext& context) {
    ContactSet contacts;
    for (const ReadableTable& table : library.chosen())
        read_points(table.shape, *table.points, collars, contacts, context);
    context.audit.throw_if_errors();
    const ReadBoreholesOptions& options = context.options;
    return build_contact_survey(
        std::move(contacts), {options.order, options.points_mark, options.has_ground_raster}, context.audit);
}

bool all_are_ags(const std::vector<std::string>& sources) {
    const auto count = std::ranges::count_if(sources, is_ags_file);
    if (count > 0 && static_cast<std::size_t>(count) < sources.size())
        throw InvalidInput(
            fmt::format("{}: AGS files and other tables can't be read together; build from one kind",
                        fmt::join(sources, ", ")));
    return count > 0;
}

//! What files say of a unit, behind its code where two units would bear one name.
void name_units(std::vector<Unit>& units, const std::map<std::string, std::string>& names) {
    std::map<std::string, std::size_t> times;
    for (const Unit& unit : units)
        if (const auto name = names.find(unit.code); name != names.end()) ++times[name->second];
    for (Unit& unit : units)
        if (const auto name = names.find(unit.code); name != names.end())
            unit.name = times[name->second] == 1 ? name->second : unit.code + " " + name->second;
}

Survey ags_survey(const std::vector<std::string>& sources, const CollarTable* collars,
                  TableContext& context) {
    const ReadBoreholesOptions& options = context.options;
    if (options.layout != TableLayout::Auto && options.layout != TableLayout::Intervals)
        throw InvalidInput(sources.front() + ": an AGS file holds intervals; leave --layout out");
    if (options.length_unit != "m" || !(options.vertical_unit.empty() || options.vertical_unit == "m"))
        throw InvalidInput(sources.front() +
                           ": AGS files state their own units, and are read in metres; leave --unit "
                           "and --vertical-unit out");
    AgsLogs ags = read_ags(sources, collars, context);
    context.audit.throw_if_errors();
    warn_of_empty_holes(ags.logs, context.audit);
    Survey survey = build_survey(std::move(ags.logs), {options.order, options.repeats}, context.audit);
    name_units(survey.units, ags.unit_names);
    return survey;
}

//! Holes whose ground is not known get it from others or a raster; if no hole knows it, it is 0 everywhere.
void settle_ground(Survey& survey, const std::string& file, const ReadBoreholesOptions& options,
                   Audit& audit) {
    if (survey.contact_points) return;
    const auto unknown = [](const Borehole& hole) { return !hole.horizons[0]; };
    const auto count = std::count_if(survey.holes.begin(), survey.holes.end(), unknown);
    if (count == 0 || options.has_ground_raster) return;
    const auto known_z = [](const Borehole& hole) {
        return std::any_of(hole.horizons.begin(), hole.horizons.end(),
                           [](const auto& z) { return z.has_value(); });
    };
    if (std::none_of(survey.holes.begin(), survey.holes.end(), known_z)) {
        audit.add_warning(
            file, 0, "",
            "no ground elevation is given; the ground is taken as 0 everywhere (or give --ground FILE)");
        for (Borehole& hole : survey.holes) {
            hole.horizons[0] = 0;
            for (std::size_t i = 0; i < hole.layers.size() && hole.layers[i].knowledge == Knowledge::Measured;
                 ++i)
                hole.horizons[i + 1] = *hole.horizons[i] - hole.layers[i].thickness;
        }
        return;
    }
    for (const Borehole& hole : survey.holes)
        if (unknown(hole))
            audit.add_warning(
                file, hole.row, "",
                fmt::format("hole {} has no ground elevation; it is predicted from the others", hole.id));
}

//! What is the same for every layout, once the survey is read from `sources`; `file` is for messages.
void finish(BoreholeTable& result, const std::vector<std::string>& sources, const std::string& file,
            const ReadBoreholesOptions& options) {
    result.audit.throw_if_errors();
    result.survey.length_unit = options.length_unit;
    if (!options.keep_far_holes) drop_far_holes(result.survey, file, result.audit);
    merge_same_place(result.survey, file, result.audit);
    settle_ground(result.survey, file, options, result.audit);
    color_units(result.survey.units);
    if (result.survey.holes.empty())
        throw InvalidInput(
            fmt::format("{}: no usable hole\n{}", fmt::join(sources, ", "), result.audit.text()));
}

}  // namespace

BoreholeTable read_boreholes(const std::vector<std::string>& sources, const ReadBoreholesOptions& options) {
    if (sources.empty()) throw InvalidInput("no borehole table is named");
    check_stated_roles(options);
    BoreholeTable result;
    const double vertical = options.vertical_unit.empty()
                                ? 1.0
                                : metres_per(options.vertical_unit) / metres_per(options.length_unit);
    metres_per(options.length_unit);
    TableContext context{options, result.audit, vertical};

    Library library(options, result.audit);
    library.open_collars();
    std::optional<CollarTable> collars;
    if (all_are_ags(sources)) {
        if (library.collars()) collars = read_collars(library.collars()->shape, context);
        result.layout = TableLayout::Intervals;
        result.values = TableValues::Depth;
        result.survey = ags_survey(sources, collars ? &*collars : nullptr, context);
        finish(result, sources, sources.size() == 1 ? sources[0] : "", options);
        return result;
    }
    library.open_sources(sources);
    library.check_stated_columns();
    result.crs = library.crs();
    if (library.collars()) collars = read_collars(library.collars()->shape, context);
    const CollarTable* at = collars ? &*collars : nullptr;

    result.layout = library.chosen().front().layout;
    result.values = TableValues::Elevation;
    switch (result.layout) {
        case TableLayout::Wide:
            result.survey = wide_survey(library, at, context, result.values);
            break;
        case TableLayout::Intervals:
            result.survey = interval_survey(library, at, context, result.values);
            break;
        case TableLayout::Samples:
            result.survey = sample_survey(library, at, context);
            break;
        default:
            result.survey = point_survey(library, at, context);
    }
    const std::string file = at && result.layout == TableLayout::Intervals ? at->file
                             : sources.size() == 1                         ? sources[0]
                                                                           : "";
    finish(result, sources, file, options);
    return result;
}

}  // namespace stratareeb
