// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "reeb/homotopy.h"
#include "reeb/monotone_edge.h"

namespace stratareeb {

//! k(t) = (1 - cos 2 pi t) / 2: 0 with slope 0 at both ends, 1 in the middle.
double sliding_weight(double t);

//! A homotopy that leans along an edge of the graph (thesis 2.1.2.3.3): between two contours it is
//! SH(s, t) = H(s, t) + k(t) (ev(t) - hv(t)), where ev is the way the edge has gone since the lower contour and hv the way
//! that the contour's mean over s has gone. The edge is asked at the height of t, so it does not matter how it is
//! parametrised, where it passes the contours, or that it goes on beyond them. Exact at the given contours;
//! C1 across them where H is, since the slide and its slope vanish there; C1 between them where the edge, too, is C1 over z.
class SlidingHomotopy {
 public:
    //! \throw InvalidInput if the edge does not reach from the lowest to the highest contour.
    SlidingHomotopy(ContourHomotopy homotopy, MonotoneEdge edge);

    const ContourHomotopy& homotopy() const { return homotopy_; }

    //! k(t) (ev(t) - hv(t)), the same for all s.
    Point3 sliding_vector(std::size_t interval, double t) const;

    //! As of ContourHomotopy.
    Point3 at(double s, std::size_t interval, double t) const;
    std::vector<Point3> contour_at(std::span<const double> s, std::size_t interval, double t) const;
    SampledContour contour(std::size_t interval, double t) const;
    std::vector<SampledContour> contours_between(std::size_t interval, std::size_t steps) const;

 private:
    ContourHomotopy homotopy_;
    MonotoneEdge edge_;
};

}  // namespace stratareeb
