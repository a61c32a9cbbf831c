// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/contour_stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <span>
#include <tuple>

#include "boreholes/errors.h"
#include "mesh/ring_crossings.h"

namespace stratareeb {

namespace {

constexpr std::size_t kTold = 20;                  // faults in a message; more would not be read
constexpr std::size_t kMostCrossings = 1'000'000;  // of a level, to find them in

bool is_before(const Point2& a, const Point2& b) {
    return std::tie(a.x, a.y) < std::tie(b.x, b.y);
}

std::vector<Point2> without_repeats(const std::vector<Point2>& points) {
    std::vector<Point2> ring;
    for (const Point2& p : points)
        if (ring.empty() || ring.back() != p) ring.push_back(p);
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
}

double signed_area(std::span<const Point2> ring) {
    double twice = 0;
    const Point2 o = ring.front();  // far coordinates cancel
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        twice += (ring[i].x - o.x) * (ring[i + 1].y - o.y) - (ring[i + 1].x - o.x) * (ring[i].y - o.y);
    return twice / 2;
}

class Faults {
 public:
    void add(std::string text) {
        if (++count_ <= kTold) told_ += (told_.empty() ? "" : "\n") + std::move(text);
    }
    void raise() const {
        if (count_ == 0) return;
        throw InvalidInput(count_ > kTold ? fmt::format("{}\nand {} more", told_, count_ - kTold) : told_);
    }

 private:
    std::string told_;
    std::size_t count_ = 0;
};

//! What is wrong with a contour by itself, crossings left out; empty if nothing is.
std::string fault_of(const StackContour& contour) {
    if (!std::isfinite(contour.z)) return "its height is not a number";
    for (std::size_t i = 0; i < contour.points.size(); ++i)
        if (!std::isfinite(contour.points[i].x + contour.points[i].y))
            return fmt::format("its point {} has coordinates that are not numbers", i + 1);
    const std::vector<Point2> ring = without_repeats(contour.points);
    if (ring.size() < 3)
        return fmt::format("a closed ring has three points or more, this one {}; leave it out", ring.size());
    if (signed_area(ring) == 0) return "it encloses no area; leave it out";
    return {};
}

StackContour plain(const StackContour& contour, std::size_t place) {
    StackContour result{
        .z = contour.z + 0.0, .points = without_repeats(contour.points), .name = contour.name};
    if (result.name.empty()) result.name = fmt::format("contour {}", place + 1);
    if (signed_area(result.points) < 0) std::ranges::reverse(result.points);
    std::ranges::rotate(result.points, std::ranges::min_element(result.points, is_before));
    return result;
}

bool comes_first(const StackContour& a, const StackContour& b) {
    if (a.z != b.z) return a.z < b.z;
    return std::ranges::lexicographical_compare(a.points, b.points, is_before);
}

std::vector<std::uint32_t> first_of_levels(std::span<const StackContour> contours) {
    std::vector<std::uint32_t> first;
    for (std::uint32_t c = 0; c < contours.size(); ++c)
        if (c == 0 || contours[c].z != contours[c - 1].z) first.push_back(c);
    first.push_back(static_cast<std::uint32_t>(contours.size()));
    return first;
}

void find_crossings(std::span<const StackContour> level, Faults& faults) {
    std::vector<std::vector<Point2>> rings;
    for (const StackContour& contour : level) rings.push_back(contour.points);
    std::set<std::pair<std::uint32_t, std::uint32_t>> told;
    for (const RingCrossing& crossing : ring_crossings(rings, {.most = kMostCrossings})) {
        if (!told.insert({crossing.ring, crossing.other_ring}).second) continue;
        const std::string place = fmt::format("near ({:.10g}, {:.10g}) at height {}", crossing.place.x,
                                              crossing.place.y, level[crossing.ring].z);
        if (crossing.ring == crossing.other_ring)
            faults.add(fmt::format("{} crosses or touches itself {}; mend it there",
                                   level[crossing.ring].name, place));
        else
            faults.add(fmt::format("{} and {} cross or touch {}; contours of one height keep apart",
                                   level[crossing.ring].name, level[crossing.other_ring].name, place));
    }
}

}  // namespace

SortedStack sorted_stack(const ContourStack& stack) {
    Faults faults;
    std::vector<StackContour> contours;
    for (std::size_t c = 0; c < stack.contours.size(); ++c) {
        const std::string fault = fault_of(stack.contours[c]);
        if (fault.empty())
            contours.push_back(plain(stack.contours[c], c));
        else
            faults.add(fmt::format(
                "{}: {}",
                stack.contours[c].name.empty() ? fmt::format("contour {}", c + 1) : stack.contours[c].name,
                fault));
    }
    faults.raise();
    SortedStack result;
    result.source.resize(contours.size());
    std::iota(result.source.begin(), result.source.end(), 0u);
    std::ranges::stable_sort(result.source, [&](std::uint32_t a, std::uint32_t b) {
        return comes_first(contours[a], contours[b]);
    });
    for (const std::uint32_t c : result.source) result.contours.push_back(std::move(contours[c]));
    result.first = first_of_levels(result.contours);
    for (std::size_t l = 0; l + 1 < result.first.size(); ++l)
        find_crossings(
            std::span(result.contours).subspan(result.first[l], result.first[l + 1] - result.first[l]),
            faults);
    faults.raise();
    return result;
}

}  // namespace stratareeb
