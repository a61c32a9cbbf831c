// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "boreholes/interpolator.h"
#include "boreholes/pinch_out.h"

namespace stratareeb {

//! Thickness of every layer anywhere in plan, predicted from holes at which it is known.
//!
//! A layer's *share* at a place is the sum of barycentric weights, in the holes' triangulation, of the
//! corners that have the layer: 1 amid holes that have it, 0 amid holes that lack it, linear in between. Its
//! pinch-out line is the level set share = fraction of the rule, one straight piece per triangle. Inside of
//! it the thickness is (share - fraction) / (1 - fraction) times the interpolator's prediction from the holes
//! that have the layer. With linear interpolation and fraction 0 that is plain linear interpolation of
//! thickness with zeros, as in the thesis.
class ThicknessField {
 public:
    //! `thickness[layer][site]`, >= 0; 0 = absent. `holes` is the triangulation of the shares; the
    //! interpolator may stand on another one of the same sites. `known[layer][site]`: sites where it is 0 tell whether the layer is
    //! there, but have no say in how thick it is elsewhere; empty = all have.
    ThicknessField(std::shared_ptr<const HoleTriangulation> holes, std::vector<std::vector<double>> thickness,
                   PinchOutRule rule, std::unique_ptr<Interpolator> interpolator,
                   const std::vector<std::vector<char>>& known = {});

    std::size_t layers() const { return thickness_.size(); }
    const HoleTriangulation& holes() const { return *holes_; }
    PinchOutRule rule() const { return rule_; }
    const std::vector<double>& at_sites(std::size_t layer) const { return thickness_[layer]; }

    bool has(std::size_t layer, std::size_t site) const { return present_[layer][site] != 0; }
    double share(std::size_t layer, const PlanLocation& location) const;
    //! How far the layer has come from its pinch-out line: 0 on it and beyond, 1 amid holes that have the layer.
    double taper(std::size_t layer, const PlanLocation& location) const;
    //! Strictly inside the pinch-out line.
    bool is_present(std::size_t layer, const PlanLocation& location) const;

    //! result[layer][place]; 0 beyond a layer's pinch-out line.
    std::vector<std::vector<double>> predict(std::span<const Point2> where) const;

 private:
    double mean_of_present(std::size_t layer, const PlanLocation& location) const;

    std::shared_ptr<const HoleTriangulation> holes_;
    std::vector<std::vector<double>> thickness_;
    std::vector<std::vector<char>> present_, has_say_, known_;
    PinchOutRule rule_;
    std::unique_ptr<Interpolator> interpolator_;
};

}  // namespace stratareeb
