// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/radial_system.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

namespace stratareeb {

namespace {

// A drift term is dropped where it is so nearly a sum of the ones before it, as shares of its own size.
constexpr double kDependent = 1e-7;
constexpr int kActiveSetRounds = 30;
// Added to the diagonal, as a share of the largest kernel value, when the system is singular in doubles.
constexpr std::array kRidges{0.0, 1e-12, 1e-9, 1e-6, 1e-3};

//! 1, u, v, u², uv, v² about the sites' middle, along and across their main direction.
struct Drift {
    Point2 middle, along{1, 0};
    double scale = 1;
    std::vector<int> terms{0};

    double term(int k, const Point2& p) const {
        const double dx = (p.x - middle.x) * scale, dy = (p.y - middle.y) * scale;
        const double u = along.x * dx + along.y * dy, v = along.x * dy - along.y * dx;
        const std::array<double, 6> all{1, u, v, u * u, u * v, v * v};
        return all[static_cast<std::size_t>(k)];
    }
};

Drift drift_frame(std::span<const Point2> at) {
    Drift drift;
    const double n = static_cast<double>(at.size());
    for (const Point2& p : at) drift.middle.x += p.x / n, drift.middle.y += p.y / n;
    double xx = 0, xy = 0, yy = 0;
    for (const Point2& p : at) {
        const double dx = p.x - drift.middle.x, dy = p.y - drift.middle.y;
        xx += dx * dx, xy += dx * dy, yy += dy * dy;
    }
    if (xx + yy > 0) drift.scale = 1 / std::sqrt((xx + yy) / n);
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
    drift.along = {std::cos(angle), std::sin(angle)};
    return drift;
}

//! Keep the terms up to `degree` that the sites can tell apart.
Drift independent_drift(std::span<const Point2> at, int degree) {
    Drift drift = drift_frame(at);
    drift.terms.clear();
    const auto n = static_cast<Eigen::Index>(at.size());
    const int count = degree >= 2 ? 6 : degree == 1 ? 3 : 1;
    Eigen::MatrixXd basis(n, count);
    for (int k = 0; k < count; ++k) {
        if (drift.terms.size() == at.size()) break;
        Eigen::VectorXd column(n);
        for (Eigen::Index i = 0; i < n; ++i) column[i] = drift.term(k, at[static_cast<std::size_t>(i)]);
        const double size = column.norm();
        const auto used = static_cast<Eigen::Index>(drift.terms.size());
        for (int twice = 0; twice < 2; ++twice)
            column -= basis.leftCols(used) * (basis.leftCols(used).transpose() * column);
        if (column.norm() <= kDependent * size) continue;
        basis.col(used) = column.normalized();
        drift.terms.push_back(k);
    }
    return drift;
}

}  // namespace

struct RadialSystem::Solution {
    RadialModel model;
    std::vector<Point2> all_sites, at;  // all, and those that take part
    std::vector<std::size_t> part;      // numbers of the latter
    Drift drift;
    Eigen::VectorXd z, weights;  // of `at`; then of the drift
    Eigen::MatrixXd system;
    Eigen::PartialPivLU<Eigen::MatrixXd> lu;
    mutable std::vector<double> distances, kernels;
    double kernel_at_zero = 0;

    Eigen::Index sites() const { return static_cast<Eigen::Index>(at.size()); }
    Eigen::Index rows() const { return sites() + static_cast<Eigen::Index>(drift.terms.size()); }

    void take(std::span<const char> taking_part, std::span<const double> value) {
        part.clear(), at.clear();
        for (std::size_t i = 0; i < all_sites.size(); ++i)
            if (taking_part[i]) part.push_back(i), at.push_back(all_sites[i]);
        z.resize(sites());
        for (std::size_t k = 0; k < part.size(); ++k) z[static_cast<Eigen::Index>(k)] = value[part[k]];
        drift = independent_drift(at, model.drift);
    }

    //! Kernels of the sites, then drift terms, at a place.
    Eigen::VectorXd row(const Point2& p) const {
        std::vector<double> squared(at.size());
        for (std::size_t i = 0; i < at.size(); ++i) {
            const double dx = at[i].x - p.x, dy = at[i].y - p.y;
            squared[i] = dx * dx + dy * dy;
        }
        Eigen::VectorXd result(rows());
        model.kernel->evaluate(squared, {result.data(), at.size()});
        for (std::size_t k = 0; k < drift.terms.size(); ++k)
            result[sites() + static_cast<Eigen::Index>(k)] = drift.term(drift.terms[k], p);
        return result;
    }

    void solve() {
        const Eigen::Index n = sites(), m = rows();
        system.setZero(m, m);
        for (Eigen::Index i = 0; i < n; ++i) {
            const Eigen::VectorXd r = row(at[static_cast<std::size_t>(i)]);
            system.col(i).head(n) = r.head(n);
            system.row(i).tail(m - n) = r.tail(m - n).transpose();
            system.col(i).tail(m - n) = r.tail(m - n);
        }
        kernel_at_zero = model.kernel->at(0);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(m);
        right.head(n) = z;
        const double size = std::max(system.topLeftCorner(n, n).cwiseAbs().maxCoeff(), 1e-300);
        system.diagonal().head(n).array() += model.diagonal;
        double before = 0;
        for (const double ridge : kRidges) {
            system.diagonal().head(n).array() += (ridge - before) * size;
            before = ridge;
            lu.compute(system);
            weights = lu.solve(right);
            if (!weights.allFinite()) continue;
            const double miss = (system * weights - right).cwiseAbs().maxCoeff();
            if (miss <= 1e-7 * (1 + z.cwiseAbs().maxCoeff())) return;
        }
        if (!weights.allFinite()) weights.setZero(), weights[n] = z.mean();
    }

    double value(const Point2& p) const { return row(p).dot(weights); }
};

RadialSystem::RadialSystem(std::vector<Point2> at, std::span<const double> value,
                           std::span<const char> at_least, const RadialModel& model)
    : solution_(std::make_unique<Solution>()) {
    Solution& s = *solution_;
    s.model = model;
    s.all_sites = std::move(at);
    std::vector<char> taking_part(value.size(), 1);
    for (std::size_t i = 0; i < at_least.size(); ++i) taking_part[i] = !at_least[i];
    s.take(taking_part, value);
    s.solve();
    if (at_least.empty() || s.part.size() == value.size()) return;
    for (int round = 0; round < kActiveSetRounds; ++round) {
        bool changed = false;
        std::vector<char> next = taking_part;
        for (std::size_t k = 0; k < s.part.size(); ++k)
            if (at_least[s.part[k]] && s.weights[static_cast<Eigen::Index>(k)] < 0)
                next[s.part[k]] = 0, changed = true;
        for (std::size_t i = 0; i < value.size(); ++i) {
            if (taking_part[i] || s.value(s.all_sites[i]) >= value[i]) continue;
            next[i] = 1, changed = true;
        }
        if (!changed) return;
        taking_part = std::move(next);
        s.take(taking_part, value);
        s.solve();
    }
}

RadialSystem::~RadialSystem() = default;
RadialSystem::RadialSystem(RadialSystem&&) noexcept = default;

double RadialSystem::value(const Point2& p) const {
    return solution_->value(p);
}

double RadialSystem::variance(const Point2& p) const {
    const Eigen::VectorXd row = solution_->row(p);
    const double kept = row.dot(solution_->lu.solve(row));
    return std::max(0.0, solution_->kernel_at_zero + solution_->model.diagonal - kept);
}

std::vector<double> RadialSystem::leave_one_out_errors() const {
    const Solution& s = *solution_;
    std::vector<double> result(s.all_sites.size(), 0.0);
    const Eigen::MatrixXd inverse = s.lu.inverse();
    for (std::size_t k = 0; k < s.part.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        result[s.part[k]] = s.weights[i] / inverse(i, i);
    }
    return result;
}

double RadialSystem::energy_per_freedom() const {
    const Solution& s = *solution_;
    const double freedom = static_cast<double>(s.sites() - static_cast<Eigen::Index>(s.drift.terms.size()));
    return freedom > 0 ? std::max(0.0, s.z.dot(s.weights.head(s.sites())) / freedom) : 0;
}

std::vector<char> RadialSystem::in_force() const {
    std::vector<char> result(solution_->all_sites.size(), 0);
    for (const std::size_t i : solution_->part) result[i] = 1;
    return result;
}

std::vector<double> RadialSystem::weights() const {
    std::vector<double> result(solution_->all_sites.size(), 0.0);
    for (std::size_t k = 0; k < solution_->part.size(); ++k)
        result[solution_->part[k]] = solution_->weights[static_cast<Eigen::Index>(k)];
    return result;
}

}  // namespace stratareeb
