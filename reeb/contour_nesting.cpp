// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/contour_nesting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

Point3 cross(const Point3& a, const Point3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Point3 unit(const Point3& a) {
    const double size = std::hypot(a.x, a.y, a.z);
    return {a.x / size, a.y / size, a.z / size};
}

//! Coordinates in the plane across a direction, counter-clockwise seen from its tip; x, y themselves for z.
class PlaneView {
 public:
    explicit PlaneView(const Point3& direction) {
        const double size = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
        if (!(size > 0) || !std::isfinite(size + direction.x + direction.y + direction.z))
            throw InvalidInput("contours can't be nested along a direction that is zero or not finite");
        const Point3 axis = unit({direction.x / size, direction.y / size, direction.z / size});
        Point3 other{1, 0, 0};  // the axis that follows the one nearest to the direction
        if (std::abs(direction.x) == size) other = {0, 1, 0};
        if (std::abs(direction.y) == size) other = {0, 0, 1};
        if (std::abs(direction.z) == size) other = {1, 0, 0};
        v_ = unit(cross(axis, other));
        u_ = cross(v_, axis);
    }

    Point2 operator()(const Point3& p) const {
        return {u_.x * p.x + u_.y * p.y + u_.z * p.z, v_.x * p.x + v_.y * p.y + v_.z * p.z};
    }

 private:
    Point3 u_, v_;
};

struct Box {
    Point2 min{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Point2 max{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    void add(const Point2& p) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
    bool holds(const Box& inner) const {
        return min.x <= inner.min.x && min.y <= inner.min.y && inner.max.x <= max.x && inner.max.y <= max.y;
    }
};

constexpr double kNoArea = 1e-9;  // of the areas added up: rounding alone

struct Ring {
    std::uint32_t contour = 0;
    std::vector<Point2> points;
    Box box;
    double area = 0;  // positive if counter-clockwise
};

Ring ring_of(const LevelSet& set, std::uint32_t contour, const PlaneView& view) {
    Ring ring{.contour = contour, .points = {}, .box = {}, .area = 0};
    ring.points.reserve(set.contours[contour].points.size());
    for (const Point3& p : set.contours[contour].points) {
        ring.points.push_back(view(p));
        ring.box.add(ring.points.back());
    }
    const Point2 o = ring.points.front();
    for (std::size_t i = 1; i + 1 < ring.points.size(); ++i) {
        const Point2 &a = ring.points[i], &b = ring.points[i + 1];
        ring.area += ((a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y)) / 2;
    }
    return ring;
}

//! A place of a ring for which the rings around it are asked: the middle of its widest segment. Contours meet in ends of
//! segments and in whole segments only, so that it lies on another ring just where that has the same segment.
struct Probe {
    Point2 at, from, to;
    std::uint32_t ring = 0;
};

Probe probe_of(const std::vector<Ring>& rings, std::uint32_t r) {
    const auto& points = rings[r].points;
    Probe probe{.at = {}, .from = points.back(), .to = points.front(), .ring = r};
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        if (std::abs(points[i + 1].x - points[i].x) > std::abs(probe.to.x - probe.from.x))
            probe.from = points[i], probe.to = points[i + 1];
    probe.at = {probe.from.x + (probe.to.x - probe.from.x) / 2,
                probe.from.y + (probe.to.y - probe.from.y) / 2};
    return probe;
}

//! Is it the probe's own segment, in its ring or in another?
bool is_segment_of(const Point2& a, const Point2& b, const Probe& probe) {
    return (a == probe.from && b == probe.to) || (a == probe.to && b == probe.from);
}

//! Is the segment a-b, not upright, below the place?
bool is_below(const Point2& a, const Point2& b, const Point2& p) {
    if (std::max(a.y, b.y) < p.y) return true;
    if (std::min(a.y, b.y) > p.y) return false;
    const bool rightward = a.x < b.x;
    const Point2 &left = rightward ? a : b, &right = rightward ? b : a;
    const double turn = (right.x - left.x) * (p.y - left.y) - (right.y - left.y) * (p.x - left.x);
    return turn == 0 ? rightward : turn > 0;
}

//! For each ring the rings around it: those of which an odd number of segments lie below its probe.
class Enclosures {
 public:
    Enclosures(const std::vector<Ring>& rings, bool with_open_contours)
        : rings_(rings), faces_up_(with_open_contours), around_(rings.size()) {
        double area = 0, total = 0;
        for (const Ring& ring : rings) area += ring.area, total += std::abs(ring.area);
        outside_is_high_ = area < -kNoArea * total;
        for (std::uint32_t r = 0; r < rings.size(); ++r) probes_.push_back(probe_of(rings, r));
        std::ranges::stable_sort(probes_, {}, [](const Probe& probe) { return probe.at.x; });
        odd_.assign(probes_.size(), 0);
        for (std::uint32_t r = 0; r < rings.size(); ++r)
            if (may_hold_others(r)) find_inside(r);
    }

    //! By ring, in ascending order.
    const std::vector<std::vector<std::uint32_t>>& around() const { return around_; }

 private:
    std::size_t probes_left_of(double x) const {
        return static_cast<std::size_t>(
            std::ranges::lower_bound(probes_, x, {}, [](const Probe& probe) { return probe.at.x; }) -
            probes_.begin());
    }

    bool may_hold(std::uint32_t ring, const Probe& probe) const {
        return probe.ring != ring && rings_[ring].box.holds(rings_[probe.ring].box);
    }

    bool may_hold_others(std::uint32_t ring) const {
        const Box& box = rings_[ring].box;
        for (std::size_t k = probes_left_of(box.min.x); k < probes_.size() && probes_[k].at.x <= box.max.x;
             ++k)
            if (may_hold(ring, probes_[k])) return true;
        return false;
    }

    //! Once around the ring, past the probes that its segments lie above or below of. A segment takes its left end's
    //! abscissa and not its right end's.
    void find_inside(std::uint32_t ring) {
        const auto& points = rings_[ring].points;
        Point2 a = points.back();
        std::size_t k = probes_left_of(a.x);
        for (const Point2& b : points) {
            while (k < probes_.size() && probes_[k].at.x < b.x) pass(ring, a, b, k++);
            while (k > 0 && probes_[k - 1].at.x >= b.x) pass(ring, a, b, --k);
            a = b;
        }
        for (const auto passed : passed_)
            if (odd_[passed]) {
                around_[probes_[passed].ring].push_back(ring);
                odd_[passed] = 0;
            }
        passed_.clear();
    }

    void pass(std::uint32_t ring, const Point2& a, const Point2& b, std::size_t k) {
        const Probe& probe = probes_[k];
        if (!may_hold(ring, probe)) return;
        // Two rings along one segment run on the two sides of a ridge. Just below the level both have moved to their right,
        // so that the probe is on the left of the other's segment; under a ridge of a cavity's roof it is the other way.
        const bool below =
            is_segment_of(a, b, probe) ? (a.x < b.x) == is_ridge(probe) : is_below(a, b, probe.at);
        if (!below) return;
        odd_[k] ^= 1;
        if (odd_[k]) passed_.push_back(k);
    }

    //! Is there lower ground beside a segment shared by two rings? High and low take turns from the outside in. Such
    //! segments are rare; with open contours there may be no outside, and the surface is taken to face up.
    bool is_ridge(const Probe& probe) const {
        if (faces_up_) return true;
        bool is_high = outside_is_high_;
        for (const Ring& ring : rings_) {
            Point2 a = ring.points.back();
            for (const Point2& b : ring.points) {
                if ((a.x <= probe.at.x) != (b.x <= probe.at.x) && !is_segment_of(a, b, probe) &&
                    is_below(a, b, probe.at))
                    is_high = !is_high;
                a = b;
            }
        }
        return !is_high;
    }

    const std::vector<Ring>& rings_;
    bool faces_up_ = false, outside_is_high_ = false;
    std::vector<Probe> probes_;  // from left to right
    std::vector<std::uint8_t> odd_;
    std::vector<std::size_t> passed_;
    std::vector<std::vector<std::uint32_t>> around_;
};

//! The parent is the ring around that has most rings around itself, always fewer than the child: no circles, whatever crosses.
void set_parents(const std::vector<Ring>& rings, const std::vector<std::vector<std::uint32_t>>& around,
                 ContourNesting& nesting) {
    std::vector<std::uint32_t> by_count(rings.size());
    for (std::uint32_t r = 0; r < rings.size(); ++r) by_count[r] = r;
    std::ranges::stable_sort(by_count, {}, [&](std::uint32_t r) { return around[r].size(); });
    for (const auto r : by_count) {
        const Ring* parent = nullptr;
        std::size_t most = 0;
        for (const auto outer : around[r])
            if (around[outer].size() < around[r].size() && (!parent || around[outer].size() > most)) {
                parent = &rings[outer];
                most = around[outer].size();
            }
        if (!parent) continue;
        nesting.parent[rings[r].contour] = parent->contour;
        nesting.depth[rings[r].contour] = nesting.depth[parent->contour] + 1;
    }
}

void set_polygons(const std::vector<Ring>& rings, ContourNesting& nesting) {
    std::vector<std::uint32_t> polygon(nesting.parent.size(), ContourNesting::kNone);
    for (const Ring& ring : rings)
        if (nesting.depth[ring.contour] % 2 == 0) {
            polygon[ring.contour] = static_cast<std::uint32_t>(nesting.polygons.size());
            nesting.polygons.push_back({.outer = ring.contour, .holes = {}});
        }
    for (const Ring& ring : rings)
        if (nesting.depth[ring.contour] % 2 == 1)
            nesting.polygons[polygon[nesting.parent[ring.contour]]].holes.push_back(ring.contour);
}

}  // namespace

ContourNesting nest_contours(const LevelSet& set, const Point3& direction) {
    const PlaneView view(direction);
    ContourNesting nesting;
    nesting.parent.assign(set.contours.size(), ContourNesting::kNone);
    nesting.depth.assign(set.contours.size(), 0);
    std::vector<Ring> rings;
    for (std::uint32_t c = 0; c < set.contours.size(); ++c) {
        if (set.contours[c].closed && !set.contours[c].points.empty())
            rings.push_back(ring_of(set, c, view));
        else
            nesting.open.push_back(c);
    }
    if (rings.size() > 1) set_parents(rings, Enclosures(rings, !nesting.open.empty()).around(), nesting);
    set_polygons(rings, nesting);
    return nesting;
}

double enclosed_area(const LevelSet& set, const ContourNesting& nesting, const Point3& direction) {
    double sum = 0;
    for (const auto& [outer, holes] : nesting.polygons) {
        sum += std::abs(set.contours[outer].area(direction));
        for (const auto hole : holes) sum -= std::abs(set.contours[hole].area(direction));
    }
    return sum;
}

}  // namespace stratareeb
