// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/stack_transition.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <tuple>

#include "mesh/ring_crossings.h"
#include "reeb/region_overlap.h"
#include "reeb/ring_stars.h"

namespace stratareeb {

namespace {

using Rings = std::vector<std::uint32_t>;

//! Rings of both levels that border one sheet. They are numbered through: the lower level's, then the upper one's.
class Sheets {
 public:
    Sheets(const StackLevel& lower, const StackLevel& upper)
        : levels_{&lower, &upper},
          cluster_(lower.size() + upper.size()),
          has_crossing_(cluster_.size(), false) {
        std::iota(cluster_.begin(), cluster_.end(), 0u);
        join_crossing();
        sheet_ = cluster_;
        for (const std::uint32_t r : leftmost_of_clusters()) join_leftward(r);
    }

    struct Sheet {
        Rings lower, upper;
        bool crosses = false;
    };

    std::vector<Sheet> all() {
        std::vector<Sheet> by_root(sheet_.size()), result;
        for (std::uint32_t r = 0; r < sheet_.size(); ++r) {
            Sheet& sheet = by_root[root(sheet_, r)];
            const bool is_lower = r < levels_[0]->size();
            (is_lower ? sheet.lower : sheet.upper).push_back(is_lower ? r : r - levels_[0]->size());
            sheet.crosses = sheet.crosses || has_crossing_[r];
        }
        for (Sheet& sheet : by_root)
            if (!sheet.lower.empty() || !sheet.upper.empty()) result.push_back(std::move(sheet));
        return result;
    }

 private:
    static std::uint32_t root(Rings& parent, std::uint32_t r) {
        while (parent[r] != r) r = parent[r] = parent[parent[r]];
        return r;
    }
    static void join(Rings& parent, std::uint32_t a, std::uint32_t b) {
        const auto [low, high] = std::minmax({root(parent, a), root(parent, b)});
        parent[high] = low;
    }

    const std::vector<Point2>& ring(std::uint32_t r) const {
        return r < levels_[0]->size() ? levels_[0]->ring(r) : levels_[1]->ring(r - levels_[0]->size());
    }

    void join_crossing() {
        if (levels_[0]->size() == 0 || levels_[1]->size() == 0) return;
        std::vector<std::vector<Point2>> rings;
        for (std::uint32_t r = 0; r < cluster_.size(); ++r) rings.push_back(ring(r));
        for (const RingCrossing& crossing : ring_crossings(rings)) {
            if (crossing.ring == crossing.other_ring) continue;
            join(cluster_, crossing.ring, crossing.other_ring);
            has_crossing_[crossing.ring] = has_crossing_[crossing.other_ring] = true;
        }
    }

    //! By cluster the ring that starts leftmost; rings start at their leftmost point.
    Rings leftmost_of_clusters() {
        Rings leftmost(cluster_.size(), StackLevel::kOutside), result;
        const auto start = [&](std::uint32_t r) { return std::tuple(ring(r).front().x, ring(r).front().y); };
        for (std::uint32_t r = 0; r < cluster_.size(); ++r) {
            std::uint32_t& best = leftmost[root(cluster_, r)];
            if (best == StackLevel::kOutside || start(r) < start(best)) best = r;
        }
        std::ranges::copy_if(leftmost, std::back_inserter(result),
                             [](std::uint32_t r) { return r != StackLevel::kOutside; });
        return result;
    }

    //! A cluster borders the face to the left of its leftmost point, and so does what comes next to the left there. These
    //! steps join all clusters around a face, because each leads to the left or to the one around the face.
    void join_leftward(std::uint32_t r) {
        const Point2 from = ring(r).front();
        std::array<bool, 2> solid{false, false};
        std::uint32_t nearest = StackLevel::kOutside;
        long double nearest_x = 0;
        for (std::uint32_t l = 0; l < 2; ++l)
            for (const auto& passage : levels_[l]->passages(from.y)) {
                const std::uint32_t other = passage.ring + (l == 0 ? 0 : levels_[0]->size());
                if (!(passage.x < from.x) || root(cluster_, other) == root(cluster_, r)) continue;
                solid[l] = !solid[l];
                if (nearest == StackLevel::kOutside || passage.x > nearest_x)
                    nearest = other, nearest_x = passage.x;
            }
        if (solid[0] != solid[1]) join(sheet_, r, nearest);
    }

    std::array<const StackLevel*, 2> levels_;
    Rings cluster_;  // union-find of rings that cross or touch
    Rings sheet_;    // the same of rings that border a sheet
    std::vector<bool> has_crossing_;
};

std::vector<RingLink> links_of(const StackLevel& lower, const StackLevel& upper, const Rings& lower_rings,
                               const Rings& upper_rings, double least_share) {
    const RegionOverlaps overlaps = region_overlaps(lower, lower_rings, upper, upper_rings);
    const auto overlap = [&](std::uint32_t a, std::uint32_t b) {
        const auto found = overlaps.find({a, b});
        return found == overlaps.end() ? 0.0 : found->second;
    };
    std::map<std::uint32_t, double> inside_lower, inside_upper;
    for (const auto& [regions, area] : overlaps) {
        inside_lower[regions.first] += area;
        inside_upper[regions.second] += area;
    }
    std::vector<RingLink> links;
    for (const std::uint32_t a : lower_rings)
        for (const std::uint32_t b : upper_rings) {
            const double shared = std::min(overlap(lower.solid_side(a), upper.solid_side(b)),
                                           overlap(lower.void_side(a), upper.void_side(b)));
            const double share = shared / std::min(inside_lower[a], inside_upper[b]);
            if (share >= least_share) links.push_back({a, b, share});
        }
    return links;
}

//! Rings without partner end: each with the rings of its holes, or a hole with its islands, unless one of these goes on.
void add_ends(const StackLevel& level, Rings ending, const Rings& of_sheet, Rings StackTransition::*side,
              std::vector<StackTransition>& pieces) {
    std::ranges::stable_sort(ending, {}, [&](std::uint32_t r) { return level.depth(r); });
    std::vector<bool> left(level.size(), false), done(level.size(), false);
    for (const std::uint32_t r : ending) left[r] = true;
    std::map<std::uint32_t, Rings> children;
    for (const std::uint32_t r : of_sheet) children[level.parent(r)].push_back(r);
    for (const std::uint32_t r : ending) {
        if (done[r]) continue;
        StackTransition end;
        Rings& together = end.*side;
        together.push_back(r);
        const Rings& inner = children[r];
        if (std::ranges::all_of(inner, [&](std::uint32_t c) { return left[c]; }))
            together.insert(together.end(), inner.begin(), inner.end());
        for (const std::uint32_t member : together) done[member] = true;
        std::ranges::sort(together);
        pieces.push_back(std::move(end));
    }
}

}  // namespace

StackTransitions stack_transitions(const StackLevel& lower, const StackLevel& upper, double least_share) {
    StackTransitions result;
    std::uint32_t number = 0;
    for (const auto& sheet : Sheets(lower, upper).all()) {
        const std::size_t before = result.pieces.size(), first_dropped = result.dropped.size();
        if (sheet.lower.size() == 1 && sheet.upper.size() == 1 && !sheet.crosses) {  // one lies in the other
            result.pieces.push_back({sheet.lower, sheet.upper, number++});
            continue;
        }
        RingStars stars;
        if (!sheet.lower.empty() && !sheet.upper.empty())
            stars = ring_stars(lower, upper, links_of(lower, upper, sheet.lower, sheet.upper, least_share));
        Rings ending_below = sheet.lower, ending_above = sheet.upper;
        for (const StackTransition& star : stars.pieces) {
            std::erase_if(ending_below,
                          [&](std::uint32_t r) { return std::ranges::count(star.lower, r) > 0; });
            std::erase_if(ending_above,
                          [&](std::uint32_t r) { return std::ranges::count(star.upper, r) > 0; });
            result.pieces.push_back(star);
        }
        result.dropped.insert(result.dropped.end(), stars.dropped.begin(), stars.dropped.end());
        add_ends(lower, ending_below, sheet.lower, &StackTransition::lower, result.pieces);
        add_ends(upper, ending_above, sheet.upper, &StackTransition::upper, result.pieces);
        for (std::size_t p = before; p < result.pieces.size(); ++p) result.pieces[p].sheet = number;
        for (std::size_t d = first_dropped; d < result.dropped.size(); ++d) result.dropped[d].sheet = number;
        if (sheet.lower.size() > 1 && sheet.upper.size() > 1 && !sheet.crosses)
            result.cells.push_back({sheet.lower, sheet.upper, number});
        ++number;
    }
    return result;
}

}  // namespace stratareeb
