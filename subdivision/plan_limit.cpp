// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/plan_limit.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>

#include "boreholes/errors.h"
#include "subdivision/fairness_rows.h"
#include "subdivision/layer_creases.h"
#include "subdivision/limit_fit.h"

namespace stratareeb {

namespace {

using Corners = std::array<std::uint32_t, 3>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// Weights: limits at their given places (on pinch-out lines; elsewhere) against a fair parametrisation. The less they
// count, the better the triangles; predictions are taken where vertices come to lie.
constexpr double kToLine = 0.5, kToPlace = 0.01, kFairness = 1;
constexpr double kFairer = 20;       // times the fairness around folds and flat triangles, in the first round
constexpr double kTruer = 30;        // times the weight of given places there, in each round after it
constexpr int kTrueRounds = 3;       // then what still folds in the best of all rounds stays linear
constexpr double kTolerance = 1e-6;  // nobody sees more of how fair a plan is
constexpr int kMostRounds = 100;
// Twice the area over the sum of squared sides (0.29 at most): below it a triangle is flat, if it came from one above.
constexpr double kFlat = 0.04, kGood = 0.08;

class PlanFit {
 public:
    PlanFit(const LayerModel& model, const LoopTopology& topology)
        : mesh_(model.plan.surface), topology_(topology), holes_(model.plan.hole_vertex) {
        plan_.creases = plan_creases(model);
        for (const auto v : mesh_.vertices()) {
            given_x_.push_back(mesh_.point(v)[0]);
            given_y_.push_back(mesh_.point(v)[1]);
        }
        find_lines(model.regions);
        umbrella_ = umbrella_rows(mesh_);
        fairness_.assign(umbrella_.vertex.size(), kFairness);
        truth_.assign(mesh_.n_vertices(), 1.0);
        is_linear_.assign(mesh_.n_faces(), 0);
    }

    PlanLimit run() {
        solve();
        std::vector<std::size_t> folded = unfold();
        for (int round = 0; !folded.empty(); ++round) {
            if (round == kMostRounds) throw GeometryError("the refined plan folds over");
            make_linear(folded, round > 1);
            solve();
            folded = bad_triangles(0);
        }
        return std::move(plan_);
    }

 private:
    //! What a fit depends on, and what came of it.
    struct Attempt {
        std::vector<double> fairness, truth;
        PlanLimit plan;
        std::vector<std::size_t> folded;
    };

    //! Where triangles fold or are flat, a fairer plan is tried, then one that keeps closer to the given places, which do not fold.
    //! \return triangles that fold all the same
    std::vector<std::size_t> unfold() {
        Attempt best{fairness_, truth_, plan_, bad_triangles(0)};
        for (int round = 0; round <= kTrueRounds; ++round) {
            const std::vector<std::size_t> bad = bad_triangles(kFlat);
            if (bad.empty()) return {};
            if (round == 0)
                make_fairer(bad);
            else
                make_truer(bad);
            solve();
            std::vector<std::size_t> folded = bad_triangles(0);
            if (folded.size() <= best.folded.size()) best = {fairness_, truth_, plan_, std::move(folded)};
        }
        fairness_ = std::move(best.fairness);
        truth_ = std::move(best.truth);
        plan_ = std::move(best.plan);
        return std::move(best.folded);
    }

    void find_lines(const LayerRegions& regions) {
        for (const auto e : mesh_.edges()) {
            if (mesh_.is_boundary(e)) continue;
            const auto h = mesh_.halfedge_handle(e, 0), o = mesh_.halfedge_handle(e, 1);
            const auto layers = [&](auto side) {
                return regions.in_face[static_cast<std::size_t>(mesh_.face_handle(side).idx())];
            };
            if (layers(h) == layers(o)) continue;
            on_line_.push_back(static_cast<std::uint32_t>(mesh_.to_vertex_handle(h).idx()));
            on_line_.push_back(static_cast<std::uint32_t>(mesh_.to_vertex_handle(o).idx()));
        }
    }

    void solve() {
        LimitFitSetup setup;
        setup.limit = limit_rows(topology_.level(0), plan_.creases);
        setup.fairness = umbrella_.rows;
        setup.tolerance = kTolerance;
        setup.fairness_weight = fairness_;
        setup.weight.assign(mesh_.n_vertices(), kToPlace);
        for (const auto v : on_line_) setup.weight[v] = kToLine;
        for (std::size_t v = 0; v < truth_.size(); ++v) setup.weight[v] *= truth_[v];
        setup.fixed.assign(mesh_.n_vertices(), 0);
        for (const auto v : mesh_.vertices())
            if (mesh_.is_boundary(v)) setup.fixed[static_cast<std::size_t>(v.idx())] = 1;
        for (const std::uint32_t v : plan_.creases.corners) setup.fixed[v] = 1;
        std::vector<double> x = given_x_, y = given_y_;
        for (const std::uint32_t v : holes_) {
            if (v == PlanMesh::kNoVertex) continue;
            if (!setup.fixed[v])
                setup.exact.push_back(v);
            else
                x[v] = rim_control(setup.limit, given_x_, v), y[v] = rim_control(setup.limit, given_y_, v);
        }
        std::ranges::sort(setup.exact);
        const LimitFit fit(std::move(setup));
        plan_.x = fit.control(x, at_exact(fit, given_x_), plan_.x);
        plan_.y = fit.control(y, at_exact(fit, given_y_), plan_.y);
        plan_.limit_x = limit_values(topology_, plan_.creases, plan_.x);
        plan_.limit_y = limit_values(topology_, plan_.creases, plan_.y);
        keep_places();
    }

    static std::vector<double> at_exact(const LimitFit& fit, const std::vector<double>& values) {
        std::vector<double> data;
        for (const std::uint32_t v : fit.setup().exact) data.push_back(values[v]);
        return data;
    }

    //! The value at a rim vertex which, with the given ones beside it, has its limit at the given place.
    static double rim_control(const SparseRows& limit, const std::vector<double>& given, std::uint32_t v) {
        double own = 0, rest = given[v];
        for (auto k = limit.first[v]; k < limit.first[v + 1]; ++k)
            if (limit.column[k] == v)
                own = limit.weight[k];
            else
                rest -= limit.weight[k] * given[limit.column[k]];
        return rest / own;
    }

    //! To the last bit, where a limit is to be at a given place.
    void keep_places() {
        const auto keep = [&](std::uint32_t v) {
            plan_.limit_x[v] = given_x_[v];
            plan_.limit_y[v] = given_y_[v];
        };
        for (const std::uint32_t v : holes_)
            if (v != PlanMesh::kNoVertex) keep(v);
        for (const std::uint32_t v : plan_.creases.corners) keep(v);
    }

    //! Triangles of the plan mesh in which one is folded, or flat though they are not.
    std::vector<std::size_t> bad_triangles(double flat) const {
        const auto& fine = topology_.finest().triangles;
        const std::size_t children = fine.size() / mesh_.n_faces();
        std::vector<std::size_t> bad;
        for (std::size_t f = 0; f < fine.size(); ++f) {
            const std::size_t parent = f / children;
            if (!bad.empty() && bad.back() == parent) continue;
            if (is_folded(fine[f]) ||
                (flat > 0 && quality(fine[f], plan_.limit_x, plan_.limit_y) < flat &&
                 quality(topology_.level(0).triangles[parent], given_x_, given_y_) > kGood))
                bad.push_back(parent);
        }
        return bad;
    }

    bool is_folded(const Corners& t) const {
        const auto at = [&](std::uint32_t v) { return Kernel::Point_2(plan_.limit_x[v], plan_.limit_y[v]); };
        return CGAL::orientation(at(t[0]), at(t[1]), at(t[2])) != CGAL::LEFT_TURN;
    }

    static double quality(const Corners& t, const std::vector<double>& x, const std::vector<double>& y) {
        double twice_area = 0, squares = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            twice_area += (x[a] - x[t[0]]) * (y[b] - y[t[0]]) - (x[b] - x[t[0]]) * (y[a] - y[t[0]]);
            squares += (x[b] - x[a]) * (x[b] - x[a]) + (y[b] - y[a]) * (y[b] - y[a]);
        }
        return twice_area / squares;
    }

    std::vector<char> corners_of(const std::vector<std::size_t>& faces) const {
        std::vector<char> flags(mesh_.n_vertices(), 0);
        for (const std::size_t f : faces)
            for (const auto v : mesh_.fv_range(TriMesh::FaceHandle(static_cast<int>(f))))
                flags[static_cast<std::size_t>(v.idx())] = 1;
        return flags;
    }

    void make_fairer(const std::vector<std::size_t>& folded) {
        const std::vector<char> near = corners_of(folded);
        for (std::size_t r = 0; r < fairness_.size(); ++r)
            if (near[umbrella_.vertex[r]]) fairness_[r] *= kFairer;
    }

    void make_truer(const std::vector<std::size_t>& folded) {
        const std::vector<char> near = corners_of(folded);
        for (std::size_t r = 0; r < fairness_.size(); ++r)
            if (near[umbrella_.vertex[r]]) fairness_[r] = kFairness;
        for (std::size_t v = 0; v < truth_.size(); ++v)
            if (near[v]) truth_[v] *= kTruer;
    }

    //! With sharp corners and edges a triangle's limit is the triangle itself.
    void make_linear(const std::vector<std::size_t>& folded, bool widen) {
        const std::vector<char> near = corners_of(folded);
        std::vector<char> is_folded(mesh_.n_faces(), 0);
        for (const std::size_t f : folded) is_folded[f] = 1;
        for (const auto f : mesh_.faces()) {
            const auto i = static_cast<std::size_t>(f.idx());
            bool reached = is_folded[i] || is_linear_[i];
            for (const auto v : mesh_.fv_range(f))
                reached |= widen && near[static_cast<std::size_t>(v.idx())];
            if (reached && !is_linear_[i]) is_linear_[i] = 1, ++plan_.straightened;
            if (!is_linear_[i]) continue;
            for (const auto e : mesh_.fe_range(f))
                plan_.creases.edges.push_back(static_cast<std::uint32_t>(e.idx()));
            for (const auto v : mesh_.fv_range(f))
                plan_.creases.corners.push_back(static_cast<std::uint32_t>(v.idx()));
        }
        for (auto* list : {&plan_.creases.edges, &plan_.creases.corners}) {
            std::ranges::sort(*list);
            list->erase(std::unique(list->begin(), list->end()), list->end());
        }
    }

    const TriMesh& mesh_;
    const LoopTopology& topology_;
    const std::vector<std::uint32_t>& holes_;
    std::vector<double> given_x_, given_y_;
    std::vector<std::uint32_t> on_line_;
    FairnessRows umbrella_;
    std::vector<double> fairness_, truth_;  // by row; by vertex, times its weight
    std::vector<char> is_linear_;
    PlanLimit plan_;
};

}  // namespace

PlanLimit plan_limit(const LayerModel& model, const LoopTopology& topology) {
    return PlanFit(model, topology).run();
}

}  // namespace stratareeb
