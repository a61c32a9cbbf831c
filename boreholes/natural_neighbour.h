// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "boreholes/interpolator.h"

namespace stratareeb {

//! Sibson's C1 natural neighbour interpolant (R. Sibson, "A brief description of natural neighbour
//! interpolation", 1981) with gradients fitted at the sites by least squares over their Delaunay neighbours,
//! weighted by the inverse square of distance. Reproduces linear fields and, inside, spherical quadrics when
//! gradients are exact. Where the tangent planes overshoot, the value is kept within the range of the
//! neighbours widened by half that range on either side, and where they are all positive at no less than half of the
//! smallest. In flat triangles that were peeled off the hull, it goes on from the peeled hull with its gradient.
class NaturalNeighbour : public Interpolator {
 public:
    explicit NaturalNeighbour(std::shared_ptr<const HoleTriangulation> holes);
    std::vector<std::vector<double>> predict(std::span<const Point2> where,
                                             std::span<const SiteField> fields) const override;

 private:
    std::vector<Point2> gradients(const SiteField& field) const;
    double blend(const NaturalPlace& place, const SiteField& field,
                 const std::vector<Point2>& gradient) const;

    std::shared_ptr<const HoleTriangulation> holes_;
    std::vector<std::vector<std::uint32_t>> neighbours_;
};

}  // namespace stratareeb
