// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/contour_columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "boreholes/errors.h"
#include "io/table_layout.h"

namespace stratareeb {

namespace {

using Names = std::vector<std::string_view>;

const Names& names_of(ContourColumn column) {
    static const Names part{"roi", "body", "structure", "part", "organ", "object", "solid", "unit", "region"};
    static const Names ring{"ring",    "contour", "ring_id", "contour_id", "line", "line_id", "polyline",
                            "polygon", "loop",    "curve",   "outline",    "id",   "fid"};
    static const Names order{"vertex",   "vertex_id", "order", "sequence", "seq", "point",
                             "point_id", "node",      "index", "nr",       "no",  "n"};
    static const Names elevation{"elevation",    "elev",        "z",
                                 "height",       "level",       "altitude",
                                 "alt",          "ele",         "contour_elevation",
                                 "contour_elev", "contour_ele", "contourelevation",
                                 "contourele",   "elevation_z", "z_coord",
                                 "cota",         "quota",       "kote",
                                 "hoehe",        "slice",       "contour"};
    switch (column) {
        case ContourColumn::Part:
            return part;
        case ContourColumn::Ring:
            return ring;
        case ContourColumn::Order:
            return order;
        case ContourColumn::Elevation:
            break;
    }
    return elevation;
}

std::string plain_name(std::string_view name) {
    std::string plain = normal_name(name);
    for (const std::string_view unit : {"_mm", "_cm", "_km", "_in"})
        if (plain.size() > unit.size() && plain.ends_with(unit)) plain.resize(plain.size() - unit.size());
    return plain;
}

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

}  // namespace

std::optional<std::size_t> find_contour_column(std::span<const std::string> names, ContourColumn column) {
    std::vector<std::string> plain;
    for (const std::string& name : names) plain.push_back(plain_name(name));
    for (const std::string_view name : names_of(column))
        if (const auto found = std::ranges::find(plain, name); found != plain.end())
            return static_cast<std::size_t>(found - plain.begin());
    return std::nullopt;
}

std::size_t stated_contour_column(std::span<const std::string> names, std::string_view stated,
                                  const std::string& file) {
    const auto found = std::ranges::find(names, lower(stated), [](const std::string& n) { return lower(n); });
    if (found == names.end())
        throw InvalidInput(fmt::format("{}: there is no column or attribute {}; there are {}", file, stated,
                                       fmt::join(names, ", ")));
    return static_cast<std::size_t>(found - names.begin());
}

}  // namespace stratareeb
