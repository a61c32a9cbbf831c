// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/plan_limit.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

#include "subdivision/fairness_rows.h"
#include "subdivision/layer_creases.h"
#include "subdivision/limit_fit.h"

namespace stratareeb {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr double kFairness = 0.05;  // against 1 for the distance of the limit to the given place
constexpr double kFairer = 20;      // times that around folds, once a round
constexpr int kFairRounds = 2;      // then what still folds stays linear

class PlanFit {
 public:
    PlanFit(const LayerModel& model, const LoopTopology& topology)
        : mesh_(model.plan.surface), topology_(topology), holes_(model.plan.hole_vertex) {
        plan_.creases = plan_creases(model);
        for (const auto v : mesh_.vertices()) {
            given_x_.push_back(mesh_.point(v)[0]);
            given_y_.push_back(mesh_.point(v)[1]);
        }
        umbrella_ = umbrella_rows(mesh_);
        fairness_.assign(umbrella_.vertex.size(), kFairness);
        is_linear_.assign(mesh_.n_faces(), 0);
    }

    PlanLimit run() {
        for (int round = 0;; ++round) {
            solve();
            const std::vector<std::size_t> folded = folded_triangles();
            if (folded.empty()) return std::move(plan_);
            if (round < kFairRounds)
                make_fairer(folded);
            else
                make_linear(folded, round > 2 * kFairRounds);
        }
    }

 private:
    void solve() {
        LimitFitSetup setup;
        setup.limit = limit_rows(topology_.level(0), plan_.creases);
        setup.fairness = umbrella_.rows;
        setup.fairness_weight = fairness_;
        setup.weight.assign(mesh_.n_vertices(), 1.0);
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
        plan_.x = fit.control(x, at_exact(fit, given_x_));
        plan_.y = fit.control(y, at_exact(fit, given_y_));
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

    //! Triangles of the plan mesh with a folded or flat one in them.
    std::vector<std::size_t> folded_triangles() const {
        const auto& fine = topology_.finest().triangles;
        const std::size_t children = fine.size() / mesh_.n_faces();
        std::vector<std::size_t> folded;
        const auto at = [&](std::uint32_t v) { return Kernel::Point_2(plan_.limit_x[v], plan_.limit_y[v]); };
        for (std::size_t f = 0; f < fine.size(); ++f) {
            const auto& [a, b, c] = fine[f];
            if (CGAL::orientation(at(a), at(b), at(c)) == CGAL::LEFT_TURN) continue;
            if (folded.empty() || folded.back() != f / children) folded.push_back(f / children);
        }
        return folded;
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
    FairnessRows umbrella_;
    std::vector<double> fairness_;
    std::vector<char> is_linear_;
    PlanLimit plan_;
};

}  // namespace

PlanLimit plan_limit(const LayerModel& model, const LoopTopology& topology) {
    return PlanFit(model, topology).run();
}

}  // namespace stratareeb
