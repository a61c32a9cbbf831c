// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_contour_stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "boreholes/errors.h"
#include "io/checked_json.h"
#include "io/contour_features.h"
#include "io/contour_table.h"
#include "io/read_table.h"
#include "io/table_layout.h"
#include "io/text_scanner.h"

namespace stratareeb {

namespace {

using Json = nlohmann::json;

std::string lower_extension(const std::string& file) {
    std::string extension = std::filesystem::path(file).extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

//! Points of two numbers, or of three if the last is the contour's height.
void read_points(const JsonItem& list, StackContour& contour) {
    for (const JsonItem& item : list.list("a list of points")) {
        const auto numbers = item.numbers();
        if (!numbers) continue;
        if (numbers->size() != 2 && !(numbers->size() == 3 && numbers->back() == contour.z))
            item.expected("two numbers [x, y], their height is the contour's z");
        else
            contour.points.push_back({(*numbers)[0], (*numbers)[1]});
    }
}

bool is_open(const Json& contour) {
    return contour.contains("closed") && contour["closed"] == false;
}

ContourStack stack_of(const Json& document, const std::string& file, const ReadContourStackOptions& options) {
    FileFaults faults(file);
    const JsonItem top(document, "", faults);
    ContourStack stack;
    if (document.is_object() && document.contains("direction"))
        throw InvalidInput(file +
                           ": its contours are sections across another direction; cut horizontal levels");
    const auto list = top.need_object("an object with a list of contours") ? top.need("contours")
                                                                           : std::optional<JsonItem>();
    const std::vector<JsonItem> items = list ? list->list("a list of contours") : std::vector<JsonItem>{};
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (!items[i].need_object("a contour with z and points")) continue;
        const bool open = is_open(document["contours"][i]);
        if (open && options.leave_out_open) continue;
        if (open)
            items[i].fault(
                "is open; a body has closed contours: leave it out, or cut levels of a closed mesh");
        StackContour& contour = stack.contours.emplace_back();
        contour.name = items[i].place();
        if (const auto z = items[i].need("z")) contour.z = z->number().value_or(0);
        if (const auto points = items[i].need("points")) read_points(*points, contour);
    }
    faults.throw_if_any();
    if (stack.contours.empty()) throw InvalidInput(file + ": there is no closed contour in it");
    return stack;
}

bool is_geojson(const Json& document) {
    return document.is_object() && document.contains("type") && !document.contains("contours");
}

bool is_table(const std::string& extension) {
    constexpr std::array<std::string_view, 8> kTables{".csv", ".tsv",  ".txt", ".dat",
                                                      ".xyz", ".xlsx", ".xls", ".ods"};
    return std::ranges::find(kTables, extension) != kTables.end();
}

//! Has it a column of geometry as text?
bool has_well_known_text(const TextTable& table) {
    const TableShape shape = table_shape(table, {});
    return shape.has_header && std::ranges::any_of(shape.names, [](const std::string& name) {
               const std::string plain = normal_name(name);
               return plain == "wkt" || plain == "geometry" || plain == "geom" || plain == "the_geom";
           });
}

}  // namespace

ContourStack read_contour_stack(const std::string& file, const ReadContourStackOptions& options) {
    const std::string extension = lower_extension(file);
    if (extension == ".json") {
        const std::string content = file_content(file);
        const Json document = parse_json(content, file);
        if (!is_geojson(document)) return stack_of(document, file, options);
    } else if (is_table(extension)) {
        const std::vector<TextTable> tables = read_tables(file);
        if (!has_well_known_text(tables.front())) return contours_of_table(tables.front(), options);
    }
    return read_contour_features(file, options);
}

}  // namespace stratareeb
