// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/saddle_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <utility>

namespace stratareeb {

namespace {

constexpr std::uint32_t kNone = ~0u;
constexpr double kFar = std::numeric_limits<double>::max();

class PathFinder {
 public:
    PathFinder(const PathRegion& region, std::span<const SheetSaddle> saddles, const SaddleHeights& heights)
        : region_(region),
          saddles_(saddles),
          heights_(heights),
          last_ring_(static_cast<std::uint32_t>(heights.ring.size()) - 1),
          neighbours_(region.plan.points.size()),
          is_taken_(region.plan.points.size(), false),
          result_(region.plan.points.size()) {
        for (const auto& t : region.plan.triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                neighbours_[t[i]].push_back(t[(i + 1) % 3]);
                neighbours_[t[i]].push_back(t[(i + 2) % 3]);
            }
        for (auto& around : neighbours_) {
            std::ranges::sort(around);
            around.erase(std::ranges::unique(around).begin(), around.end());
        }
        for (std::size_t v = 0; v < result_.size(); ++v)
            if (region.ring[v] != PathRegion::kInside) result_[v] = heights.ring[region.ring[v]];
        for (const SheetSaddle& saddle : saddles) {
            result_[saddle.vertex] = heights.saddle;
            is_taken_[saddle.vertex] = true;
        }
    }

    std::optional<std::vector<std::optional<double>>> run() {
        std::vector<std::vector<std::uint32_t>> starts;  // by saddle: where its paths to rings begin
        for (const SheetSaddle& saddle : saddles_) {
            starts.emplace_back();
            for (const std::uint32_t ring : saddle.rings)
                if (!lead_to_ring(saddle.vertex, ring, starts.back())) return std::nullopt;
        }
        find_ways_to_last_ring();
        std::vector<Way> ways;
        for (std::size_t k = 0; k < saddles_.size(); ++k)
            if (!lead_between(saddles_[k].vertex, starts[k], ways)) return std::nullopt;
        set_heights_to_last_ring(ways);
        return std::move(result_);
    }

 private:
    //! From a saddle by the first vertex of its path to the last ring.
    struct Way {
        std::uint32_t first = 0;
        double length = 0;
    };
    using Entry = std::pair<double, std::uint32_t>;
    using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

    double length(std::uint32_t a, std::uint32_t b) const {
        const Point3 &p = region_.plan.points[a], &q = region_.plan.points[b];
        return std::hypot(p.x - q.x, p.y - q.y);
    }

    bool is_free(std::uint32_t v) const { return region_.ring[v] == PathRegion::kInside && !is_taken_[v]; }

    //! The vertices around an inner one, counter-clockwise.
    std::vector<std::uint32_t> link(std::uint32_t v) const {
        std::map<std::uint32_t, std::uint32_t> next;
        for (const auto& t : region_.plan.triangles)
            for (std::size_t i = 0; i < 3; ++i)
                if (t[i] == v) next[t[(i + 1) % 3]] = t[(i + 2) % 3];
        std::vector<std::uint32_t> around{next.begin()->first};
        while (around.size() < next.size()) around.push_back(next.at(around.back()));
        return around;
    }

    //! The shortest free path, beside none that starts at this saddle already.
    bool lead_to_ring(std::uint32_t saddle, std::uint32_t ring, std::vector<std::uint32_t>& starts) {
        const auto around = link(saddle);
        std::vector<std::uint32_t> barred;  // a way to the last ring needs room
        for (std::size_t i = 0; i < around.size(); ++i)
            for (const std::size_t k : {(i + 1) % around.size(), (i + around.size() - 1) % around.size()})
                if (std::ranges::count(starts, around[k]) > 0) barred.push_back(around[i]);
        std::vector<double> far(result_.size(), kFar);
        std::vector<std::uint32_t> from(result_.size(), kNone);
        Queue queue;
        for (const std::uint32_t v : around) {
            if (std::ranges::count(barred, v) > 0 || !(is_free(v) || region_.ring[v] == ring)) continue;
            far[v] = length(saddle, v);
            queue.emplace(far[v], v);
        }
        while (!queue.empty()) {
            const auto [way, v] = queue.top();
            queue.pop();
            if (way > far[v]) continue;
            if (region_.ring[v] == ring) {
                starts.push_back(take_path(v, from, far, heights_.ring[ring]));
                return true;
            }
            for (const std::uint32_t w : neighbours_[v]) {
                if (!is_free(w) && region_.ring[w] != ring) continue;
                if (std::ranges::count(around, w) > 0) continue;  // touches the saddle once
                const double there = way + length(v, w);
                if (there >= far[w]) continue;
                far[w] = there;
                from[w] = v;
                queue.emplace(there, w);
            }
        }
        return false;
    }

    //! \return its first vertex
    std::uint32_t take_path(std::uint32_t end, const std::vector<std::uint32_t>& from,
                            const std::vector<double>& far, double height) {
        std::uint32_t first = end;
        for (std::uint32_t v = from[end]; v != kNone; v = from[v]) {
            first = v;
            is_taken_[v] = true;
            result_[v] = heights_.saddle + far[v] / far[end] * (height - heights_.saddle);
        }
        return first;
    }

    void find_ways_to_last_ring() {
        far_.assign(result_.size(), kFar);
        next_.assign(result_.size(), kNone);
        Queue queue;
        for (std::uint32_t v = 0; v < result_.size(); ++v)
            if (region_.ring[v] == last_ring_) {
                far_[v] = 0;
                queue.emplace(0, v);
            }
        while (!queue.empty()) {
            const auto [way, v] = queue.top();
            queue.pop();
            if (way > far_[v]) continue;
            for (const std::uint32_t w : neighbours_[v]) {
                const double there = way + length(v, w);
                if (!is_free(w) || there >= far_[w]) continue;
                far_[w] = there;
                next_[w] = v;
                queue.emplace(there, w);
            }
        }
    }

    //! Between any two paths, the nearest way to the last ring.
    bool lead_between(std::uint32_t saddle, const std::vector<std::uint32_t>& starts,
                      std::vector<Way>& ways) {
        auto around = link(saddle);
        const auto is_start = [&](std::uint32_t v) { return std::ranges::count(starts, v) > 0; };
        std::ranges::rotate(around, std::ranges::find_if(around, is_start));
        std::size_t found = 0;
        for (std::size_t i = 0; i < around.size();) {
            ++i;  // past a start
            Way best{kNone, kFar};
            for (; i < around.size() && !is_start(around[i]); ++i) {
                const std::uint32_t v = around[i];
                if (far_[v] == kFar) continue;
                const double way = far_[v] + length(saddle, v);
                if (way < best.length) best = {v, way};
            }
            if (best.first == kNone) return false;
            ways.push_back(best);
            ++found;
        }
        return found == starts.size();
    }

    //! Where ways run together, the longest one says how far is left.
    void set_heights_to_last_ring(const std::vector<Way>& ways) {
        std::vector<double> whole(result_.size(), 0);
        for (const Way& way : ways)
            for (std::uint32_t v = way.first; v != kNone; v = next_[v])
                whole[v] = std::max(whole[v], way.length);
        const double last = heights_.ring[last_ring_];
        for (std::uint32_t v = 0; v < result_.size(); ++v)
            if (whole[v] > 0 && region_.ring[v] == PathRegion::kInside)
                result_[v] = last + far_[v] / whole[v] * (heights_.saddle - last);
    }

    const PathRegion& region_;
    std::span<const SheetSaddle> saddles_;
    const SaddleHeights& heights_;
    std::uint32_t last_ring_;
    std::vector<std::vector<std::uint32_t>> neighbours_;
    std::vector<bool> is_taken_;
    std::vector<std::optional<double>> result_;
    std::vector<double> far_;  // to the last ring
    std::vector<std::uint32_t> next_;
};

}  // namespace

std::optional<std::vector<std::optional<double>>> saddle_path_heights(const PathRegion& region,
                                                                      std::span<const SheetSaddle> saddles,
                                                                      const SaddleHeights& heights) {
    return PathFinder(region, saddles, heights).run();
}

}  // namespace stratareeb
