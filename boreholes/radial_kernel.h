// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "boreholes/variogram.h"

namespace stratareeb {

//! A function of distance that surfaces are sums of. In local coordinates.
class RadialKernel {
 public:
    virtual ~RadialKernel() = default;
    //! kernel(√squared_distance), one by one; the spans are equally long.
    virtual void evaluate(std::span<const double> squared_distance, std::span<double> result) const = 0;
    double at(double distance) const {
        const double squared = distance * distance;
        double result = 0;
        evaluate({&squared, 1}, {&result, 1});
        return result;
    }
};

//! Covariance C(h) = sill · ρ(h / range) of a variogram's structure, without its nugget. Where `micro_range` > 0 the nugget
//! is taken as a structure of that range: nugget · ψ(h / micro_range), ψ(t) = (1 − t)⁴ (4 t + 1) for t < 1 (H. Wendland, 1995).
//! Distances are in the variogram's own metric, so anisotropy is the caller's.
std::unique_ptr<RadialKernel> covariance_kernel(const Variogram& variogram, double micro_range);

//! Thin-plate spline in tension (P. Wessel and D. Bercovici, "Interpolation with splines in tension: a Green's function
//! approach", 1998): −(K₀(p r) + ln(p r / 2) + γ) · 4 / p², which goes to r² ln r + const · r² as the tension p goes to 0;
//! for p = 0 it is r² ln r (J. Duchon, 1977). Conditionally positive definite given a linear drift.
std::unique_ptr<RadialKernel> spline_kernel(double tension);

}  // namespace stratareeb
