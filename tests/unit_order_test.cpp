// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/unit_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace stratareeb {
namespace {

using Units = std::vector<std::size_t>;

TEST(UnitOrder, chain_of_pairs_is_put_in_order) {
    OrderVotes votes(3);
    votes.above(2, 0) = 4;
    votes.above(0, 1) = 4;
    const UnitOrder order = rank_units(votes);
    EXPECT_EQ(order.units, (Units{2, 0, 1}));
    EXPECT_TRUE(order.conflicts.empty());
}

TEST(UnitOrder, weakest_pair_of_a_cycle_gives_way) {
    OrderVotes votes(3);
    votes.above(0, 1) = 5;
    votes.above(1, 2) = 4;
    votes.above(2, 0) = 3;
    const UnitOrder order = rank_units(votes);
    EXPECT_EQ(order.units, (Units{0, 1, 2}));
    ASSERT_EQ(order.conflicts.size(), 1u);
    EXPECT_EQ(order.conflicts[0].above, 2u);
    EXPECT_EQ(order.conflicts[0].below, 0u);
}

TEST(UnitOrder, ties_and_strangers_keep_first_appearance) {
    OrderVotes votes(4);
    votes.above(1, 0) = votes.above(0, 1) = 2;
    EXPECT_EQ(rank_units(votes).units, (Units{0, 1, 2, 3}));
    EXPECT_TRUE(rank_units(OrderVotes(0)).units.empty());
}

TEST(UnitOrder, consistent_columns_give_back_their_order_for_random_columns) {
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
        Units truth(2 + random() % 90);
        std::iota(truth.begin(), truth.end(), std::size_t{0});
        std::shuffle(truth.begin(), truth.end(), random);
        OrderVotes votes(truth.size());
        std::vector<double> depths(truth.size());
        std::iota(depths.begin(), depths.end(), 0.0);
        votes.add_hole(truth, depths);
        EXPECT_EQ(rank_units(votes).units, truth);
    }
}

double heaviest_by_trial(const Units& ranks, const std::vector<double>& weights) {
    double best = 0;
    for (unsigned set = 0; set < (1U << ranks.size()); ++set) {
        double weight = 0;
        std::size_t last = 0;
        bool rising = true;
        for (std::size_t i = 0; i < ranks.size(); ++i) {
            if (!((set >> i) & 1U)) continue;
            rising = rising && ranks[i] >= last;
            last = ranks[i];
            weight += weights[i];
        }
        if (rising) best = std::max(best, weight);
    }
    return best;
}

TEST(HeaviestChain, is_as_heavy_as_the_best_of_all_subsets) {
    std::mt19937 random(3);
    for (int round = 0; round < 500; ++round) {
        const std::size_t count = random() % 11;
        Units ranks;
        std::vector<double> weights;
        for (std::size_t i = 0; i < count; ++i) {
            ranks.push_back(random() % 5);
            weights.push_back(static_cast<double>(random() % 8));
        }
        const auto kept = heaviest_chain(ranks, weights);
        double weight = 0;
        std::size_t last = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (!kept[i]) continue;
            EXPECT_GE(ranks[i], last);
            last = ranks[i];
            weight += weights[i];
        }
        EXPECT_EQ(weight, heaviest_by_trial(ranks, weights));
    }
}

}  // namespace
}  // namespace stratareeb
