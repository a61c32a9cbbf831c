// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/smooth_bodies.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <BRepCheck_Analyzer.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "boreholes/errors.h"
#include "io/faceted_bodies.h"
#include "io/smooth_shapes.h"
#include "subdivision/strip_cells.h"

namespace stratareeb {
namespace {

constexpr double kIntegrationShare =
    0.2;  // of the volume that a body may be off, for how CAD programs integrate
constexpr std::size_t kSpansAStrip[] = {14, 7};

class Maker {
 public:
    Maker(const LayerModel& model, const SmoothBodiesOptions& options)
        : model_(model), options_(options), brep_(build_smooth_brep(model, options.fit)) {}

    SmoothBodies make() {
        examine_all();
        hold_lines();
        for (const std::size_t spans : kSpansAStrip) {
            const auto sheets = badly_integrated();
            if (std::ranges::count(sheets, 1) == 0) break;
            cut_into_strips(brep_, sheets, spans);
            examine_all();
        }
        SmoothBodies result;
        std::map<std::uint32_t, std::size_t> bodies_of_layer;
        for (std::size_t b = 0; b < shapes_.size(); ++b) {
            const auto layer = brep_.cells.bodies[b].layer;
            const Unit& unit = model_.units[layer];
            CadBody body{.name = body_name(unit, bodies_of_layer[layer]++),
                         .color = rgb_from_text(unit.color),
                         .solid = shapes_[b]};
            if (!faults_[b].empty()) {
                result.notes.push_back(fmt::format("'{}' is made of facets: {}", body.name, faults_[b]));
                body.solid = facets(b);
            } else if (brep_.quality[b].off > options_.worth_telling * brep_.size) {
                result.notes.push_back(fmt::format(
                    "'{}': its smooth faces are up to {:.3g} off the triangles where these are steepest",
                    body.name, brep_.quality[b].off));
            }
            result.reports.push_back({.name = body.name,
                                      .smooth = faults_[b].empty(),
                                      .faces = count_faces(*body.solid),
                                      .off = faults_[b].empty() ? brep_.quality[b].off : 0,
                                      .edge_off = faults_[b].empty() ? brep_.quality[b].edge_off : 0,
                                      .volume = faults_[b].empty() ? volumes_[b] : cad_volume(*body.solid),
                                      .mesh_volume = brep_.quality[b].mesh_volume});
            result.bodies.push_back(std::move(body));
        }
        return result;
    }

 private:
    // Lines that were moved may touch where many meet closely: then they stay where the model has them, if that is better.
    void hold_lines() {
        const auto before = std::ranges::count(is_valid_, 0);
        if (before == 0) return;
        SmoothBrepOptions steady = options_.fit;
        steady.snap_lines = false;
        SmoothBrep moved = std::exchange(brep_, rebuild_smooth_brep(model_, brep_.horizons, steady));
        examine_all();
        if (std::ranges::count(is_valid_, 0) < before) return;
        brep_ = std::move(moved);
        examine_all();
    }

    void examine_all() {
        shapes_ = smooth_shapes(brep_);
        faults_.assign(shapes_.size(), {});
        is_valid_.assign(shapes_.size(), 1);
        volumes_.assign(shapes_.size(), 0);
        tbb::parallel_for(std::size_t{0}, shapes_.size(), [&](std::size_t b) { examine(b, *shapes_[b]); });
    }

    // Sheets of bodies whose volume comes out wrong because their faces have too many spans.
    std::vector<char> badly_integrated() const {
        std::vector<char> sheets(brep_.horizons.sheets.size(), 0);
        for (std::size_t b = 0; b < shapes_.size(); ++b) {
            const auto& quality = brep_.quality[b];
            const double off = std::abs(volumes_[b] - quality.volume) / quality.mesh_volume;
            if (off <= kIntegrationShare * options_.volume_tolerance) continue;
            for (const auto* faces : {&brep_.cells.bodies[b].top, &brep_.cells.bodies[b].base})
                for (const auto c : *faces) sheets[brep_.horizons.of_cell[c]] = 1;
        }
        return sheets;
    }

    void examine(std::size_t b, const TopoDS_Shape& shape) {
        const auto& quality = brep_.quality[b];
        faults_[b] = fault_of(quality);
        try {
            volumes_[b] = cad_volume(shape);
            if (faults_[b].empty() && !BRepCheck_Analyzer(shape).IsValid()) {
                faults_[b] = "smooth faces make no valid solid of it";
                is_valid_[b] = 0;
            }
        } catch (const Standard_Failure& e) {
            faults_[b] = fmt::format("OpenCASCADE can't check its smooth faces ({})", e.GetMessageString());
        }
        if (!faults_[b].empty()) return;
        const double off = std::abs(volumes_[b] - quality.mesh_volume) / quality.mesh_volume;
        if (!(off <= options_.volume_tolerance))
            faults_[b] = fmt::format("smooth faces would change its volume by {:.2g} %", 100 * off);
    }

    std::string fault_of(const SmoothBrep::BodyQuality& quality) const {
        if (!(quality.least_thickness > 0)) return "its smooth top and base would cross";
        if (!(quality.off <= options_.most_off * brep_.size))
            return fmt::format("smooth faces would be {:.3g} off", quality.off);
        if (!(quality.edge_off <= options_.most_edge_off * brep_.size))
            return fmt::format("smooth faces would meet only to {:.3g}", quality.edge_off);
        return {};
    }

    // The planar solid of the same part of the layer. Its faces over the body's first triangle tell which it is.
    std::shared_ptr<const TopoDS_Shape> facets(std::size_t b) const {
        LayerModel part;
        const auto& body = brep_.cells.bodies[b];
        part.units = model_.units;
        part.origin = model_.origin;
        part.plan = model_.plan;
        part.horizons = model_.horizons;
        part.regions.zero_at = model_.regions.zero_at;
        part.regions.in_face.resize(model_.regions.in_face.size());
        for (const auto f : body.faces) part.regions.in_face[f][body.layer] = true;
        auto bodies = faceted_bodies(build_layer_solid(part, body.layer));
        if (bodies.size() != 1)
            throw GeometryError(fmt::format("layer '{}': one of its bodies falls into {} parts",
                                            body_name(model_.units[body.layer], 0), bodies.size()));
        return bodies[0].solid;
    }

    const LayerModel& model_;
    const SmoothBodiesOptions& options_;
    SmoothBrep brep_;
    std::vector<std::shared_ptr<const TopoDS_Shape>> shapes_;  // [body]
    std::vector<char> is_valid_;                               // [body]
    std::vector<std::string> faults_;                          // [body]; empty = sound
    std::vector<double> volumes_;
};

}  // namespace

SmoothBodies smooth_bodies(const LayerModel& model, const SmoothBodiesOptions& options) {
    return Maker(model, options).make();
}

}  // namespace stratareeb
