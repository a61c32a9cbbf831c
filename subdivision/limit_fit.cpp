// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/limit_fit.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

namespace stratareeb {

namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Vector = Eigen::VectorXd;
using Triplets = std::vector<Eigen::Triplet<double>>;

constexpr int kMostIterations = 400;
constexpr int kBoundRounds = 2;

int column(std::uint32_t v) {
    return static_cast<int>(v);
}

Matrix rows_of(const LimitFitSetup& setup) {
    const auto n = setup.limit.size();
    Triplets entries;
    const auto add = [&](const SparseRows& rows, std::size_t r, std::size_t at, double weight) {
        if (weight <= 0) return;
        for (auto k = rows.first[r]; k < rows.first[r + 1]; ++k)
            entries.emplace_back(static_cast<int>(at), column(rows.column[k]),
                                 std::sqrt(weight) * rows.weight[k]);
    };
    for (std::size_t v = 0; v < n; ++v) add(setup.limit, v, v, setup.weight[v]);
    for (std::size_t r = 0; r < setup.fairness.size(); ++r)
        add(setup.fairness, r, n + r, setup.fairness_weight[r]);
    Matrix rows(static_cast<int>(n + setup.fairness.size()), static_cast<int>(n));
    rows.setFromTriplets(entries.begin(), entries.end());
    return rows;
}

double own_weight(const SparseRows& rows, std::uint32_t v) {
    for (auto k = rows.first[v]; k < rows.first[v + 1]; ++k)
        if (rows.column[k] == v) return rows.weight[k];
    return 0;
}

}  // namespace

struct LimitFit::System {
    Matrix rows;       // weighted
    Matrix from_free;  // control values from free ones, but for what fixed values and data add
    std::vector<std::uint32_t> free;
    Matrix reduced;  // rows * from_free
    Eigen::LeastSquaresConjugateGradient<Matrix> solver;
};

LimitFit::LimitFit(LimitFitSetup setup) : setup_(std::move(setup)), system_(std::make_unique<System>()) {
    const auto n = static_cast<std::uint32_t>(setup_.limit.size());
    std::vector<char> is_exact(n, 0);
    for (const std::uint32_t v : setup_.exact) is_exact[v] = 1;
    std::vector<int> number(n, -1);
    Triplets entries;
    for (std::uint32_t v = 0; v < n; ++v) {
        if (setup_.fixed[v] || is_exact[v]) continue;
        number[v] = static_cast<int>(system_->free.size());
        system_->free.push_back(v);
        entries.emplace_back(column(v), number[v], 1.0);
    }
    for (const std::uint32_t v : setup_.exact) {
        const double own = own_weight(setup_.limit, v);
        for (auto k = setup_.limit.first[v]; k < setup_.limit.first[v + 1]; ++k)
            if (const int q = number[setup_.limit.column[k]]; q >= 0)
                entries.emplace_back(column(v), q, -setup_.limit.weight[k] / own);
    }
    system_->from_free.resize(static_cast<int>(n), static_cast<int>(system_->free.size()));
    system_->from_free.setFromTriplets(entries.begin(), entries.end());
    system_->rows = rows_of(setup_);
    system_->reduced = system_->rows * system_->from_free;
    system_->solver.setTolerance(setup_.tolerance);
    system_->solver.setMaxIterations(kMostIterations);
    if (!system_->free.empty()) system_->solver.compute(system_->reduced);
}

LimitFit::~LimitFit() = default;
LimitFit::LimitFit(LimitFit&&) noexcept = default;

void LimitFit::meet(std::vector<double>& control, std::span<const double> data) const {
    const SparseRows& rows = setup_.limit;
    for (std::size_t i = 0; i < setup_.exact.size(); ++i) {
        const std::uint32_t v = setup_.exact[i];
        double rest = data[i];
        for (auto k = rows.first[v]; k < rows.first[v + 1]; ++k)
            if (rows.column[k] != v) rest -= rows.weight[k] * control[rows.column[k]];
        control[v] = rest / own_weight(rows, v);
    }
}

std::vector<double> LimitFit::control(const std::vector<double>& prediction, std::span<const double> data,
                                      const std::vector<double>& start) const {
    const std::size_t n = prediction.size();
    std::vector<double> result(n, 0.0);
    for (std::size_t v = 0; v < n; ++v)
        if (setup_.fixed[v]) result[v] = prediction[v];
    meet(result, data);  // what is there with all free values at 0
    const System& system = *system_;
    if (system.free.empty()) return result;
    const auto given = Eigen::Map<const Vector>(result.data(), static_cast<int>(n));
    Vector right = -(system.rows * given);
    for (std::size_t v = 0; v < n; ++v)
        if (setup_.weight[v] > 0) right[static_cast<int>(v)] += std::sqrt(setup_.weight[v]) * prediction[v];
    const std::vector<double>& guess = start.empty() ? prediction : start;
    Vector first(static_cast<int>(system.free.size()));
    for (std::size_t q = 0; q < system.free.size(); ++q) first[static_cast<int>(q)] = guess[system.free[q]];
    const Vector solved = system.solver.solveWithGuess(right, first);
    for (std::size_t q = 0; q < system.free.size(); ++q) result[system.free[q]] = solved[static_cast<int>(q)];
    meet(result, data);
    return result;
}

namespace {

//! The largest value that all neighbours of an exact vertex may have without its own falling below `lowest`.
double ring_limit(const SparseRows& rows, std::uint32_t v, double data, double lowest) {
    const double own = own_weight(rows, v);
    return own < 1 ? (data - own * lowest) / (1 - own) : data;
}

//! Bring free values up to the lowest, then those around data down as far as the data ask. Never raises one beyond what
//! another datum asks for, since less around one means more at it.
std::vector<std::uint32_t> bounded(const LimitFit& fit, std::vector<double>& control,
                                   std::span<const double> data, const std::vector<double>& lowest) {
    const LimitFitSetup& setup = fit.setup();
    std::vector<char> moved(control.size(), 0);
    std::vector<char> is_exact(control.size(), 0);
    for (const std::uint32_t v : setup.exact) is_exact[v] = 1;
    for (std::size_t v = 0; v < control.size(); ++v)
        if (!setup.fixed[v] && !is_exact[v] && control[v] < lowest[v]) control[v] = lowest[v], moved[v] = 1;
    fit.meet(control, data);
    for (std::size_t i = 0; i < setup.exact.size(); ++i) {
        const std::uint32_t v = setup.exact[i];
        if (control[v] >= lowest[v]) continue;
        const double most = ring_limit(setup.limit, v, data[i], lowest[v]);
        for (auto k = setup.limit.first[v]; k < setup.limit.first[v + 1]; ++k)
            if (const std::uint32_t u = setup.limit.column[k]; u != v && !setup.fixed[u] && control[u] > most)
                control[u] = most, moved[u] = 1;
    }
    fit.meet(control, data);
    std::vector<std::uint32_t> list;
    for (std::uint32_t v = 0; v < moved.size(); ++v)
        if (moved[v]) list.push_back(v);
    return list;
}

}  // namespace

std::vector<double> control_above(LimitFitSetup setup, const std::vector<double>& prediction,
                                  std::span<const double> data, std::vector<double> lowest) {
    const LimitFit free(setup);
    std::vector<double> control = free.control(prediction, data);
    std::vector<double> wanted = prediction;
    for (int round = 0;; ++round) {
        const auto moved = bounded(free, control, data, lowest);
        if (moved.empty() || round == kBoundRounds) return control;
        for (const std::uint32_t v : moved) {
            setup.fixed[v] = 1;
            wanted[v] = control[v];
            lowest[v] = std::min(lowest[v], control[v]);
        }
        control = LimitFit(setup).control(wanted, data, control);
    }
}

}  // namespace stratareeb
