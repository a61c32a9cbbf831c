// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/limit_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>

#include "mesh/plan_mesh.h"
#include "subdivision/crease_field.h"
#include "subdivision/fairness_rows.h"

namespace stratareeb {
namespace {

struct Problem {
    LimitFitSetup setup;
    std::vector<double> prediction, data;
};

//! Holes with rings of their own in a square.
Problem random_problem(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    std::vector<Point2> holes;
    const auto is_far = [&](const Point2& p) {
        return std::ranges::none_of(holes,
                                    [&](const Point2& q) { return std::hypot(p.x - q.x, p.y - q.y) < 0.1; });
    };
    while (holes.size() < 9)
        if (const Point2 p{0.1 + 0.8 * unit(), 0.1 + 0.8 * unit()}; is_far(p)) holes.push_back(p);
    const PlanMesh plan =
        build_plan_mesh({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, holes, {}, {.spacing = 0.25, .ring_holes = true});
    const std::size_t n = plan.surface.n_vertices();
    std::vector<double> x, y;
    for (const auto v : plan.surface.vertices()) {
        x.push_back(plan.surface.point(v)[0]);
        y.push_back(plan.surface.point(v)[1]);
    }
    const LoopTopology topology(plan.surface, 0);
    const FairnessRows fairness = bending_rows(plan.surface, x, y);
    Problem problem;
    problem.setup = {limit_rows(topology.level(0), {}),
                     fairness.rows,
                     std::vector<double>(n, 1.0),
                     std::vector<double>(fairness.vertex.size(), 0.3),
                     std::vector<char>(n, 0),
                     1e-13,
                     plan.hole_vertex};
    for (std::size_t v = 0; v < n; ++v) {
        problem.prediction.push_back(unit());
        if (unit() < 0.1 && std::ranges::find(plan.hole_vertex, v) == plan.hole_vertex.end())
            problem.setup.fixed[v] = 1, problem.prediction[v] = 0;
    }
    for (std::size_t i = 0; i < holes.size(); ++i) problem.data.push_back(std::pow(10, 4 * unit() - 2));
    return problem;
}

double limit_at(const SparseRows& rows, std::uint32_t v, const std::vector<double>& control) {
    double sum = 0;
    for (auto k = rows.first[v]; k < rows.first[v + 1]; ++k) sum += rows.weight[k] * control[rows.column[k]];
    return sum;
}

//! The same by a dense system of Lagrange multipliers.
std::vector<double> oracle(const Problem& problem) {
    const auto& s = problem.setup;
    const auto n = static_cast<Eigen::Index>(problem.prediction.size());
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
    const auto add = [&](const SparseRows& rows, std::size_t r, double weight, double value) {
        Eigen::VectorXd row = Eigen::VectorXd::Zero(n);
        for (auto k = rows.first[r]; k < rows.first[r + 1]; ++k) row[rows.column[k]] += rows.weight[k];
        K += weight * row * row.transpose();
        b += weight * value * row;
    };
    for (std::size_t v = 0; v < s.limit.size(); ++v) add(s.limit, v, s.weight[v], problem.prediction[v]);
    for (std::size_t r = 0; r < s.fairness.size(); ++r) add(s.fairness, r, s.fairness_weight[r], 0);
    std::vector<Eigen::VectorXd> constraints;
    std::vector<double> values;
    for (std::size_t i = 0; i < s.exact.size(); ++i) {
        Eigen::VectorXd row = Eigen::VectorXd::Zero(n);
        for (auto k = s.limit.first[s.exact[i]]; k < s.limit.first[s.exact[i] + 1]; ++k)
            row[s.limit.column[k]] = s.limit.weight[k];
        constraints.push_back(row);
        values.push_back(problem.data[i]);
    }
    for (Eigen::Index v = 0; v < n; ++v)
        if (s.fixed[static_cast<std::size_t>(v)]) {
            constraints.push_back(Eigen::VectorXd::Unit(n, v));
            values.push_back(problem.prediction[static_cast<std::size_t>(v)]);
        }
    const auto m = static_cast<Eigen::Index>(constraints.size());
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + m, n + m);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n + m);
    system.topLeftCorner(n, n) = K;
    right.head(n) = b;
    for (Eigen::Index i = 0; i < m; ++i) {
        system.block(n + i, 0, 1, n) = constraints[static_cast<std::size_t>(i)].transpose();
        system.block(0, n + i, n, 1) = constraints[static_cast<std::size_t>(i)];
        right[n + i] = values[static_cast<std::size_t>(i)];
    }
    const Eigen::VectorXd solved = system.fullPivLu().solve(right);
    return {solved.data(), solved.data() + n};
}

TEST(LimitFit, is_the_least_squares_solution_through_the_data) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Problem problem = random_problem(seed);
        const std::vector<double> control = LimitFit(problem.setup).control(problem.prediction, problem.data);
        const std::vector<double> expected = oracle(problem);
        for (std::size_t v = 0; v < control.size(); ++v)
            EXPECT_NEAR(control[v], expected[v], 1e-6) << "seed " << seed;
        for (std::size_t i = 0; i < problem.data.size(); ++i)
            EXPECT_NEAR(limit_at(problem.setup.limit, problem.setup.exact[i], control), problem.data[i],
                        1e-12 * (1 + problem.data[i]));
    }
}

TEST(LimitFit, stays_above_what_is_lowest_and_still_meets_the_data) {
    int bounded = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const Problem problem = random_problem(seed);
        const std::vector<double> lowest(problem.prediction.size(), 1e-6);
        const std::vector<double> control =
            control_above(problem.setup, problem.prediction, problem.data, lowest);
        const std::vector<double> free = LimitFit(problem.setup).control(problem.prediction, problem.data);
        bounded += std::ranges::min(free) < 0;
        for (std::size_t v = 0; v < control.size(); ++v)
            EXPECT_TRUE(problem.setup.fixed[v] || control[v] > 0) << "seed " << seed;
        for (std::size_t i = 0; i < problem.data.size(); ++i)
            EXPECT_NEAR(limit_at(problem.setup.limit, problem.setup.exact[i], control), problem.data[i],
                        1e-12 * (1 + problem.data[i]));
    }
    EXPECT_GT(bounded, 20);
}

}  // namespace
}  // namespace stratareeb
