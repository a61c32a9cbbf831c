// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/fit_variogram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "boreholes/radial_kernel.h"
#include "boreholes/site_gaps.h"
#include "boreholes/vecchia_likelihood.h"

namespace stratareeb {

namespace {

constexpr std::size_t kLeastSites = 8;
// Of −2 log likelihood, that anisotropy's two parameters must bring: held-out holes of real surveys are predicted worse with less.
constexpr double kWorthAnisotropy = 12;
constexpr int kIsotropicSteps = 30, kStretchedSteps = 100;  // evaluations of the likelihood

//! Parameters of a fit, all real numbers. The metric is exp of the symmetric (s t; t −s).
struct Parameters {
    std::array<double, 4> x{};  // log range, logit of the nugget's share, s, t
    double range() const { return std::exp(x[0]); }
    double nugget_share() const { return 1 / (1 + std::exp(-x[1])); }
};

StepMetric metric_of(const Parameters& p) {
    const double size = std::hypot(p.x[2], p.x[3]);
    if (size == 0) return {1, 0, 1};
    const double c = std::cosh(size), s = std::sinh(size) / size;
    return {c + s * p.x[2], s * p.x[3], c - s * p.x[2]};
}

//! What is fitted, within which bounds.
class Fit {
 public:
    Fit(const VecchiaLikelihood& likelihood, double nearest, double extent)
        : likelihood_(likelihood), low_range_(std::log(nearest / 2)), high_range_(std::log(4 * extent)) {}

    double misfit(VariogramModel model, Parameters& p, double& sill) const {
        p.x[0] = std::clamp(p.x[0], low_range_, high_range_);
        p.x[1] = std::clamp(p.x[1], model == VariogramModel::Gaussian ? -9.0 : -14.0, 4.0);
        // A weak wish for isotropy and against corners of the parameters that no data tell apart.
        const double stretch = p.x[2] * p.x[2] + p.x[3] * p.x[3];
        const auto kernel =
            covariance_kernel({.model = model, .nugget = 0, .sill = 1, .range = p.range()}, 0);
        return likelihood_.misfit(likelihood_.covariances(*kernel, metric_of(p)), p.nugget_share(), sill) +
               4 * stretch + std::max(0.0, stretch - 1) * 50;
    }

    double low_range() const { return low_range_; }
    double high_range() const { return high_range_; }

    //! Nelder and Mead's simplex (1965) in the first `dimensions` parameters.
    double descend(VariogramModel model, Parameters& best, std::size_t dimensions, double step,
                   int evaluations) const {
        struct Corner {
            double misfit;
            Parameters p;
        };
        double sill = 0;
        std::vector<Corner> simplex;
        const auto corner = [&](Parameters p) {
            const double m = misfit(model, p, sill);
            --evaluations;
            return Corner{m, p};
        };
        simplex.push_back(corner(best));
        for (std::size_t d = 0; d < dimensions; ++d) {
            Parameters p = best;
            p.x[d] += d < 2 ? step : step / 3;
            simplex.push_back(corner(p));
        }
        const auto along = [&](const Parameters& from, const Parameters& to, double t) {
            Parameters p;
            for (std::size_t d = 0; d < 4; ++d) p.x[d] = from.x[d] + t * (to.x[d] - from.x[d]);
            return p;
        };
        while (evaluations > 0) {
            std::ranges::stable_sort(simplex, {}, &Corner::misfit);
            Corner& worst = simplex.back();
            if (worst.misfit - simplex.front().misfit < 1e-3) break;
            Parameters middle;
            for (std::size_t k = 0; k + 1 < simplex.size(); ++k)
                for (std::size_t d = 0; d < 4; ++d)
                    middle.x[d] += simplex[k].p.x[d] / static_cast<double>(simplex.size() - 1);
            const Corner mirrored = corner(along(worst.p, middle, 2));
            if (mirrored.misfit < simplex.front().misfit) {
                const Corner farther = corner(along(worst.p, middle, 3));
                worst = farther.misfit < mirrored.misfit ? farther : mirrored;
            } else if (mirrored.misfit < simplex[simplex.size() - 2].misfit) {
                worst = mirrored;
            } else {
                const Corner nearer =
                    corner(along(worst.p, middle, mirrored.misfit < worst.misfit ? 1.5 : 0.5));
                if (nearer.misfit < std::min(worst.misfit, mirrored.misfit)) {
                    worst = nearer;
                } else {
                    for (std::size_t k = 1; k < simplex.size(); ++k)
                        simplex[k] = corner(along(simplex[k].p, simplex[0].p, 0.5));
                }
            }
        }
        std::ranges::stable_sort(simplex, {}, &Corner::misfit);
        best = simplex.front().p;
        return simplex.front().misfit;
    }

 private:
    const VecchiaLikelihood& likelihood_;
    double low_range_, high_range_;
};

struct Candidate {
    VariogramModel model;
    Parameters p;
    double misfit;
};

//! The best of a few ranges and nuggets.
Parameters rough_fit(const Fit& fit) {
    constexpr VariogramModel kTypical = VariogramModel::Matern32;
    Parameters best;
    double least = std::numeric_limits<double>::infinity(), sill = 0;
    for (int r = 1; r <= 4; ++r)
        for (const double nugget : {-5.0, -1.0}) {
            Parameters p{{fit.low_range() + (fit.high_range() - fit.low_range()) * r / 5, nugget, 0, 0}};
            const double misfit = fit.misfit(kTypical, p, sill);
            if (misfit < least) least = misfit, best = p;
        }
    return best;
}

Variogram as_variogram(const Candidate& c, double sill, double scale) {
    const double size = std::hypot(c.p.x[2], c.p.x[3]), share = c.p.nugget_share();
    // The metric shrinks steps across the stretch: its small eigenvalue's direction is the long one.
    double angle = 0.5 * std::atan2(c.p.x[3], c.p.x[2]) + std::acos(0.0);
    if (size == 0) angle = 0;
    return {.model = c.model,
            .nugget = sill * share * scale,
            .sill = sill * (1 - share) * scale,
            .range = c.p.range() * std::exp(size),
            .ratio = std::exp(-2 * size),
            .angle = angle};
}

}  // namespace

Variogram fit_variogram(std::span<const Point2> at, std::span<const double> value,
                        const VariogramFitOptions& options) {
    const double n = static_cast<double>(value.size());
    double mean = 0, variance = 0;
    for (const double v : value) mean += v / n;
    for (const double v : value) variance += (v - mean) * (v - mean) / n;
    const bool equal = std::ranges::adjacent_find(value, std::ranges::not_equal_to{}) == value.end();
    if (at.size() < kLeastSites + drift_terms(options.drift) || equal) {
        const double extent = at.size() > 1 ? extent_of(at) : 1;
        return {.model = VariogramModel::Exponential,
                .nugget = 0,
                .sill = equal ? 1 : variance,
                .range = extent > 0 ? extent : 1};
    }
    std::vector<double> scaled(value.begin(), value.end());
    for (double& v : scaled) v = (v - mean) / std::sqrt(variance);
    const VecchiaLikelihood likelihood(at, scaled, options.drift);
    const Fit fit(likelihood, median_gap(at), extent_of(at));
    const Parameters start = rough_fit(fit);
    Candidate best{options.models.front(), {}, std::numeric_limits<double>::infinity()};
    for (const VariogramModel model : options.models) {
        Candidate c{model, start, 0};
        c.misfit = fit.descend(model, c.p, 2, 1, kIsotropicSteps);
        if (c.misfit < best.misfit) best = c;
    }
    if (options.anisotropy) {
        Candidate stretched = best;
        stretched.misfit = fit.descend(best.model, stretched.p, 4, 0.6, kStretchedSteps);
        if (stretched.misfit < best.misfit - kWorthAnisotropy) best = stretched;
    }
    double sill = 1;
    fit.misfit(best.model, best.p, sill);
    return as_variogram(best, sill, variance);
}

}  // namespace stratareeb
