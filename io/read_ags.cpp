// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_ags.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "boreholes/errors.h"
#include "io/ags_file.h"
#include "io/cell_value.h"

namespace stratareeb {

namespace {

using Row = AgsGroup::Row;

//! A group of one of the files.
struct Part {
    const AgsFile* file;
    std::uint32_t number;  // of the file
    const AgsGroup* group;
};

//! Where the place of a hole stands.
struct PlaceHeadings {
    std::string x, y, ground;
};

double metres_per(std::string_view unit) {
    if (unit.empty() || unit == "m") return 1;
    if (unit == "mm") return 0.001;
    if (unit == "cm") return 0.01;
    if (unit == "km") return 1000;
    if (unit == "ft") return 0.3048;
    return 0;
}

class AgsReader {
 public:
    AgsReader(const std::vector<AgsFile>& files, const CollarTable* collars, TableContext& context)
        : collars_(collars), context_(context) {
        for (std::uint32_t number = 0; number < files.size(); ++number) {
            result_.logs.files.push_back(files[number].source);
            const char* holes = files[number].edition == 3 ? "HOLE" : "LOCA";
            for (const AgsGroup* group : files[number].all(holes))
                holes_.push_back({&files[number], number, group});
            for (const AgsGroup* group : files[number].all("GEOL"))
                strata_.push_back({&files[number], number, group});
        }
        for (const AgsFile& file : files) read_names(file);
    }

    AgsLogs read() {
        if (!check_groups()) return std::move(result_);
        const PlaceHeadings headings = place_headings();
        for (const Part& part : holes_) read_holes(part, headings);
        choose_unit_heading();
        for (const Part& part : strata_) read_strata(part);
        report_unknown_holes();
        name_units();
        return std::move(result_);
    }

 private:
    void warn(const Part& part, std::size_t line, const std::string& heading, const std::string& text) {
        context_.audit.add_warning(part.file->source, line, heading,
                                   fmt::format("group {}: {}", part.group->name, text));
    }
    void error(const Part& part, std::size_t line, const std::string& heading, const std::string& text) {
        context_.audit.add_error(part.file->source, line, heading,
                                 fmt::format("group {}: {}", part.group->name, text));
    }

    bool check_groups() {
        const std::string& source = result_.logs.files.front();
        if (strata_.empty())
            context_.audit.add_error(
                source, 0, "", "no group GEOL: the AGS file has no strata; name the file that has them");
        if (holes_.empty() && !collars_)
            context_.audit.add_error(
                source, 0, "",
                "no group LOCA or HOLE: the AGS file has no places of holes; name the file that has "
                "them as well, or --collars FILE");
        for (const auto& [role, heading] : context_.options.columns) check_stated(role, heading);
        return !context_.audit.has_errors();
    }

    void check_stated(const std::string& role, const std::string& heading) {
        const bool of_place = role == "x" || role == "y" || role == "ground";
        if (!of_place && role != "unit")
            throw InvalidInput(fmt::format(
                "--columns {}={}: of an AGS file only x, y, ground and unit can be stated", role, heading));
        const auto& parts = of_place ? holes_ : strata_;
        const bool known = std::ranges::any_of(
            parts, [&](const Part& part) { return part.group->column(heading).has_value(); });
        if (!known && !heading.empty())
            throw InvalidInput(fmt::format(
                "--columns {}={}: no such heading in group {}; it has {}", role, heading,
                parts.empty() ? (of_place ? "LOCA" : "GEOL") : parts.front().group->name,
                parts.empty() ? "" : fmt::format("{}", fmt::join(parts.front().group->headings, ", "))));
    }

    //! The stated heading of a role, or the usual one with the group's prefix.
    std::string heading_of(const std::string& role, const std::string& usual) const {
        const auto stated = context_.options.columns.find(role);
        return stated == context_.options.columns.end() ? usual : stated->second;
    }

    std::size_t filled(const std::vector<Part>& parts, const std::string& heading) const {
        std::size_t count = 0;
        for (const Part& part : parts)
            if (const auto column = part.group->column(heading_in(part, heading)))
                for (const Row& row : part.group->rows) count += !part.group->cell(row, column).empty();
        return count;
    }

    //! "?_NATE" is HOLE_NATE in edition 3 and LOCA_NATE in edition 4.
    static std::string heading_in(const Part& part, const std::string& heading) {
        return heading.starts_with("?_") ? part.group->name + heading.substr(1) : heading;
    }

    PlaceHeadings place_headings() {
        const bool local = !holes_.empty() && filled(holes_, "?_NATE") == 0 && filled(holes_, "?_LOCX") > 0;
        if (local && !context_.options.columns.contains("x"))
            warn(holes_.front(), 0, "",
                 "no hole has national grid coordinates; the local ones (LOCX, LOCY, and LOCZ as its ground) "
                 "are taken");
        const bool local_ground = local && filled(holes_, "?_GL") == 0;
        return {heading_of("x", local ? "?_LOCX" : "?_NATE"), heading_of("y", local ? "?_LOCY" : "?_NATN"),
                heading_of("ground", local_ground ? "?_LOCZ" : "?_GL")};
    }

    //! In metres; nullopt where the cell is empty. What is no number is an error.
    std::optional<double> number(const Part& part, const Row& row, const std::string& id,
                                 const std::string& heading) {
        const auto column = part.group->column(heading);
        const std::string_view text = part.group->cell(row, column);
        const CellValue value = cell_value(text);
        if (!column || value.kind == CellKind::Empty) return std::nullopt;
        const double factor = metres_per(part.group->unit(*column));
        if (factor == 0) {
            error(part, part.group->line, heading,
                  fmt::format("its unit \"{}\" is no length that is known; expected m, mm, cm, km or ft",
                              part.group->unit(*column)));
        } else if (value.kind != CellKind::Number) {
            error(part, row.line, heading,
                  fmt::format("hole {}: \"{}\" is no number; correct it, or leave it empty", id, text));
        } else {
            return value.number * factor;
        }
        return std::nullopt;
    }

    std::string hole_of(const Part& part, const Row& row) const {
        auto column = part.group->column(part.file->edition == 3 ? "HOLE_ID" : "LOCA_ID");
        if (!column) column = part.group->column(part.file->edition == 3 ? "LOCA_ID" : "HOLE_ID");
        return cell_name(part.group->cell(row, column));
    }

    void read_holes(const Part& part, const PlaceHeadings& headings) {
        for (const Row& row : part.group->rows) {
            const std::string id = hole_of(part, row);
            if (id.empty()) {
                warn(part, row.line, "", "no hole id; the row is left out");
                continue;
            }
            const std::size_t errors = context_.audit.error_count();
            auto x = number(part, row, id, heading_in(part, headings.x)),
                 y = number(part, row, id, heading_in(part, headings.y)),
                 ground = number(part, row, id, heading_in(part, headings.ground));
            if (context_.audit.error_count() > errors) continue;
            if (const Collar* collar = collars_ ? collars_->find(id) : nullptr) {
                if (!x || !y) x = collar->at.x, y = collar->at.y;
                if (!ground) ground = collar->ground;
            }
            note_inclination(part, row, id);
            if (x && y)
                add_hole(part, row, {id, {*x, *y}, ground, {}, row.line, part.number});
            else if (!numbers_.contains(id) && without_place_.try_emplace(id, 0).second)
                warn(part, row.line, headings_of_place(part, headings),
                     fmt::format("hole {} has no coordinates; it is left out (give them with --collars FILE)",
                                 id));
        }
    }

    static std::string headings_of_place(const Part& part, const PlaceHeadings& headings) {
        return heading_in(part, headings.x) + ", " + heading_in(part, headings.y);
    }

    void note_inclination(const Part& part, const Row& row, const std::string& id) {
        const CellValue dip =
            cell_value(part.group->cell(row, part.group->column(part.group->name + "_INCL")));
        if (dip.kind == CellKind::Number && std::abs(dip.number) != 90 && dip.number != 0)
            warn(part, row.line, part.group->name + "_INCL",
                 fmt::format("hole {} dips by {} degrees; it is taken as vertical", id, dip.number));
    }

    void add_hole(const Part& part, const Row& row, HoleLog hole) {
        const auto [place, is_new] = numbers_.try_emplace(hole.id, result_.logs.holes.size());
        if (is_new) {
            without_place_.erase(hole.id);
            result_.logs.holes.push_back(std::move(hole));
            return;
        }
        HoleLog& other = result_.logs.holes[place->second];
        if (!(other.at == hole.at))
            warn(part, row.line, "",
                 fmt::format("hole {} stands in {}:{} already, at another place; that row is used", hole.id,
                             result_.logs.files[other.file], other.row));
        if (!other.ground) other.ground = hole.ground;
    }

    void choose_unit_heading() {
        unit_heading_ = heading_of("unit", "");
        if (!unit_heading_.empty()) return;
        std::size_t rows = 0, most = 0;
        for (const Part& part : strata_) rows += part.group->rows.size();
        for (const char* heading : {"GEOL_GEOL", "GEOL_GEO2", "GEOL_LEG", "GEOL_FORM"}) {
            const std::size_t count = filled(strata_, heading);
            if (count > most) most = count, unit_heading_ = heading;
            if (2 * count >= rows) break;
        }
        if (unit_heading_.empty())
            return error(strata_.front(), strata_.front().group->line, "",
                         "none of GEOL_GEOL, GEOL_GEO2, GEOL_LEG and GEOL_FORM is filled, so rows have no "
                         "unit; state the "
                         "heading with --columns unit=HEADING");
        if (unit_heading_ != "GEOL_GEOL")
            warn(strata_.front(), strata_.front().group->line, unit_heading_,
                 fmt::format(
                     "units are the codes in {}, as GEOL_GEOL is mostly empty; another heading: --columns "
                     "unit=HEADING",
                     unit_heading_));
    }

    void read_strata(const Part& part) {
        for (const Row& row : part.group->rows) {
            const std::string id = hole_of(part, row);
            if (id.empty()) {
                warn(part, row.line, "", "no hole id; the stratum is left out");
                continue;
            }
            HoleLog* hole = find_hole(part, row, id);
            if (!hole) continue;
            const std::size_t errors = context_.audit.error_count();
            const auto top = number(part, row, id, "GEOL_TOP"), base = number(part, row, id, "GEOL_BASE");
            if (context_.audit.error_count() > errors) continue;
            if (!top || !base) {
                warn(part, row.line, top ? "GEOL_BASE" : "GEOL_TOP",
                     fmt::format("hole {}: empty; the stratum is left out", id));
                continue;
            }
            const std::string unit = cell_name(part.group->cell(row, part.group->column(unit_heading_)));
            hole->intervals.push_back({*top, *base, unit_number(unit), row.line, part.number});
        }
    }

    HoleLog* find_hole(const Part& part, const Row& row, const std::string& id) {
        if (const auto found = numbers_.find(id); found != numbers_.end())
            return &result_.logs.holes[found->second];
        if (const Collar* collar = collars_ ? collars_->find(id) : nullptr) {
            add_hole(part, row, {id, collar->at, collar->ground, {}, row.line, part.number});
            return &result_.logs.holes.back();
        }
        if (const auto missing = without_place_.find(id); missing != without_place_.end()) return nullptr;
        const auto [place, is_new] = unknown_number_.try_emplace(id, unknown_.size());
        if (is_new) unknown_.push_back({&part, row.line, id, 0});
        ++unknown_[place->second].strata;
        return nullptr;
    }

    void report_unknown_holes() {
        for (const Unknown& hole : unknown_)
            warn(*hole.part, hole.line, "",
                 fmt::format("hole {} is not among the holes of the file; its {} strata are left out",
                             hole.id, hole.strata));
    }

    std::size_t unit_number(const std::string& unit) {
        if (unit.empty()) return LogInterval::kNoUnit;
        const auto [place, is_new] = units_.try_emplace(unit, result_.logs.units.size());
        if (is_new) result_.logs.units.push_back(unit);
        return place->second;
    }

    void read_names(const AgsFile& file) {
        for (const AgsGroup* group : file.all("ABBR")) {
            const auto heading = group->column("ABBR_HDNG"), code = group->column("ABBR_CODE"),
                       text = group->column("ABBR_DESC");
            for (const Row& row : group->rows)
                names_.try_emplace(
                    {std::string(group->cell(row, heading)), cell_name(group->cell(row, code))},
                    group->cell(row, text));
        }
    }

    static bool says_something(std::string_view name) { return !name.empty() && name != "Undefined"; }

    void name_units() {
        for (const std::string& unit : result_.logs.units)
            if (const auto name = names_.find({unit_heading_, unit});
                name != names_.end() && !name->second.empty())
                result_.unit_names.emplace(unit, name->second);
    }

    struct Unknown {
        const Part* part;
        std::size_t line;
        std::string id;
        std::size_t strata;
    };

    const CollarTable* collars_;
    TableContext& context_;
    AgsLogs result_;
    std::vector<Part> holes_, strata_;
    std::string unit_heading_;
    std::map<std::pair<std::string, std::string>, std::string> names_;  // (heading, code) → description
    std::unordered_map<std::string, std::size_t> numbers_, units_, without_place_, unknown_number_;
    std::vector<Unknown> unknown_;
};

}  // namespace

AgsLogs read_ags(const std::vector<std::string>& sources, const CollarTable* collars, TableContext& context) {
    std::vector<AgsFile> files;
    for (const std::string& source : sources) files.push_back(read_ags_file(source, context.audit));
    return AgsReader(files, collars, context).read();
}

}  // namespace stratareeb
