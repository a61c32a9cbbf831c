// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! An error that a hold-out found: where, in which draw, and predicted - actual.
struct PlacedError {
    Point2 at;
    std::size_t draw = 0;
    double error = 0;
    double gap = 0;  // distance of the nearest hole that the prediction was made from
};

//! Mean size of errors over the distance of the nearest hole: linear between a few distances, never falling, level beyond the
//! first and the last.
struct GapProfile {
    std::vector<double> gap, size;  // gaps ascending; empty where nothing is known
    double at(double distance) const;
};

//! How errors grow with the distance of the nearest hole: means of classes of at least 30 errors (one class of fewer than 60),
//! made to rise by pooling neighbours (R. E. Barlow et al., "Statistical inference under order restrictions", 1972).
class ErrorByGap {
 public:
    explicit ErrorByGap(std::span<const PlacedError> errors);

    //! From all errors.
    GapProfile profile() const;
    //! From errors of other draws.
    GapProfile without(std::size_t draw) const;

 private:
    struct Class {
        double gap = 0, size = 0;  // sums
        double count = 0;
    };
    static GapProfile rising(const std::vector<Class>& classes);

    std::vector<Class> classes_;
    std::map<std::size_t, std::vector<Class>> of_draw_;
};

//! For each asked hole the distance of the nearest one of another draw among those that know.
//! \param draw of the hole in `know`; as many as those. Holes that are in no draw have one of their own.
//! \return 0 where there is none
std::vector<double> gaps_to_other_draws(std::span<const Point2> know, std::span<const std::size_t> draw,
                                        std::span<const std::size_t> asked);

}  // namespace stratareeb
