// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/model_column.h"

namespace stratareeb {

std::optional<std::size_t> ModelColumn::layer_at(double z) const {
    if (horizons.empty() || !(z <= horizons.front())) return std::nullopt;
    for (std::size_t i = 0; i + 1 < horizons.size(); ++i)
        if (z >= horizons[i + 1] && horizons[i] > horizons[i + 1]) return i;
    return std::nullopt;
}

std::optional<ModelColumn> ColumnQuery::column(const Point2& place) const {
    const auto found = locator_.locate({place.x - model_.origin.x, place.y - model_.origin.y});
    if (!found) return std::nullopt;
    ModelColumn column{.at = place, .horizons = {}};
    column.horizons.reserve(model_.horizons.size());
    for (const auto& horizon : model_.horizons)
        column.horizons.push_back(found->value(horizon) + model_.origin.z);
    return column;
}

}  // namespace stratareeb
