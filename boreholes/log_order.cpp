// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/log_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "boreholes/unit_order.h"

namespace stratareeb {
namespace {

constexpr std::size_t kHolesNamed = 5;      // in one warning
constexpr std::size_t kPairsReported = 50;  // contradicting pairs that get a warning of their own

struct UnitDepths {
    std::vector<std::size_t> units;
    std::vector<double> depths;  // mean depth of each, weighted by thickness
};

UnitDepths unit_depths(const HoleLog& hole) {
    std::map<std::size_t, std::pair<double, double>> sums;  // unit → (thickness, thickness × depth)
    for (const LogInterval& interval : hole.intervals) {
        if (interval.unit == LogInterval::kNoUnit) continue;
        auto& [thickness, moment] = sums[interval.unit];
        thickness += interval.thickness();
        moment += interval.thickness() * 0.5 * (interval.from + interval.to);
    }
    UnitDepths result;
    for (const auto& [unit, sum] : sums) {
        result.units.push_back(unit);
        result.depths.push_back(sum.second / sum.first);
    }
    return result;
}

std::vector<std::size_t> inferred_order(const LogSet& logs) {
    OrderVotes votes(logs.units.size());
    for (const HoleLog& hole : logs.holes) {
        const UnitDepths depths = unit_depths(hole);
        votes.add_hole(depths.units, depths.depths);
    }
    return rank_units(votes).units;
}

std::vector<std::size_t> stated_order(const LogSet& logs, const std::vector<std::string>& order,
                                      Audit& audit) {
    std::vector<std::size_t> units;
    for (const std::string& code : order) {
        const auto found = std::find(logs.units.begin(), logs.units.end(), code);
        if (found == logs.units.end()) {
            audit.add_warning("", 0, "",
                              fmt::format("the order names unit {}, which no hole has; left out", code));
            continue;
        }
        const auto unit = static_cast<std::size_t>(found - logs.units.begin());
        if (std::find(units.begin(), units.end(), unit) == units.end()) units.push_back(unit);
    }
    return units;
}

void renumber(LogSet& logs, const std::vector<std::size_t>& order) {
    std::vector<std::size_t> rank(logs.units.size());
    std::vector<std::string> units;
    for (std::size_t i = 0; i < order.size(); ++i) {
        rank[order[i]] = i;
        units.push_back(logs.units[order[i]]);
    }
    logs.units = std::move(units);
    for (HoleLog& hole : logs.holes)
        for (LogInterval& interval : hole.intervals)
            if (interval.unit != LogInterval::kNoUnit) interval.unit = rank[interval.unit];
}

struct Contradiction {
    std::size_t agree = 0, against = 0;
    std::string holes;
};

void report_contradictions(const LogSet& logs, std::size_t ordered, Audit& audit) {
    std::map<std::pair<std::size_t, std::size_t>, Contradiction> pairs;  // (upper, lower) of the order
    for (const HoleLog& hole : logs.holes) {
        const UnitDepths known = unit_depths(hole);
        for (std::size_t i = 0; i < known.units.size(); ++i)
            for (std::size_t j = i + 1; j < known.units.size() && known.units[j] < ordered; ++j) {
                auto& pair = pairs[{known.units[i], known.units[j]}];
                if (known.depths[i] <= known.depths[j]) {
                    ++pair.agree;
                } else if (++pair.against <= kHolesNamed) {
                    pair.holes += (pair.holes.empty() ? "" : ", ") + hole.id;
                }
            }
    }
    std::size_t reported = 0;
    for (const auto& [units, pair] : pairs) {
        if (pair.against == 0 || ++reported > kPairsReported) continue;
        audit.add_warning(
            "", 0, "",
            fmt::format(
                "{} lies above {} in the order taken{}; {} of {} holes with both have it below ({}{})",
                logs.units[units.first], logs.units[units.second],
                pair.against > pair.agree ? ", against most holes, since the units form a cycle" : "",
                pair.against, pair.agree + pair.against, pair.holes,
                pair.against > kHolesNamed ? ", …" : ""));
    }
    if (reported > kPairsReported)
        audit.add_warning(
            "", 0, "",
            fmt::format("{} more pairs of units lie one way in some holes, the other way in others",
                        reported - kPairsReported));
}

std::vector<bool> kept_intervals(const HoleLog& hole, std::size_t ordered) {
    std::vector<std::size_t> ranks, places;
    std::vector<double> weights;
    for (std::size_t i = 0; i < hole.intervals.size(); ++i) {
        if (hole.intervals[i].unit >= ordered) continue;  // kNoUnit is larger than any
        ranks.push_back(hole.intervals[i].unit);
        weights.push_back(hole.intervals[i].thickness());
        places.push_back(i);
    }
    const std::vector<bool> chain = heaviest_chain(ranks, weights);
    std::vector<bool> kept(hole.intervals.size(), false);
    for (std::size_t i = 0; i < chain.size(); ++i) kept[places[i]] = chain[i];
    return kept;
}

void fit_hole(const LogSet& logs, HoleLog& hole, std::size_t ordered, Audit& audit) {
    const std::vector<bool> kept = kept_intervals(hole, ordered);
    const auto first = std::find(kept.begin(), kept.end(), true);
    const bool none = first == kept.end();
    std::size_t absorber =
        none ? LogInterval::kNoUnit : hole.intervals[static_cast<std::size_t>(first - kept.begin())].unit;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        LogInterval& interval = hole.intervals[i];
        if (kept[i]) absorber = interval.unit;
        if (kept[i] || interval.unit == LogInterval::kNoUnit) continue;
        audit.add_warning(logs.files[interval.file], interval.row, "",
                          fmt::format("hole {}: {} at {} to {} is out of order; {}", hole.id,
                                      logs.units[interval.unit], interval.from, interval.to,
                                      none ? "unknown there" : "taken as " + logs.units[absorber]));
        interval.unit = absorber;
    }
}

}  // namespace

void split_repeats(LogSet& logs) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> numbers;  // (unit, occurrence) → its own unit
    for (HoleLog& hole : logs.holes) {
        std::map<std::size_t, std::size_t> met;
        for (LogInterval& interval : hole.intervals) {
            if (interval.unit == LogInterval::kNoUnit) continue;
            const std::size_t occurrence = ++met[interval.unit];
            if (occurrence == 1) continue;
            const auto [place, is_new] = numbers.try_emplace({interval.unit, occurrence}, logs.units.size());
            if (is_new) logs.units.push_back(fmt::format("{} ({})", logs.units[interval.unit], occurrence));
            interval.unit = place->second;
        }
    }
}

std::size_t order_units(LogSet& logs, const std::vector<std::string>& order, Audit& audit) {
    std::vector<std::size_t> units = order.empty() ? inferred_order(logs) : stated_order(logs, order, audit);
    const std::size_t ordered = units.size();
    std::vector<bool> placed(logs.units.size(), false);
    for (const std::size_t unit : units) placed[unit] = true;
    for (std::size_t unit = 0; unit < placed.size(); ++unit) {
        if (placed[unit]) continue;
        units.push_back(unit);
        audit.add_warning("", 0, "",
                          fmt::format("unit {} is not in the order given; its intervals go to the unit above",
                                      logs.units[unit]));
    }
    renumber(logs, units);
    report_contradictions(logs, ordered, audit);
    return ordered;
}

void fit_logs_to_order(LogSet& logs, std::size_t ordered, Audit& audit) {
    for (HoleLog& hole : logs.holes) fit_hole(logs, hole, ordered, audit);
    logs.units.resize(ordered);
}

}  // namespace stratareeb
