// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/refined_layers.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "boreholes/errors.h"
#include "subdivision/bend_handover.h"
#include "subdivision/crease_field.h"
#include "subdivision/fairness_rows.h"
#include "subdivision/layer_creases.h"
#include "subdivision/limit_fit.h"
#include "subdivision/moved_values.h"
#include "subdivision/plan_limit.h"
#include "subdivision/refined_regions.h"
#include "subdivision/separated_holes.h"

namespace stratareeb {

namespace {

constexpr int kMostLevels = 6;
constexpr double kThinnest =
    1e-10;  // of the model's size: what is left where a layer thins out to its pinch-out line
constexpr double kLowestShare = 0.1;  // of the predicted thickness, below which fairness may not bring it

double size_of(const LayerModel& model) {
    TriMesh::Point low = model.plan.surface.point(TriMesh::VertexHandle(0)), high = low;
    for (const auto v : model.plan.surface.vertices()) {
        low.minimize(model.plan.surface.point(v));
        high.maximize(model.plan.surface.point(v));
    }
    const auto [deepest, any] = std::ranges::minmax(model.horizons.back());
    const double top = std::ranges::max(model.horizons.front());
    return std::max({(high - low).norm(), top - deepest, any - deepest});
}

class LayerRefinement {
 public:
    LayerRefinement(const LayerModel& control, const RefineLayersOptions& options)
        : options_(options),
          control_(separated_holes(control)),
          topology_(control_.plan.surface, options.levels),
          thinnest_(kThinnest * size_of(control)) {
        for (const auto v : control_.plan.hole_vertex)
            if (v != PlanMesh::kNoVertex) holes_.push_back(v);
        std::ranges::sort(holes_);
        holes_.erase(std::unique(holes_.begin(), holes_.end()), holes_.end());
    }

    RefinedLayers run() {
        report("smoothing the plan", 0);
        plan_ = plan_limit(control_, topology_);
        creases_ = layer_creases(control_, plan_.creases);
        moved_ = moved_places(control_.plan.surface, plan_.limit_x, plan_.limit_y);
        bending_ = bending_rows(control_.plan.surface, plan_.x, plan_.y);
        regions_ = refined_regions(control_.regions, topology_);
        fit_ground();
        for (std::size_t i = 0; i < control_.units.size(); ++i) {
            report("smoothing layers",
                   0.3 + 0.5 * static_cast<double>(i) / static_cast<double>(control_.units.size()));
            fit_layer(i);
        }
        report("measuring smoothness", 0.85);
        RefinedLayers result{refined_model(), {}};
        result.smoothness = smoothness(result.model);
        report("measuring smoothness", 1);
        return result;
    }

 private:
    void report(const char* step, double share) const {
        if (options_.progress) options_.progress(step, share);
    }

    LimitFitSetup setup(const FieldCreases& creases) const {
        LimitFitSetup setup;
        setup.limit = limit_rows(topology_.level(0), creases);
        setup.fairness = bending_.rows;
        setup.fairness_weight.assign(bending_.vertex.size(), options_.fairness);
        setup.weight.assign(control_.plan.surface.n_vertices(), 1.0);
        setup.fixed.assign(control_.plan.surface.n_vertices(), 0);
        return setup;
    }

    void fit_ground() {
        LimitFitSetup problem = setup(creases_.plan);
        problem.exact = holes_;
        std::vector<double> data;
        for (const std::uint32_t v : holes_) data.push_back(control_.horizons[0][v]);
        const LimitFit fit(std::move(problem));
        const auto control = fit.control(moved_.values(control_.horizons[0]), data);
        ground_ = limit_values(topology_, creases_.plan, control);
    }

    void fit_layer(std::size_t layer) {
        const std::size_t n = control_.plan.surface.n_vertices();
        LimitFitSetup problem = setup(creases_.thickness[layer]);
        std::vector<double> given(n), lowest(n);
        for (std::size_t v = 0; v < n; ++v) given[v] = control_.thickness(layer, v);
        std::vector<double> wanted = moved_.values(given);
        for (std::size_t v = 0; v < n; ++v) {
            problem.fixed[v] = control_.regions.zero_at[v][layer];
            wanted[v] = problem.fixed[v] ? 0 : std::max(wanted[v], thinnest_);
            lowest[v] = problem.fixed[v] ? 0 : std::max(kLowestShare * wanted[v], 0.1 * thinnest_);
        }
        for (std::size_t r = 0; r < bending_.vertex.size(); ++r)
            if (problem.fixed[bending_.vertex[r]]) problem.fairness_weight[r] = 0;
        const std::vector<double>& handed = handed_to(layer);
        std::vector<double> data;
        for (const std::uint32_t v : holes_) {
            if (problem.fixed[v]) continue;
            problem.exact.push_back(v);
            data.push_back(std::max(given[v] - (handed.empty() ? 0 : handed[v]), 0.2 * thinnest_));
            lowest[v] = 0.1 * thinnest_;
        }
        hand_over(layer, control_above(std::move(problem), wanted, data, lowest));
    }

    const std::vector<double>& handed_to(std::size_t layer) {
        handed_.resize(control_.units.size());
        return handed_[layer];
    }

    void receive(const std::map<std::size_t, std::vector<double>>& bends) {
        for (const auto& [to, bend] : bends) {
            auto& sum = handed_[to];
            if (sum.empty())
                sum = bend;
            else
                for (std::size_t v = 0; v < sum.size(); ++v) sum[v] += bend[v];
        }
    }

    void hand_over(std::size_t layer, const std::vector<double>& control) {
        std::vector<double> values = limit_values(topology_, creases_.thickness[layer], control);
        if (options_.smooth_below)
            receive(bends_handed_over(control_, creases_, topology_, layer, control, values));
        auto& handed = handed_[layer];
        for (std::size_t v = 0; v < values.size(); ++v)
            values[v] = regions_.zero_at[v][layer]
                            ? 0
                            : std::max(values[v] + (handed.empty() ? 0 : handed[v]), thinnest_);
        std::vector<double>().swap(handed);
        thickness_.push_back(std::move(values));
    }

    LayerModel refined_model() {
        LayerModel model;
        model.units = control_.units;
        model.origin = control_.origin;
        model.length_unit = control_.length_unit;
        model.columns = control_.columns;
        model.spacing = control_.spacing;
        model.notes = control_.notes;
        model.plan = refined_plan();
        model.regions = std::move(regions_);
        model.horizons.push_back(std::move(ground_));
        for (const auto& thickness : thickness_) {
            std::vector<double> base = model.horizons.back();
            for (std::size_t v = 0; v < base.size(); ++v) base[v] -= thickness[v];
            model.horizons.push_back(std::move(base));
        }
        keep_contacts(model);
        if (plan_.straightened > 0)
            model.notes.push_back(fmt::format(
                "{} of {} triangles of the control mesh stay flat, since the plan would fold there",
                plan_.straightened, control_.plan.surface.n_faces()));
        return model;
    }

    PlanMesh refined_plan() const {
        PlanMesh plan;
        const LoopLevel& fine = topology_.finest();
        plan.surface.reserve(fine.vertices, fine.ends.size(), fine.triangles.size());
        for (std::size_t v = 0; v < fine.vertices; ++v)
            plan.surface.add_vertex({plan_.limit_x[v], plan_.limit_y[v], 0});
        using Vertex = TriMesh::VertexHandle;
        for (const auto& [a, b, c] : fine.triangles)
            plan.surface.add_face(Vertex(static_cast<int>(a)), Vertex(static_cast<int>(b)),
                                  Vertex(static_cast<int>(c)));
        plan.hole_vertex = control_.plan.hole_vertex;
        return plan;
    }

    //! The limit is at the contacts but for rounding; that is taken away too.
    void keep_contacts(LayerModel& model) {
        for (std::size_t k = 0; k < model.horizons.size(); ++k)
            for (const std::uint32_t v : holes_) {
                const double off = std::abs(model.horizons[k][v] - control_.horizons[k][v]);
                largest_misfit_ = std::max(largest_misfit_, off);
                model.horizons[k][v] = control_.horizons[k][v];
            }
    }

    //! Edges of the control mesh along which a horizon is meant to bend.
    std::vector<std::vector<char>> meant_bends() const {
        std::vector<std::vector<char>> bends(control_.horizons.size(),
                                             std::vector<char>(topology_.level(0).ends.size(), 0));
        for (auto& flags : bends)
            for (const std::uint32_t e : creases_.plan.edges) flags[e] = 1;
        for (std::size_t i = 0; i < control_.units.size(); ++i)
            for (const Handover& h : handovers(control_, i))
                for (std::size_t k = i + 1; k < bends.size() && k <= h.to; ++k) bends[k][h.edge] = 1;
        return bends;
    }

    SmoothnessReport smoothness(const LayerModel& model) const {
        SmoothnessReport result{
            .levels = options_.levels, .straightened = plan_.straightened, .largest_misfit = largest_misfit_};
        const auto bends = meant_bends();
        std::vector<Smoothness> before(bends.size()), after(bends.size());
        std::vector<double> x, y;
        for (const auto v : control_.plan.surface.vertices()) {
            x.push_back(control_.plan.surface.point(v)[0]);
            y.push_back(control_.plan.surface.point(v)[1]);
        }
        const std::size_t descendants = topology_.level(0).ends.size() << options_.levels;
        tbb::parallel_for(std::size_t{0}, bends.size(), [&](std::size_t k) {
            before[k] = smoothness_of(topology_.level(0), x, y, control_.horizons[k], bends[k]);
            std::vector<char> fine(topology_.finest().ends.size(), 0);
            for (std::size_t e = 0; e < descendants; ++e) fine[e] = bends[k][e >> options_.levels];
            after[k] =
                smoothness_of(topology_.finest(), plan_.limit_x, plan_.limit_y, model.horizons[k], fine);
        });
        for (std::size_t k = 0; k < bends.size(); ++k) {
            add(result.before, before[k]);
            add(result.after, after[k]);
        }
        result.thinnest = thinnest_present(model);
        return result;
    }

    static void add(Smoothness& sum, const Smoothness& one) {
        sum.largest_jump_deg = std::max(sum.largest_jump_deg, one.largest_jump_deg);
        sum.bending_energy += one.bending_energy;
    }

    static double thinnest_present(const LayerModel& model) {
        double least = 0;
        bool any = false;
        for (std::size_t i = 0; i < model.units.size(); ++i)
            for (std::size_t v = 0; v < model.horizons[0].size(); ++v) {
                if (model.regions.zero_at[v][i]) continue;
                const double t = model.thickness(i, v);
                if (!any || t < least) least = t, any = true;
            }
        return least;
    }

    const RefineLayersOptions& options_;
    LayerModel control_;
    LoopTopology topology_;
    double thinnest_;
    std::vector<std::uint32_t> holes_;
    PlanLimit plan_;
    LayerCreases creases_;
    MovedPlaces moved_;
    FairnessRows bending_;
    LayerRegions regions_;
    std::vector<double> ground_;
    std::vector<std::vector<double>> handed_, thickness_;  // at the finest level, by layer
    double largest_misfit_ = 0;
};

}  // namespace

RefinedLayers refine_layers(const LayerModel& control, const RefineLayersOptions& options) {
    if (options.levels < 0 || options.levels > kMostLevels)
        throw InvalidInput(
            fmt::format("{} levels of refinement (0 to {} are possible)", options.levels, kMostLevels));
    if (options.levels == 0) return {control, {}};
    return LayerRefinement(control, options).run();
}

}  // namespace stratareeb
