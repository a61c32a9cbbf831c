// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tie_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "mesh/clip_lines.h"

namespace stratareeb {

namespace {

constexpr double kTieGap = 0.7;  // of the gap between holes: ties along a way on
constexpr double kOnWay = 1e-7;  // of the extent
// Ties stand closer together towards the tip, and beside the way on, where no pinch-out line ends on it but by chance.
constexpr std::array kFirst{0.2, 0.6, 1.2};  // of the gap of ties, from the tip
constexpr double kAside = 0.5;               // of the way from the tip,
constexpr double kMostAside = 0.35;          // and of the gap of ties
// More to one side than to the other, so that no pinch-out line half way between them runs along the way on.
constexpr double kLeft = 1.16, kRight = 0.84;

using Place = std::pair<double, double>;

Place place_of(const Point2& p) {
    return {p.x, p.y};
}

class BlockTying {
 public:
    BlockTying(FaultBlocks& blocks, double hole_gap)
        : blocks_(blocks), gap_(kTieGap * hole_gap), tolerance_(way_on_tolerance(blocks)) {}

    void run() {
        if (blocks_.ways_on.empty()) return;
        collect_sides();
        blocks_of_way_.resize(blocks_.ways_on.size());
        for (const auto& [ends, block] : sides_)
            if (const std::size_t way = way_of(ends.first, ends.second); way != kNone)
                blocks_of_way_[way].insert(block);
        for (const auto& [ends, block] : sides_) tie_beside(ends.first, ends.second, block);
    }

 private:
    void collect_sides() {
        sides_.clear();
        for (std::uint32_t b = 0; b < blocks_.outline.size(); ++b)
            for (const auto& ring : blocks_.outline[b])
                for (std::size_t i = 0; i < ring.size(); ++i)
                    sides_[{place_of(ring[i]), place_of(ring[(i + 1) % ring.size()])}] = b;
    }

    //! The way on that a side of an outline is part of, if there is a block beyond it.
    std::size_t way_of(const Place& a, const Place& b) const {
        if (!sides_.contains({b, a})) return kNone;
        for (std::size_t w = 0; w < blocks_.ways_on.size(); ++w)
            if (blocks_.ways_on[w].holds({a.first, a.second}, {b.first, b.second}, tolerance_)) return w;
        return kNone;
    }

    //! How far from the tip ties stand.
    std::vector<double> places_along(double length) const {
        std::vector<double> places;
        for (std::size_t k = 0; places.empty() || places.back() < length; ++k)
            places.push_back(gap_ *
                             (k < kFirst.size() ? kFirst[k] : static_cast<double>(k - kFirst.size() + 2)));
        places.pop_back();
        return places;
    }

    //! In a block, beside a side of its outline that is part of a way on.
    void tie_beside(const Place& a, const Place& b, std::uint32_t block) {
        const std::size_t w = way_of(a, b);
        if (w == kNone) return;
        const WayOn& way = blocks_.ways_on[w];
        const double dx = b.first - a.first, dy = b.second - a.second, length = std::hypot(dx, dy);
        const double from = std::hypot(a.first - way.tip.x, a.second - way.tip.y),
                     to = std::hypot(b.first - way.tip.x, b.second - way.tip.y);
        for (const double s : places_along(std::hypot(way.end.x - way.tip.x, way.end.y - way.tip.y))) {
            const double share = (s - from) / (to - from);
            if (share < 0 || share >= 1) continue;
            const double off =
                (from < to ? kLeft : kRight) * std::min(kMostAside * gap_, kAside * s) / length;
            const Point2 at{a.first + share * dx - off * dy, a.second + share * dy + off * dx};
            if (inside_.try_emplace(block, blocks_.outline[block]).first->second(at))
                add(at, blocks_of_way_[w], {block, sides_.at({b, a})});
        }
    }

    void add(const Point2& at, const std::set<std::uint32_t>& from, const std::set<std::uint32_t>& to) {
        blocks_.ties.push_back({at, {from.begin(), from.end()}, {to.begin(), to.end()}});
    }

    static constexpr std::size_t kNone = ~std::size_t{0};

    FaultBlocks& blocks_;
    double gap_, tolerance_;
    std::map<std::pair<Place, Place>, std::uint32_t> sides_;  // of outlines, the block to the left
    std::vector<std::set<std::uint32_t>> blocks_of_way_;
    std::map<std::uint32_t, InsideTest> inside_;
};

}  // namespace

double way_on_tolerance(const FaultBlocks& blocks) {
    double x0 = 0, x1 = 0, y0 = 0, y1 = 0;
    bool first = true;
    for (const auto& outline : blocks.outline)
        for (const auto& ring : outline)
            for (const Point2& p : ring) {
                if (std::exchange(first, false)) x0 = x1 = p.x, y0 = y1 = p.y;
                x0 = std::min(x0, p.x), x1 = std::max(x1, p.x), y0 = std::min(y0, p.y),
                y1 = std::max(y1, p.y);
            }
    return kOnWay * std::hypot(x1 - x0, y1 - y0);
}

void tie_blocks(FaultBlocks& blocks, double hole_gap) {
    BlockTying(blocks, hole_gap).run();
}

}  // namespace stratareeb
