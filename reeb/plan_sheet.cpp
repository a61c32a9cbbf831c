// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/plan_sheet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "boreholes/errors.h"
#include "mesh/point_in_ring.h"
#include "mesh/region_triangulation.h"
#include "mesh/ring_crossings.h"
#include "reeb/contour_touches.h"
#include "reeb/harmonic_heights.h"
#include "reeb/link_signs.h"
#include "reeb/saddle_paths.h"

namespace stratareeb {

namespace {

constexpr double kMostPoints = 60'000;
constexpr double kEdgesPerStep = 1.5;  // a region's edges over its mean width's step
constexpr std::size_t kAttempts = 3;
constexpr double kFiner = 2.5;        // each attempt than the one before
constexpr double kStretched = 0.05;   // of the heights, where bays are deep; see harmonic_heights
constexpr double kDome = 2.0 / 3;     // of its prism: a half ellipsoid
constexpr double kMostLogarithm = 8;  // more would level the top of winding caps
constexpr int kHalvings = 40;
constexpr double kStarReach = 3;  // how much farther from the node than half its gap a ring may be

using Rings = std::vector<std::vector<Point2>>;

Rings outlines_of(std::span<const SheetRing> rings) {
    Rings outlines(rings.size());
    for (std::size_t r = 0; r < rings.size(); ++r)
        for (const Point3& p : rings[r].points) outlines[r].push_back({p.x, p.y});
    return outlines;
}

bool is_level(const SheetRing& ring) {
    return std::ranges::all_of(ring.points, [&](const Point3& p) { return p.z == ring.points.front().z; });
}

//! The ring around all others, if no other one is around another. \pre none crosses another
std::optional<std::size_t> outer_ring(const Rings& rings) {
    std::optional<std::size_t> outer;
    for (std::size_t a = 0; a < rings.size(); ++a) {
        std::size_t inside = 0;
        for (std::size_t b = 0; b < rings.size(); ++b)
            inside += a != b && is_inside_ring(rings[a], rings[b].front());
        if (inside > 0 && (inside + 1 < rings.size() || outer)) return std::nullopt;
        if (inside + 1 == rings.size()) outer = a;
    }
    return outer;
}

//! Does the sheet face upward? Nothing if its rings disagree.
std::optional<bool> faces_up(std::span<const SheetRing> rings, std::size_t outer) {
    std::optional<bool> up;
    for (std::size_t r = 0; r < rings.size(); ++r) {
        const bool own = ((r == outer) == rings[r].is_lower) != rings[r].is_hole;
        if (up && *up != own) return std::nullopt;
        up = own;
    }
    return up;
}

double distance_to(const std::vector<Point2>& ring, const Point3& p) {
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
        const double t =
            square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
        least = std::min(least, std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy));
    }
    return least;
}

class SheetMaker {
 public:
    SheetMaker(std::span<const SheetRing> rings, const std::optional<Point3>& node, std::size_t steps)
        : rings_(rings),
          outlines_(outlines_of(rings)),
          node_(node),
          steps_(static_cast<double>(std::max<std::size_t>(steps, 2))) {}

    std::optional<PlanSheet> run() {
        if (!std::ranges::all_of(rings_, is_level) || !ring_crossings(outlines_, {.most = 1}).empty())
            return std::nullopt;
        const auto outer = outer_ring(outlines_);
        if (!outer) return std::nullopt;
        const auto up = faces_up(rings_, *outer);
        if (!up || !find_last_ring()) return std::nullopt;
        const double edge = edge_length(*outer);
        const bool is_found =
            (meet_in_node() && find_sheet(edge)) || (meet_across_gaps() && find_sheet(edge));
        if (!is_found) return std::nullopt;
        PlanSheet sheet;
        sheet.added.assign(plan_.points.begin() + static_cast<std::ptrdiff_t>(ring_points_),
                           plan_.points.end());
        sheet.critical = places_.size();
        sheet.triangles = std::move(plan_.triangles);
        if (!*up)
            for (auto& t : sheet.triangles) std::swap(t[1], t[2]);
        return sheet;
    }

 private:
    double height(std::size_t r) const { return rings_[r].points.front().z; }

    //! Where there is no room for paths between rings, finer triangles may make it.
    bool find_sheet(double edge) {
        try {
            for (std::size_t attempt = 0; attempt < kAttempts; ++attempt, edge /= kFiner) {
                triangulate(edge);
                if (set_heights()) return true;
            }
        } catch (const InvalidInput&) {
            // The node is not inside, or rings are too close.
        }
        return false;
    }

    //! Which ring is alone on its side, and are heights in order?
    bool find_last_ring() {
        const auto lower = static_cast<std::size_t>(std::ranges::count_if(rings_, &SheetRing::is_lower));
        const std::size_t upper = rings_.size() - lower;
        if (rings_.size() == 1 ? !node_.has_value() : lower == 0 || upper == 0 || (lower > 1 && upper > 1))
            return false;
        if (rings_.size() > 2 && !node_) return false;
        if (rings_.size() == 2 && node_) return false;
        for (std::size_t r = 0; r < rings_.size(); ++r) {
            if (node_ && !(rings_[r].is_lower ? height(r) < node_->z : height(r) > node_->z)) return false;
            if ((lower > 1) != rings_[r].is_lower) last_ = r;
        }
        return rings_.size() != 2 || (height(0) < height(1)) == rings_[0].is_lower;
    }

    //! Rings but the last.
    std::vector<std::uint32_t> joined_rings() const {
        std::vector<std::uint32_t> joined;
        for (std::uint32_t r = 0; r < rings_.size(); ++r)
            if (r != last_ || rings_.size() == 1) joined.push_back(r);
        return joined;
    }

    std::vector<ContourTouch> touches_of(const std::vector<std::uint32_t>& joined) const {
        std::vector<SampledContour> contours;
        for (const std::uint32_t r : joined) contours.push_back(contour_by_perimeter(rings_[r].points));
        return contour_touches(contours, node_->z);
    }

    //! All in the node, if of three rings and more none is much farther from it than where it meets others.
    bool meet_in_node() {
        if (!node_) return true;
        const auto joined = joined_rings();
        saddle_rings_ = {joined};
        places_ = {*node_};
        if (joined.size() < 3) return true;
        double gap = 0, reach = 0;
        for (const ContourTouch& touch : touches_of(joined))
            gap = std::max(gap, distance_to(outlines_[joined[touch.first]], touch.place));
        for (const std::uint32_t r : joined) reach = std::max(reach, distance_to(outlines_[r], *node_));
        return reach <= kStarReach * gap;
    }

    //! Two by two, three rings and more.
    bool meet_across_gaps() {
        const auto joined = joined_rings();
        if (!node_ || joined.size() < 3) return false;
        saddle_rings_.clear();
        places_.clear();
        for (const ContourTouch& touch : touches_of(joined)) {
            saddle_rings_.push_back({joined[touch.first], joined[touch.second]});
            places_.push_back(touch.place);
        }
        return true;
    }

    //! About the mean width of the region over the steps.
    double edge_length(std::size_t outer) const {
        double area = 0, length = 0;
        for (std::size_t r = 0; r < outlines_.size(); ++r) {
            double twice = 0;
            const auto& ring = outlines_[r];
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point2 &o = ring[0], &a = ring[i], &b = ring[(i + 1) % ring.size()];
                twice += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
                length += std::hypot(b.x - a.x, b.y - a.y);
            }
            area += (r == outer ? 0.5 : -0.5) * std::abs(twice);
        }
        return std::max(2 * area / length / steps_ * kEdgesPerStep, std::sqrt(area / kMostPoints));
    }

    //! A circle of points around each saddle leaves paths room; in a cap the node is enough.
    std::vector<RegionPoint> inner_points() const {
        std::vector<RegionPoint> points;
        for (const Point3& p : places_) points.push_back({.place = {p.x, p.y}});
        if (rings_.size() == 1) return points;
        for (std::size_t k = 0; k < places_.size(); ++k) {
            double near = std::numeric_limits<double>::max();
            for (const auto& ring : outlines_) near = std::min(near, distance_to(ring, places_[k]));
            for (const Point3& other : places_)
                if (!(other == places_[k]))
                    near = std::min(near, std::hypot(other.x - places_[k].x, other.y - places_[k].y) / 2);
            const std::size_t count = std::max<std::size_t>(8, 4 * saddle_rings_[k].size());
            const double radius = near / 2, step = 2 * std::numbers::pi / static_cast<double>(count);
            points[k].size = radius * step;
            for (std::size_t i = 0; i < count; ++i) {
                const double angle = step * static_cast<double>(i);
                points.push_back({.place = {places_[k].x + radius * std::cos(angle),
                                            places_[k].y + radius * std::sin(angle)},
                                  .size = radius * step});
            }
        }
        return points;
    }

    void triangulate(double edge) {
        plan_ = {};
        ring_.clear();
        std::vector<RegionRing> rings;
        for (std::size_t r = 0; r < rings_.size(); ++r) {
            rings.push_back({outlines_[r], rings_[r].is_lower ? 0u : 1u});
            plan_.points.insert(plan_.points.end(), rings_[r].points.begin(), rings_[r].points.end());
            ring_.resize(plan_.points.size(), static_cast<std::uint32_t>(r));
        }
        ring_points_ = plan_.points.size();
        const auto inside = inner_points();
        for (const RegionPoint& p : inside) plan_.points.push_back({p.place.x, p.place.y, 0});
        auto region = triangulate_region(rings, inside, {.largest_edge = edge});
        for (const Point2& p : region.added) plan_.points.push_back({p.x, p.y, 0});
        plan_.triangles = std::move(region.triangles);
        ring_.resize(plan_.points.size(), PathRegion::kInside);
    }

    std::optional<std::vector<std::optional<double>>> fixed_heights() const {
        if (rings_.size() > 2) {
            std::vector<SheetSaddle> saddles;
            SaddleHeights heights{.ring = {}, .saddle = node_->z};
            const auto number = [&](std::uint32_t r) {  // the last ring comes last
                return r == last_ ? static_cast<std::uint32_t>(rings_.size() - 1) : r > last_ ? r - 1 : r;
            };
            for (std::size_t k = 0; k < places_.size(); ++k) {
                saddles.push_back({static_cast<std::uint32_t>(ring_points_ + k), {}});
                for (const std::uint32_t r : saddle_rings_[k]) saddles.back().rings.push_back(number(r));
            }
            for (std::size_t r = 0; r < rings_.size(); ++r)
                if (r != last_) heights.ring.push_back(height(r));
            heights.ring.push_back(height(last_));
            std::vector<std::uint32_t> ring = ring_;
            for (std::uint32_t& r : ring)
                if (r != PathRegion::kInside) r = number(r);
            return saddle_path_heights({plan_, ring}, saddles, heights);
        }
        std::vector<std::optional<double>> heights(plan_.points.size());
        for (std::size_t v = 0; v < ring_points_; ++v) heights[v] = height(ring_[v]);
        if (node_) heights[ring_points_] = node_->z;
        return heights;
    }

    //! The node is to stay outside of it.
    double stretched_share() const {
        if (!node_ || rings_.size() == 1) return kStretched;
        double low = node_->z, high = node_->z;
        for (std::size_t r = 0; r < rings_.size(); ++r) {
            low = std::min(low, height(r));
            high = std::max(high, height(r));
        }
        return std::min(
            {kStretched, (node_->z - low) / (high - low) / 2, (high - node_->z) / (high - low) / 2});
    }

    bool set_heights() {
        const auto fixed = fixed_heights();
        if (!fixed) return false;
        const auto heights = harmonic_heights(plan_, *fixed, stretched_share());
        if (!heights) return false;
        for (std::size_t v = 0; v < heights->size(); ++v) plan_.points[v].z = (*heights)[v];
        if (rings_.size() == 1) raise_dome();
        return is_sound();
    }

    //! A harmonic cap is a spike. On a disc its share w of the height falls with the logarithm of the distance r from the node, so that sqrt(1 -
    //! exp(-2 L w)) is the half ellipsoid sqrt(1 - r^2); L is such that the
    //! cap holds what that does, two thirds of its prism, or nearly so where it winds.
    void raise_dome() {
        const double base = height(0), rise = node_->z - base;
        const auto profile = [](double share, double L) {
            return std::sqrt(-std::expm1(-2 * L * share) / -std::expm1(-2 * L));
        };
        std::vector<double> share;
        for (const Point3& p : plan_.points) share.push_back((p.z - base) / rise);
        const auto filled = [&](double L) {
            double area = 0, volume = 0;
            for (const auto& t : plan_.triangles) {
                const Point3 &a = plan_.points[t[0]], &b = plan_.points[t[1]], &c = plan_.points[t[2]];
                const double own = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
                area += own;
                for (const std::uint32_t v : t) volume += own / 3 * profile(share[v], L);
            }
            return volume / area;
        };
        double low = 1e-3, high = kMostLogarithm;
        for (int step = 0; step < kHalvings; ++step) {
            const double middle = std::sqrt(low * high);
            (filled(middle) < kDome ? low : high) = middle;
        }
        for (std::size_t v = ring_points_ + 1; v < share.size(); ++v)
            plan_.points[v].z = base + rise * profile(share[v], low);
    }

    //! Rounding may undo what is so by construction.
    bool is_sound() const {
        std::vector<bool> inner(plan_.points.size(), false);
        for (std::size_t v = ring_points_; v < inner.size(); ++v) inner[v] = true;
        const auto signs = link_signs(plan_, inner);
        for (std::size_t v = ring_points_; v < inner.size(); ++v) {
            const std::size_t k = v - ring_points_;
            int expected = 2;
            if (k < places_.size() && rings_.size() > 2)
                expected = 2 * static_cast<int>(saddle_rings_[k].size());
            if (k < places_.size() && rings_.size() == 1) expected = rings_[0].is_lower ? kHighest : kLowest;
            if (signs[v] != expected) return false;
        }
        for (const auto& t : plan_.triangles)
            for (const std::uint32_t v : t)
                for (const std::uint32_t w : t)
                    if (v < ring_points_ && w >= ring_points_ &&
                        !(rings_[ring_[v]].is_lower ? plan_.points[w].z > plan_.points[v].z
                                                    : plan_.points[w].z < plan_.points[v].z))
                        return false;
        return true;
    }

    std::span<const SheetRing> rings_;
    Rings outlines_;
    const std::optional<Point3>& node_;
    double steps_;
    std::size_t last_ = 0;
    std::vector<Point3> places_;                            // of saddles, or the tip
    std::vector<std::vector<std::uint32_t>> saddle_rings_;  // by saddle
    TriangleSoup plan_;
    std::vector<std::uint32_t> ring_;  // by vertex
    std::size_t ring_points_ = 0;
};

}  // namespace

std::optional<PlanSheet> plan_sheet(std::span<const SheetRing> rings, const std::optional<Point3>& node,
                                    std::size_t steps) {
    return SheetMaker(rings, node, steps).run();
}

}  // namespace stratareeb
