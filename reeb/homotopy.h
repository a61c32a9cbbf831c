// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "boreholes/point.h"
#include "reeb/height_scale.h"
#include "reeb/homotopy_weights.h"
#include "reeb/sampled_contour.h"

namespace stratareeb {

//! The contours between given ones: H(s, t) for t from 0 to 1 in each interval between a contour and the next (thesis
//! 2.1.1.4). Every point moves in plan by the weights of its kind; its height runs evenly with t (or as a scale says), so that level contours
//! stay level; what a tilted contour deviates from its level is mixed as x and y are. The given contours are
//! met to the last bit. A contour of one point is the tip of a cap.
class ContourHomotopy {
 public:
    //! Vertical interpolation: contours bottom to top, corresponding (corresponding_contours), and their heights.
    //! \throw InvalidInput if a contour is none, counts differ, there are fewer than two or heights don't rise.
    ContourHomotopy(std::vector<SampledContour> contours, const std::vector<double>& heights,
                    const HomotopyOptions& options = {});
    //! The same over the places that the scale gives to heights.
    ContourHomotopy(std::vector<SampledContour> contours, const std::vector<double>& heights,
                    const HomotopyOptions& options, const HeightScale& scale);
    //! The same with other places than heights to run over: contour i is at places[i] and at height levels[i].
    ContourHomotopy(std::vector<SampledContour> contours, std::vector<double> places,
                    std::vector<double> levels, const HomotopyOptions& options);

    std::size_t intervals() const { return weights_.intervals(); }
    const std::vector<SampledContour>& contours() const { return contours_; }
    const std::vector<double>& places() const { return weights_.places(); }
    const std::vector<double>& levels() const { return levels_; }

    //! H at one parameter. \pre interval < intervals(), t in [0, 1]: as in all that follows.
    Point3 at(double s, std::size_t interval, double t) const;
    //! H at many parameters: a whole contour.
    std::vector<Point3> contour_at(std::span<const double> s, std::size_t interval, double t) const;
    //! The contour at t with the parameters of the given contour nearer to it and those where the other one has corners (joint_parameters),
    //! or of one of them if the other is a point.
    SampledContour contour(std::size_t interval, double t) const;
    //! The steps - 1 contours at t = 1/steps, 2/steps, ... strictly inside an interval.
    std::vector<SampledContour> contours_between(std::size_t interval, std::size_t steps) const;

    //! The height at t.
    double level(std::size_t interval, double t) const;
    //! The mean of H(s, t) over s.
    Point3 mean(std::size_t interval, double t) const;

 private:
    std::vector<Point3> mixed(std::size_t interval, double t, std::span<const ContourWeight> weights,
                              std::span<const std::vector<Point3>> given) const;
    std::vector<SampledContour> contours_at(std::span<const double> s, std::size_t interval,
                                            std::span<const double> t) const;
    std::vector<double> parameters_near(std::size_t interval, double t) const;

    std::vector<SampledContour> contours_;
    std::vector<double> levels_;
    HomotopyWeights weights_;
    std::optional<HeightScale> scale_;        // of the heights between; else they run evenly
    std::vector<std::vector<Point3>> means_;  // one point per contour
};

//! An interval and the share of it.
struct HomotopyPlace {
    std::size_t interval = 0;
    double t = 0;
};

//! Where a height (or any other place) lies among ascending ones.
//! \throw InvalidInput if it is outside all of them.
HomotopyPlace homotopy_place(std::span<const double> places, double place);

//! Horizontal interpolation (thesis 3.2): contours of nested layers at one height, outermost to innermost or the other way
//! round, corresponding. They run over the mean distance between them, so that evenly spaced t are evenly spaced layers.
//! \throw InvalidInput if they are not all at one height or two in a row are the same.
ContourHomotopy horizontal_homotopy(std::vector<SampledContour> contours,
                                    const HomotopyOptions& options = {});

}  // namespace stratareeb
