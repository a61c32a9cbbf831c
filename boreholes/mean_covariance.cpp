// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/mean_covariance.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "boreholes/site_gaps.h"
#include "boreholes/vecchia_likelihood.h"

namespace stratareeb {

namespace {

constexpr std::size_t kLeastSites = 8;
constexpr double kLongest = 32;    // range of the slowest exponential, in extents
constexpr double kShortest = 0.5;  // range of the fastest one, in median gaps, about
constexpr std::size_t kMostRates = 16;
constexpr double kFreedom = 6;  // of the law of errors
constexpr double kLikely = 40;  // of −2 log likelihood, above the least: what is worse has no weight
constexpr std::array kModels{std::pair(VariogramModel::Exponential, kPracticalExponential),
                             std::pair(VariogramModel::Matern32, kPracticalMatern32)};
// A dome of a hundred metres picked to a metre has a nugget of a ten-thousandth.
constexpr std::array kNuggets{0.0, 1e-4, 4e-4, 1.6e-3, 6e-3, 0.025, 0.08, 0.2, 0.4, 0.6, 0.8, 0.95};

std::size_t number_of_rates(double gap, double extent) {
    const double doublings = std::log2(std::max(1.0, kLongest * extent / (kShortest * gap)));
    return std::min(kMostRates, static_cast<std::size_t>(std::ceil(doublings)) + 1);
}

//! One model, rate and nugget of the grid of those looked at.
struct Candidate {
    std::size_t model = 0, rate = 0, nugget = 0;
    double misfit = std::numeric_limits<double>::quiet_NaN(), sill = 0;

    bool is_known() const { return !std::isnan(misfit); }
};

//! Misfits over the grid, where they matter: every other rate and nugget, then whatever is beside a likely one.
class Search {
 public:
    Search(const VecchiaLikelihood& likelihood, double slowest, std::size_t rates)
        : likelihood_(likelihood), slowest_(slowest), rates_(rates), covariances_(kModels.size() * rates) {
        for (std::size_t m = 0; m < kModels.size(); ++m)
            for (std::size_t r = 0; r < rates; ++r)
                for (std::size_t n = 0; n < kNuggets.size(); ++n) all_.push_back({m, r, n});
    }

    std::vector<Candidate> run() {
        for (Candidate& c : all_)
            if (c.rate % 2 == 0 && c.nugget % 2 == 0) rate(c);
        while (add_neighbours()) continue;
        std::erase_if(all_, [](const Candidate& c) { return !c.is_known(); });
        return std::move(all_);
    }

    Variogram variogram(const Candidate& c) const {
        const auto& [model, practical] = kModels[c.model];
        const double nugget = kNuggets[c.nugget];
        return {model, c.sill * nugget, c.sill * (1 - nugget), practical / rate_of(c.rate)};
    }

 private:
    double rate_of(std::size_t r) const { return std::ldexp(slowest_, static_cast<int>(r)); }

    void rate(Candidate& c) {
        auto& covariances = covariances_[c.model * rates_ + c.rate];
        if (covariances.empty()) {
            const auto& [model, practical] = kModels[c.model];
            covariances =
                likelihood_.covariances(*covariance_kernel({model, 0, 1, practical / rate_of(c.rate)}, 0));
        }
        c.misfit = likelihood_.misfit(covariances, kNuggets[c.nugget], c.sill, kFreedom);
        least_ = std::min(least_, c.misfit);
    }

    bool is_likely(std::size_t m, std::size_t r, std::size_t n) const {
        if (r >= rates_ || n >= kNuggets.size()) return false;
        return all_[(m * rates_ + r) * kNuggets.size() + n].misfit < least_ + kLikely;
    }

    bool add_neighbours() {
        std::vector<Candidate*> next;
        for (Candidate& c : all_) {
            const auto [m, r, n] = std::tuple(c.model, c.rate, c.nugget);
            const bool beside = is_likely(m, r + 1, n) || is_likely(m, r - 1, n) || is_likely(m, r, n + 1) ||
                                is_likely(m, r, n - 1) || is_likely(1 - m, r, n);
            if (!c.is_known() && beside) next.push_back(&c);
        }
        for (Candidate* c : next) rate(*c);
        return !next.empty();
    }

    const VecchiaLikelihood& likelihood_;
    double slowest_, least_ = std::numeric_limits<double>::infinity();
    std::size_t rates_;
    std::vector<VecchiaLikelihood::Covariances> covariances_;  // by model, rate
    std::vector<Candidate> all_;                               // by model, rate, nugget
};

MeanCovariance weighted_mean(Search search, double slowest, std::size_t rates, double variance) {
    const std::vector<Candidate> all = search.run();
    MeanCovariance mean{slowest, std::vector<double>(rates, 0.0), std::vector<double>(rates, 0.0), 0, {}};
    const Candidate& best = *std::ranges::min_element(all, {}, &Candidate::misfit);
    double sum = 0;
    for (const Candidate& c : all) sum += std::exp((best.misfit - c.misfit) / 2);
    for (const Candidate& c : all) {
        const double weight = std::exp((best.misfit - c.misfit) / 2) / sum * variance;
        const Variogram v = search.variogram(c);
        mean.nugget += weight * v.nugget;
        mean.constant[c.rate] += weight * v.sill;
        if (v.model == VariogramModel::Matern32) mean.linear[c.rate] += weight * v.sill;
    }
    mean.likeliest = search.variogram(best);
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
    return weighted_mean({likelihood, slowest, rates}, slowest, rates, variance);
}

std::unique_ptr<RadialKernel> mean_covariance_kernel(const MeanCovariance& mean, double micro_range) {
    return std::make_unique<MeanCovarianceKernel>(mean, micro_range);
}

}  // namespace stratareeb
