// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "boreholes/borehole.h"
#include "boreholes/column_field.h"
#include "boreholes/complete_columns.h"

namespace stratareeb {

//! Columns at places without a hole. Elevations and thicknesses in survey units.
struct PredictedColumns {
    std::vector<double> ground;                  // elevation, per place
    std::vector<std::vector<double>> thickness;  // [layer][place], >= 0; 0 = absent
    std::vector<char> inside;                    // per place: in the holes' hull or on it

    //! Elevation of horizon k at a place: 0 the ground, k = i + 1 the base of layer i.
    double horizon(std::size_t k, std::size_t place) const;
};

//! What a layer model of a survey says at any place, without a mesh: the holes' columns are completed, then the ground and
//! the thickness of every layer are predicted from them, and layers are cut by options.rules.
class ColumnPredictor {
 public:
    //! `bare`: on the plain Delaunay triangulation of the holes, as the thesis does and as models without spacing are
    //! built; otherwise flat triangles along the hull are left out, as in models with a spacing.
    //! \throw InvalidInput as complete_columns does.
    explicit ColumnPredictor(const Survey& survey, const CompletionOptions& options = {}, bool bare = false);

    //! Places in survey coordinates.
    PredictedColumns at(std::span<const Point2> where) const;

    const std::vector<std::string>& notes() const { return field_.columns().notes; }

 private:
    std::vector<std::vector<double>> ruled(std::span<const Point2> local,
                                           std::span<const double> ground) const;

    LayerRules rules_;
    ColumnField field_;  // counted from the first hole, for the last digits' sake
};

}  // namespace stratareeb
