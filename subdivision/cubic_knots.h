// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace stratareeb {

//! Cubic splines of one variable, twice continuously differentiable over given breaks: the B-spline basis with
//! four-fold knots at both ends and single ones between (C. de Boor, A Practical Guide to Splines, 1978).
class CubicKnots {
 public:
    //! The basis functions that are not zero at a place: four neighbours.
    struct Values {
        std::size_t first = 0;
        std::array<double, 4> value{};
    };

    //! \pre at least two breaks, ascending.
    explicit CubicKnots(std::vector<double> breaks);
    static CubicKnots uniform(double low, double high, std::size_t spans);

    std::size_t spans() const { return breaks_.size() - 1; }
    std::size_t functions() const { return breaks_.size() + 2; }
    const std::vector<double>& breaks() const { return breaks_; }
    double low() const { return breaks_.front(); }
    double high() const { return breaks_.back(); }

    //! The span a place lies in; places outside belong to the nearest.
    std::size_t span(double t) const;

    //! Basis functions (derivative 0) or their first or second derivatives at t; beyond the ends the outer
    //! cubic pieces go on.
    Values values(double t, int derivative = 0) const;

    //! The value at t of the spline with the given coefficients, one a function.
    double evaluate(const std::vector<double>& coefficients, double t, int derivative = 0) const;

    //! Coefficients that reproduce the identity t -> t: the means of each three consecutive knots.
    std::vector<double> greville() const;

    //! The spans that an interval reaches into.
    CubicKnots part(double low, double high) const;

    //! The same with the marked spans halved.
    CubicKnots refined(const std::vector<char>& halve) const;

 private:
    //! The four functions over a span, as polynomials of 0 <= s <= 1.
    struct Piece {
        double low, per_width;
        std::array<std::array<double, 4>, 4> of_power;  // [power of s][function]
    };

    Piece piece(std::size_t span) const;
    std::size_t bucket(double t) const;

    std::vector<double> breaks_, knots_;
    std::vector<Piece> pieces_;      // [span]
    std::vector<std::size_t> last_;  // [bucket], all as wide: the last break that lies in it or before
    double buckets_a_unit_ = 0;
};

}  // namespace stratareeb
