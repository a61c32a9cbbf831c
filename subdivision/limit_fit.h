// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "subdivision/control_topology.h"

namespace stratareeb {

//! What the control values of a field have to do, but for numbers. Fields that share it are solved for with one
//! setup.
struct LimitFitSetup {
    SparseRows limit;            // limit value of each control vertex; row v has column v
    SparseRows fairness;         // sums of control values that should be 0: they are where the field is fair
    std::vector<double> weight;  // by vertex, how much the limit should be as predicted; 0 = no wish
    std::vector<double> fairness_weight;  // by fairness row
    std::vector<char> fixed;              // by vertex: the control value is given
    double tolerance = 1e-12;          // of the solution's residual; data are met to rounding whatever it is
    std::vector<std::uint32_t> exact;  // vertices, none of them fixed, whose limit is given
};

//! Control values whose limit passes through given values exactly and, among all that do, is closest to the prediction
//! and fair: least squares, by conjugate gradients. Data are met by elimination of one control value for each, which
//! leaves a problem whose condition does not depend on its size: nothing to factorise, time and memory are linear.
class LimitFit {
 public:
    //! \pre no two exact vertices are neighbours (see separated_holes)
    explicit LimitFit(LimitFitSetup setup);
    ~LimitFit();
    LimitFit(LimitFit&&) noexcept;

    const LimitFitSetup& setup() const { return setup_; }

    //! `prediction`: limit value wanted, at fixed vertices the control value; `data`: limit values at the exact vertices.
    //! \param start where to start from, if not from the prediction
    std::vector<double> control(const std::vector<double>& prediction, std::span<const double> data,
                                const std::vector<double>& start = {}) const;

    //! The control values at the exact vertices that follow from all others.
    void meet(std::vector<double>& control, std::span<const double> data) const;

 private:
    struct System;
    LimitFitSetup setup_;
    std::unique_ptr<System> system_;
};

//! The same with control values that stay above `lowest` everywhere but at fixed vertices.
//! \pre data are larger than the lowest values around them
std::vector<double> control_above(LimitFitSetup setup, const std::vector<double>& prediction,
                                  std::span<const double> data, std::vector<double> lowest);

}  // namespace stratareeb
