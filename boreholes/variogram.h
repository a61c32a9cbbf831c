// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

enum class VariogramModel { Spherical, Exponential, Gaussian, Matern32, Matern52 };

//! "spherical", "exponential", "gaussian", "matern-3/2", "matern-5/2".
std::string_view name_of(VariogramModel model);
//! \throw InvalidInput for another name.
VariogramModel variogram_model(std::string_view name);

//! How unlike values become with distance: γ(h) = nugget + sill · (1 − ρ(h / range)) for h > 0, γ(0) = 0. `range` is where the
//! spherical model reaches the sill and the others 95 % of it. With anisotropy, `range` holds along `angle` (radians,
//! counter-clockwise from east) and range · ratio across.
struct Variogram {
    VariogramModel model = VariogramModel::Spherical;
    double nugget = 0, sill = 1, range = 1;
    double ratio = 1, angle = 0;

    double at(double distance) const;       // along `angle`
    double at(double dx, double dy) const;  // of a step in plan
};

//! ρ(t), the correlation at t ranges: 1 at 0, 0.05 at 1 (spherical: 0).
//! Spherical 1 − 3t/2 + t³/2; exponential e^(−3t); Gaussian e^(−3t²); Matérn 3/2 (1 + s) e^(−s), s = 4.744 t;
//! Matérn 5/2 (1 + s + s²/3) e^(−s), s = 5.918 t.
double correlation(VariogramModel model, double t);
inline constexpr double kPracticalExponential = 3;
inline constexpr double kPracticalMatern32 = 4.743864518390578;
inline constexpr double kPracticalMatern52 = 5.918649346310187;

//! Mean half squared difference of the pairs of one class of distance.
struct VariogramBin {
    double distance = 0;  // mean of the pairs
    double gamma = 0;
    double pairs = 0;
};

//! Matheron's experimental variogram: bins of equal width up to `reach`. At most 2,000 sites, spread evenly over the list, are
//! paired. Empty bins are left out.
std::vector<VariogramBin> experimental_variogram(std::span<const Point2> at, std::span<const double> value,
                                                 double reach, std::size_t bins = 15);

//! Weighted least squares, weights pairs / γ² (N. Cressie, "Fitting variogram models by weighted least squares", 1985).
//! Isotropic. A fit to fewer than three bins is a guess: no nugget, range the largest distance.
Variogram fit_to_bins(std::span<const VariogramBin> bins, VariogramModel model);

}  // namespace stratareeb
