// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/model_summary.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mesh/analysis.h"
#include "mesh/compensated_sum.h"

namespace stratareeb {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr double kVolumeTolerance = 1e-9;   // of the envelope
constexpr double kContactTolerance = 1e-9;  // of the model's size

void count_holes(UnitSummary& summary, std::size_t layer, const Survey& survey) {
    for (const Borehole& hole : survey.holes) {
        const LayerFact fact = layer < hole.layers.size() ? hole.layers[layer] : LayerFact{};
        summary.holes_present += fact.is_present();
        summary.holes_at_least += fact.knowledge == Knowledge::AtLeast;
        summary.holes_absent += fact.is_absent();
        summary.holes_unknown += fact.knowledge == Knowledge::Unknown;
    }
}

void measure_in_plan(UnitSummary& summary, const LayerModel& model, std::size_t layer) {
    CompensatedSum plan_area;
    const auto& mesh = model.plan.surface;
    for (const auto f : mesh.faces()) {
        if (!model.regions.in_face[static_cast<std::size_t>(f.idx())][layer]) continue;
        plan_area.add(mesh.calc_face_area(f));
        for (const auto v : mesh.fv_range(f))
            summary.max_thickness =
                std::max(summary.max_thickness, model.thickness(layer, static_cast<std::size_t>(v.idx())));
    }
    summary.plan_area = plan_area.value();
    if (summary.plan_area > 0) summary.mean_thickness = summary.volume / summary.plan_area;
}

double model_size(const LayerModel& model) {
    double low = model.horizons[0][0], high = low;
    for (const auto& horizon : {model.horizons.front(), model.horizons.back()})
        for (const double z : horizon) low = std::min(low, z), high = std::max(high, z);
    double x0 = 0, x1 = 0, y0 = 0, y1 = 0;
    for (const auto v : model.plan.surface.vertices()) {
        const auto& p = model.plan.surface.point(v);
        x0 = std::min(x0, p[0]), x1 = std::max(x1, p[0]), y0 = std::min(y0, p[1]), y1 = std::max(y1, p[1]);
    }
    return std::max({high - low, x1 - x0, y1 - y0});
}

ModelCheck plan_is_unfolded(const LayerModel& model) {
    const auto& mesh = model.plan.surface;
    std::size_t folded = 0;
    for (const auto f : mesh.faces()) {
        std::array<Kernel::Point_2, 3> corner;
        int k = 0;
        for (const auto v : mesh.fv_range(f)) corner[k++] = {mesh.point(v)[0], mesh.point(v)[1]};
        folded += CGAL::orientation(corner[0], corner[1], corner[2]) != CGAL::LEFT_TURN;
    }
    return {"plan_unfolded", folded == 0,
            fmt::format("{} of {} plan triangles folded or flat", folded, mesh.n_faces())};
}

ModelCheck horizons_are_ordered(const LayerModel& model) {
    std::size_t crossings = 0;
    for (std::size_t i = 0; i + 1 < model.horizons.size(); ++i)
        for (std::size_t v = 0; v < model.horizons[i].size(); ++v) crossings += !(model.thickness(i, v) >= 0);
    return {"horizons_ordered", crossings == 0,
            fmt::format("{} places where a horizon lies above the one over it", crossings)};
}

ModelCheck solids_are_watertight(const LayerModel& model, const std::vector<UnitSummary>& units) {
    std::string which;
    for (std::size_t i = 0; i < units.size(); ++i)
        if (!units[i].watertight)
            which += (which.empty() ? "" : "; ") + model.units[i].code + ": " +
                     (units[i].problems.empty() ? "" : units[i].problems.front());
    return {"solids_watertight", which.empty(),
            which.empty() ? "closed, 2-manifold, outward, no self-intersection, no triangle without area"
                          : which};
}

ModelCheck volumes_add_up(const LayerModel& model, const std::vector<UnitSummary>& units) {
    CompensatedSum sum;
    for (const auto& unit : units) sum.add(unit.volume);
    const double envelope = envelope_volume(model);
    const double off = std::abs(sum.value() - envelope) / envelope;
    return {"volumes_add_up", off <= kVolumeTolerance,
            fmt::format("relative difference to the envelope {:.2g}", off)};
}

ModelCheck contacts_are_honoured(const LayerModel& model, const Survey& survey) {
    const Misfit misfit = misfit_of(model, survey);
    const double size = model_size(model);
    return {"contacts_honoured", misfit.max <= kContactTolerance * size,
            fmt::format("largest misfit {:.2g} {} over {} contacts", misfit.max, model.length_unit,
                        misfit.contacts)};
}

ModelCheck absent_layers_are_absent(const LayerModel& model, const Survey& survey) {
    std::size_t wrong = 0, known = 0;
    const double negligible = kContactTolerance * model_size(model);
    for (std::size_t h = 0; h < survey.holes.size(); ++h) {
        const auto v = model.plan.hole_vertex[h];
        if (v == PlanMesh::kNoVertex) continue;
        for (std::size_t i = 0; i < survey.holes[h].layers.size(); ++i) {
            const LayerFact& fact = survey.holes[h].layers[i];
            if (fact.knowledge == Knowledge::Unknown) continue;
            if (fact.is_present() && fact.thickness < negligible) continue;
            ++known;
            wrong += fact.is_absent() != (model.thickness(i, v) == 0);
        }
    }
    return {"absence_kept", wrong == 0,
            fmt::format("{} of {} layers known in holes are there against what the hole says", wrong, known)};
}

}  // namespace

UnitSummary summarize_unit(const LayerModel& model, const LayerSolid& solid, const Survey& survey) {
    UnitSummary summary;
    const std::size_t layer = solid.order - 1;
    count_holes(summary, layer, survey);
    summary.triangles = solid.surface.n_faces();
    if (summary.triangles == 0) return summary;
    const MeshReport report = analyze(solid.surface);
    summary.volume = report.volume;
    summary.area = report.area;
    summary.components = report.components;
    summary.genus = report.genus.value_or(0);
    summary.watertight = report.watertight;
    summary.problems = report.problems;
    measure_in_plan(summary, model, layer);
    return summary;
}

UnitSummary summarize_unit(const LayerModel& model, std::size_t layer, const std::vector<LayerSolid>& solids,
                           const Survey& survey) {
    if (solids.size() == 1 && solids[0].block == 0) return summarize_unit(model, solids[0], survey);
    UnitSummary summary;
    count_holes(summary, layer, survey);
    CompensatedSum volume, area;
    for (const LayerSolid& solid : solids) {
        const MeshReport report = analyze(solid.surface);
        summary.triangles += solid.surface.n_faces();
        volume.add(report.volume);
        area.add(report.area);
        summary.components += report.components;
        summary.genus += report.genus.value_or(0);
        summary.watertight &= report.watertight;
        for (const std::string& problem : report.problems)
            summary.problems.push_back(fmt::format("block {}: {}", solid.block, problem));
    }
    summary.volume = volume.value();
    summary.area = area.value();
    measure_in_plan(summary, model, layer);
    return summary;
}

Misfit misfit_of(const LayerModel& model, const Survey& survey) {
    Misfit misfit;
    CompensatedSum squares;
    for (std::size_t h = 0; h < survey.holes.size(); ++h) {
        const auto v = model.plan.hole_vertex[h];
        if (v == PlanMesh::kNoVertex) continue;
        const auto& contacts = survey.holes[h].horizons;
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            if (!contacts[k]) continue;
            const double off = std::abs(model.horizons[k][v] + model.origin.z - *contacts[k]);
            misfit.max = std::max(misfit.max, off);
            squares.add(off * off);
            ++misfit.contacts;
        }
    }
    if (misfit.contacts > 0) misfit.rms = std::sqrt(squares.value() / static_cast<double>(misfit.contacts));
    return misfit;
}

std::vector<ModelCheck> check_model(const LayerModel& model, const Survey& survey,
                                    const std::vector<UnitSummary>& units) {
    return {plan_is_unfolded(model),
            horizons_are_ordered(model),
            solids_are_watertight(model, units),
            volumes_add_up(model, units),
            contacts_are_honoured(model, survey),
            absent_layers_are_absent(model, survey)};
}

}  // namespace stratareeb
