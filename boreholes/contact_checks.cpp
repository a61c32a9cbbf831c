// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/contact_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "boreholes/errors.h"
#include "boreholes/unit_order.h"

namespace stratareeb {
namespace {

constexpr double kNear = 0.002;        // of the extent in plan
constexpr double kSteep = 10;          // height over distance
constexpr double kHigh = 0.02;         // of the range of heights
constexpr double kStrayShare = 0.005;  // of all points: more steep pairs are a shape, not mistakes
constexpr std::size_t kStrayMost = 100;
constexpr std::size_t kOrderSample = 400;    // points of a unit that are compared with another unit's
constexpr std::size_t kOrderSamples = 8000;  // of all units together
constexpr std::size_t kCellVisits = 200;     // points of a cell that are compared with a new one

struct Extent {
    double plan = 0, height = 0;
};

Extent extent_of(const ContactSet& contacts) {
    std::array<double, 3> low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (const ContactPoint& point : contacts.points) {
        const std::array<double, 3> p{point.at.x, point.at.y, point.z};
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], p[i]);
            high[i] = std::max(high[i], p[i]);
        }
    }
    return {std::hypot(high[0] - low[0], high[1] - low[1]), high[2] - low[2]};
}

double plan_distance(const Point2& a, const Point2& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

struct SteepPair {
    std::size_t first, second;  // indices of points
};

//! Points of one unit in square cells as wide as the search distance.
class CellGrid {
 public:
    explicit CellGrid(double cell) : cell_(cell) {}

    void add(const Point2& at, std::size_t point) { cells_[key(index(at.x), index(at.y))].push_back(point); }

    template <typename Visit>
    void visit_near(const Point2& at, Visit visit) const {
        for (std::int64_t dx = -1; dx <= 1; ++dx)
            for (std::int64_t dy = -1; dy <= 1; ++dy)
                if (const auto found = cells_.find(key(index(at.x) + dx, index(at.y) + dy));
                    found != cells_.end())
                    for (std::size_t i = 0; i < std::min(found->second.size(), kCellVisits); ++i)
                        visit(found->second[found->second.size() - 1 - i]);
    }

 private:
    std::int64_t index(double v) const { return static_cast<std::int64_t>(std::floor(v / cell_)); }
    static std::uint64_t key(std::int64_t column, std::int64_t row) {
        return static_cast<std::uint64_t>(column) * 0x9e3779b97f4a7c15ULL ^ static_cast<std::uint64_t>(row);
    }

    double cell_;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

std::vector<SteepPair> steep_pairs(const ContactSet& contacts, const Extent& extent) {
    const double near = kNear * extent.plan;
    std::vector<SteepPair> pairs;
    if (near == 0) return pairs;
    std::vector<CellGrid> grids(contacts.units.size(), CellGrid(near));
    for (std::size_t i = 0; i < contacts.points.size(); ++i) {
        const ContactPoint& point = contacts.points[i];
        bool steep = false;  // one pair per point will do
        grids[point.unit].visit_near(point.at, [&](std::size_t j) {
            if (steep) return;
            const ContactPoint& other = contacts.points[j];
            const double height = std::abs(point.z - other.z);
            if (height <= kHigh * extent.height) return;
            const double distance = plan_distance(point.at, other.at);
            steep = distance <= near && height > kSteep * distance;
            if (steep) pairs.push_back({j, i});
        });
        grids[point.unit].add(point.at, i);
    }
    return pairs;
}

//! Mean height of the five nearest other points of the unit.
double neighbour_height(const ContactSet& contacts, const SteepPair& pair) {
    const ContactPoint& at = contacts.points[pair.first];
    std::vector<std::pair<double, double>> near;  // distance, height
    for (std::size_t i = 0; i < contacts.points.size(); ++i)
        if (i != pair.first && i != pair.second && contacts.points[i].unit == at.unit)
            near.emplace_back(plan_distance(contacts.points[i].at, at.at), contacts.points[i].z);
    std::sort(near.begin(), near.end());
    near.resize(std::min<std::size_t>(near.size(), 5));
    double sum = 0;
    for (const auto& [distance, z] : near) sum += z;
    return near.empty() ? at.z : sum / static_cast<double>(near.size());
}

void drop_strays(ContactSet& contacts, const std::vector<SteepPair>& pairs, Audit& audit) {
    std::vector<bool> dropped(contacts.points.size(), false);
    for (const SteepPair& pair : pairs) {
        const ContactPoint &a = contacts.points[pair.first], &b = contacts.points[pair.second];
        const double around = neighbour_height(contacts, pair);
        const bool drop_first = std::abs(a.z - around) > std::abs(b.z - around);
        dropped[drop_first ? pair.first : pair.second] = true;
        audit.add_warning(
            contacts.files[b.file], b.row, "",
            fmt::format("{} has two heights at x {}, y {}: z {} (row {}) and z {}; the first fits its "
                        "neighbours {} and is {}",
                        contacts.units[a.unit], a.at.x, a.at.y, a.z, a.row, b.z,
                        drop_first ? "worse" : "better",
                        drop_first ? "left out" : "kept, the other left out"));
    }
    std::size_t i = 0;
    std::erase_if(contacts.points, [&](const ContactPoint&) { return dropped[i++]; });
}

std::vector<std::vector<const ContactPoint*>> sampled_points(const ContactSet& contacts) {
    std::vector<std::vector<const ContactPoint*>> all(contacts.units.size()), samples(contacts.units.size());
    for (const ContactPoint& point : contacts.points) all[point.unit].push_back(&point);
    const std::size_t most = std::clamp<std::size_t>(kOrderSamples / (all.size() + 1), 1, kOrderSample);
    for (std::size_t unit = 0; unit < all.size(); ++unit) {
        const std::size_t step = all[unit].size() / most + 1;
        for (std::size_t i = 0; i < all[unit].size(); i += step) samples[unit].push_back(all[unit][i]);
    }
    return samples;
}

//! Each point of one unit votes by its height against its nearest neighbour of the other; half of a vote in
//! all, so that one shared place outweighs it.
void add_neighbour_votes(const std::vector<const ContactPoint*>& a, const std::vector<const ContactPoint*>& b,
                         double& a_above, double& b_above) {
    double up = 0, down = 0;
    for (const ContactPoint* point : a) {
        const auto nearest = std::min_element(b.begin(), b.end(), [&](const auto* p, const auto* q) {
            return plan_distance(p->at, point->at) < plan_distance(q->at, point->at);
        });
        ((*nearest)->z < point->z ? up : down) += 1;
    }
    if (up + down == 0) return;
    a_above += 0.25 * up / (up + down);
    b_above += 0.25 * down / (up + down);
}

}  // namespace

void drop_faults(ContactSet& contacts, Audit& audit) {
    std::vector<std::size_t> number(contacts.units.size());
    std::vector<std::string> kept;
    std::vector<bool> is_fault(contacts.units.size());
    for (std::size_t unit = 0; unit < contacts.units.size(); ++unit) {
        std::string lower = contacts.units[unit];
        for (char& c : lower)
            if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        const auto at = lower.find("fault");
        const auto is_letter = [&](std::size_t i) {
            return i < lower.size() && lower[i] >= 'a' && lower[i] <= 'z';
        };
        is_fault[unit] = at != lower.npos && (at == 0 || !is_letter(at - 1)) &&
                         (!is_letter(at + 5) || lower[at + 5] == 's');
        number[unit] = kept.size();
        if (!is_fault[unit]) kept.push_back(contacts.units[unit]);
        if (is_fault[unit])
            audit.add_warning(
                "", 0, "",
                fmt::format("{} is a fault by its name: its points bound no layer and are left out; layers "
                            "run across it without a break",
                            contacts.units[unit]));
    }
    std::erase_if(contacts.points, [&](const ContactPoint& point) { return is_fault[point.unit]; });
    for (ContactPoint& point : contacts.points) point.unit = number[point.unit];
    contacts.units = std::move(kept);
}

void refuse_overhangs(ContactSet& contacts, Audit& audit) {
    const std::vector<SteepPair> pairs = steep_pairs(contacts, extent_of(contacts));
    if (pairs.empty()) return;
    const double strays =
        std::min(kStrayShare * static_cast<double>(contacts.points.size()), static_cast<double>(kStrayMost));
    if (static_cast<double>(pairs.size()) <= strays) return drop_strays(contacts, pairs, audit);
    const auto worst =
        *std::max_element(pairs.begin(), pairs.end(), [&](const SteepPair& p, const SteepPair& q) {
            const auto height = [&](const SteepPair& s) {
                return std::abs(contacts.points[s.first].z - contacts.points[s.second].z);
            };
            return height(p) < height(q);
        });
    const ContactPoint &a = contacts.points[worst.first], &b = contacts.points[worst.second];
    throw InvalidInput(
        fmt::format("{}:{}: {} is at z {} and, {:.3g} away in plan (row {}), at z {}, near x {}, y {}; {} "
                    "such pairs: the surface "
                    "overhangs, is folded or faulted there. A layer here has one height at each place: leave "
                    "out one side, or give the "
                    "sides different units",
                    contacts.files[b.file], b.row, contacts.units[a.unit], b.z, plan_distance(a.at, b.at),
                    a.row, a.z, b.at.x, b.at.y, pairs.size()));
}

std::vector<std::vector<std::size_t>> points_by_place(const ContactSet& contacts) {
    const auto& points = contacts.points;
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::tie(points[a].at.x, points[a].at.y, a) < std::tie(points[b].at.x, points[b].at.y, b);
    });
    std::vector<std::vector<std::size_t>> places;
    for (std::size_t i = 0; i < order.size(); ++i)
        if (i > 0 && points[order[i]].at == points[order[i - 1]].at)
            places.back().push_back(order[i]);
        else
            places.push_back({order[i]});
    std::sort(places.begin(), places.end(),
              [](const auto& a, const auto& b) { return a.front() < b.front(); });
    return places;
}

std::vector<std::size_t> inferred_contact_order(const ContactSet& contacts) {
    OrderVotes votes(contacts.units.size());
    std::vector<std::size_t> units;
    std::vector<double> depths;
    for (const auto& place : points_by_place(contacts)) {
        if (place.size() < 2) continue;
        units.clear();
        depths.clear();
        for (const std::size_t i : place) {
            const ContactPoint& point = contacts.points[i];
            if (std::find(units.begin(), units.end(), point.unit) != units.end()) continue;
            units.push_back(point.unit);
            depths.push_back(-point.z);
        }
        votes.add_hole(units, depths);
    }
    const auto samples = sampled_points(contacts);
    for (std::size_t a = 0; a < samples.size(); ++a)
        for (std::size_t b = a + 1; b < samples.size(); ++b) {
            if (samples[a].empty() || samples[b].empty()) continue;
            if (votes.above(a, b) + votes.above(b, a) > 0) continue;
            add_neighbour_votes(samples[a], samples[b], votes.above(a, b), votes.above(b, a));
            add_neighbour_votes(samples[b], samples[a], votes.above(b, a), votes.above(a, b));
        }
    return rank_units(votes).units;
}

}  // namespace stratareeb
