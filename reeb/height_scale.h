// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace stratareeb {

//! Places from 0 to 1 for the heights of an edge between two nodes. Beside a critical point that is round, contours of a smooth surface spread
//! like the root of the height above or below it: over the root they move evenly. So a place is a share x of the height between ends that
//! are not round; x = sin^2(pi p / 2) between two round ones; x = p^2 or 1 - (1 - p)^2 where one is.
class HeightScale {
 public:
    //! \pre low < high
    HeightScale(double low, double high, bool round_low, bool round_high);

    double place(double height) const;
    double height(double place) const;  // the inverse; low and high are met to the last bit

 private:
    double low_, high_;
    bool round_low_, round_high_;
};

}  // namespace stratareeb
