// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/decimate_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <tuple>

#include "boreholes/errors.h"
#include "mesh/plan_collapse.h"
#include "mesh/triangle_soup.h"

namespace stratareeb {

namespace {

using Vertex = TriMesh::VertexHandle;
using Halfedge = TriMesh::HalfedgeHandle;
using Choice = PlanCollapse::Choice;

constexpr double kStraight = 1e-9;   // of the extent: an outline as close to a straight line as that is one
constexpr double kRounding = 1e-12;  // of the model's size: what an error of 0 lets pass
constexpr double kLineShare = 0.1;   // of the spacing: how far lines may be straightened by default
constexpr double kFlattest = 1e-4;   // sine: flatter triangles than that are no ground to interpolate on
constexpr std::size_t kReportEvery = 1024;
constexpr double kAnyDeviation = std::numeric_limits<double>::max();

double extent_of(const TriMesh& mesh) {
    TriMesh::Point low = mesh.point(Vertex(0)), high = low;
    for (const Vertex v : mesh.vertices()) low.minimize(mesh.point(v)), high.maximize(mesh.point(v));
    return (high - low).norm();
}

double size_of(const LayerModel& model) {
    double size = extent_of(model.plan.surface);
    for (const auto& horizon : model.horizons)
        for (const double z : horizon) size = std::max(size, std::abs(z));
    return size;
}

//! Takes vertices out of the plan, the one that costs least first.
class Decimation {
 public:
    Decimation(PlanCollapse& plan, double negligible) : plan_(plan), negligible_(negligible) {
        const std::size_t vertices = plan.mesh().n_vertices();
        cost_.resize(vertices);
        is_queued_.assign(vertices, 0);
        is_stale_.assign(vertices, 0);
    }

    //! Down to a number of triangles, or until nothing more can go. Sweeps again over what could not go before: it may have
    //! become possible by what went elsewhere.
    void run(std::size_t target, const std::function<void(double)>& progress) {
        const double start = static_cast<double>(plan_.triangles() - std::min(target, plan_.triangles()));
        for (bool any = true; any && plan_.triangles() > target;) {
            any = false;
            for (const Vertex v : plan_.mesh().vertices()) update(v);
            while (!queue_.empty() && plan_.triangles() > target) {
                any |= take_next();
                if (progress && ++steps_ % kReportEvery == 0)
                    progress(1 - static_cast<double>(plan_.triangles() - target) / start);
            }
            for (const Vertex v : plan_.mesh().vertices())
                if (plan_.triangles() > target) any |= take_with_turns(v);
        }
    }

 private:
    //! Turn edges away from a vertex until it can go, or no more can be turned.
    bool take_with_turns(Vertex v) {
        while (plan_.turn_edge_away(v))
            if (const auto choice = plan_.best(v)) return plan_.collapse(choice->into), true;
        return false;
    }

    // Where nothing is lost, short edges go first, which leaves triangles of one size; the number breaks ties.
    using Cost = std::tuple<double, double, int>;

    Cost cost_of(const Choice& choice) const {
        return {std::max(choice.deviation, negligible_), choice.length,
                plan_.mesh().from_vertex_handle(choice.into).idx()};
    }

    void update(Vertex v) {
        const auto choice = plan_.best(v);
        const auto i = static_cast<std::size_t>(v.idx());
        is_stale_[i] = 0;
        is_queued_[i] = choice.has_value();
        if (!choice) return;
        cost_[i] = cost_of(*choice);
        queue_.push({cost_[i], choice->into});
    }

    //! Costs are looked at again when their turn comes: what happened near by raises most of them.
    bool take_next() {
        const auto [cost, into] = queue_.top();
        queue_.pop();
        const Vertex v(std::get<2>(cost));
        const auto i = static_cast<std::size_t>(v.idx());
        if (plan_.mesh().status(v).deleted() || !is_queued_[i] || cost != cost_[i]) return false;
        if (is_stale_[i]) return update(v), false;
        if (const auto choice = plan_.try_into(into); !choice || cost_of(*choice) > cost)
            return update(v), false;
        neighbours_.clear();
        for (const Vertex u : plan_.mesh().vv_range(v)) neighbours_.push_back(u);
        plan_.collapse(into);
        for (const Vertex u : neighbours_) {
            is_stale_[static_cast<std::size_t>(u.idx())] = 1;
            if (!is_queued_[static_cast<std::size_t>(u.idx())]) update(u);
        }
        return true;
    }

    PlanCollapse& plan_;
    double negligible_;
    std::vector<Cost> cost_;
    std::vector<char> is_queued_, is_stale_;
    std::priority_queue<std::pair<Cost, Halfedge>, std::vector<std::pair<Cost, Halfedge>>, std::greater<>>
        queue_;
    std::vector<Vertex> neighbours_;
    std::size_t steps_ = 0;
};

//! The model over what is left of its plan, in the same order.
LayerModel reduced(const LayerModel& model, const TriMesh& left) {
    LayerModel result;
    result.units = model.units;
    result.origin = model.origin;
    result.length_unit = model.length_unit;
    result.columns = model.columns;
    result.spacing = model.spacing;
    result.notes = model.notes;
    result.regions.opened = model.regions.opened;
    result.horizons.resize(model.horizons.size());
    std::vector<std::uint32_t> number(left.n_vertices(), PlanMesh::kNoVertex);
    TriangleSoup soup;
    for (const Vertex v : left.vertices()) {
        const auto i = static_cast<std::size_t>(v.idx());
        number[i] = static_cast<std::uint32_t>(soup.points.size());
        soup.points.push_back({left.point(v)[0], left.point(v)[1], 0});
        result.regions.zero_at.push_back(model.regions.zero_at[i]);
        for (std::size_t k = 0; k < model.horizons.size(); ++k)
            result.horizons[k].push_back(model.horizons[k][i]);
    }
    for (const auto f : left.faces()) {
        std::array<std::uint32_t, 3> triangle;
        int corner = 0;
        for (const Vertex v : left.fv_range(f))
            triangle[corner++] = number[static_cast<std::size_t>(v.idx())];
        soup.triangles.push_back(triangle);
        result.regions.in_face.push_back(model.regions.in_face[static_cast<std::size_t>(f.idx())]);
    }
    result.plan.surface = half_edge_mesh(soup);
    for (const auto v : model.plan.hole_vertex)
        result.plan.hole_vertex.push_back(v == PlanMesh::kNoVertex ? v : number[v]);
    return result;
}

void check(const DecimateLayersOptions& options) {
    if (!options.triangles && !options.max_error)
        throw InvalidInput("decimation needs a number of triangles or a largest error to stop at");
    if (options.max_error && !(*options.max_error >= 0))
        throw InvalidInput(fmt::format("the largest error {} should be 0 or more", *options.max_error));
    if (options.line_tolerance && !(*options.line_tolerance >= 0))
        throw InvalidInput(
            fmt::format("the tolerance of pinch-out lines {} should be 0 or more", *options.line_tolerance));
    if (!(options.min_angle_deg >= 0 && options.min_angle_deg <= 30))
        throw InvalidInput(
            fmt::format("the smallest angle {} should be from 0 to 30 degrees", options.min_angle_deg));
}

PlanCollapse::Limits limits_of(const LayerModel& model, const DecimateLayersOptions& options, double size) {
    const double straight = kStraight * extent_of(model.plan.surface);
    return {.line_tolerance = std::max(options.line_tolerance.value_or(kLineShare * model.spacing), straight),
            .outline_tolerance = straight,
            .min_sine = std::max(std::sin(options.min_angle_deg * std::numbers::pi / 180), kFlattest),
            .deviation = options.max_error ? std::max(*options.max_error, kRounding * size) : kAnyDeviation};
}

std::string note_of(const DecimatedLayers& result, const DecimateLayersOptions& options) {
    const std::size_t left = result.model.plan.surface.n_faces();
    std::string note = fmt::format(
        "decimated from {} to {} plan triangles; horizons are at most {:.3g} {} from where they were",
        result.triangles_before, left, result.deviation, result.model.length_unit);
    if (!result.target_reached)
        note += fmt::format("; {} can't be reached: {}", *options.triangles,
                            options.max_error ? "the error, holes, outline and pinch-out lines need the rest"
                                              : "holes, outline and pinch-out lines need the rest");
    return note;
}

}  // namespace

DecimatedLayers decimate_layers(const LayerModel& model, const DecimateLayersOptions& options) {
    check(options);
    DecimatedLayers result;
    result.triangles_before = model.plan.surface.n_faces();
    const std::size_t target = options.triangles.value_or(0);
    if (result.triangles_before == 0) return result;
    const double size = size_of(model);
    PlanCollapse plan(model, limits_of(model, options, size));
    Decimation(plan, kRounding * size).run(target, options.progress);
    const bool any = plan.triangles() < result.triangles_before;  // turned edges alone are no gain
    result.model = any ? reduced(model, plan.mesh()) : model;
    result.deviation = any ? plan.deviation() : 0;
    result.target_reached = !options.triangles || plan.triangles() <= target;
    result.note = note_of(result, options);
    if (options.progress) options.progress(1);
    return result;
}

}  // namespace stratareeb
