// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_intervals.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "io/cell_value.h"

namespace stratareeb {
namespace {

std::optional<IntervalColumns> columns_by_place(const TableShape& shape) {
    if (shape.column_count() != 4 || !shape.stated.empty()) return std::nullopt;
    const CellCensus unit = cell_census(shape, 3), from = cell_census(shape, 1), to = cell_census(shape, 2);
    const CellCensus hole = cell_census(shape, 0);
    const bool fits = unit.other > unit.numbers && from.numbers > from.other && to.numbers > to.other &&
                      hole.other > hole.numbers;
    if (!fits) return std::nullopt;
    return IntervalColumns{0, 1, 2, 3, {}, {}, {}, false};
}

bool says_elevation(const std::string& name) {
    const std::string normal = normal_name(name);
    return normal.find("elev") != normal.npos || normal.starts_with("z_") || normal.ends_with("_z");
}

//! Depths grow from `from` to `to`; elevations fall.
bool mostly_falls(const TableShape& shape, const IntervalColumns& columns) {
    std::size_t falls = 0, rises = 0;
    for (std::size_t row = shape.first_row; row < shape.row_count() && falls + rises < 1000; ++row) {
        const CellValue from = cell_value(shape.table->cell(row, columns.from), shape.table->decimal_comma);
        const CellValue to = cell_value(shape.table->cell(row, columns.to), shape.table->decimal_comma);
        if (from.kind != CellKind::Number || to.kind != CellKind::Number) continue;
        (from.number > to.number ? falls : rises) += 1;
    }
    return falls > rises;
}

class IntervalReader {
 public:
    IntervalReader(const TableShape& shape, const IntervalColumns& columns, const CollarTable* collars,
                   LogSet& logs, TableContext& context)
        : shape_(shape), columns_(columns), collars_(collars), logs_(logs), context_(context) {
        file_ = file_number(shape.table->source);
        for (std::size_t unit = 0; unit < logs.units.size(); ++unit) units_.emplace(logs.units[unit], unit);
        for (std::size_t hole = 0; hole < logs.holes.size(); ++hole)
            holes_.emplace(logs.holes[hole].id, hole);
        if (collars && logs.holes.empty()) add_collars();
    }

    void read() {
        for (std::size_t row = shape_.first_row; row < shape_.row_count(); ++row) read_row(row);
        for (const auto& [id, rows] : unknown_)
            warn(rows.first,
                 fmt::format("hole {} has no usable collar; its {} intervals are left out", id, rows.second));
        for (const std::size_t hole : without_ground_) take_ground_from_top(logs_.holes[hole]);
    }

 private:
    void warn(std::size_t line, std::string text) {
        context_.audit.add_warning(shape_.table->source, line, "", std::move(text));
    }

    std::uint32_t file_number(const std::string& file) {
        const auto found = std::find(logs_.files.begin(), logs_.files.end(), file);
        if (found != logs_.files.end()) return static_cast<std::uint32_t>(found - logs_.files.begin());
        logs_.files.push_back(file);
        return static_cast<std::uint32_t>(logs_.files.size() - 1);
    }

    void add_collars() {
        const std::uint32_t file = file_number(collars_->file);
        for (const Collar& collar : collars_->collars) {
            holes_.emplace(collar.id, logs_.holes.size());
            logs_.holes.push_back({collar.id, collar.at, collar.ground, {}, collar.row, file});
        }
    }

    void read_row(std::size_t row) {
        const std::size_t line = shape_.table->line(row);
        const std::string id = cell_name(shape_.table->cell(row, columns_.hole));
        const auto from = number_cell(shape_, row, columns_.from, context_);
        const auto to = number_cell(shape_, row, columns_.to, context_);
        const std::string unit = cell_name(shape_.table->cell(row, columns_.unit));
        if (id.empty() && !from && !to && unit.empty()) return;
        if (id.empty()) return warn(line, "no hole id; the interval is left out");
        HoleLog* hole = hole_of(id, row);
        if (!hole) return;
        if (!from || !to) return warn_open(row, id, from, to);
        add_interval(*hole,
                     {*from, *to, unit.empty() ? LogInterval::kNoUnit : unit_number(unit), line, file_});
    }

    void warn_open(std::size_t row, const std::string& id, const std::optional<double>& from,
                   const std::optional<double>& to) {
        const auto is_empty = [&](std::size_t column) {
            return cell_value(shape_.table->cell(row, column), false).kind == CellKind::Empty;
        };
        if ((from || is_empty(columns_.from)) && (to || is_empty(columns_.to)))
            warn(shape_.table->line(row),
                 fmt::format("hole {}: no {}; the interval is left out", id, from ? "to" : "from"));
    }

    std::size_t unit_number(const std::string& unit) {
        const auto [place, is_new] = units_.try_emplace(unit, logs_.units.size());
        if (is_new) logs_.units.push_back(unit);
        return place->second;
    }

    HoleLog* hole_of(const std::string& id, std::size_t row) {
        if (const auto found = holes_.find(id); found != holes_.end()) return &logs_.holes[found->second];
        if (collars_ || !columns_.x || !columns_.y) {
            note_unknown(id, shape_.table->line(row));
            return nullptr;
        }
        if (without_place_.contains(id)) return nullptr;
        const std::size_t errors = context_.audit.error_count();
        const auto x = number_cell(shape_, row, *columns_.x, context_),
                   y = number_cell(shape_, row, *columns_.y, context_);
        auto ground = number_cell(shape_, row, columns_.ground, context_);
        if (ground) *ground *= context_.vertical;
        if (!x || !y) {
            without_place_.insert(id);
            if (context_.audit.error_count() == errors)
                warn(shape_.table->line(row), fmt::format("hole {} has no x, y; it is left out", id));
            return nullptr;
        }
        holes_.emplace(id, logs_.holes.size());
        logs_.holes.push_back({id, {*x, *y}, ground, {}, shape_.table->line(row), file_});
        return &logs_.holes.back();
    }

    void note_unknown(const std::string& id, std::size_t line) {
        const auto [place, is_new] = unknown_place_.try_emplace(id, unknown_.size());
        if (is_new) unknown_.push_back({id, {line, 0}});
        ++unknown_[place->second].second.second;
    }

    void add_interval(HoleLog& hole, LogInterval interval) {
        interval.from *= context_.vertical;
        interval.to *= context_.vertical;
        if (columns_.elevations) {  // below a ground still to be found, depths count from elevation 0
            if (!hole.ground) without_ground_.insert(static_cast<std::size_t>(&hole - logs_.holes.data()));
            interval.from = hole.ground.value_or(0) - interval.from;
            interval.to = hole.ground.value_or(0) - interval.to;
        }
        hole.intervals.push_back(interval);
    }

    void take_ground_from_top(HoleLog& hole) {
        double top = hole.intervals.front().from;
        for (const LogInterval& interval : hole.intervals) top = std::min(top, interval.from);
        for (LogInterval& interval : hole.intervals) {
            interval.from -= top;
            interval.to -= top;
        }
        hole.ground = -top;
        warn(hole.intervals.front().row,
             fmt::format("hole {} has no ground elevation; the top of its log, {}, is taken", hole.id, -top));
    }

    const TableShape& shape_;
    const IntervalColumns& columns_;
    const CollarTable* collars_;
    LogSet& logs_;
    TableContext& context_;
    std::uint32_t file_ = 0;
    std::unordered_map<std::string, std::size_t> units_, holes_, unknown_place_;
    std::unordered_set<std::string> without_place_;
    std::set<std::size_t> without_ground_;
    std::vector<std::pair<std::string, std::pair<std::size_t, std::size_t>>>
        unknown_;  // id, (first line, rows)
};

}  // namespace

std::optional<IntervalColumns> find_interval_columns(const TableShape& shape, TableValues values) {
    if (!shape.has_header && shape.stated.empty()) return columns_by_place(shape);
    const auto hole = find_column(shape, Role::Hole), unit = find_column(shape, Role::Unit);
    const auto from = find_column(shape, Role::From), to = find_column(shape, Role::To);
    if (!hole || !unit || !from || !to) return std::nullopt;
    IntervalColumns columns{*hole,
                            *from,
                            *to,
                            *unit,
                            find_column(shape, Role::X),
                            find_column(shape, Role::Y),
                            find_column(shape, Role::Ground),
                            false};
    columns.elevations =
        values == TableValues::Elevation ||
        (values == TableValues::Auto && (says_elevation(shape.names[*from]) || mostly_falls(shape, columns)));
    return columns;
}

void read_intervals(const TableShape& shape, const IntervalColumns& columns, const CollarTable* collars,
                    LogSet& logs, TableContext& context) {
    if (!collars && (!columns.x || !columns.y)) {
        context.audit.add_error(
            shape.table->source, 0, "",
            "the intervals have no columns for x and y; name the table with the holes' places: "
            "--collars FILE");
        return;
    }
    IntervalReader(shape, columns, collars, logs, context).read();
}

}  // namespace stratareeb
