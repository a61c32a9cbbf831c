// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/point_run_tree.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stratareeb {

namespace {

constexpr std::size_t kLeaf = 8;     // points that are cheaper to look at than to part
constexpr double kRounding = 1e-14;  // of the terms of a bound: far more than they can be wrong
constexpr std::size_t kDepth = 64;   // a tree over all points that memory can hold is less deep

double squared_length(const Point3& v) {
    return v.x * v.x + v.y * v.y + v.z * v.z;
}

Point3 between(const Point3& a, const Point3& b) {
    return {b.x - a.x, b.y - a.y, b.z - a.z};
}

//! What is left of v seen along a direction.
Point3 across(const Point3& v, const Point3& direction) {
    const double along = v.x * direction.x + v.y * direction.y + v.z * direction.z;
    return {v.x - along * direction.x, v.y - along * direction.y, v.z - along * direction.z};
}

//! Of the origin from a segment.
double squared_distance(const Point3& start, const Point3& chord) {
    const double length = squared_length(chord);
    const double along = -(start.x * chord.x + start.y * chord.y + start.z * chord.z);
    const double t = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
    return squared_length({start.x + t * chord.x, start.y + t * chord.y, start.z + t * chord.z});
}

}  // namespace

PointRunTree::PointRunTree(std::span<const Point3> points) : points_(points) {
    build(0, 0, points.size());
}

void PointRunTree::build(std::size_t run, std::size_t first, std::size_t last) {
    if (runs_.size() <= run) runs_.resize(run + 1);
    const Point3 start = points_[first], chord = between(start, points_[last - 1]);
    double deviation = 0;
    for (const Point3& p : points_.subspan(first, last - first))
        deviation = std::max(deviation, squared_distance(between(p, start), chord));
    runs_[run] = {start, chord, std::sqrt(deviation)};
    if (last - first <= kLeaf) return;
    const std::size_t middle = (first + last) / 2;
    build(2 * run + 1, first, middle);
    build(2 * run + 2, middle, last);
}

double PointRunTree::bound(std::size_t run, const Point3& place, const Point3& direction) const {
    const Run& r = runs_[run];
    const double distance =
        std::sqrt(squared_distance(across(between(place, r.start), direction), across(r.chord, direction)));
    return std::max(0.0, distance - r.deviation - kRounding * (distance + r.deviation));
}

double PointRunTree::distance(const Point3& place, const Point3& direction, std::uint32_t guess,
                              double tolerance) const {
    struct Open {
        std::size_t run, first, last;
        double bound;
    };
    double best = std::sqrt(squared_length(across(between(place, points_[guess]), direction)));
    double least_left_out = best;
    std::array<Open, kDepth> stack;
    std::size_t size = 0;
    stack[size++] = {0, 0, points_.size(), bound(0, place, direction)};
    while (size > 0) {
        const Open open = stack[--size];
        if (open.bound >= best * (1 - tolerance)) {
            least_left_out = std::min(least_left_out, open.bound);
            continue;
        }
        if (open.last - open.first <= kLeaf) {
            double least = best * best;
            for (const Point3& p : points_.subspan(open.first, open.last - open.first))
                least = std::min(least, squared_length(across(between(place, p), direction)));
            best = std::min(best, std::sqrt(least));
            continue;
        }
        const std::size_t middle = (open.first + open.last) / 2, half = 2 * open.run + 1;
        Open nearer{half, open.first, middle, bound(half, place, direction)};
        Open other{half + 1, middle, open.last, bound(half + 1, place, direction)};
        if (other.bound < nearer.bound) std::swap(nearer, other);
        stack[size++] = other;
        stack[size++] = nearer;
    }
    return std::min(best, least_left_out);
}

}  // namespace stratareeb
