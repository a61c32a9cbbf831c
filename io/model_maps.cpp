// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boreholes/errors.h"
#include "io/axis_ticks.h"
#include "mesh/plan_areas.h"
#include "mesh/triangle_soup.h"
#include "reeb/level_set.h"

namespace stratareeb {

namespace {

//! The plan's part where the layer is, with the field of its vertices.
struct PartOfPlan {
    TriMesh mesh;
    ScalarField field;
};

PartOfPlan part_of(const LayerModel& model, const std::vector<double>& field,
                   std::optional<std::size_t> layer) {
    const TriMesh& plan = model.plan.surface;
    constexpr std::uint32_t kNone = ~0u;
    std::vector<std::uint32_t> number(plan.n_vertices(), kNone);
    PartOfPlan part;
    TriangleSoup soup;
    for (const auto f : plan.faces()) {
        if (layer && !model.regions.in_face[static_cast<std::size_t>(f.idx())][*layer]) continue;
        std::array<std::uint32_t, 3> corners{};
        std::size_t i = 0;
        for (const auto v : plan.fv_range(f)) {
            auto& n = number[static_cast<std::size_t>(v.idx())];
            if (n == kNone) {
                n = static_cast<std::uint32_t>(soup.points.size());
                const auto& p = plan.point(v);
                soup.points.push_back({p[0] + model.origin.x, p[1] + model.origin.y, 0});
                part.field.push_back(field[static_cast<std::size_t>(v.idx())]);
            }
            corners[i++] = n;
        }
        soup.triangles.push_back(corners);
    }
    part.mesh = half_edge_mesh(soup);
    return part;
}

std::vector<double> round_levels(const ScalarField& field, double interval) {
    constexpr double kMost = 10'000;
    if (!(interval > 0) || !std::isfinite(interval))
        throw InvalidInput(fmt::format("a contour interval of {}: give a length above 0", interval));
    std::vector<double> levels;
    if (field.empty()) return levels;
    const auto [low, high] = std::ranges::minmax(field);
    if ((high - low) / interval > kMost)
        throw InvalidInput(
            fmt::format("a contour interval of {} makes {:.0f} values between {:.6g} and {:.6g}; "
                        "give a larger one",
                        interval, (high - low) / interval, low, high));
    for (double k = std::ceil(low / interval); k * interval <= high; ++k)
        levels.push_back(k * interval + 0.0);
    return levels;
}

//! The same everywhere but for rounding: its lines would be noise.
bool is_level(double low, double high) {
    constexpr double kRounding = 1e-9;
    return !(high - low > kRounding * std::max(std::abs(low), std::abs(high)));
}

}  // namespace

std::vector<double> mapped_field(const LayerModel& model, MapSubject subject, std::size_t layer) {
    const std::size_t horizon = subject == MapSubject::Ground ? 0
                                : subject == MapSubject::Base ? layer + 1
                                                              : layer;
    std::vector<double> field = model.horizons[horizon];
    for (std::size_t v = 0; v < field.size(); ++v)
        field[v] = subject == MapSubject::Thickness ? model.thickness(layer, v) : field[v] + model.origin.z;
    return field;
}

std::vector<char> layer_vertices(const LayerModel& model, std::size_t layer) {
    std::vector<char> use(model.plan.surface.n_vertices(), 0);
    for (const auto f : model.plan.surface.faces())
        if (model.regions.in_face[static_cast<std::size_t>(f.idx())][layer])
            for (const auto v : model.plan.surface.fv_range(f)) use[static_cast<std::size_t>(v.idx())] = 1;
    return use;
}

double suitable_interval(const std::vector<double>& field, const std::vector<char>& use) {
    constexpr double kLines = 12;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (std::size_t v = 0; v < field.size(); ++v)
        if (use.empty() || use[v]) {
            low = std::min(low, field[v]);
            high = std::max(high, field[v]);
        }
    return is_level(low, high) ? 1 : round_step((high - low) / kLines);
}

std::vector<ContourLine> contour_lines(const LayerModel& model, MapSubject subject, std::size_t layer,
                                       double interval) {
    return contour_lines(model, mapped_field(model, subject, layer),
                         subject == MapSubject::Ground ? std::nullopt : std::optional(layer), interval);
}

std::vector<ContourLine> contour_lines(const LayerModel& model, const std::vector<double>& field,
                                       std::optional<std::size_t> layer, double interval) {
    const PartOfPlan part = part_of(model, field, layer);
    std::vector<ContourLine> lines;
    const auto [low, high] = std::ranges::minmax(part.field);
    if (is_level(low, high)) return lines;
    const std::vector<double> levels = round_levels(part.field, interval);
    if (levels.empty()) return lines;
    for (const LevelSet& set : level_sets(part.mesh, part.field, levels))
        for (const Contour& contour : set.contours) {
            ContourLine line{.value = set.level, .closed = contour.closed, .points = {}};
            for (const Point3& p : contour.points)
                if (line.points.empty() || !(line.points.back() == Point2{p.x, p.y}))
                    line.points.push_back({p.x, p.y});
            if (line.points.size() > 1) lines.push_back(std::move(line));
        }
    return lines;
}

std::vector<MapArea> layer_areas(const LayerModel& model, std::size_t layer) {
    std::vector<MapArea> areas;
    for (auto& area : plan_areas(
             model, [&](std::size_t face) { return model.regions.in_face[face][layer] ? layer : kNoLabel; }))
        areas.push_back({std::move(area.rings), layer});
    return areas;
}

std::string subject_words(const LayerModel& model, MapSubject subject, std::size_t layer) {
    const char* what = subject == MapSubject::Top    ? "top"
                       : subject == MapSubject::Base ? "base"
                                                     : "thickness";
    if (subject == MapSubject::Ground) return fmt::format("elevation of the ground [{}]", model.length_unit);
    return fmt::format("{} of {} [{}]", what, model.units[layer].name, model.length_unit);
}

}  // namespace stratareeb
