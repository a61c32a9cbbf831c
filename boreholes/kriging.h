// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "boreholes/radial_interpolator.h"

namespace stratareeb {

//! Ordinary kriging (drift 0) and universal kriging with a linear (1) or quadratic (2) drift (G. Matheron, 1963 and 1969; N. Cressie,
//! "Statistics for Spatial Data", 1993): of all unbiased weighted means the one of least variance. Unless a
//! variogram is given, the covariance is the mean of those that each field allows (mean_covariance.h); with `anisotropy` the
//! likeliest variogram (fit_variogram.h).
//!
//! A nugget would make the surface jump at every hole. By default it is taken as what it mostly is, change over less than the
//! holes' distance: a structure of the range of the median gap between sites, so the surface passes through the values smoothly and
//! is elsewhere what kriging with a nugget gives. With `filter_nugget` it passes beside them.
class Kriging : public RadialInterpolator {
 public:
    Kriging(std::shared_ptr<const HoleTriangulation> holes, int drift, const InterpolatorOptions& options);

    //! The variogram in use for a field, in coordinates and values as given; of those averaged, the likeliest.
    Variogram variogram_of(const SiteField& field) const;

 protected:
    FieldModel model_of(const FieldSites& sites) const override;

 private:
    FieldModel model_with(const Variogram& v, const FieldSites& sites) const;
    FieldModel mean_model(const FieldSites& sites) const;
    //! In local coordinates and scaled values.
    Variogram local(Variogram v, const FieldSites& sites) const;
    bool averages() const { return !variogram_ && !anisotropy_; }

    int drift_;
    std::optional<Variogram> variogram_;
    bool filter_nugget_, anisotropy_;
};

}  // namespace stratareeb
