// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "boreholes/point.h"
#include "boreholes/variogram.h"

namespace stratareeb {

struct VariogramFitOptions {
    //! Models to choose from; the likeliest is taken.
    std::vector<VariogramModel> models{VariogramModel::Spherical, VariogramModel::Exponential,
                                       VariogramModel::Gaussian, VariogramModel::Matern32,
                                       VariogramModel::Matern52};
    bool anisotropy = true;  // where it is much likelier than none
    int drift = 0;           // degree of the polynomial that the values stray from
};

//! The likeliest variogram of values at distinct sites: restricted likelihood in Vecchia's approximation, each site given those of
//! its nearest sites that come before it in a random order (A. V. Vecchia, 1988; M. L. Stein, Z. Chi and L. J. Welty, 2004), which
//! needs no bins, works on a few dozen sites and on any number of them. Exact for the sites it looks at (at most 700, each with
//! 12 neighbours). Fewer than 8 sites or equal values: no nugget, exponential over the extent.
//! Coordinates should be of size one. The same sites give the same fit.
Variogram fit_variogram(std::span<const Point2> at, std::span<const double> value,
                        const VariogramFitOptions& options = {});

}  // namespace stratareeb
