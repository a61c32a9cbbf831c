// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "boreholes/point.h"
#include "boreholes/radial_kernel.h"

namespace stratareeb {

//! A linear map of steps in plan, symmetric: (xx xy; xy yy).
struct StepMetric {
    double xx = 1, xy = 0, yy = 1;
};

//! How likely values at sites are, given a covariance: restricted likelihood in Vecchia's approximation, each site given 12 of
//! those before it in a random order (A. V. Vecchia, 1988; M. L. Stein, Z. Chi and L. J. Welty, 2004). Of many sites 800 are looked
//! at: the first of the order, whose neighbours are far, tell the long range, the last ones the short one.
class VecchiaLikelihood {
 public:
    //! `drift` is the degree of the polynomial that the values stray from. \pre distinct sites of size one, more than its terms.
    VecchiaLikelihood(std::span<const Point2> at, std::span<const double> value, int drift);

    //! Covariances among each site and its neighbours, for a structure of sill 1 without nugget; of use for any nugget.
    using Covariances = std::vector<double>;
    Covariances covariances(const RadialKernel& structure, const StepMetric& metric = {}) const;

    //! −2 log of the likelihood, but for a constant, of `nugget` (a share of the total sill) and the structure. `sill` becomes the
    //! total sill that makes it least. With `freedom` > 0 errors are taken to have Student's t law of so many degrees of
    //! freedom, by which a few wild values say little; 0 is the normal law.
    double misfit(const Covariances& covariances, double nugget, double& sill, double freedom = 0) const;

 private:
    static constexpr std::size_t kNeighbours = 12, kMostTerms = 6;
    static constexpr std::size_t kPairs = kNeighbours * (kNeighbours + 1) / 2;
    //! Right-hand sides: covariances to the site, values, drift.
    static constexpr std::size_t kMostColumns = 2 + kMostTerms;

    //! A site and the sites before it that it is predicted from. Steps lead from the site.
    struct Conditional {
        double value = 0;
        std::vector<double> others;
        std::vector<Point2> step;
    };
    struct Surprise {
        double squared_error, variance;  // of the best linear prediction, for a total sill of 1
    };
    //! Lower triangle of the covariances, row by row, and the right-hand sides.
    struct Rows {
        std::array<std::array<double, kNeighbours>, kNeighbours> K;
        std::array<std::array<double, kMostColumns>, kNeighbours> right;
    };

    static Conditional conditional_of(std::span<const Point2> at, std::span<const double> value,
                                      std::uint32_t site, std::span<const std::uint32_t> near);
    void fill(const Conditional& c, const double* covariance, double nugget, Rows& rows) const;
    void eliminate(Rows& rows, std::size_t n) const;
    Surprise surprise_of(const Conditional& c, const double* covariance, double nugget) const;

    std::vector<Conditional> conditionals_;
    std::size_t terms_;
};

//! Of a polynomial of that degree in x and y.
constexpr std::size_t drift_terms(int degree) {
    return degree >= 2 ? 6 : degree == 1 ? 3 : 1;
}

}  // namespace stratareeb
