// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_wide.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "io/cell_value.h"

namespace stratareeb {
namespace {

class WideReader {
 public:
    WideReader(const TableShape& shape, const WideColumns& columns, const CollarTable* collars,
               ListedSet& listed, TableContext& context)
        : shape_(shape), columns_(columns), collars_(collars), listed_(listed), context_(context) {
        file_ = static_cast<std::uint32_t>(listed.files.size());
        listed.files.push_back(shape.table->source);
        for (std::size_t unit = 0; unit < listed.units.size(); ++unit)
            units_.emplace(listed.units[unit], unit);
    }

    void read() {
        warn_of_ignored();
        for (const LayerColumn& layer : columns_.layers)
            fixed_units_.push_back(layer.code ? 0 : unit_number(layer.unit));
        for (std::size_t row = shape_.first_row; row < shape_.row_count(); ++row) read_row(row);
    }

 private:
    void warn(std::size_t row, std::string text) {
        context_.audit.add_warning(shape_.table->source, row, "", std::move(text));
    }

    void warn_of_ignored() {
        std::vector<std::string> names;
        std::size_t nameless = 0;
        for (const std::size_t column : columns_.ignored)
            if (shape_.names[column].empty())
                ++nameless;
            else if (!shape_.table->has_geometry || column > 1)
                names.push_back(shape_.names[column]);
        if (nameless > 0) names.push_back(fmt::format("{} without a name", nameless));
        if (!names.empty())
            warn(0, fmt::format("columns not used: {} (--order names the layer columns)",
                                fmt::join(names, ", ")));
    }

    std::size_t unit_number(const std::string& unit) {
        const auto [place, is_new] = units_.try_emplace(unit, listed_.units.size());
        if (is_new) listed_.units.push_back(unit);
        return place->second;
    }

    void read_row(std::size_t row) {
        const std::size_t errors = context_.audit.error_count();
        ListedHole hole;
        hole.row = shape_.table->line(row);
        hole.file = file_;
        if (columns_.hole) hole.id = cell_name(shape_.table->cell(row, *columns_.hole));
        if (hole.id.empty()) hole.id = fmt::format("row {}", hole.row);
        const bool placed = place(row, hole);
        read_layers(row, hole);
        if (context_.audit.error_count() > errors || !placed) return;
        note_repeated_id(hole);
        listed_.holes.push_back(std::move(hole));
    }

    //! Find x, y and ground. False (with a warning or an error) if the hole has no place.
    bool place(std::size_t row, ListedHole& hole) {
        const std::size_t errors = context_.audit.error_count();
        const auto x = number_cell(shape_, row, columns_.x, context_),
                   y = number_cell(shape_, row, columns_.y, context_);
        hole.ground = number_cell(shape_, row, columns_.ground, context_);
        if (hole.ground) *hole.ground *= context_.vertical;
        const Collar* collar = collars_ ? collars_->find(hole.id) : nullptr;
        if (collar && !hole.ground) hole.ground = collar->ground;
        if (x && y)
            hole.at = {*x, *y};
        else if (collar)
            hole.at = collar->at;
        else if (context_.audit.error_count() == errors && !is_blank(row))
            warn(hole.row, fmt::format("hole {} has no {}; it is left out", hole.id,
                                       columns_.x ? "x, y" : "usable collar"));
        return (x && y) || collar;
    }

    bool is_blank(std::size_t row) const {
        for (std::size_t column = 0; column < shape_.table->cell_count(row); ++column)
            if (!shape_.table->cell(row, column).empty()) return false;
        return true;
    }

    void read_layers(std::size_t row, ListedHole& hole) {
        for (std::size_t i = 0; i < columns_.layers.size(); ++i) {
            const LayerColumn& column = columns_.layers[i];
            ListedLayer layer;
            layer.unit = fixed_units_[i];
            const bool read = read_value(row, column.value, layer);
            if (column.code) {
                const std::string code = cell_name(shape_.table->cell(row, *column.code));
                if (code.empty() && layer.given) add_missing_code(row, *column.code);
                if (code.empty()) continue;
                layer.unit = unit_number(code);
            }
            if (read) hole.layers.push_back(layer);
        }
    }

    void add_missing_code(std::size_t row, std::size_t column) {
        context_.audit.add_error(shape_.table->source, shape_.table->line(row), name(column),
                                 "a value without the code of its unit; name the unit or empty the value");
    }

    std::string name(std::size_t column) const {
        return column < shape_.names.size() ? shape_.names[column] : std::to_string(column + 1);
    }

    bool read_value(std::size_t row, std::size_t column, ListedLayer& layer) {
        const CellValue value = cell_value(shape_.table->cell(row, column), shape_.table->decimal_comma);
        if (value.kind == CellKind::Text || value.kind == CellKind::NotFinite) {
            add_number_error(shape_, row, column, context_);
            return false;
        }
        if (columns_.values == TableValues::Thickness && value.number < 0) {
            context_.audit.add_error(
                shape_.table->source, shape_.table->line(row), name(column),
                fmt::format("thickness {} is negative; if the numbers are depths or elevations, say so "
                            "(--values depth, --values elevation)",
                            value.number));
            return false;
        }
        layer.given = value.kind != CellKind::Empty;
        layer.at_least = value.kind == CellKind::AtLeast;
        layer.value = value.number * context_.vertical;
        return true;
    }

    void note_repeated_id(const ListedHole& hole) {
        if (!columns_.hole) return;
        const auto [first, is_new] = ids_.try_emplace(hole.id, hole.row);
        if (!is_new)
            warn(hole.row, fmt::format("hole id {} stands in row {} already; both rows are used", hole.id,
                                       first->second));
    }

    const TableShape& shape_;
    const WideColumns& columns_;
    const CollarTable* collars_;
    ListedSet& listed_;
    TableContext& context_;
    std::uint32_t file_ = 0;
    std::unordered_map<std::string, std::size_t> units_, ids_;
    std::vector<std::size_t> fixed_units_;
};

}  // namespace

void read_wide(const TableShape& shape, const WideColumns& columns, const CollarTable* collars,
               ListedSet& listed, TableContext& context) {
    if (!collars && !(columns.x && columns.y)) {
        context.audit.add_error(
            shape.table->source, 0, "",
            "no columns for x and y; state them (--columns x=NAME,y=NAME), or name the table with the "
            "holes' places: --collars FILE");
        return;
    }
    WideReader(shape, columns, collars, listed, context).read();
}

}  // namespace stratareeb
