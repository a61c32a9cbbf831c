// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace stratareeb {

//! Holes that are left out together, by number, ascending: none of them sees another.
using Draw = std::vector<std::size_t>;

//! Every hole left out once, in `folds` draws of nearly equal size: hole h is in draw p[h] % folds, where p is
//! random_permutation(holes, seed). With as many folds as holes, each is left out by itself.
//! \throw InvalidInput unless 2 <= folds <= holes
std::vector<Draw> fold_draws(std::size_t holes, std::size_t folds, std::uint64_t seed);

//! `at_a_time` holes left out together, other ones each time, until at least `share` of all have been out: the thesis's way
//! (its section 4.1.4: 2, 5 or 10 at a time until 30 per cent), but no hole is out twice, since a second error of one hole
//! is no new evidence.
//! \throw InvalidInput unless 1 <= at_a_time < holes and 0 < share <= 1
std::vector<Draw> repeated_draws(std::size_t holes, std::size_t at_a_time, double share, std::uint64_t seed);

//! Each hole by itself.
std::vector<Draw> single_draws(std::size_t holes);

}  // namespace stratareeb
