// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "boreholes/interpolator.h"
#include "boreholes/nearest_sites.h"

namespace stratareeb {

//! Inverse distance weighting of the k nearest sites, w_i = ((R − d_i) / (R d_i))^power with R the distance of the next site,
//! so that a site gains and loses its say without a jump (D. Shepard, 1968, with the weights of R. Franke and G. Nielson, 1980);
//! with no more than k sites 1 / d_i^power. Never leaves the range of the values; level at every site.
class InverseDistance : public Interpolator {
 public:
    InverseDistance(std::shared_ptr<const HoleTriangulation> holes, const InterpolatorOptions& options);
    std::vector<std::vector<double>> predict(std::span<const Point2> where,
                                             std::span<const SiteField> fields) const override;

 private:
    //! Of the nearest sites, nearest first; those that have none are taken off.
    void set_weights(std::vector<NearSite>& near, std::vector<double>& weight) const;

    std::shared_ptr<const HoleTriangulation> holes_;
    double power_;
    std::size_t neighbours_;
};

}  // namespace stratareeb
