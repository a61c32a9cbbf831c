// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/height_scale.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stratareeb {

namespace {

//! The place of a share that is at most a half (of any share, if the other end is not round), counted from a round end.
double from_round_end(double share, bool other_is_round) {
    const double root = std::sqrt(std::max(share, 0.0));
    return other_is_round ? 2 / std::numbers::pi * std::asin(std::min(root, 1.0)) : root;
}

double share_from_round_end(double place, bool other_is_round) {
    const double root = other_is_round ? std::sin(std::numbers::pi / 2 * place) : place;
    return root * root;
}

}  // namespace

HeightScale::HeightScale(double low, double high, bool round_low, bool round_high)
    : low_(low), high_(high), round_low_(round_low), round_high_(round_high) {}

// Heights are counted from the end that is nearer: what is beside a node keeps its digits.
double HeightScale::place(double height) const {
    const double below = (height - low_) / (high_ - low_), above = (high_ - height) / (high_ - low_);
    if (round_low_ && (!round_high_ || below <= above)) return from_round_end(below, round_high_);
    return round_high_ ? 1 - from_round_end(above, round_low_) : below;
}

double HeightScale::height(double place) const {
    if (place <= 0) return low_;
    if (place >= 1) return high_;
    const double rise = high_ - low_;
    if (round_low_ && (!round_high_ || place <= 0.5))
        return low_ + share_from_round_end(place, round_high_) * rise;
    return round_high_ ? high_ - share_from_round_end(1 - place, round_low_) * rise : low_ + place * rise;
}

}  // namespace stratareeb
