// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/map_output.h"

#include <fmt/format.h>

#include "boreholes/errors.h"
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
