// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/unit_order.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>

namespace stratareeb {
namespace {

struct Majority {
    std::size_t above, below;
    double margin, votes;
};

std::vector<Majority> sorted_majorities(const OrderVotes& votes) {
    std::vector<Majority> pairs;
    for (std::size_t a = 0; a < votes.unit_count(); ++a)
        for (std::size_t b = a + 1; b < votes.unit_count(); ++b) {
            const double ab = votes.above(a, b), ba = votes.above(b, a);
            if (ab == 0 && ba == 0) continue;
            if (ab >= ba)
                pairs.push_back({a, b, ab - ba, ab});
            else
                pairs.push_back({b, a, ba - ab, ba});
        }
    std::stable_sort(pairs.begin(), pairs.end(), [](const Majority& p, const Majority& q) {
        return p.margin != q.margin ? p.margin > q.margin : p.votes > q.votes;
    });
    return pairs;
}

//! Transitive closure of "above", kept as rows of bits while pairs are added.
class Above {
 public:
    explicit Above(std::size_t count) : count_(count), words_((count + 63) / 64), bits_(count * words_, 0) {}

    bool has(std::size_t a, std::size_t b) const { return (bits_[a * words_ + b / 64] >> (b % 64)) & 1U; }

    void add(std::size_t a, std::size_t b) {
        if (has(a, b)) return;
        for (std::size_t x = 0; x < count_; ++x)
            if (x == a || has(x, a)) join(x, b);
    }

 private:
    void join(std::size_t x, std::size_t b) {
        for (std::size_t w = 0; w < words_; ++w) bits_[x * words_ + w] |= bits_[b * words_ + w];
        bits_[x * words_ + b / 64] |= std::uint64_t{1} << (b % 64);
    }

    std::size_t count_, words_;
    std::vector<std::uint64_t> bits_;
};

std::vector<std::size_t> topological_order(const Above& above, std::size_t count) {
    std::vector<std::size_t> waiting(count, 0), order;
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = 0; b < count; ++b)
            if (above.has(a, b)) ++waiting[b];
    std::vector<bool> placed(count, false);
    while (order.size() < count) {
        std::size_t next = 0;
        while (placed[next] || waiting[next] > 0) ++next;
        placed[next] = true;
        order.push_back(next);
        for (std::size_t b = 0; b < count; ++b)
            if (above.has(next, b)) --waiting[b];
    }
    return order;
}

//! Prefix maximum over ranks of the heaviest chain that ends there.
class HeaviestSoFar {
 public:
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    struct Best {
        double weight = 0;
        std::size_t item = kNone;
    };

    explicit HeaviestSoFar(std::size_t ranks) : tree_(ranks + 1) {}

    Best up_to(std::size_t rank) const {
        Best best;
        for (std::size_t i = rank + 1; i > 0; i -= i & (~i + 1)) take_heavier(best, tree_[i]);
        return best;
    }

    void offer(std::size_t rank, Best offered) {
        for (std::size_t i = rank + 1; i < tree_.size(); i += i & (~i + 1)) take_heavier(tree_[i], offered);
    }

 private:
    // An item of weight 0 still lengthens a chain, so an existing chain beats none; otherwise the earlier
    // stays.
    static void take_heavier(Best& best, const Best& other) {
        if (other.item == kNone) return;
        if (best.item == kNone || other.weight > best.weight ||
            (other.weight == best.weight && other.item < best.item))
            best = other;
    }

    std::vector<Best> tree_;
};

}  // namespace

void OrderVotes::add_hole(std::span<const std::size_t> units, std::span<const double> depths) {
    for (std::size_t i = 0; i < units.size(); ++i)
        for (std::size_t j = i + 1; j < units.size(); ++j) {
            if (depths[i] < depths[j]) above(units[i], units[j]) += 1;
            if (depths[j] < depths[i]) above(units[j], units[i]) += 1;
        }
}

UnitOrder rank_units(const OrderVotes& votes) {
    Above above(votes.unit_count());
    UnitOrder order;
    for (const Majority& pair : sorted_majorities(votes)) {
        if (!above.has(pair.below, pair.above))
            above.add(pair.above, pair.below);
        else if (pair.margin > 0)
            order.conflicts.push_back({pair.above, pair.below});
    }
    order.units = topological_order(above, votes.unit_count());
    return order;
}

std::vector<bool> heaviest_chain(std::span<const std::size_t> ranks, std::span<const double> weights) {
    std::vector<bool> kept(ranks.size(), false);
    if (ranks.empty()) return kept;
    const std::size_t top = *std::max_element(ranks.begin(), ranks.end());
    HeaviestSoFar heaviest(top + 1);
    std::vector<std::size_t> previous(ranks.size());
    for (std::size_t i = 0; i < ranks.size(); ++i) {
        const auto best = heaviest.up_to(ranks[i]);
        previous[i] = best.item;
        heaviest.offer(ranks[i], {best.weight + weights[i], i});
    }
    for (std::size_t i = heaviest.up_to(top).item; i != HeaviestSoFar::kNone; i = previous[i]) kept[i] = true;
    return kept;
}

}  // namespace stratareeb
