// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/fit_variogram.h"

#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <random>

#include "boreholes/nearest_sites.h"
#include "boreholes/radial_kernel.h"
#include "boreholes/site_gaps.h"

namespace stratareeb {

namespace {

constexpr std::size_t kLeastSites = 8;
constexpr std::size_t kNeighbours = 12;
constexpr std::size_t kCoarse =
    400;  // first sites of the order: their neighbours are far, they tell the long range
constexpr std::size_t kFine = 400;  // last sites of the order: their neighbours are near
constexpr std::size_t kTasks = 16;
constexpr double kJitter = 1e-10;  // keeps factors of nearly repeated sites finite
// Of −2 log likelihood, that anisotropy's two parameters must bring: held-out holes of real surveys are predicted worse with less.
constexpr double kWorthAnisotropy = 12;
constexpr int kIsotropicSteps = 30, kStretchedSteps = 100;  // evaluations of the likelihood

//! A site and the sites before it that it is predicted from. Steps lead from the site.
struct Conditional {
    double value = 0;
    std::vector<double> others;
    std::vector<Point2> step;
};

//! Parameters of a fit, all real numbers. The metric is exp of the symmetric (s t; t −s).
struct Parameters {
    std::array<double, 4> x{};  // log range, logit of the nugget's share, s, t
    double range() const { return std::exp(x[0]); }
    double nugget_share() const { return 1 / (1 + std::exp(-x[1])); }
};

struct Metric {
    double xx, xy, yy;
};

Metric metric_of(const Parameters& p) {
    const double size = std::hypot(p.x[2], p.x[3]);
    if (size == 0) return {1, 0, 1};
    const double c = std::cosh(size), s = std::sinh(size) / size;
    return {c + s * p.x[2], s * p.x[3], c - s * p.x[2]};
}

std::vector<std::uint32_t> random_order(std::size_t count) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::mt19937_64 random(1);
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    return order;
}

Conditional conditional_of(std::span<const Point2> at, std::span<const double> value, std::uint32_t site,
                           std::span<const NearSite> near) {
    Conditional result{value[site], {}, {}};
    for (const NearSite& n : near) {
        if (n.site == site || result.others.size() == kNeighbours) continue;
        result.others.push_back(value[n.site]);
        result.step.push_back({at[n.site].x - at[site].x, at[n.site].y - at[site].y});
    }
    return result;
}

//! The first sites given the closest of those before them, the last given the closest of all others.
std::vector<Conditional> conditionals(std::span<const Point2> at, std::span<const double> value,
                                      std::size_t least) {
    const std::vector<std::uint32_t> order = random_order(at.size());
    std::vector<Conditional> result;
    const std::size_t coarse = at.size() <= kCoarse + kFine ? at.size() : kCoarse;
    std::vector<NearSite> near;
    for (std::size_t k = least; k < coarse; ++k) {
        near.clear();
        for (std::size_t j = 0; j < k; ++j) {
            const double dx = at[order[j]].x - at[order[k]].x, dy = at[order[j]].y - at[order[k]].y;
            near.push_back({dx * dx + dy * dy, order[j]});
        }
        const std::size_t count = std::min(kNeighbours, near.size());
        std::ranges::partial_sort(near, near.begin() + static_cast<std::ptrdiff_t>(count));
        result.push_back(conditional_of(at, value, order[k], std::span(near).first(count)));
    }
    if (coarse == at.size()) return result;
    const NearestSites index(at);
    for (std::size_t k = at.size() - kFine; k < at.size(); ++k) {
        index.nearest(at[order[k]], kNeighbours + 1, near);
        result.push_back(conditional_of(at, value, order[k], near));
    }
    return result;
}

constexpr std::size_t kMostTerms = 6;
constexpr std::size_t kMostColumns =
    2 + kMostTerms;  // right-hand sides: covariances to the site, values, drift

struct Surprise {
    double squared_error, variance;  // of the best linear prediction, for a total sill of 1
};

//! The likelihood of a model, site by site.
class Likelihood {
 public:
    Likelihood(std::vector<Conditional> conditionals, int drift)
        : conditionals_(std::move(conditionals)),
          terms_(drift >= 2   ? 6
                 : drift == 1 ? 3
                              : 1) {}

    std::size_t size() const { return conditionals_.size(); }

    //! −2 log of the restricted likelihood, but for a constant; `sill` becomes the total sill that makes it least.
    double misfit(VariogramModel model, const Parameters& p, double& sill) const {
        const double share = p.nugget_share();
        const Variogram structure{.model = model, .nugget = 0, .sill = 1 - share, .range = p.range()};
        const auto kernel = covariance_kernel(structure, 0);
        const Metric metric = metric_of(p);
        std::vector<Surprise> surprise(conditionals_.size());
        tbb::parallel_for(std::size_t{0}, kTasks, [&](std::size_t task) {
            const std::size_t begin = task * surprise.size() / kTasks,
                              end = (task + 1) * surprise.size() / kTasks;
            for (std::size_t i = begin; i < end; ++i)
                surprise[i] = surprise_of(conditionals_[i], *kernel, metric);
        });
        const double n = static_cast<double>(surprise.size());
        double scaled = 0, logs = 0;
        for (const Surprise& s : surprise)
            scaled += s.squared_error / s.variance, logs += std::log(s.variance);
        sill = std::max(scaled / n, 1e-300);
        return n * std::log(sill) + logs;
    }

 private:
    //! Lower triangle of the covariances, row by row, and the right-hand sides.
    struct Rows {
        std::array<std::array<double, kNeighbours>, kNeighbours> K;
        std::array<std::array<double, kMostColumns>, kNeighbours> right;
    };

    void fill(const Conditional& c, const RadialKernel& kernel, const Metric& metric, Rows& rows) const {
        const std::size_t n = c.others.size();
        std::array<Point2, kNeighbours> local;
        for (std::size_t i = 0; i < n; ++i) {
            const Point2& d = c.step[i];
            local[i] = {metric.xx * d.x + metric.xy * d.y, metric.xy * d.x + metric.yy * d.y};
        }
        std::array<double, kNeighbours*(kNeighbours + 1) / 2> squared, covariance;
        std::size_t count = 0;
        for (std::size_t i = 0; i < n; ++i) {
            squared[count++] = local[i].x * local[i].x + local[i].y * local[i].y;
            for (std::size_t j = 0; j < i; ++j) {
                const double dx = local[i].x - local[j].x, dy = local[i].y - local[j].y;
                squared[count++] = dx * dx + dy * dy;
            }
        }
        kernel.evaluate(std::span(squared).first(count), std::span(covariance).first(count));
        count = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const Point2& p = local[i];
            rows.right[i] = {covariance[count++], c.others[i], 1, p.x, p.y, p.x * p.x, p.x * p.y, p.y * p.y};
            for (std::size_t j = 0; j < i; ++j) rows.K[i][j] = covariance[count++];
            rows.K[i][i] = 1 + kJitter;
        }
    }

    //! Cholesky's factor L in place of K, L⁻¹ times the right-hand sides in place of them. A pivot that rounding took away counts
    //! as small.
    void eliminate(Rows& rows, std::size_t n) const {
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
    Surprise surprise_of(const Conditional& c, const RadialKernel& kernel, const Metric& metric) const {
        Rows rows;
        const std::size_t n = c.others.size();
        fill(c, kernel, metric, rows);
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

    std::vector<Conditional> conditionals_;
    std::size_t terms_;
};

//! What is fitted, within which bounds.
class Fit {
 public:
    Fit(const Likelihood& likelihood, double nearest, double extent)
        : likelihood_(likelihood), low_range_(std::log(nearest / 2)), high_range_(std::log(4 * extent)) {}

    double misfit(VariogramModel model, Parameters& p, double& sill) const {
        p.x[0] = std::clamp(p.x[0], low_range_, high_range_);
        p.x[1] = std::clamp(p.x[1], model == VariogramModel::Gaussian ? -9.0 : -14.0, 4.0);
        // A weak wish for isotropy and against corners of the parameters that no data tell apart.
        const double stretch = p.x[2] * p.x[2] + p.x[3] * p.x[3];
        return likelihood_.misfit(model, p, sill) + 4 * stretch + std::max(0.0, stretch - 1) * 50;
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
    const Likelihood& likelihood_;
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
    const std::size_t terms = options.drift >= 2 ? 6 : options.drift == 1 ? 3 : 1;
    const bool equal = std::ranges::adjacent_find(value, std::ranges::not_equal_to{}) == value.end();
    if (at.size() < kLeastSites + terms || equal) {
        const double extent = at.size() > 1 ? extent_of(at) : 1;
        return {.model = VariogramModel::Exponential,
                .nugget = 0,
                .sill = equal ? 1 : variance,
                .range = extent > 0 ? extent : 1};
    }
    std::vector<double> scaled(value.begin(), value.end());
    for (double& v : scaled) v = (v - mean) / std::sqrt(variance);
    const Likelihood likelihood(conditionals(at, scaled, terms + 1), options.drift);
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
