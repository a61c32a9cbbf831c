// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "boreholes/radial_interpolator.h"

namespace stratareeb {

//! The surface of least bending through the values, ∫ |D²z|² + p² |∇z|² (J. Duchon, 1977, for p = 0; in tension p: P. Wessel and
//! D. Bercovici, 1998), or beside them with smoothing (G. Wahba, "Spline Models for Observational Data", 1990). Reproduces planes.
//! Its deviation is that of the kriging which it equals, with the variance that the values ask for.
class ThinPlateSpline : public RadialInterpolator {
 public:
    ThinPlateSpline(std::shared_ptr<const HoleTriangulation> holes, const InterpolatorOptions& options);

 protected:
    FieldModel model_of(const FieldSites& sites) const override;

 private:
    std::optional<double> tension_;
    double smoothing_;
    bool smoothing_by_data_;
};

}  // namespace stratareeb
