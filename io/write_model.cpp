// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_model.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/write_choice.h"

namespace stratareeb {

namespace {

using Json = nlohmann::ordered_json;

Json unit_json(const LayerModel& model, std::size_t i, const UnitSummary& summary) {
    const Unit& unit = model.units[i];
    const auto horizon = [&](std::size_t k) {
        return kHorizonsFolder + numbered_name(k, k == 0 ? "ground" : model.units[k - 1].name) + ".ply";
    };
    const bool absent = summary.triangles == 0;
    return {{"order", i + 1},
            {"code", unit.code},
            {"name", unit.name},
            {"color", unit.color},
            {"volume", summary.volume},
            {"area", summary.area},
            {"plan_area", summary.plan_area},
            {"mean_thickness", summary.mean_thickness},
            {"max_thickness", summary.max_thickness},
            {"triangles", summary.triangles},
            {"components", summary.components},
            {"genus", summary.genus},
            {"solid", absent ? Json() : Json("layers/" + numbered_name(i + 1, unit.name) + ".ply")},
            {"top", horizon(i)},
            {"base", horizon(i + 1)},
            {"holes_present", summary.holes_present},
            {"holes_absent", summary.holes_absent},
            {"holes_unknown", summary.holes_unknown},
            {"holes_at_least", summary.holes_at_least}};
}

//! Solids of a faulted model: `solid` is the one of the first block that has the layer.
void set_solids(Json& unit, const std::vector<std::string>& solids) {
    unit["solid"] = solids.empty() ? Json() : Json(solids.front());
    unit["solids"] = solids;
}

Json smoothness_json(const SmoothnessReport& report) {
    const auto values = [](const Smoothness& s) {
        return Json{{"largest_jump_deg", s.largest_jump_deg}, {"bending_energy", s.bending_energy}};
    };
    return {{"levels", report.levels},
            {"before", values(report.before)},
            {"after", values(report.after)},
            {"straightened", report.straightened},
            {"largest_misfit", report.largest_misfit},
            {"thinnest", report.thinnest}};
}

Json cad_json(const std::vector<SmoothBodyReport>& bodies) {
    Json json = Json::array();
    for (const auto& body : bodies)
        json.push_back({{"name", body.name},
                        {"smooth", body.smooth},
                        {"faces", body.faces},
                        {"distance", body.off},
                        {"edge_distance", body.edge_off},
                        {"volume", body.volume},
                        {"mesh_volume", body.mesh_volume}});
    return json;
}

}  // namespace

std::string numbered_name(std::size_t number, const std::string& name) {
    std::string safe;
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           c == '-' || c == '.';
        if (plain)
            safe += c;
        else if (!safe.empty() && safe.back() != '_')
            safe += '_';
    }
    while (!safe.empty() && (safe.back() == '_' || safe.back() == '.')) safe.pop_back();
    constexpr std::size_t kLongest = 60;
    return fmt::format("{:02}_{}", number, safe.empty() ? "layer" : safe.substr(0, kLongest));
}

std::string model_json(const LayerModel& model, const Survey& survey, const ModelRecord& record) {
    const Misfit misfit = misfit_of(model, survey);
    Json json{{"format", "stratareeb model 1"},
              {"boreholes", survey.holes.size()},
              {"length_unit", model.length_unit},
              {"origin", {model.origin.x, model.origin.y, model.origin.z}},
              {"envelope_volume", envelope_volume(model)},
              {"spacing", model.spacing},
              {"plan_vertices", model.plan.surface.n_vertices()},
              {"plan_triangles", model.plan.surface.n_faces()},
              {"ground", "horizons/00_ground.ply"}};
    if (!record.crs.empty()) json["crs"] = record.crs;
    json["units"] = Json::array();
    for (std::size_t i = 0; i < record.units.size(); ++i)
        json["units"].push_back(unit_json(model, i, record.units[i]));
    if (!model.seams.empty()) {
        json["fault_blocks"] = model.seams.blocks;
        for (std::size_t i = 0; i < record.solids.size(); ++i) set_solids(json["units"][i], record.solids[i]);
    }
    json["checks"] = Json::array();
    for (const auto& check : record.checks)
        json["checks"].push_back({{"name", check.name}, {"ok", check.ok}, {"detail", check.detail}});
    json["misfit"] = {{"max", misfit.max}, {"rms", misfit.rms}, {"contacts", misfit.contacts}};
    if (record.smoothness) json["smoothness"] = smoothness_json(*record.smoothness);
    if (!record.cad.empty()) json["cad"] = cad_json(record.cad);
    if (record.choice) json["auto"] = choice_json(*record.choice);
    json["options"] = record.options;
    json["warnings"] = record.warnings;
    json["files"] = record.files;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace stratareeb
