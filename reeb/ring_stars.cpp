// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/ring_stars.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace stratareeb {

namespace {

using Rings = std::vector<std::uint32_t>;

//! Can rings of one level become a single ring of this kind of the other?
bool can_be_one(const StackLevel& level, const Rings& rings, bool is_hole) {
    const std::uint32_t top =
        *std::ranges::min_element(rings, {}, [&](std::uint32_t r) { return level.depth(r); });
    if (level.is_hole(top) != is_hole) return false;
    // Down from the region around: a set of rings hangs together if each one's outer region is that or inside another.
    return std::ranges::all_of(rings, [&](std::uint32_t r) {
        return level.parent(r) == level.parent(top) || std::ranges::count(rings, level.parent(r)) > 0;
    });
}

class Stars {
 public:
    Stars(const StackLevel& lower, const StackLevel& upper, std::vector<RingLink> links)
        : lower_(lower), upper_(upper), links_(std::move(links)) {
        std::ranges::sort(links_, {},
                          [](const RingLink& l) { return std::tuple(-l.share, l.lower, l.upper); });
        for (const RingLink& link : links_) {
            if (!piece_of_lower_.contains(link.lower)) {
                piece_of_lower_[link.lower] = pieces_.size();
                pieces_.push_back({{link.lower}, {}, 0});
            }
            if (!piece_of_upper_.contains(link.upper)) {
                piece_of_upper_[link.upper] = pieces_.size();
                pieces_.push_back({{}, {link.upper}, 0});
            }
        }
    }

    RingStars run() {
        pass(true);
        while (pass(false)) {
        }
        RingStars result;
        for (const RingLink& link : links_)
            if (piece_of_lower_[link.lower] != piece_of_upper_[link.upper])
                result.dropped.push_back({link.lower, link.upper, link.share});
        for (StackTransition& piece : pieces_)
            if (!piece.lower.empty() && !piece.upper.empty()) result.pieces.push_back(std::move(piece));
        return result;
    }

 private:
    bool pass(bool same_kind_only) {
        bool joined = false;
        for (const RingLink& link : links_) {
            if (same_kind_only && lower_.is_hole(link.lower) != upper_.is_hole(link.upper)) continue;
            joined = join(piece_of_lower_[link.lower], piece_of_upper_[link.upper]) || joined;
        }
        return joined;
    }

    bool join(std::size_t a, std::size_t b) {
        if (a == b) return false;
        const auto union_of = [](const Rings& p, const Rings& q) {
            Rings both;
            std::ranges::merge(p, q, std::back_inserter(both));
            return both;
        };
        StackTransition both{union_of(pieces_[a].lower, pieces_[b].lower),
                             union_of(pieces_[a].upper, pieces_[b].upper), 0};
        const bool sound = both.upper.size() == 1
                               ? can_be_one(lower_, both.lower, upper_.is_hole(both.upper.front()))
                               : both.lower.size() == 1 &&
                                     can_be_one(upper_, both.upper, lower_.is_hole(both.lower.front()));
        if (!sound) return false;
        for (const std::uint32_t r : pieces_[b].lower) piece_of_lower_[r] = a;
        for (const std::uint32_t r : pieces_[b].upper) piece_of_upper_[r] = a;
        pieces_[a] = std::move(both);
        pieces_[b] = {};
        return true;
    }

    const StackLevel &lower_, &upper_;
    std::vector<RingLink> links_;
    std::vector<StackTransition> pieces_;
    std::map<std::uint32_t, std::size_t> piece_of_lower_, piece_of_upper_;
};

}  // namespace

RingStars ring_stars(const StackLevel& lower, const StackLevel& upper, std::vector<RingLink> links) {
    return Stars(lower, upper, std::move(links)).run();
}

}  // namespace stratareeb
