// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace stratareeb {

enum class HomotopyKind { Linear, Parabola, Quadrant, Cardinal, CatmullRom, NaturalCubic };

//! "linear", "parabola", "quadrant", "cardinal", "catmull-rom", "natural-cubic".
std::string_view homotopy_name(HomotopyKind kind);
std::optional<HomotopyKind> homotopy_kind(std::string_view name);

//! Where parabola and quadrant start, that is, stand upright: at the lower contour of two, or at the upper.
enum class HomotopyDirection { Upward, Downward };

//! How heights go with the places that contours are mixed over. Even: they are the heights themselves, as in the thesis. Round: those
//! of a HeightScale, for contours of smooth surfaces beside minima, maxima and saddles.
enum class HomotopyPace { Even, Round };

struct HomotopyOptions {
    HomotopyKind kind = HomotopyKind::NaturalCubic;
    HomotopyPace pace = HomotopyPace::Even;
    HomotopyDirection direction = HomotopyDirection::Upward;
    double tension = 0.5;  // Cardinal: 1/2 takes straight strands and evenly spaced parabolas as they are
    double a = 0.5;        // Catmull-Rom: share of the next interval in the slope where an interval starts
    double b = 0.5;        // the same where an interval ends

    friend bool operator==(const HomotopyOptions&, const HomotopyOptions&) = default;
};

struct ContourWeight {
    std::size_t contour = 0;
    double weight = 0;
};

//! How a homotopy mixes the contours of a strand: every kind is a sum of them with weights that depend on the place only,
//! add up to 1, and single out the given contour at its own place (thesis 2.1.2.3.2 and 3.2).
//!
//! Linear, parabola and quadrant mix the two contours around: C0. Cardinal and Catmull-Rom (a = b) mix four: C1; their slopes
//! are the thesis's where contours are evenly spaced, and divided by the spacing where they are not, without which they
//! would not be C1 over height. Where four are lacking, a virtual contour mirrors the second in the first (or the last but
//! one in the last). A Cardinal one of round pace has the slopes of parabolas through three contours, at the ends too: what moves as a
//! parabola comes back whatever the spacing (for tension 1/2; slopes are proportional to it). Natural cubic mixes all: C2, second derivative 0 at both ends; n contours have n - 1 pieces (the
//! printed ranges have one too many); weights below 1e-18 are left out.
class HomotopyWeights {
 public:
    //! `places`: one per contour, strictly ascending, at least two.
    //! \throw InvalidInput if they are not, or a number among the options is not finite.
    HomotopyWeights(std::vector<double> places, const HomotopyOptions& options);

    std::size_t intervals() const { return places_.size() - 1; }
    const std::vector<double>& places() const { return places_; }

    //! Weights at share t in [0, 1] of the way from contour `interval` to the next; ascending by contour.
    std::vector<ContourWeight> at(std::size_t interval, double t) const;

 private:
    double step(std::size_t interval) const { return places_[interval + 1] - places_[interval]; }
    std::vector<ContourWeight> of_two(std::size_t interval, double t) const;
    std::vector<ContourWeight> parabola_slope(std::size_t contour) const;
    std::vector<ContourWeight> of_four(std::size_t interval, double t) const;
    std::vector<ContourWeight> of_all(std::size_t interval, double t) const;
    std::vector<double> solved(std::vector<double> right_side) const;

    std::vector<double> places_;
    HomotopyOptions options_;
    std::vector<double> pivots_;  // of the natural spline's tridiagonal matrix, one per inner contour
};

}  // namespace stratareeb
