// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/coarse_facets.h"

#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "boreholes/errors.h"
#include "io/faceted_bodies.h"
#include "mesh/decimate_layers.h"
#include "subdivision/plan_levels.h"

namespace stratareeb {
namespace {

constexpr int kRounds = 3;
constexpr double kNextError = 0.25;   // of the error before
constexpr double kLeastFactor = 0.5;  // of thicknesses between holes, for the volume's sake

using Faces = std::vector<std::uint32_t>;

// The model's bodies in a model of some of its vertices: the triangles of each.
class BodyFinder {
 public:
    BodyFinder(const LayerModel& model, const PlanCells& cells) : model_(model), cells_(cells) {
        for (const auto v : model.plan.surface.vertices()) vertex_at_[place(model, v)] = v.idx();
    }

    std::vector<Faces> faces_in(const LayerModel& coarse) {
        std::vector<Faces> result(cells_.bodies.size());
        const PlanLevels levels(coarse);
        for (std::uint32_t layer = 0; layer < coarse.units.size(); ++layer) {
            const auto bodies = bodies_at_vertices(layer);
            const auto parts = levels.layer_parts(layer);
            std::map<std::uint32_t, std::uint32_t> body_of_part;
            for (const auto f : coarse.plan.surface.faces())
                for (const auto v : coarse.plan.surface.fv_range(f)) {
                    const std::uint32_t part = parts[static_cast<std::size_t>(f.idx())];
                    const std::uint32_t body =
                        bodies[static_cast<std::size_t>(vertex_at_.at(place(coarse, v)))];
                    if (part != PlanLevels::kNone && body != PlanLevels::kNone) body_of_part[part] = body;
                }
            for (std::uint32_t f = 0; f < parts.size(); ++f)
                if (const auto it = body_of_part.find(parts[f]); it != body_of_part.end())
                    result[it->second].push_back(f);
        }
        return result;
    }

 private:
    static std::pair<double, double> place(const LayerModel& model, TriMesh::VertexHandle v) {
        return {model.plan.surface.point(v)[0], model.plan.surface.point(v)[1]};
    }

    // Where the layer has thickness.
    std::vector<std::uint32_t> bodies_at_vertices(std::uint32_t layer) const {
        const TriMesh& plan = model_.plan.surface;
        std::vector<std::uint32_t> result(plan.n_vertices(), PlanLevels::kNone);
        for (std::uint32_t b = 0; b < cells_.bodies.size(); ++b) {
            if (cells_.bodies[b].layer != layer) continue;
            for (const auto f : cells_.bodies[b].faces)
                for (const auto v : plan.fv_range(plan.face_handle(f))) {
                    const auto i = static_cast<std::size_t>(v.idx());
                    if (!model_.regions.zero_at[i][layer]) result[i] = b;
                }
        }
        return result;
    }

    const LayerModel& model_;
    const PlanCells& cells_;
    std::map<std::pair<double, double>, int> vertex_at_;
};

// The planar solid of a part of a layer.
std::shared_ptr<const TopoDS_Shape> solid_over(const LayerModel& model, std::uint32_t layer,
                                               const Faces& faces) {
    LayerModel part;
    part.units = model.units;
    part.origin = model.origin;
    part.plan = model.plan;
    part.horizons = model.horizons;
    part.regions.zero_at = model.regions.zero_at;
    part.regions.in_face.resize(model.regions.in_face.size());
    for (const auto f : faces) part.regions.in_face[f][layer] = true;
    auto bodies = faceted_bodies(build_layer_solid(part, layer));
    if (bodies.size() != 1)
        throw GeometryError(fmt::format("layer '{}': one of its bodies falls into {} parts",
                                        body_name(model.units[layer], 0), bodies.size()));
    return bodies[0].solid;
}

double volume_over(const LayerModel& model, std::uint32_t layer, const Faces& faces) {
    const TriMesh& plan = model.plan.surface;
    double volume = 0;
    for (const auto f : faces)
        for (const auto v : plan.fv_range(plan.face_handle(f)))
            volume += plan.calc_face_area(plan.face_handle(f)) / 3 *
                      model.thickness(layer, static_cast<std::size_t>(v.idx()));
    return volume;
}

// Thicknesses of the coarse model, body by body, by the factor that gives those whose volume differs the one they had; holes
// keep theirs, where that is enough. What is 0 stays 0, and horizons stay in order.
class VolumeKeeper {
 public:
    VolumeKeeper(const LayerModel& model, const PlanCells& cells, const std::vector<Faces>& faces,
                 double tolerance, LayerModel& coarse)
        : model_(model), cells_(cells), faces_(faces), tolerance_(tolerance), coarse_(coarse) {
        is_hole_.assign(coarse.plan.surface.n_vertices(), 0);
        for (const auto v : coarse.plan.hole_vertex)
            if (v != PlanMesh::kNoVertex) is_hole_[v] = 1;
    }

    //! \return how far a horizon moved at most.
    double keep() {
        std::vector<std::vector<double>> factors(coarse_.units.size(),
                                                 std::vector<double>(is_hole_.size(), 1));
        for (std::size_t b = 0; b < faces_.size(); ++b) set_factors(b, factors[cells_.bodies[b].layer]);
        double moved = 0;
        std::vector<double> above = coarse_.horizons.front();  // as it was
        for (std::size_t layer = 0; layer < coarse_.units.size(); ++layer) {
            auto& base = coarse_.horizons[layer + 1];
            const auto& top = coarse_.horizons[layer];
            for (std::size_t v = 0; v < base.size(); ++v) {
                const double before = base[v];
                base[v] = top[v] - factors[layer][v] * (above[v] - before);
                above[v] = before;
                moved = std::max(moved, std::abs(base[v] - before));
            }
        }
        return moved;
    }

 private:
    void set_factors(std::size_t b, std::vector<double>& factors) const {
        const TriMesh& plan = coarse_.plan.surface;
        const std::uint32_t layer = cells_.bodies[b].layer;
        double in_holes = 0, elsewhere = 0;
        for (const auto f : faces_[b])
            for (const auto v : plan.fv_range(plan.face_handle(f))) {
                const auto i = static_cast<std::size_t>(v.idx());
                (is_hole_[i] ? in_holes : elsewhere) +=
                    plan.calc_face_area(plan.face_handle(f)) / 3 * coarse_.thickness(layer, i);
            }
        const double wanted = volume_over(model_, layer, cells_.bodies[b].faces);
        if (std::abs(in_holes + elsewhere - wanted) <= tolerance_ * wanted) return;
        const double without_holes = elsewhere > 0 ? (wanted - in_holes) / elsewhere : 0;
        const bool keeps_holes = without_holes > kLeastFactor && without_holes < 1 / kLeastFactor;
        const double factor = keeps_holes ? without_holes : wanted / (in_holes + elsewhere);
        if (!std::isfinite(factor)) return;
        for (const auto f : faces_[b])
            for (const auto v : plan.fv_range(plan.face_handle(f)))
                if (const auto i = static_cast<std::size_t>(v.idx()); !(keeps_holes && is_hole_[i]))
                    factors[i] = factor;
    }

    const LayerModel& model_;
    const PlanCells& cells_;
    const std::vector<Faces>& faces_;
    double tolerance_;
    LayerModel& coarse_;
    std::vector<char> is_hole_;
};

}  // namespace

CoarseFacets coarse_facets(const LayerModel& model, const PlanCells& cells,
                           const std::vector<std::size_t>& bodies, const CoarseFacetsOptions& options) {
    BodyFinder finder(model, cells);
    DecimatedLayers coarse;
    std::vector<Faces> faces;
    const auto differs = [&](std::size_t b) {
        const auto& body = cells.bodies[b];
        const double volume = volume_over(model, body.layer, body.faces);
        return std::abs(volume_over(coarse.model, body.layer, faces[b]) - volume) >
               options.volume_tolerance * volume;
    };
    double error = options.max_error;
    for (int round = 0; round < kRounds; ++round, error *= kNextError) {
        auto finer = decimate_layers(model, {.max_error = error});
        if (round > 0 && finer.model.plan.surface.n_faces() > options.most_triangles) break;
        coarse = std::move(finer);
        faces = finder.faces_in(coarse.model);
        if (std::ranges::none_of(bodies, differs)) break;
    }
    if (coarse.model.plan.surface.n_faces() > options.most_triangles) {
        coarse = decimate_layers(model, {.triangles = options.most_triangles});
        faces = finder.faces_in(coarse.model);
    }
    const double moved = VolumeKeeper(model, cells, faces, options.volume_tolerance, coarse.model).keep();
    CoarseFacets result{.deviation = coarse.deviation + moved};
    for (const std::size_t b : bodies)
        result.solids.push_back(solid_over(coarse.model, cells.bodies[b].layer, faces[b]));
    return result;
}

}  // namespace stratareeb
