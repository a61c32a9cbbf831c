// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/map_drawing.h"

#include <fmt/format.h>

#include <cmath>

#include "boreholes/errors.h"
#include "io/axis_ticks.h"
#include "mesh/plan_areas.h"
#include "mesh/ring_stitching.h"

namespace stratareeb {

PlanMap map_of(const SavedModel& saved, const std::string& title) {
    PlanMap map{.title = title, .length_unit = saved.model.length_unit};
    for (const Unit& unit : saved.model.units) map.legend.push_back({unit.name, rgb_from_text(unit.color)});
    for (const Borehole& hole : saved.survey.holes) map.points.push_back({hole.at, hole.id});
    map.outline = plan_outline(saved.model);
    return map;
}

std::vector<MapFeature> section_features(const std::vector<SectionPolygon>& polygons,
                                         const std::vector<Unit>& units) {
    std::vector<MapFeature> features;
    for (const SectionPolygon& polygon : polygons) {
        const Unit& unit = units[polygon.layer];
        MapFeature feature{.kind = MapFeature::Kind::Polygon,
                           .parts = {{}},
                           .layer = unit.code,
                           .color = unit.color,
                           .attributes = {{"unit", unit.name},
                                          {"order", static_cast<double>(polygon.layer + 1)},
                                          {"area", area(polygon)}}};
        for (const Point2& p : polygon.outline) feature.parts[0].push_back({p.x, p.y, 0});
        features.push_back(std::move(feature));
    }
    return features;
}

std::vector<MapFeature> area_features(const std::vector<MapArea>& areas, const std::vector<Unit>& units) {
    std::vector<MapFeature> features;
    for (const MapArea& area : areas) {
        const Unit& unit = units[area.entry];
        double size = 0;
        for (const auto& ring : area.rings) size += ring_area(ring);
        MapFeature feature{
            .kind = MapFeature::Kind::Polygon,
            .parts = {},
            .layer = unit.code,
            .color = unit.color,
            .attributes = {
                {"unit", unit.name}, {"order", static_cast<double>(area.entry + 1)}, {"area", size}}};
        for (const auto& ring : area.rings) {
            auto& part = feature.parts.emplace_back();
            for (const Point2& p : ring) part.push_back({p.x, p.y, 0});
        }
        features.push_back(std::move(feature));
    }
    return features;
}

namespace {

//! Lines of a field over the part of the plan that a map of the subject is about.
ContourMap contoured(const LayerModel& model, MapSubject subject, std::size_t layer, double interval,
                     std::vector<double> field) {
    const bool whole = subject == MapSubject::Ground;
    const std::vector<char> use = whole ? std::vector<char>{} : layer_vertices(model, layer);
    ContourMap map{.subject = subject,
                   .layer = layer,
                   .interval = interval,
                   .field = std::move(field),
                   .about = subject_words(model, subject, layer),
                   .is_elevation = subject != MapSubject::Thickness,
                   .lines = {},
                   .areas = {}};
    if (!whole) map.areas = layer_areas(model, layer);
    if (!whole && map.areas.empty())
        throw InvalidInput(
            fmt::format("unit '{}' is absent everywhere; there is nothing to map", model.units[layer].code));
    if (!(interval > 0)) map.interval = suitable_interval(map.field, use);
    map.lines = contour_lines(model, map.field, whole ? std::nullopt : std::optional(layer), map.interval);
    return map;
}

PredictedQuantity quantity_of(MapSubject subject, std::size_t layer) {
    switch (subject) {
        case MapSubject::Thickness:
            return {.thickness = true, .index = layer};
        case MapSubject::Base:
            return {.thickness = false, .index = layer + 1};
        case MapSubject::Top:
            return {.thickness = false, .index = layer};
        case MapSubject::Ground:
            break;
    }
    return {};
}

}  // namespace

ContourMap contour_map(const LayerModel& model, MapSubject subject, std::size_t layer, double interval) {
    return contoured(model, subject, layer, interval, mapped_field(model, subject, layer));
}

ContourMap spread_map(const SavedModel& saved, MapSubject subject, std::size_t layer, Spread spread,
                      const ErrorSpreadOptions& options, double interval) {
    const std::string words = subject_words(saved.model, subject, layer);
    ErrorSpread error;
    try {
        error = error_spread(saved.model, saved.survey, quantity_of(subject, layer), spread, options);
    } catch (const InvalidInput& fault) {
        throw InvalidInput(words + ": " + fault.what());
    }
    ContourMap map = contoured(saved.model, subject, layer, interval, std::move(error.size));
    map.is_elevation = false;
    map.about = spread == Spread::Deviation
                    ? "standard deviation of the " + words
                    : fmt::format("{} %{} interval, ±, of the {}", 100 * options.confidence,
                                  error.certain ? "" : " (too few boreholes: largest error)", words);
    return map;
}

PlanMap drawn_map(const SavedModel& saved, const ContourMap& contours, const std::string& title) {
    const std::string& about = contours.about;
    PlanMap map = map_of(saved, title.empty() ? about : title);
    map.areas = contours.areas;
    map.note = fmt::format("{}lines every {:g} {}", title.empty() ? "" : about + ", ", contours.interval,
                           saved.model.length_unit);
    constexpr int kBoldEvery = 5;
    for (const ContourLine& line : contours.lines) {
        const bool bold = std::llround(line.value / contours.interval) % kBoldEvery == 0;
        map.lines.push_back({line.points, line.closed, tick_text(line.value, contours.interval), bold});
    }
    return map;
}

PlanMap geology_drawing(const SavedModel& saved, const std::vector<MapArea>& areas,
                        const std::string& title) {
    PlanMap map = map_of(saved, title.empty() ? "units at the ground" : title);
    map.areas = areas;
    return map;
}

std::vector<MapArea> geology_areas(const LayerModel& model) {
    std::vector<MapArea> areas;
    for (auto& area : geological_map(model)) areas.push_back({std::move(area.rings), area.label});
    return areas;
}

std::vector<MapFeature> line_features(const LayerModel& model, const ContourMap& contours) {
    std::vector<MapFeature> features;
    for (const ContourLine& line : contours.lines) {
        MapFeature feature{
            .kind = MapFeature::Kind::Line,
            .parts = {{}},
            .layer = contours.subject == MapSubject::Ground ? "ground" : model.units[contours.layer].code,
            .color = "#404040",
            .attributes = {{"value", line.value}, {"closed", line.closed ? 1.0 : 0.0}}};
        const double z = contours.is_elevation ? line.value : 0;
        for (const Point2& p : line.points) feature.parts[0].push_back({p.x, p.y, z});
        if (line.closed) feature.parts[0].push_back(feature.parts[0].front());
        features.push_back(std::move(feature));
    }
    return features;
}

std::size_t unit_by_name(const LayerModel& model, const std::string& name) {
    std::string known;
    for (std::size_t i = 0; i < model.units.size(); ++i) {
        if (model.units[i].code == name || model.units[i].name == name) return i;
        known += (i > 0 ? ", " : "") + model.units[i].code;
    }
    for (std::size_t i = 0; i < model.units.size(); ++i)
        if (std::to_string(i + 1) == name) return i;
    throw InvalidInput(fmt::format("the model has no unit '{}'; it has {}", name, known));
}

}  // namespace stratareeb
