// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/contour_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "boreholes/errors.h"
#include "io/cell_value.h"
#include "io/checked_json.h"
#include "io/contour_columns.h"
#include "io/table_layout.h"

namespace stratareeb {

namespace {

class TableReader {
 public:
    TableReader(const TextTable& table, const ReadContourStackOptions& options)
        : table_(table), options_(options), faults_(table.source) {}

    ContourStack read() {
        find_columns();
        for (std::size_t row = shape_.first_row; row < table_.row_count(); ++row) read_row(row);
        faults_.throw_if_any();
        if (options_.part.empty() && parts_.size() > 1)
            throw InvalidInput(fmt::format("{}: there are several bodies: {}; say which part to read",
                                           table_.source, fmt::join(parts_, ", ")));
        if (rings_.empty())
            throw InvalidInput(
                fmt::format("{}: no contour{}{}", table_.source,
                            options_.part.empty() ? "" : " belongs to " + options_.part,
                            parts_.empty() ? "" : fmt::format("; there are {}", fmt::join(parts_, ", "))));
        ContourStack stack;
        for (Ring& ring : rings_) stack.contours.push_back(contour(ring));
        return stack;
    }

 private:
    struct Ring {
        StackContour contour;
        std::size_t line = 0;        // of its first point
        std::vector<double> orders;  // of its points, if there is such a column
    };

    void find_columns() {
        shape_ = table_shape(table_, {});
        if (!shape_.has_header)
            throw InvalidInput(
                fmt::format("{}: the first row is no header (expected the names of columns: x, y, elevation, "
                            "and ring where there are several of one height)",
                            table_.source));
        const auto& names = shape_.names;
        elevation_ = options_.elevation.empty()
                         ? find_contour_column(names, ContourColumn::Elevation)
                         : std::optional(stated_contour_column(names, options_.elevation, table_.source));
        ring_ = find_contour_column(names, ContourColumn::Ring);
        if (ring_ == elevation_) ring_.reset();
        order_ = find_contour_column(names, ContourColumn::Order);
        part_ = find_contour_column(names, ContourColumn::Part);
        x_ = find_coordinate(Role::X, "x");
        y_ = find_coordinate(Role::Y, "y");
        std::string missing;
        for (const auto& [column, name] :
             {std::pair(x_, "x"), std::pair(y_, "y"), std::pair(elevation_, "elevation")})
            if (!column) missing += (missing.empty() ? "" : ", ") + std::string(name);
        if (!missing.empty())
            throw InvalidInput(fmt::format("{}: there is no column {}; there are {}", table_.source, missing,
                                           fmt::join(names, ", ")));
    }

    //! Also where a unit that boreholes don't come in stands behind it: x_mm.
    std::optional<std::size_t> find_coordinate(Role role, std::string_view letter) const {
        if (const auto found = find_column(shape_, role)) return found;
        for (std::size_t c = 0; c < shape_.names.size(); ++c) {
            const std::string name = normal_name(shape_.names[c]);
            if (name.size() <= 4 && name.starts_with(std::string(letter) + "_")) return c;
        }
        return std::nullopt;
    }

    std::optional<double> number(std::size_t row, std::size_t column) {
        const std::string_view text = table_.cell(row, column);
        const CellValue cell = cell_value(text, table_.decimal_comma);
        if (cell.kind == CellKind::Number) return cell.number;
        faults_.add(fmt::format("row {}", table_.line(row)),
                    fmt::format("{} is \"{}\" (expected a number)", shape_.names[column], text));
        return std::nullopt;
    }

    std::string name(std::size_t row, const std::optional<std::size_t>& column) const {
        return column ? cell_name(table_.cell(row, *column)) : "";
    }

    void read_row(std::size_t row) {
        const std::string part = name(row, part_);
        if (part_) parts_.insert(part);
        if (!options_.part.empty() && part_ && part != options_.part) return;
        const auto x = number(row, *x_), y = number(row, *y_), z = number(row, *elevation_);
        const auto order = order_ ? number(row, *order_) : std::optional(0.0);
        if (!x || !y || !z || !order) return;
        Ring& ring = ring_of(row, part, *z);
        if (ring.contour.z != *z)
            faults_.add(fmt::format("row {}", table_.line(row)),
                        fmt::format("{} is {}, and {} in row {} of the same contour (expected a level line)",
                                    shape_.names[*elevation_], *z, ring.contour.z, ring.line));
        ring.contour.points.push_back({*x, *y});
        ring.orders.push_back(*order);
    }

    Ring& ring_of(std::size_t row, const std::string& part, double z) {
        const std::string id = ring_ ? name(row, ring_) : "";
        const auto [found, is_new] = places_.insert({{part, id, ring_ ? 0.0 : z}, rings_.size()});
        if (is_new) {
            rings_.emplace_back();
            rings_.back().contour.z = z;
            rings_.back().line = table_.line(row);
            rings_.back().contour.name = ring_ ? fmt::format("{} {}", shape_.names[*ring_], id)
                                               : fmt::format("the contour at height {}", z);
        }
        return rings_[found->second];
    }

    static StackContour contour(Ring& ring) {
        if (std::ranges::is_sorted(ring.orders)) return std::move(ring.contour);
        std::vector<std::size_t> place(ring.orders.size());
        for (std::size_t i = 0; i < place.size(); ++i) place[i] = i;
        std::ranges::stable_sort(place, {}, [&](std::size_t i) { return ring.orders[i]; });
        StackContour sorted{.z = ring.contour.z, .points = {}, .name = std::move(ring.contour.name)};
        for (const std::size_t i : place) sorted.points.push_back(ring.contour.points[i]);
        return sorted;
    }

    const TextTable& table_;
    const ReadContourStackOptions& options_;
    FileFaults faults_;
    TableShape shape_;
    std::optional<std::size_t> x_, y_, elevation_, ring_, order_, part_;
    std::vector<Ring> rings_;  // in the order of their first rows
    std::map<std::tuple<std::string, std::string, double>, std::size_t> places_;
    std::set<std::string> parts_;
};

}  // namespace

ContourStack contours_of_table(const TextTable& table, const ReadContourStackOptions& options) {
    return TableReader(table, options).read();
}

}  // namespace stratareeb
