// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "boreholes/hole_triangulation.h"
#include "boreholes/point.h"

namespace stratareeb {

//! A quantity at the sites of a triangulation. Sites whose `use` is 0 have no say; empty `use` means all.
struct SiteField {
    std::span<const double> value;
    std::span<const char> use;
};

//! A way to predict values between scattered sites. Outside the sites' hull, every interpolator here gives
//! the value of the closest hull point.
class Interpolator {
 public:
    virtual ~Interpolator() = default;

    //! Several fields over the same sites at the same places; result[field][place]. The value is 0 where none
    //! of the sites around a place has a say. At a used site it is that site's value, to the last bit.
    virtual std::vector<std::vector<double>> predict(std::span<const Point2> where,
                                                     std::span<const SiteField> fields) const = 0;
};

enum class InterpolatorKind {
    Linear,            // barycentric on the Delaunay triangulation (TIN), C0; the thesis's method
    NaturalNeighbour,  // Sibson's C1 interpolant (R. Sibson, 1981), smooth away from the sites
};

//! "linear" or "natural".
//! \throw InvalidInput for any other name.
InterpolatorKind interpolator_kind(std::string_view name);

std::unique_ptr<Interpolator> make_interpolator(InterpolatorKind kind,
                                                std::shared_ptr<const HoleTriangulation> holes);

}  // namespace stratareeb
