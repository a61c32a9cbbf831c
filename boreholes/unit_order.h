// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace stratareeb {

//! A square table of votes: how many holes have unit a above unit b.
class OrderVotes {
 public:
    explicit OrderVotes(std::size_t unit_count) : size_(unit_count), votes_(unit_count * unit_count, 0) {}

    std::size_t unit_count() const { return size_; }
    double& above(std::size_t a, std::size_t b) { return votes_[a * size_ + b]; }
    double above(std::size_t a, std::size_t b) const { return votes_[a * size_ + b]; }

    //! Let one hole vote: `depths[i]` is how deep it has unit `units[i]`; equal depths don't vote. Units are
    //! distinct.
    void add_hole(std::span<const std::size_t> units, std::span<const double> depths);

 private:
    std::size_t size_;
    std::vector<double> votes_;
};

//! Two units that the order puts against the majority of holes, because stronger pairs say so (a cycle).
struct OrderConflict {
    std::size_t above, below;  // as most holes that have both say
};

struct UnitOrder {
    std::vector<std::size_t> units;  // top first; a permutation of 0 … unit_count - 1
    std::vector<OrderConflict> conflicts;
};

//! The order of units from top to bottom that best agrees with the votes: pairs are locked in from the
//! clearest majority to the weakest, leaving out those that would close a cycle (Tideman's ranked pairs).
//! Ties, and units that no pair relates, keep the order of their numbers. Time O(n² log n + n³/64).
UnitOrder rank_units(const OrderVotes& votes);

//! Which items of a sequence make up its heaviest chain of never decreasing ranks. Weights ≥ 0; among equally
//! heavy chains the one whose items come first. Time O(n log n).
std::vector<bool> heaviest_chain(std::span<const std::size_t> ranks, std::span<const double> weights);

}  // namespace stratareeb
