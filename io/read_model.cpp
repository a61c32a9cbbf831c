// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "boreholes/errors.h"
#include "io/checked_json.h"
#include "io/model_holes.h"
#include "io/read_ply.h"
#include "io/text_scanner.h"
#include "io/write_model.h"
#include "mesh/thickness_regions.h"
#include "mesh/triangle_soup.h"

namespace stratareeb {

namespace {

namespace fs = std::filesystem;

//! What model.json says that the horizons don't.
struct Description {
    std::vector<Unit> units;
    Point3 origin;
    std::string length_unit, crs;
    double spacing = 0;
    std::size_t fault_blocks = 0;
    std::vector<std::string> horizons;  // paths in the folder, ground first
};

std::string needed_text(const JsonItem& item, std::string_view key) {
    const auto member = item.need(key);
    return member ? member->text().value_or("") : "";
}

Description description(const fs::path& file) {
    const nlohmann::json json = parse_json(file_content(file), file.string());
    FileFaults faults(file.string());
    const JsonItem root(json, "", faults);
    Description description;
    if (root.need_object("a model")) {
        description.length_unit = needed_text(root, "length_unit");
        description.horizons.push_back(needed_text(root, "ground"));
        if (const auto blocks = root.find("fault_blocks"))
            description.fault_blocks = static_cast<std::size_t>(std::max(blocks->number().value_or(0), 0.0));
        if (const auto crs = root.find("crs")) description.crs = crs->text().value_or("");
        if (const auto spacing = root.find("spacing")) description.spacing = spacing->number().value_or(0);
        if (const auto origin = root.need("origin")) {
            const auto xyz = origin->numbers();
            if (xyz && xyz->size() == 3)
                description.origin = {(*xyz)[0], (*xyz)[1], (*xyz)[2]};
            else if (xyz)
                origin->expected("three numbers");
        }
        if (const auto units = root.need("units"))
            for (const JsonItem& unit : units->list("units")) {
                if (!unit.need_object("a unit")) continue;
                description.units.push_back(
                    {needed_text(unit, "code"), needed_text(unit, "name"), needed_text(unit, "color")});
                description.horizons.push_back(needed_text(unit, "base"));
            }
    }
    faults.throw_if_any();
    if (description.units.empty()) throw InvalidInput(file.string() + ": a model without units");
    if (description.units.size() > kMaxLayers)
        throw InvalidInput(
            fmt::format("{}: {} units, more than {}", file.string(), description.units.size(), kMaxLayers));
    return description;
}

void check_same_plan(const TriangleSoup& ground, const TriangleSoup& other, const fs::path& file) {
    const auto same_plan = [](const Point3& a, const Point3& b) { return a.x == b.x && a.y == b.y; };
    if (ground.triangles != other.triangles || !std::ranges::equal(ground.points, other.points, same_plan))
        throw InvalidInput(
            file.string() +
            ": not the same points in x, y and triangles as the ground; build the model again");
}

std::vector<double> elevations(const TriangleSoup& soup) {
    std::vector<double> z;
    z.reserve(soup.points.size());
    for (const Point3& p : soup.points) z.push_back(p.z);
    return z;
}

void check_order(const LayerModel& model, const Description& description, const fs::path& folder) {
    for (std::size_t i = 0; i < model.units.size(); ++i)
        for (std::size_t v = 0; v < model.horizons[i].size(); ++v)
            if (model.thickness(i, v) < 0)
                throw InvalidInput(
                    fmt::format("{}: above the horizon over it at vertex {}; build the model again",
                                (folder / description.horizons[i + 1]).string(), v));
}

Description description_in(const fs::path& folder) {
    if (!fs::is_directory(folder))
        throw IoError(fmt::format("{}: not a folder; give the one that `build` wrote", folder.string()));
    if (!fs::exists(folder / "model.json"))
        throw InvalidInput(
            fmt::format("{}: no model.json; give the folder that `build` wrote", folder.string()));
    return description(folder / "model.json");
}

//! The layers between the surfaces that a description names.
LayerModel layers_of(const Description& description, const fs::path& folder) {
    LayerModel model;
    model.units = description.units;
    model.origin = description.origin;
    model.length_unit = description.length_unit;
    model.spacing = description.spacing;
    TriangleSoup plan;
    for (const std::string& name : description.horizons) {
        const fs::path file = folder / name;
        TriangleSoup soup = read_ply(file).soup;
        model.horizons.push_back(elevations(soup));
        if (model.horizons.size() == 1)
            plan = std::move(soup);
        else
            check_same_plan(plan, soup, file);
    }
    if (plan.triangles.empty())
        throw InvalidInput((folder / description.horizons[0]).string() + ": no triangles");
    for (Point3& p : plan.points) p.z = 0;
    model.plan.surface = half_edge_mesh(plan);
    check_order(model, description, folder);
    model.regions = regions_of_thickness(model.plan.surface, model.horizons);
    if (description.fault_blocks == 0) return model;
    model.seams = seams_of_pieces(model.plan.surface, model.horizons);
    if (model.seams.blocks != description.fault_blocks)
        throw InvalidInput(fmt::format(
            "{}: {} pieces, but model.json says {} fault blocks; build the model again",
            (folder / description.horizons[0]).string(), model.seams.blocks, description.fault_blocks));
    return model;
}

}  // namespace

SavedModel read_model(const fs::path& folder) {
    SavedModel saved;
    const Description description = description_in(folder);
    saved.model = layers_of(description, folder);
    saved.crs = description.crs;
    LayerModel& model = saved.model;
    if (fs::exists(folder / kModelHolesFile)) {
        ModelHoles holes =
            read_model_holes(folder / kModelHolesFile, model.units, model.plan.surface.n_vertices());
        saved.survey = std::move(holes.survey);
        model.plan.hole_vertex = std::move(holes.vertex);
    }
    saved.survey.units = model.units;
    saved.survey.length_unit = model.length_unit;
    for (const Borehole& hole : saved.survey.holes)
        model.columns.sites.push_back({hole.at.x - model.origin.x, hole.at.y - model.origin.y});
    return saved;
}

std::optional<LayerModel> read_unrefined(const fs::path& folder) {
    Description before = description_in(folder);
    for (std::string& name : before.horizons)
        name = (fs::path(kUnrefinedFolder) / fs::path(name).filename()).string();
    if (!fs::exists(folder / before.horizons.front())) return std::nullopt;
    return layers_of(before, folder);
}

}  // namespace stratareeb
