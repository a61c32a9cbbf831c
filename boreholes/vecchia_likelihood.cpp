// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/vecchia_likelihood.h"

#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

#include "boreholes/nearest_sites.h"

namespace stratareeb {

namespace {

constexpr std::size_t kCoarse =
    400;  // first sites of the order: their neighbours are far, they tell the long range
constexpr std::size_t kFine = 400;  // last sites of the order: their neighbours are near
constexpr std::size_t kTasks = 16;
constexpr double kJitter = 1e-10;  // keeps factors of nearly repeated sites finite
constexpr int kScaleRounds = 8;    // of reweighting, for the scale of Student's t

std::vector<std::uint32_t> random_order(std::size_t count) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::mt19937_64 random(1);
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    return order;
}

//! The closest of some sites, ties by number. Distances alike in the digits of a float are ties, so that rounding of far
//! coordinates doesn't choose other neighbours on a lattice.
void keep_closest(std::vector<NearSite>& near, std::size_t count, std::vector<std::uint32_t>& result) {
    count = std::min(count, near.size());
    std::ranges::partial_sort(
        near, near.begin() + static_cast<std::ptrdiff_t>(count), {},
        [&](const NearSite& n) { return std::pair(static_cast<float>(n.squared_distance), n.site); });
    result.clear();
    for (std::size_t i = 0; i < count; ++i) result.push_back(near[i].site);
}

}  // namespace

//! The first sites given the closest of those before them, the last given the closest of all others.
VecchiaLikelihood::VecchiaLikelihood(std::span<const Point2> at, std::span<const double> value, int drift)
    : terms_(drift_terms(drift)) {
    const std::vector<std::uint32_t> order = random_order(at.size());
    const std::size_t coarse = at.size() <= kCoarse + kFine ? at.size() : kCoarse;
    std::vector<NearSite> near;
    std::vector<std::uint32_t> closest;
    for (std::size_t k = terms_ + 1; k < coarse; ++k) {
        near.clear();
        for (std::size_t j = 0; j < k; ++j) {
            const double dx = at[order[j]].x - at[order[k]].x, dy = at[order[j]].y - at[order[k]].y;
            near.push_back({dx * dx + dy * dy, order[j]});
        }
        keep_closest(near, kNeighbours, closest);
        conditionals_.push_back(conditional_of(at, value, order[k], closest));
    }
    if (coarse == at.size()) return;
    const NearestSites index(at);
    for (std::size_t k = at.size() - kFine; k < at.size(); ++k) {
        index.nearest(at[order[k]], 2 * kNeighbours, near);
        std::erase_if(near, [&](const NearSite& n) { return n.site == order[k]; });
        keep_closest(near, kNeighbours, closest);
        conditionals_.push_back(conditional_of(at, value, order[k], closest));
    }
}

VecchiaLikelihood::Conditional VecchiaLikelihood::conditional_of(std::span<const Point2> at,
                                                                 std::span<const double> value,
                                                                 std::uint32_t site,
                                                                 std::span<const std::uint32_t> near) {
    Conditional result{value[site], {}, {}};
    for (const std::uint32_t n : near) {
        result.others.push_back(value[n]);
        result.step.push_back({at[n].x - at[site].x, at[n].y - at[site].y});
    }
    return result;
}

VecchiaLikelihood::Covariances VecchiaLikelihood::covariances(const RadialKernel& structure,
                                                              const StepMetric& metric) const {
    Covariances result(conditionals_.size() * kPairs);
    tbb::parallel_for(std::size_t{0}, conditionals_.size(), [&](std::size_t k) {
        const auto& step = conditionals_[k].step;
        std::array<Point2, kNeighbours> local;
        for (std::size_t i = 0; i < step.size(); ++i)
            local[i] = {metric.xx * step[i].x + metric.xy * step[i].y,
                        metric.xy * step[i].x + metric.yy * step[i].y};
        std::array<double, kPairs> squared;
        std::size_t count = 0;
        for (std::size_t i = 0; i < step.size(); ++i) {
            squared[count++] = local[i].x * local[i].x + local[i].y * local[i].y;
            for (std::size_t j = 0; j < i; ++j) {
                const double dx = local[i].x - local[j].x, dy = local[i].y - local[j].y;
                squared[count++] = dx * dx + dy * dy;
            }
        }
        structure.evaluate(std::span(squared).first(count), std::span(result).subspan(k * kPairs, count));
    });
    return result;
}

double VecchiaLikelihood::misfit(const Covariances& covariances, double nugget, double& sill,
                                 double freedom) const {
    std::vector<Surprise> surprise(conditionals_.size());
    tbb::parallel_for(std::size_t{0}, kTasks, [&](std::size_t task) {
        const std::size_t begin = task * surprise.size() / kTasks,
                          end = (task + 1) * surprise.size() / kTasks;
        for (std::size_t i = begin; i < end; ++i)
            surprise[i] = surprise_of(conditionals_[i], &covariances[i * kPairs], nugget);
    });
    const double n = static_cast<double>(surprise.size());
    double scaled = 0, logs = 0;
    for (const Surprise& s : surprise) scaled += s.squared_error / s.variance, logs += std::log(s.variance);
    sill = std::max(scaled / n, 1e-300);
    if (freedom <= 0) return n * std::log(sill) + logs;
    double scale = sill;
    for (int round = 0; round < kScaleRounds; ++round) {
        double sum = 0;
        for (const Surprise& s : surprise) {
            const double r = s.squared_error / s.variance;
            sum += (freedom + 1) / (freedom + r / scale) * r;
        }
        scale = std::max(sum / n, 1e-300);
    }
    double result = n * std::log(scale) + logs;
    for (const Surprise& s : surprise)
        result += (freedom + 1) * std::log1p(s.squared_error / s.variance / scale / freedom);
    return result;
}

void VecchiaLikelihood::fill(const Conditional& c, const double* covariance, double nugget,
                             Rows& rows) const {
    const double share = 1 - nugget;
    for (std::size_t i = 0; i < c.others.size(); ++i) {
        const Point2& p = c.step[i];
        rows.right[i] = {share * *covariance++, c.others[i], 1, p.x, p.y, p.x * p.x, p.x * p.y, p.y * p.y};
        for (std::size_t j = 0; j < i; ++j) rows.K[i][j] = share * *covariance++;
        rows.K[i][i] = 1 + kJitter;
    }
}

//! Cholesky's factor L in place of K, L⁻¹ times the right-hand sides in place of them. A pivot that rounding took away counts
//! as small.
void VecchiaLikelihood::eliminate(Rows& rows, std::size_t n) const {
    const std::size_t columns = 2 + terms_;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = rows.K[i][j];
            for (std::size_t k = 0; k < j; ++k) sum -= rows.K[i][k] * rows.K[j][k];
            rows.K[i][j] = j < i ? sum / rows.K[j][j] : std::sqrt(std::max(sum, kJitter));
        }
        for (std::size_t c = 0; c < columns; ++c) {
            double sum = rows.right[i][c];
            for (std::size_t k = 0; k < i; ++k) sum -= rows.K[i][k] * rows.right[k][c];
            rows.right[i][c] = sum / rows.K[i][i];
        }
    }
}

//! Error and variance of the best linear unbiased prediction of the site from its neighbours.
VecchiaLikelihood::Surprise VecchiaLikelihood::surprise_of(const Conditional& c, const double* covariance,
                                                           double nugget) const {
    Rows rows;
    const std::size_t n = c.others.size();
    fill(c, covariance, nugget, rows);
    eliminate(rows, n);
    using Terms = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostTerms, 1>;
    using Normal = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostTerms, kMostTerms>;
    const auto terms = static_cast<Eigen::Index>(terms_);
    Normal normal = Normal::Zero(terms, terms);
    Terms g = Terms::Zero(terms), h = Terms::Zero(terms);
    g[0] = 1;  // the site is the origin of its steps
    double aa = 0, ay = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const auto& r = rows.right[i];
        const Eigen::Map<const Terms> f(r.data() + 2, terms);
        aa += r[0] * r[0], ay += r[0] * r[1];
        g -= r[0] * f, h += r[1] * f;
        normal += f * f.transpose();
    }
    const Eigen::LDLT<Normal> solver(normal);
    const Terms share = solver.solve(g);
    const double error = c.value - (ay + share.dot(h)), variance = 1 - aa + g.dot(share);
    if (!std::isfinite(error) || !(variance > kJitter)) return {c.value * c.value, 1};
    return {error * error, variance};
}

}  // namespace stratareeb
