// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "boreholes/interpolator.h"

namespace stratareeb {

//! Barycentric interpolation on the Delaunay triangles of the holes: the method of the thesis (its
//! section 4.1.3.2). Corners without a say are left out and the other weights made to sum to 1.
class LinearTin : public Interpolator {
 public:
    explicit LinearTin(std::shared_ptr<const HoleTriangulation> holes) : holes_(std::move(holes)) {}
    std::vector<std::vector<double>> predict(std::span<const Point2> where,
                                             std::span<const SiteField> fields) const override;

 private:
    std::shared_ptr<const HoleTriangulation> holes_;
};

}  // namespace stratareeb
