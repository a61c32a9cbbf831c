// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "boreholes/random_survey.h"
#include "mesh/layer_model.h"

namespace stratareeb::test {

//! A model of 30 random holes and 4 layers with pinch-outs and zeros; every third on the bare triangulation, every fourth of heights
//! rounded to whole units.
inline LayerModel random_model(std::uint64_t seed) {
    LayerModelOptions options;
    if (seed % 3 == 0) options.spacing = 0;
    return build_layer_model(random_survey({.holes = 30,
                                            .layers = 4,
                                            .seed = seed,
                                            .truth = seed % 2 ? TruthKind::Random : TruthKind::Lens,
                                            .pinch_outs = true,
                                            .resolution = seed % 4 ? 0.001 : 1.0,
                                            .zero_share = 0.3}),
                             options);
}

}  // namespace stratareeb::test
