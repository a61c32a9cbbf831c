// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "boreholes/point.h"
#include "boreholes/radial_kernel.h"

namespace stratareeb {

//! What a surface is made of: a kernel at each site plus a polynomial.
struct RadialModel {
    std::shared_ptr<const RadialKernel> kernel;
    int drift = 0;        // degree of the polynomial: 0, 1 or 2; less where the sites can't tell
    double diagonal = 0;  // added at each site to itself: smoothing, or a nugget to filter out
};

//! The surface z(p) = Σ w_i k(|p − s_i|) + Σ d_j f_j(p) through values at sites (dual kriging, and every spline that is a sum of
//! radial functions), from the dense system
//!     | K + diagonal·I   F | |w|   |z|
//!     | Fᵀ               0 | |d| = |0|.
//! Values that are lower bounds are met as such: of all surfaces z(s_i) ≥ bound the one of least energy wᵀ K w, found by
//! the active-set method (a bound that pulls down is let go, one that is not met is taken up).
class RadialSystem {
 public:
    //! \pre distinct sites of size one, at least one measured; `at_least` is empty or as long as `value`.
    RadialSystem(std::vector<Point2> at, std::span<const double> value, std::span<const char> at_least,
                 const RadialModel& model);
    ~RadialSystem();
    RadialSystem(RadialSystem&&) noexcept;

    double value(const Point2& p) const;
    //! Squared deviation of a new value there from value(p), for a kernel that is a covariance; ≥ 0. The value of a new
    //! observation, so a `diagonal` counts as its nugget.
    double variance(const Point2& p) const;
    //! What each site of the system would be missed by without it: value − prediction from the others (O. Dubrule,
    //! "Cross validation of kriging in a unique neighborhood", 1983). Bounds not in force are left out (0).
    std::vector<double> leave_one_out_errors() const;
    //! zᵀ w / (n − drift terms): the variance factor that the values themselves ask for.
    double energy_per_freedom() const;
    //! For each site: takes part (all measured ones, and the bounds in force).
    std::vector<char> in_force() const;
    //! w, by site; 0 for bounds not in force.
    std::vector<double> weights() const;

 private:
    struct Solution;
    std::unique_ptr<Solution> solution_;
};

}  // namespace stratareeb
