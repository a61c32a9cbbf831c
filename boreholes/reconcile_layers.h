// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace stratareeb {

//! Predictions of one quantity at some places, and how large their errors are.
struct RatedPrediction {
    std::vector<double> value;
    double error = 0;                // root of the mean squared error at left-out sites, same units
    std::vector<double> share = {};  // of that error at each place, >= 0; empty: 1 everywhere
};

//! Layers and the depths of their bases, predicted each by itself, contradict each other. Of all columns this is the one that
//! strays least from both, each in units of its own error: with T the thicknesses, D the depths, the t_i that make
//!     Σ (t_i − T_i)² / error(T_i)² + Σ (t_1 + … + t_i − D_i)² / error(D_i)²
//! least, place by place: a walk whose steps and places are both measured (R. E. Kalman, 1960; H. E. Rauch, F. Tung and
//! C. T. Striebel, 1965). What has no error stays as it is, thicknesses before depths. Where thicknesses add up to the depths, they are
//! returned to the last bit. So a top that is wrong in one hole, which makes one layer too thick and the next too thin, doesn't move all
//! horizons below.
//! \param thickness [layer], all with a value for each place
//! \param depth     [layer], of the layer's base below the first one's top; depth[0] is not looked at
//! \pre equally many; \return [layer][place]
std::vector<std::vector<double>> reconcile_layers(std::span<const RatedPrediction> thickness,
                                                  std::span<const RatedPrediction> depth);

}  // namespace stratareeb
