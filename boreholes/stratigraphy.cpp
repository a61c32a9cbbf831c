// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/stratigraphy.h"

#include <fmt/format.h>

#include <algorithm>

#include "boreholes/errors.h"
#include "boreholes/log_order.h"

namespace stratareeb {
namespace {

constexpr std::size_t kMostUnits = 500;
constexpr double kTouching = 1e-6;       // survey units: a log that begins this deep begins at the ground
constexpr double kLateStartShare = 0.2;  // of the holes with logs; more of them make an overburden unit
constexpr std::size_t kNone = LogInterval::kNoUnit;

void check_unit_count(const LogSet& logs) {
    if (logs.units.size() > kMostUnits)
        throw InvalidInput(
            fmt::format("{} different units ({}, {}, …): more than {}; is this the unit column? State it "
                        "with --columns unit=NAME",
                        logs.units.size(), logs.units[0], logs.units[1], kMostUnits));
}

//! Join neighbours of one unit, closing gaps that can only hold that unit; drop the rows without a unit.
std::vector<LogInterval> segments(const HoleLog& hole) {
    std::vector<LogInterval> result;
    for (const LogInterval& interval : hole.intervals) {
        if (interval.unit == kNone) continue;
        if (!result.empty() && result.back().unit == interval.unit)
            result.back().to = interval.to;
        else
            result.push_back(interval);
    }
    return result;
}

bool starts_late(const std::vector<LogInterval>& column) {
    return !column.empty() && column.front().from > kTouching;
}

//! Writes what one hole's column of units in order says into a Borehole.
class FactWriter {
 public:
    FactWriter(const HoleLog& hole, std::size_t units, Borehole& out) : hole_(hole), out_(out) {
        out_.id = hole.id;
        out_.at = hole.at;
        out_.row = hole.row;
        out_.layers.resize(units);
        out_.horizons.resize(units + 1);
        out_.horizons[0] = hole.ground;
    }

    void write(const std::vector<LogInterval>& column, bool has_overburden) {
        if (column.empty()) return;
        write_first(column.front(), has_overburden);
        for (std::size_t j = 1; j < column.size(); ++j) write_below(column[j - 1], column[j]);
        LayerFact& last = out_.layers[column.back().unit];
        last.knowledge = Knowledge::AtLeast;  // it ends with the hole
        out_.horizons[column.back().unit + 1].reset();
    }

 private:
    void write_first(const LogInterval& first, bool has_overburden) {
        measure(first.unit,
                first.unit == 0 ? first.to : first.thickness());  // nothing else fits above unit 0
        know(first.unit + 1, first.to);
        if (first.from > kTouching) {
            if (first.unit > 0) know(first.unit, first.from);
            if (has_overburden && first.unit == 1) measure(0, first.from);
            return;
        }
        for (std::size_t unit = 0; unit < first.unit; ++unit) absent(unit, first.from);
    }

    void write_below(const LogInterval& above, const LogInterval& segment) {
        measure(segment.unit, segment.thickness());
        know(segment.unit + 1, segment.to);
        if (segment.from - above.to <= kTouching) {
            for (std::size_t unit = above.unit + 1; unit < segment.unit; ++unit) absent(unit, segment.from);
            return;
        }
        if (segment.unit == above.unit + 1) {  // the gap is part of one or the other
            out_.layers[above.unit].knowledge = Knowledge::AtLeast;
            out_.layers[segment.unit].knowledge = Knowledge::AtLeast;
            out_.horizons[segment.unit].reset();
            return;
        }
        know(segment.unit, segment.from);
    }

    void measure(std::size_t unit, double thickness) { out_.layers[unit] = {Knowledge::Measured, thickness}; }

    void absent(std::size_t unit, double depth) {
        measure(unit, 0);
        know(unit + 1, depth);
    }

    void know(std::size_t horizon, double depth) {
        if (hole_.ground) out_.horizons[horizon] = *hole_.ground - depth;
    }

    const HoleLog& hole_;
    Borehole& out_;
};

bool needs_overburden(const std::vector<std::vector<LogInterval>>& columns) {
    const auto logged =
        std::count_if(columns.begin(), columns.end(), [](const auto& c) { return !c.empty(); });
    const auto late = std::count_if(columns.begin(), columns.end(), starts_late);
    return static_cast<double>(late) > kLateStartShare * static_cast<double>(logged);
}

void add_overburden(LogSet& logs, std::vector<std::vector<LogInterval>>& columns, Audit& audit) {
    const auto late = std::count_if(columns.begin(), columns.end(), starts_late);
    audit.add_warning(
        "", 0, "",
        fmt::format("{} holes are logged from below the ground; what lies above {} is the unit overburden",
                    late, logs.units.front()));
    logs.units.insert(logs.units.begin(), "overburden");
    for (auto& column : columns)
        for (LogInterval& segment : column) ++segment.unit;
}

void warn_of_late_start(const LogSet& logs, const HoleLog& hole, const LogInterval& first, Audit& audit) {
    audit.add_warning(logs.files[first.file], first.row, "",
                      fmt::format("hole {}: the log begins at {}; above it {}", hole.id, first.from,
                                  first.unit == 0 ? "is taken as " + logs.units[0] : "is unknown"));
}

}  // namespace

Survey build_survey(LogSet logs, const StratigraphyOptions& options, Audit& audit) {
    check_unit_count(logs);
    clean_logs(logs, audit);
    if (options.repeats == RepeatRule::Split) split_repeats(logs);
    check_unit_count(logs);
    const std::size_t ordered = order_units(logs, options.order, audit);
    fit_logs_to_order(logs, ordered, audit);

    std::vector<std::vector<LogInterval>> columns;
    for (const HoleLog& hole : logs.holes) columns.push_back(segments(hole));
    const bool overburden = needs_overburden(columns);
    if (overburden) add_overburden(logs, columns, audit);

    Survey survey;
    for (const std::string& code : logs.units) survey.units.push_back({code, code, ""});
    survey.holes.resize(logs.holes.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (starts_late(columns[i]) && !overburden)
            warn_of_late_start(logs, logs.holes[i], columns[i].front(), audit);
        FactWriter(logs.holes[i], logs.units.size(), survey.holes[i]).write(columns[i], overburden);
    }
    return survey;
}

}  // namespace stratareeb
