// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "boreholes/error_by_gap.h"
#include "boreholes/point.h"

namespace stratareeb {

//! How large errors are at a place, from those that a hold-out found: their mean size at such a distance from the nearest
//! hole (error_by_gap.h), times how much larger or smaller the nearest errors are than theirs; the latter drawn towards 1, so that
//! a few lucky holes promise nothing. It works for every interpolator alike, since it is made from errors, not from a model of
//! them.
class LocalError {
 public:
    explicit LocalError(std::vector<PlacedError> errors);
    ~LocalError();
    LocalError(LocalError&&) noexcept;
    LocalError& operator=(LocalError&&) noexcept;

    std::size_t count() const { return errors_.size(); }
    std::span<const PlacedError> errors() const { return errors_; }

    //! Expected size of an error at a place, from all errors. `gap` is the distance of the hole nearest to it.
    double at(const Point2& place, double gap) const;

    //! The same from errors of other draws only: what an error of this draw may be held against.
    double at_without(const Point2& place, double gap, std::size_t draw) const;

 private:
    struct Index;
    double sized(const GapProfile& profile, const Point2& place, double gap,
                 std::optional<std::size_t> draw) const;

    std::vector<PlacedError> errors_;
    std::unique_ptr<Index> index_;
};

//! prediction ± half_width(local error): an interval that holds the truth with a given confidence.
struct PredictionReach {
    double factor = 0;  // of the local error
    double most =
        0;  // a little above the largest of the errors found; where they are rare, a few make the factor huge
    bool certain = true;  // false: too few errors for the confidence; the largest one is taken

    double half_width(double local_error) const { return std::min(factor * local_error, most); }
};

//! The reach for a new place: the conformal quantile of |error| / local error over all errors (V. Vovk, A. Gammerman and G.
//! Shafer, "Algorithmic learning in a random world", 2005; normalised as by H. Papadopoulos, 2008).
PredictionReach prediction_reach(const LocalError& local, double confidence);

//! Are there enough errors for a quantile of this confidence, as 19 for 0.95?
bool has_enough_errors(std::size_t count, double confidence);

//! For each error, the half width of the interval that would have been given there by errors of other draws alone
//! (cross-conformal prediction, V. Vovk, 2015), no wider than the largest of n of those by a
//! share of 10 / n. With exchangeable holes the share of |error| <= half width is at least
//! about the confidence, whatever the interpolator and the law of errors.
std::vector<double> held_out_half_widths(const LocalError& local, double confidence);

}  // namespace stratareeb
