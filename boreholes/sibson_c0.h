// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "boreholes/interpolator.h"

namespace stratareeb {

//! Sibson's C0 interpolant (R. Sibson, 1981): the mean of the natural neighbours, weighted by their coordinates. Never leaves
//! the range of the neighbours; smooth but for the sites, where it has tips.
class SibsonC0 : public Interpolator {
 public:
    explicit SibsonC0(std::shared_ptr<const HoleTriangulation> holes) : holes_(std::move(holes)) {}
    std::vector<std::vector<double>> predict(std::span<const Point2> where,
                                             std::span<const SiteField> fields) const override;

 private:
    std::shared_ptr<const HoleTriangulation> holes_;
};

}  // namespace stratareeb
