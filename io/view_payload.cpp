// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/view_payload.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "io/checked_json.h"
#include "io/text_scanner.h"
#include "io/view_graphs.h"
#include "io/view_order.h"
#include "io/view_streams.h"

namespace stratareeb {

namespace {

using nlohmann::json;

//! Tenths of a millimetre (or of a thousandth of a foot) are enough to draw and print.
double rounded(double value) {
    constexpr double kDigits = 1e4;
    return std::round(value * kDigits) / kDigits;
}

//! The layers that a hole was drilled through, downwards from where it knows an elevation.
json intervals_of(const Borehole& hole, double origin_z) {
    json intervals = json::array();
    std::optional<double> top;
    for (std::size_t i = 0; i < hole.layers.size(); ++i) {
        if (hole.horizons[i]) top = hole.horizons[i];
        std::optional<double> base = hole.horizons[i + 1];
        const LayerFact& fact = hole.layers[i];
        if (!base && top && fact.knowledge != Knowledge::Unknown) base = *top - fact.thickness;
        if (top && base && *base < *top)
            intervals.push_back({i, rounded(*top - origin_z), rounded(*base - origin_z),
                                 fact.knowledge == Knowledge::AtLeast ? 0 : 1});
        top = fact.knowledge == Knowledge::AtLeast ? std::nullopt : base;
    }
    return intervals;
}

json holes_of(const SavedModel& saved) {
    json holes = json::array();
    const Point3& origin = saved.model.origin;
    for (const Borehole& hole : saved.survey.holes) {
        json intervals = intervals_of(hole, origin.z);
        json top;
        if (!hole.horizons.empty() && hole.horizons[0])
            top = rounded(*hole.horizons[0] - origin.z);
        else if (!intervals.empty())
            top = intervals[0][1];
        holes.push_back({{"id", hole.id},
                         {"x", rounded(hole.at.x - origin.x)},
                         {"y", rounded(hole.at.y - origin.y)},
                         {"top", std::move(top)},
                         {"intervals", std::move(intervals)}});
    }
    return holes;
}

json units_of(const LayerModel& model, const std::filesystem::path& summary) {
    json from;
    if (!summary.empty()) from = parse_json(file_content(summary), summary.string());
    json units = json::array();
    for (std::size_t i = 0; i < model.units.size(); ++i) {
        json unit{
            {"code", model.units[i].code}, {"name", model.units[i].name}, {"color", model.units[i].color}};
        for (const char* key : {"volume", "plan_area", "mean_thickness", "max_thickness"})
            if (from.contains("units") && from["units"].size() == model.units.size() &&
                from["units"][i].contains(key) && from["units"][i][key].is_number())
                unit[key] = from["units"][i][key];
        units.push_back(std::move(unit));
    }
    return units;
}

std::string four_bytes(std::size_t number) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>((number >> (8 * i)) & 255);
    return bytes;
}

}  // namespace

std::string view_payload(const SavedModel& saved, const ViewPayloadOptions& options) {
    const LayerModel model = in_view_order(saved.model);
    const LayerModel straight = in_view_order(straight_between_holes(model));
    ViewStreams streams;
    json header{{"format", "stratareeb view 1"},
                {"title", options.title},
                {"report", options.report},
                {"length_unit", model.length_unit},
                {"origin", {model.origin.x, model.origin.y, model.origin.z}},
                {"units", units_of(model, options.summary)},
                {"holes", holes_of(saved)},
                {"model", view_surfaces(model, streams)}};
    header["straight"] = straight.plan.surface.n_faces() > 0 ? view_surfaces(straight, streams) : json();
    header["unrefined"] =
        options.unrefined ? view_surfaces(in_view_order(*options.unrefined), streams) : json();
    header["graphs"] = view_graphs(model, streams);
    const std::string text = header.dump(-1, ' ', false, json::error_handler_t::replace);
    return four_bytes(text.size()) + text + streams.bytes();
}

}  // namespace stratareeb
