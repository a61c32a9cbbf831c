// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "boreholes/point.h"
#include "subdivision/cubic_knots.h"

namespace stratareeb {

//! The normal equations of a bicubic B-spline height over given knots: least squares to weighted heights at places, with
//! bending energy. Coefficients are [function of x][function of y].
class SplineEquations {
 public:
    SplineEquations(const CubicKnots& x, const CubicKnots& y);
    ~SplineEquations();

    //! The integral of z_xx^2 + 2 z_xy^2 + z_yy^2 over the rectangle, times a factor. Forgets all heights.
    void begin_with_bending(double factor);

    //! The same over one span by one, each derivative in lengths of the span in its direction.
    void add_bending_of_span(std::size_t along_x, std::size_t along_y, double factor);

    void add(const Point2& at, double z, double weight);

    //! The coefficients of least squares.
    //! \throw GeometryError if the equations can't be solved.
    std::vector<double> solve();

    //! The same among coefficients that are nowhere above limits (infinity = none), by a primal-dual active set
    //! (M. Hintermueller, K. Ito, K. Kunisch, 2002). Limits hold exactly; where the set does not settle, coefficients are
    //! not quite those of least squares.
    //! \param held [coefficient] to be tried first as those at their limits, and then those that are; empty = none
    std::vector<double> solve_below(const std::vector<double>& highest, std::vector<char>& held);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace stratareeb
