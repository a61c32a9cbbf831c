// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/spline_fit.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>

namespace stratareeb {
namespace {

// Bending counts as much as a sample's distance on waves of this share of a span: it decides where samples
// don't, and nothing else.
constexpr double kFairWave = 0.05;
constexpr double kEndWeight = 1e6;  // of a sample's weight

constexpr double kTests = 7;  // places a span at which an approximation is compared

using Triplets = std::vector<Eigen::Triplet<double>>;

void add_square(Triplets& entries, const CubicKnots::Values& v, double weight) {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            entries.emplace_back(static_cast<int>(v.first) + i, static_cast<int>(v.first) + j,
                                 weight * v.value[i] * v.value[j]);
}

// The integral of the squared second derivative: piecewise quadratic, so that two Gauss points a span suffice.
void add_bending(Triplets& entries, const CubicKnots& knots, double samples) {
    const double length = knots.high() - knots.low();
    for (std::size_t s = 0; s < knots.spans(); ++s) {
        const double a = knots.breaks()[s], width = knots.breaks()[s + 1] - a;
        const double weight = samples / length * std::pow(kFairWave * width, 4);
        for (const double x : {0.5 - std::sqrt(1.0 / 12), 0.5 + std::sqrt(1.0 / 12)})
            add_square(entries, knots.values(a + x * width, 2), weight * width / 2);
    }
}

std::vector<std::vector<double>> least_squares(const CubicKnots& knots, const std::vector<double>& t,
                                               const std::vector<std::vector<double>>& samples) {
    const auto n = static_cast<Eigen::Index>(knots.functions());
    Triplets entries;
    Eigen::MatrixXd b = Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(samples.size()));
    for (std::size_t i = 0; i < t.size(); ++i) {
        const double weight = i == 0 || i + 1 == t.size() ? kEndWeight : 1;
        const auto v = knots.values(t[i]);
        add_square(entries, v, weight);
        for (std::size_t c = 0; c < samples.size(); ++c)
            for (int k = 0; k < 4; ++k)
                b(static_cast<Eigen::Index>(v.first) + k, static_cast<Eigen::Index>(c)) +=
                    weight * v.value[k] * samples[c][i];
    }
    add_bending(entries, knots, static_cast<double>(t.size()));
    Eigen::SparseMatrix<double> A(n, n);
    A.setFromTriplets(entries.begin(), entries.end());
    const Eigen::MatrixXd x = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(A).solve(b);
    std::vector<std::vector<double>> result;
    for (std::size_t c = 0; c < samples.size(); ++c) {
        const auto column = x.col(static_cast<Eigen::Index>(c));
        result.emplace_back(column.begin(), column.end());
        result.back().front() = samples[c].front();
        result.back().back() = samples[c].back();
    }
    return result;
}

}  // namespace

SplineCurve fit_spline(const std::vector<double>& parameters, const std::vector<std::vector<double>>& samples,
                       const SplineFitOptions& options) {
    CubicKnots knots({parameters.front(), parameters.back()});
    while (true) {
        SplineCurve curve{knots, least_squares(knots, parameters, samples)};
        std::vector<char> halve(knots.spans(), 0);
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            double square = 0;
            for (std::size_t c = 0; c < samples.size(); ++c)
                square += std::pow(curve.at(c, parameters[i]) - samples[c][i], 2);
            if (!(square <= options.tolerance * options.tolerance)) halve[knots.span(parameters[i])] = 1;
        }
        const auto more = static_cast<std::size_t>(std::ranges::count(halve, 1));
        if (more == 0 || knots.spans() + more > options.most_spans) return curve;
        knots = knots.refined(halve);
    }
}

std::vector<double> interpolate_spline(const CubicKnots& knots, const std::function<double(double)>& f) {
    const auto n = static_cast<Eigen::Index>(knots.functions());
    const auto places = knots.greville();
    Triplets entries;
    Eigen::VectorXd b(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto v = knots.values(places[static_cast<std::size_t>(i)]);
        for (int k = 0; k < 4; ++k) entries.emplace_back(i, static_cast<int>(v.first) + k, v.value[k]);
        b[i] = f(places[static_cast<std::size_t>(i)]);
    }
    Eigen::SparseMatrix<double> A(n, n);
    A.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(A);
    const Eigen::VectorXd x = solver.solve(b);
    std::vector<double> result(x.begin(), x.end());
    result.front() = b[0];
    result.back() = b[n - 1];
    return result;
}

SplineCurve approximate(const CubicKnots& first, const std::function<double(double)>& f,
                        const SplineFitOptions& options) {
    CubicKnots knots = first;
    while (true) {
        SplineCurve curve{knots, {interpolate_spline(knots, f)}};
        std::vector<char> halve(knots.spans(), 0);
        for (std::size_t s = 0; s < knots.spans(); ++s) {
            const double a = knots.breaks()[s], width = knots.breaks()[s + 1] - a;
            const double n =
                options.resolution > 0 ? std::max(kTests, std::ceil(width / options.resolution)) : kTests;
            for (double k = 0.5; k < n && !halve[s]; ++k)
                halve[s] =
                    !(std::abs(curve.at(0, a + k / n * width) - f(a + k / n * width)) <= options.tolerance);
        }
        const auto more = static_cast<std::size_t>(std::ranges::count(halve, 1));
        if (more == 0 || knots.spans() + more > options.most_spans) return curve;
        knots = knots.refined(halve);
    }
}

}  // namespace stratareeb
