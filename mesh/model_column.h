// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mesh/layer_model.h"
#include "mesh/plan_locator.h"

namespace stratareeb {

//! What a model has below one place: a synthetic log. Elevations in the frame of whoever asked.
struct ModelColumn {
    Point2 at;
    std::vector<double> horizons;  // ground, then the base of each layer; equal where a layer is absent

    double thickness(std::size_t layer) const { return horizons[layer] - horizons[layer + 1]; }
    //! The layer at an elevation: the upper one where two meet, since a log's interval ends with its base. Nothing
    //! above the ground and below the lowest base.
    std::optional<std::size_t> layer_at(double z) const;
};

//! Asks a model what is where, in map coordinates.
class ColumnQuery {
 public:
    //! The model must outlive it.
    explicit ColumnQuery(const LayerModel& model) : model_(model), locator_(model.plan.surface) {}

    //! Nothing outside the footprint. At a borehole, the hole's own column.
    std::optional<ModelColumn> column(const Point2& place) const;

 private:
    const LayerModel& model_;
    PlanLocator locator_;
};

}  // namespace stratareeb
