// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/table_layout.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "boreholes/errors.h"
#include "io/cell_value.h"

namespace stratareeb {
namespace {

struct RoleNames {
    Role role;
    std::string stated;              // how the user calls the role
    std::vector<std::string> names;  // normal names in the wild, best first
};

// clang-format off
const std::vector<RoleNames>& role_names() {
    static const std::vector<RoleNames> names{
        {Role::X, "x", {"x", "easting", "eastings", "east", "x_coord", "xcoord", "coord_x", "x_coordinate", "coordinate_x",
                        "utm_x", "utm_e", "utm_easting", "loca_nate", "geometry_x", "rechtswert", "point_x", "este",
                        "longitude", "lon", "long"}},
        {Role::Y, "y", {"y", "northing", "northings", "north", "y_coord", "ycoord", "coord_y", "y_coordinate",
                        "coordinate_y", "utm_y", "utm_n", "utm_northing", "loca_natn", "geometry_y", "hochwert", "point_y",
                        "norte", "latitude", "lat"}},
        {Role::Ground, "ground", {"z", "ground", "z_ground", "ground_z", "z_collar", "collar_z", "datum_elevation",
                        "datum", "ref_elev", "ref_elevation", "ground_elevation", "ground_level", "ground_elev",
                        "ground_surface", "ground_surface_elevation", "surface_elevation", "elevation_ground",
                        "collar_elevation", "collar", "land_surface", "surface", "elevation", "elev", "altitude", "height",
                        "level", "gl", "rl", "loca_gl", "topo", "cota", "geometry_z", "z_coord"}},
        {Role::Hole, "hole", {"hole_id", "hole", "borehole_id", "borehole", "bore_id", "bore", "bhid", "bh_id", "bh",
                        "boring", "boring_id", "hole_name", "well_id", "well", "loca_id", "api", "api_number", "uwi",
                        "point_id", "station", "site_id", "well_name", "drillhole", "drill_hole", "dhid", "sondeo", "codi",
                        "bohrung", "name", "id"}},
        {Role::From, "from", {"from", "from_depth", "depth_from", "top_depth", "depth_top", "geol_top", "top", "start",
                        "start_depth", "depth_start", "upper", "upper_depth", "from_elevation", "top_elevation",
                        "top_elev", "elevation_top", "z_top", "top_z"}},
        {Role::To, "to", {"to", "to_depth", "depth_to", "base_depth", "depth_base", "bottom_depth", "depth_bottom",
                        "geol_base", "base", "bottom", "end", "end_depth", "depth_end", "lower", "lower_depth",
                        "to_elevation", "base_elevation", "bottom_elevation", "bottom_elev", "base_elev",
                        "elevation_base", "elevation_bottom", "z_base", "z_bottom", "base_z"}},
        {Role::Unit, "unit", {"unit", "unit_code", "formation", "lithology", "stratum", "strata", "stratigraphy", "layer",
                        "lith", "litho", "lith_code", "lithology_code", "major_lith_code", "geology_code", "geology",
                        "geol_leg", "class", "clase", "facies", "soil_type", "soil", "material", "surface", "code",
                        "strat_unit", "stratigraphic_unit", "horizon", "marker", "top_name"}},
        {Role::Z, "z", {"z", "elevation", "elev", "z_coord", "altitude", "height", "cota", "level", "geometry_z"}},
        {Role::Depth, "depth", {"md", "depth", "measured_depth", "tvd", "depth_md"}},
        {Role::HoleDepth, "", {"depth", "total_depth", "hole_depth", "end_depth", "td", "final_depth", "borehole_depth"}},
    };
    return names;
}
// clang-format on

const RoleNames& names_of(Role role) {
    return *std::find_if(role_names().begin(), role_names().end(),
                         [&](const RoleNames& r) { return r.role == role; });
}

bool is_upper(char c) {
    return c >= 'A' && c <= 'Z';
}
bool is_lower(char c) {
    return c >= 'a' && c <= 'z';
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
char lower(char c) {
    return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c;
}

std::vector<std::string> words(std::string_view name) {
    std::vector<std::string> result;
    bool open = false;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const char c = name[i];
        if (!is_upper(c) && !is_lower(c) && !is_digit(c) && static_cast<unsigned char>(c) < 0x80) {
            open = false;
            continue;
        }
        const bool after_lower = i > 0 && is_lower(name[i - 1]) && is_upper(c);
        const bool last_capital =
            i > 0 && i + 1 < name.size() && is_upper(name[i - 1]) && is_upper(c) && is_lower(name[i + 1]);
        if (!open || after_lower || last_capital) result.emplace_back();
        result.back().push_back(lower(c));
        open = true;
    }
    return result;
}

bool is_measure(const std::string& word) {
    constexpr std::array<std::string_view, 15> kMeasures{"m",    "meter", "meters", "metre", "metres",
                                                         "feet", "ft",    "foot",   "usft",  "masl",
                                                         "maod", "mbgl",  "bgl",    "aod",   "mod"};
    return std::find(kMeasures.begin(), kMeasures.end(), word) != kMeasures.end();
}

std::string joined(const std::vector<std::string>& parts, std::size_t first) {
    std::string text;
    for (std::size_t i = first; i < parts.size(); ++i) text += (i > first ? "_" : "") + parts[i];
    return text;
}

std::string letter(std::size_t column) {
    std::string text;
    for (std::size_t n = column + 1; n > 0; n = (n - 1) / 26)
        text.insert(text.begin(), static_cast<char>('A' + (n - 1) % 26));
    return text;
}

std::size_t filled_cells(const TextTable& table, std::size_t row) {
    std::size_t filled = 0;
    for (std::size_t column = 0; column < table.cell_count(row); ++column)
        filled += !trimmed(table.cell(row, column)).empty();
    return filled;
}

//! Blank rows and one-cell title rows above a wider table.
std::size_t first_table_row(const TextTable& table) {
    std::size_t row = 0;
    while (row < table.row_count() && filled_cells(table, row) == 0) ++row;
    const std::size_t top = row;
    while (row < table.row_count() && filled_cells(table, row) <= 1) ++row;
    return row < table.row_count() && filled_cells(table, row) >= 3 ? row : top;
}

bool is_header_row(const TextTable& table, std::size_t row) {
    std::size_t seen = 0, numbers = 0;
    for (std::size_t column = 0; column < table.cell_count(row) && seen < 3; ++column) {
        const CellKind kind = cell_value(table.cell(row, column), table.decimal_comma).kind;
        if (trimmed(table.cell(row, column)).empty()) continue;
        ++seen;
        numbers += kind != CellKind::Text && kind != CellKind::Empty;
    }
    return numbers < 2;
}

}  // namespace

std::string normal_name(std::string_view name) {
    const auto all = words(name);
    std::vector<std::string> kept;
    for (const std::string& word : all)
        if (kept.empty() || !is_measure(word)) kept.push_back(word);
    return joined(kept, 0);
}

TableShape table_shape(const TextTable& table, const std::map<std::string, std::string>& stated) {
    TableShape shape;
    shape.table = &table;
    shape.stated = stated;
    shape.names.resize(table.column_count());
    for (std::size_t column = 0; column < shape.names.size(); ++column) shape.names[column] = letter(column);
    if (!table.field_names.empty()) {
        shape.has_header = true;
        shape.names = table.field_names;
        return shape;
    }
    shape.first_row = first_table_row(table);
    if (shape.first_row >= table.row_count() || !is_header_row(table, shape.first_row)) return shape;
    shape.has_header = true;
    for (std::size_t column = 0; column < table.cell_count(shape.first_row); ++column)
        shape.names[column] = trimmed(table.cell(shape.first_row, column));
    for (std::size_t column = table.cell_count(shape.first_row); column < shape.names.size(); ++column)
        shape.names[column].clear();
    ++shape.first_row;
    return shape;
}

std::optional<std::size_t> column_by_name(const TableShape& shape, std::string_view name) {
    const auto same = [&](const std::string& other) {
        return std::equal(name.begin(), name.end(), other.begin(), other.end(),
                          [](char a, char b) { return lower(a) == lower(b); });
    };
    const auto found = std::find_if(shape.names.begin(), shape.names.end(), same);
    if (found != shape.names.end()) return static_cast<std::size_t>(found - shape.names.begin());
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (error != std::errc() || end != name.data() + name.size()) return std::nullopt;
    if (number < 1 || number > shape.names.size()) return std::nullopt;
    return number - 1;
}

bool is_stated(const TableShape& shape, Role role) {
    return shape.stated.contains(names_of(role).stated);
}

std::optional<std::size_t> find_column(const TableShape& shape, Role role) {
    const RoleNames& names = names_of(role);
    if (const auto stated = shape.stated.find(names.stated); stated != shape.stated.end())
        return stated->second.empty() ? std::nullopt : column_by_name(shape, stated->second);
    if (!shape.has_header) return std::nullopt;
    std::vector<std::vector<std::string>> normal;
    for (const std::string& name : shape.names) {
        normal.push_back({normal_name(name)});
        const auto all = words(name);  // "A_x": a spreadsheet's letter before the name
        if (all.size() >= 2 && all[0].size() == 1) normal.back().push_back(joined(all, 1));
    }
    for (const std::string& name : names.names)
        for (std::size_t column = 0; column < normal.size(); ++column)
            if (std::find(normal[column].begin(), normal[column].end(), name) != normal[column].end())
                return column;
    return std::nullopt;
}

const std::vector<std::string>& stated_role_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> result;
        for (const RoleNames& role : role_names())
            if (!role.stated.empty()) result.push_back(role.stated);
        return result;
    }();
    return names;
}

}  // namespace stratareeb
