// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/layer_model.h"

namespace stratareeb {

//! The part of a model between two elevations: a model of its own, whose layers end at the slab's top and bottom.
struct Slab {
    double low = 0,
           high = 0;  // map elevations; the lowest slab's low and the highest one's high are the model's own
    LayerModel model;
};

//! Parts a model by elevation. All slabs share one plan mesh, cut where a horizon is at a level, so that the solids of slabs
//! conform with one another as layers do, and volumes of the slabs add up to those of the layers.
class SlabCutter {
 public:
    //! `levels`: map elevations, ascending, between lowest base and highest ground. A level through a vertex of a horizon would
    //! let bodies touch themselves there: it is moved by a millionth of the model's height or a little more (see levels()).
    //! \throw InvalidInput if levels don't ascend, or one is above or below all of the model
    SlabCutter(const LayerModel& model, std::vector<double> levels);

    std::size_t size() const { return levels_.size() + 1; }
    //! Levels as cut.
    const std::vector<double>& levels() const { return levels_; }
    //! Slab 0 is the lowest.
    Slab slab(std::size_t i) const;

 private:
    LayerModel cut_;
    std::vector<double> levels_;  // map elevations
    std::vector<double> cuts_;    // the same in the model's frame
    double low_ = 0, high_ = 0;   // in the model's frame
};

//! Levels that part a model into slabs of equal height.
//! \throw InvalidInput if count is 0, or the model has no height
std::vector<double> even_levels(const LayerModel& model, std::size_t count);

}  // namespace stratareeb
