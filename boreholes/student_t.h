// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace stratareeb {

//! Which law a standardised mean is held against.
enum class MeanLaw {
    Normal,    // large samples, or a known standard deviation
    StudentT,  // the standard deviation is estimated from the same few values
};

//! The quantile of a law that the share `probability` lies below. `freedom` is the degrees of freedom of Student's t
//! and is not used by the normal law.
//! \pre 0 < probability < 1; freedom > 0 for Student's t
double quantile(MeanLaw law, double probability, double freedom);

//! Probability of a value at least as far from 0 as `statistic`, on either side.
double two_sided_p(MeanLaw law, double statistic, double freedom);

}  // namespace stratareeb
