// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/mean_covariance.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "boreholes/site_gaps.h"
#include "boreholes/vecchia_likelihood.h"

namespace stratareeb {

namespace {

constexpr std::size_t kLeastSites = 8;
constexpr double kLongest = 4;     // range of the slowest exponential, in extents
constexpr double kShortest = 0.5;  // range of the fastest one, in median gaps, about
constexpr std::size_t kMostRates = 14;
constexpr double kFreedom = 6;  // of the law of errors
constexpr std::array kNuggets{0.0, 0.01, 0.05, 0.15, 0.3, 0.5, 0.7, 0.9};

struct Candidate {
    Variogram variogram;  // of values of variance 1
    std::size_t rate = 0;
    double misfit = 0;
};

std::size_t number_of_rates(double gap, double extent) {
    const double doublings = std::log2(std::max(1.0, kLongest * extent / (kShortest * gap)));
    return std::min(kMostRates, static_cast<std::size_t>(std::ceil(doublings)) + 1);
}

std::vector<Candidate> candidates(const VecchiaLikelihood& likelihood, double slowest, std::size_t rates) {
    std::vector<Candidate> result;
    for (std::size_t k = 0; k < rates; ++k)
        for (const auto& [model, practical] : {std::pair(VariogramModel::Exponential, kPracticalExponential),
                                               std::pair(VariogramModel::Matern32, kPracticalMatern32)}) {
            const double range = practical / std::ldexp(slowest, static_cast<int>(k));
            const auto structure =
                covariance_kernel({.model = model, .nugget = 0, .sill = 1, .range = range}, 0);
            const auto covariances = likelihood.covariances(*structure);
            for (const double nugget : kNuggets) {
                double sill = 0;
                const double misfit = likelihood.misfit(covariances, nugget, sill, kFreedom);
                result.push_back({{model, sill * nugget, sill * (1 - nugget), range}, k, misfit});
            }
        }
    return result;
}

MeanCovariance weighted(const std::vector<Candidate>& all, double slowest, std::size_t rates,
                        double variance) {
    MeanCovariance mean{slowest, std::vector<double>(rates, 0.0), std::vector<double>(rates, 0.0), 0, {}};
    const Candidate& best = *std::ranges::min_element(all, {}, &Candidate::misfit);
    double sum = 0;
    for (const Candidate& c : all) sum += std::exp((best.misfit - c.misfit) / 2);
    for (const Candidate& c : all) {
        const double weight = std::exp((best.misfit - c.misfit) / 2) / sum * variance;
        mean.nugget += weight * c.variogram.nugget;
        mean.constant[c.rate] += weight * c.variogram.sill;
        if (c.variogram.model == VariogramModel::Matern32) mean.linear[c.rate] += weight * c.variogram.sill;
    }
    mean.likeliest = best.variogram;
    mean.likeliest.nugget *= variance, mean.likeliest.sill *= variance;
    return mean;
}

class MeanCovarianceKernel : public RadialKernel {
 public:
    MeanCovarianceKernel(const MeanCovariance& mean, double micro_range) : mean_(mean), micro_(micro_range) {
        while (mean_.constant.size() > 1 && mean_.constant.back() == 0)
            mean_.constant.pop_back(), mean_.linear.pop_back();
    }

    // The exponential of a doubled rate is the square of the one before.
    void evaluate(std::span<const double> squared_distance, std::span<double> result) const override {
        const auto n = static_cast<Eigen::Index>(result.size());
        const Eigen::ArrayXd r = Eigen::Map<const Eigen::ArrayXd>(squared_distance.data(), n).sqrt();
        Eigen::Map<Eigen::ArrayXd> out(result.data(), n);
        Eigen::ArrayXd power = (-mean_.rate * r).exp();
        out = (mean_.constant[0] + mean_.linear[0] * mean_.rate * r) * power;
        for (std::size_t k = 1; k < mean_.constant.size(); ++k) {
            power = power.square();
            const double rate = std::ldexp(mean_.rate, static_cast<int>(k));
            out += (mean_.constant[k] + mean_.linear[k] * rate * r) * power;
        }
        if (micro_ <= 0 || mean_.nugget <= 0) return;
        for (Eigen::Index i = 0; i < n; ++i)
            if (const double t = r[i] / micro_; t < 1)
                out[i] += mean_.nugget * std::pow(1 - t, 4) * (4 * t + 1);
    }

 private:
    MeanCovariance mean_;
    double micro_;
};

}  // namespace

MeanCovariance mean_covariance(std::span<const Point2> at, std::span<const double> value, int drift) {
    const double n = static_cast<double>(value.size());
    double mean = 0, variance = 0;
    for (const double v : value) mean += v / n;
    for (const double v : value) variance += (v - mean) * (v - mean) / n;
    const bool equal = std::ranges::adjacent_find(value, std::ranges::not_equal_to{}) == value.end();
    if (at.size() < kLeastSites + drift_terms(drift) || equal) {
        const double extent = at.size() > 1 ? extent_of(at) : 0, range = extent > 0 ? extent : 1,
                     sill = equal ? 1 : variance;
        return {kPracticalExponential / range, {sill}, {0}, 0, {VariogramModel::Exponential, 0, sill, range}};
    }
    std::vector<double> scaled(value.begin(), value.end());
    for (double& v : scaled) v = (v - mean) / std::sqrt(variance);
    const VecchiaLikelihood likelihood(at, scaled, drift);
    const double extent = extent_of(at), slowest = kPracticalExponential / (kLongest * extent);
    const std::size_t rates = number_of_rates(median_gap(at), extent);
    return weighted(candidates(likelihood, slowest, rates), slowest, rates, variance);
}

std::unique_ptr<RadialKernel> mean_covariance_kernel(const MeanCovariance& mean, double micro_range) {
    return std::make_unique<MeanCovarianceKernel>(mean, micro_range);
}

}  // namespace stratareeb
