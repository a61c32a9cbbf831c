// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "boreholes/point.h"
#include "reeb/sampled_contour.h"

namespace stratareeb {

enum class ContourDistance {
    Euclidean,   // between the contours' images in the unit square: their shapes decide
    Parametric,  // between parameters: they stay as they are, up to the nearest vertices
};

enum class RectangleAxes {
    Plane,  // the bounding rectangle's sides along x and y, once the contour's plane is turned level: the thesis
    Principal,  // along the principal axes of both contours together: no matter how they lie in their plane
};

struct CorrespondenceOptions {
    ContourDistance distance = ContourDistance::Euclidean;
    RectangleAxes axes = RectangleAxes::Plane;
    std::size_t samples = 0;  // points per contour at even parameters; 0 = the contour's own points
};

//! Parameters of two contours at the places that belong together.
struct Correspondence {
    double first = 0, second = 0;
    double distance = 0;  // of the two, as measured
};

//! Which point of one contour belongs to which of another (thesis 2.1.2.3.1): each contour's plane, whichever it is, is turned
//! level, its bounding rectangle becomes the unit square, and the closest pair of points there is the answer.
//! A rectangle without width (a line, a point) becomes the middle of the square in that direction. Time: n log n.
//! \throw InvalidInput if a contour is none.
Correspondence correspond(const SampledContour& first, const SampledContour& second,
                          const CorrespondenceOptions& options = {});

//! The same contours with parameters that belong together all the way: the first keeps its own, each next one gets its
//! origin from its correspondence with the one before.
std::vector<SampledContour> corresponding_contours(std::vector<SampledContour> contours,
                                                   const CorrespondenceOptions& options = {});

//! At right angles to a polygon's plane, which runs counter-clockwise seen from its tip; its length is twice the area.
Point3 area_vector(std::span<const Point3> points);

}  // namespace stratareeb
