// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "boreholes/interpolator.h"

namespace stratareeb {

//! A grid of least curvature (I. C. Briggs, "Machine contouring using minimum curvature", 1974), with tension T if asked for
//! (W. H. F. Smith and P. Wessel, 1990): of all grids through the sites the one that makes
//! (1 − T) Σ (z_xx² + 2 z_xy² + z_yy²) + T Σ |∇z|² least, edges free, as one sparse system of equations. Between its nodes the
//! surface is bicubic; what it still misses at the sites is added as a natural neighbour surface of its own, so that values
//! are met to the last bit however coarse the grid.
class MinimumCurvature : public Interpolator {
 public:
    MinimumCurvature(std::shared_ptr<const HoleTriangulation> holes, const InterpolatorOptions& options);
    std::vector<std::vector<double>> predict(std::span<const Point2> where,
                                             std::span<const SiteField> fields) const override;

 private:
    std::shared_ptr<const HoleTriangulation> holes_;
    double tension_;
    std::size_t nodes_;
};

}  // namespace stratareeb
