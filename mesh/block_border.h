// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/layer_model.h"

namespace stratareeb {

//! The outline of one block's model, side by side.
class BlockBorder {
 public:
    //! Every corner of the outline becomes a vertex of the plan mesh, if it is none.
    //! `same`: points closer than that are the same.
    BlockBorder(LayerModel& model, const Footprint& outline, double same);

    //! Plan vertices from corner `side` of a ring to the next corner, both included.
    const std::vector<std::uint32_t>& side(std::size_t ring, std::size_t side) const {
        return sides_[ring][side];
    }

    //! A new vertex on the boundary edge from a to b (inside to the left), `share` of the way; horizons are linear along it.
    static std::uint32_t split_edge(LayerModel& model, std::uint32_t a, std::uint32_t b, const Point2& at,
                                    double share);

 private:
    static std::vector<std::vector<std::uint32_t>> boundary_loops(const TriMesh& mesh);
    void insert_corners(LayerModel& model, const std::vector<Point2>& ring, std::vector<std::uint32_t>& loop,
                        double same);

    std::vector<std::vector<std::vector<std::uint32_t>>> sides_;  // [ring][side][vertex along it]
};

}  // namespace stratareeb
