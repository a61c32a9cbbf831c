// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "boreholes/point.h"
#include "boreholes/radial_kernel.h"
#include "boreholes/variogram.h"

namespace stratareeb {

//! The mean of many covariances: C(r) = Σ_k (constant_k + linear_k · s_k) e^(−s_k), s_k = rate · 2^k · r, and a nugget.
struct MeanCovariance {
    double rate = 1;  // per unit of distance, the slowest
    std::vector<double> constant, linear;
    double nugget = 0;
    Variogram likeliest;  // of those averaged
};

//! What values say of their covariance, when no one variogram is the only one that they allow: exponential and Matérn 3/2
//! structures of all ranges from half the median gap to 32 extents, doubling, with nuggets of a dozen shares, each weighted by its
//! likelihood (vecchia_likelihood.h, with Student's t law of 6 degrees of freedom, for thicknesses have long tails). Kriging with the
//! mean of the covariances is the best linear prediction when which of them holds is not known. Nothing is searched for: the
//! result changes as little as the values and coordinates do.
//! Fewer than 8 sites (and the terms of the drift), or equal values: exponential over the extent, no nugget.
//! \param at distinct, of size one.
MeanCovariance mean_covariance(std::span<const Point2> at, std::span<const double> value, int drift);

//! C(r), with the nugget as a structure of `micro_range` (see covariance_kernel); 0 leaves it out.
std::unique_ptr<RadialKernel> mean_covariance_kernel(const MeanCovariance& mean, double micro_range);

}  // namespace stratareeb
