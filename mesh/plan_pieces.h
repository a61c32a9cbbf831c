// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "boreholes/point.h"
#include "mesh/layer_model.h"

namespace stratareeb {

//! A triangle within a plan triangle, corners by their weights of the plan triangle's own. Pieces of a plan triangle may
//! overlap: those with a negative area are taken away from the others.
struct PlanPiece {
    std::uint32_t face = 0;
    double area = 0;
    std::array<std::array<double, 3>, 3> weights{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

    //! A quantity linear over the plan triangle, at the piece's corners.
    std::array<double, 3> values(const std::array<double, 3>& at_corners) const {
        std::array<double, 3> result{};
        for (std::size_t i = 0; i < 3; ++i)
            result[i] = weights[i][0] == 1   ? at_corners[0]
                        : weights[i][1] == 1 ? at_corners[1]
                        : weights[i][2] == 1 ? at_corners[2]
                                             : weights[i][0] * at_corners[0] + weights[i][1] * at_corners[1] +
                                                   weights[i][2] * at_corners[2];
        return result;
    }
};

//! The part of a model's plan inside areas, piece by piece, in the order of plan triangles: triangles that no ring meets whole,
//! others as sums of what lies below each side of the rings (signed trapezoids, convex). Integrals of pieces add up to the area's
//! to rounding, however it is shaped. Corners are visited in the order of `fv_range`.
//! \param areas rings in map coordinates, outer ones counter-clockwise, holes clockwise, that don't cross or overlap; none =
//! the whole plan
void for_each_piece(const LayerModel& model, const std::vector<std::vector<Point2>>& areas,
                    const std::function<void(const PlanPiece&)>& visit);

}  // namespace stratareeb
