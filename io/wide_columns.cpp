// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "io/cell_value.h"
#include "io/read_wide.h"

namespace stratareeb {
namespace {

using Words = std::vector<std::string>;

Words split_words(const std::string& normal) {
    Words words;
    std::size_t begin = 0;
    while (begin <= normal.size()) {
        const std::size_t end = std::min(normal.find('_', begin), normal.size());
        words.push_back(normal.substr(begin, end - begin));
        begin = end + 1;
    }
    return words;
}

std::string without_digits(std::string word) {
    while (!word.empty() && word.back() >= '0' && word.back() <= '9') word.pop_back();
    return word;
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_code_word(const std::string& word) {
    return is_one_of(word, {"code", "unit", "lith", "lithology", "formation", "layer", "material", "geology",
                            "soil", "stratum"});
}

TableValues value_word(const std::string& word) {
    if (is_one_of(word, {"thickness", "thick", "thk", "isopach", "t"})) return TableValues::Thickness;
    if (is_one_of(word, {"depth", "md", "tvd"})) return TableValues::Depth;
    if (is_one_of(word, {"elevation", "elev", "rl"})) return TableValues::Elevation;
    return TableValues::Auto;
}

//! The last word of a header without a number behind it: "E_thickness1" and "Thickness 1" both end in
//! "thickness".
std::string last_word(const std::string& name) {
    Words words = split_words(normal_name(name));
    while (words.size() > 1 && without_digits(words.back()).empty()) words.pop_back();
    return without_digits(words.back());
}

bool is_pair(const TableShape& shape, std::size_t column) {
    return column + 1 < shape.column_count() && is_code_word(last_word(shape.names[column])) &&
           value_word(last_word(shape.names[column + 1])) != TableValues::Auto;
}

bool is_numbered(const std::string& name) {
    return !name.empty() && name.back() >= '0' && name.back() <= '9';
}

//! Two pairs or more, or a numbered one: "code, depth" alone may be anything.
bool has_pairs(const TableShape& shape) {
    std::size_t pairs = 0;
    bool numbered = false;
    for (std::size_t column = 0; column < shape.column_count(); ++column) {
        if (!is_pair(shape, column)) continue;
        ++pairs;
        numbered = numbered || (is_numbered(shape.names[column]) && is_numbered(shape.names[column + 1]));
    }
    return pairs > 1 || numbered;
}

//! Columns that tell of a hole, not of a layer.
bool is_about_hole(const std::string& name) {
    static const std::set<std::string> names{"depth",
                                             "total_depth",
                                             "hole_depth",
                                             "end_depth",
                                             "td",
                                             "final_depth",
                                             "borehole_depth",
                                             "z",
                                             "ground",
                                             "elevation",
                                             "ground_elevation",
                                             "datum",
                                             "datum_elevation",
                                             "datum_type",
                                             "ground_level",
                                             "z_ground",
                                             "x",
                                             "y",
                                             "easting",
                                             "northing",
                                             "lat",
                                             "lon",
                                             "latitude",
                                             "longitude",
                                             "water_level",
                                             "groundwater",
                                             "water_table",
                                             "swl",
                                             "well_number",
                                             "well_name",
                                             "hole_type",
                                             "fid",
                                             "objectid",
                                             "ogc_fid",
                                             "inclination",
                                             "azimuth",
                                             "dip",
                                             "diameter",
                                             "plugback_depth",
                                             "deepest",
                                             "name"};
    if (names.contains(normal_name(name))) return true;
    const Words words = split_words(normal_name(name));
    if (words.size() == 2 && words[1].starts_with("dep") &&
        is_one_of(words[0], {"bore", "hole", "well", "drilled", "max", "final", "water", "casing", "drill"}))
        return true;
    return std::any_of(words.begin(), words.end(), [](const std::string& word) {
        return is_one_of(word,
                         {"id",       "type",    "date",    "year",  "operator", "driller",     "comment",
                          "comments", "remark",  "remarks", "note",  "notes",    "description", "number",
                          "times",    "rows",    "row",     "count", "crs",      "epsg",        "status",
                          "method",   "project", "county",  "state", "country",  "draw"});
    });
}

std::string_view without_measure(std::string_view name) {
    name = trimmed(name);
    if (name.ends_with(')') && name.rfind('(') != name.npos && name.rfind('(') > 0)
        name = name.substr(0, name.rfind('('));
    if (name.ends_with(']') && name.rfind('[') != name.npos && name.rfind('[') > 0)
        name = name.substr(0, name.rfind('['));
    return trimmed(name);
}

//! The unit that a layer column's header names: "layer1_thickness" is about "layer1", "Clay (m)" about
//! "Clay".
std::string unit_of_header(const std::string& header) {
    std::string_view name = without_measure(header);
    const auto separator = name.find_last_of(" _-.");
    if (separator != name.npos && separator > 0 &&
        value_word(normal_name(name.substr(separator + 1))) != TableValues::Auto &&
        name.substr(separator + 1).size() > 1)
        name = name.substr(0, separator);
    return cell_name(name);
}

TableValues value_of_header(const std::string& header) {
    const Words words = split_words(normal_name(header));
    if (words.size() < 2 || words.back().size() < 2) return TableValues::Auto;
    return value_word(words.back());
}

std::optional<std::size_t> headerless_offset(const TableShape& shape) {
    std::size_t odd = 0, even = 0, text = 0, rows = 0;
    for (std::size_t row = shape.first_row; row < shape.row_count() && rows < 1000; ++row, ++rows) {
        std::size_t cells = shape.table->cell_count(row);
        while (cells > 0 && shape.table->cell(row, cells - 1).empty()) --cells;
        (cells % 2 == 1 ? odd : even) += 1;
        text += cell_value(shape.table->cell(row, 0), shape.table->decimal_comma).kind == CellKind::Text;
    }
    if (rows == 0) return std::nullopt;
    return 2 * text > rows || (text == 0 && even > odd) ? 1 : 0;
}

//! x, y, ground, then code and thickness pairs, all by place; a hole id may come first.
std::optional<WideColumns> columns_by_place(const TableShape& shape) {
    const auto first = headerless_offset(shape);
    if (!first || shape.column_count() < *first + 5) return std::nullopt;
    WideColumns columns;
    if (*first == 1) columns.hole = 0;
    columns.x = *first;
    columns.y = *first + 1;
    columns.ground = *first + 2;
    for (std::size_t column = *first + 3; column + 1 < shape.column_count() + 1; column += 2)
        columns.layers.push_back({column, "", column + 1});
    return columns;
}

bool is_stated_unit(const ReadBoreholesOptions& options, const std::string& name) {
    return std::find(options.order.begin(), options.order.end(), unit_of_header(name)) !=
               options.order.end() ||
           std::find(options.order.begin(), options.order.end(), name) != options.order.end();
}

bool is_layer_column(const TableShape& shape, std::size_t column, const ReadBoreholesOptions& options) {
    const std::string& name = shape.names[column];
    if (!options.order.empty()) return is_stated_unit(options, name);
    if (name.empty() || is_about_hole(name)) return false;
    if (value_of_header(name) != TableValues::Auto) return true;
    const CellCensus census = cell_census(shape, column);
    return census.numbers > 0 && census.numbers >= census.other;
}

void add_named_layers(const TableShape& shape, const ReadBoreholesOptions& options, WideColumns& columns) {
    const std::set<std::optional<std::size_t>> taken{columns.hole, columns.x, columns.y, columns.ground};
    for (std::size_t column = 0; column < shape.column_count(); ++column) {
        if (taken.contains(column)) continue;
        if (is_layer_column(shape, column, options)) {
            const bool whole = std::find(options.order.begin(), options.order.end(), shape.names[column]) !=
                               options.order.end();
            columns.layers.push_back(
                {std::nullopt, whole ? shape.names[column] : unit_of_header(shape.names[column]), column});
        } else if (const CellCensus census = cell_census(shape, column); census.numbers + census.other > 0) {
            columns.ignored.push_back(column);
        }
    }
    const auto place = [&](const LayerColumn& layer) {
        return std::find(options.order.begin(), options.order.end(), layer.unit);
    };
    if (!options.order.empty())
        std::stable_sort(columns.layers.begin(), columns.layers.end(),
                         [&](const LayerColumn& a, const LayerColumn& b) { return place(a) < place(b); });
}

void add_pairs(const TableShape& shape, WideColumns& columns) {
    const std::set<std::optional<std::size_t>> taken{columns.hole, columns.x, columns.y, columns.ground};
    for (std::size_t column = 0; column < shape.column_count(); ++column) {
        if (is_pair(shape, column)) {
            columns.layers.push_back({column, "", column + 1});
            ++column;
        } else if (!taken.contains(column)) {
            columns.ignored.push_back(column);
        }
    }
}

TableValues recognised_values(const TableShape& shape, const WideColumns& columns) {
    std::array<std::size_t, 4> count{};
    for (const LayerColumn& layer : columns.layers) {
        const std::string& name = shape.names[layer.value];
        const TableValues value = layer.code ? value_word(last_word(name)) : value_of_header(name);
        ++count[static_cast<std::size_t>(value)];
    }
    for (const TableValues value : {TableValues::Depth, TableValues::Elevation})
        if (2 * count[static_cast<std::size_t>(value)] > columns.layers.size()) return value;
    return TableValues::Thickness;
}

}  // namespace

std::optional<WideColumns> find_wide_columns(const TableShape& shape, const ReadBoreholesOptions& options) {
    if (!shape.has_header) {
        auto columns = columns_by_place(shape);
        if (columns && options.values != TableValues::Auto) columns->values = options.values;
        return columns;
    }
    WideColumns columns{find_column(shape, Role::Hole),
                        find_column(shape, Role::X),
                        find_column(shape, Role::Y),
                        find_column(shape, Role::Ground),
                        {},
                        {},
                        TableValues::Thickness};
    if (!columns.hole && !(columns.x && columns.y)) return std::nullopt;
    if (has_pairs(shape))
        add_pairs(shape, columns);
    else
        add_named_layers(shape, options, columns);
    if (columns.layers.empty()) return std::nullopt;
    columns.values = options.values == TableValues::Auto ? recognised_values(shape, columns) : options.values;
    return columns;
}

}  // namespace stratareeb
