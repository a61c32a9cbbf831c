// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/listed_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "boreholes/errors.h"
#include "boreholes/unit_order.h"

namespace stratareeb {
namespace {

constexpr std::size_t kMostUnits = 500;
constexpr std::size_t kUnordered = static_cast<std::size_t>(-1);

void split_repeats(ListedSet& listed) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> numbers;
    for (ListedHole& hole : listed.holes) {
        std::map<std::size_t, std::size_t> met;
        for (ListedLayer& layer : hole.layers) {
            const std::size_t occurrence = ++met[layer.unit];
            if (occurrence == 1) continue;
            const auto [place, is_new] = numbers.try_emplace({layer.unit, occurrence}, listed.units.size());
            if (is_new) listed.units.push_back(fmt::format("{} ({})", listed.units[layer.unit], occurrence));
            layer.unit = place->second;
        }
    }
}

//! Each unit's mean place in a row's list.
void add_votes(const ListedHole& hole, OrderVotes& votes) {
    std::map<std::size_t, std::pair<double, double>> places;
    for (std::size_t i = 0; i < hole.layers.size(); ++i) {
        auto& [count, sum] = places[hole.layers[i].unit];
        count += 1;
        sum += static_cast<double>(i);
    }
    std::vector<std::size_t> units;
    std::vector<double> depths;
    for (const auto& [unit, place] : places) {
        units.push_back(unit);
        depths.push_back(place.second / place.first);
    }
    votes.add_hole(units, depths);
}

bool same_list(const ListedHole& a, const ListedHole& b) {
    return std::equal(a.layers.begin(), a.layers.end(), b.layers.begin(), b.layers.end(),
                      [](const ListedLayer& p, const ListedLayer& q) { return p.unit == q.unit; });
}

std::vector<std::size_t> listed_order(const ListedSet& listed, Audit& audit) {
    const bool alike = std::all_of(listed.holes.begin(), listed.holes.end(), [&](const ListedHole& hole) {
        return same_list(hole, listed.holes.front());
    });
    std::vector<std::size_t> order(listed.units.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (alike) return order;
    OrderVotes votes(listed.units.size());
    for (const ListedHole& hole : listed.holes) add_votes(hole, votes);
    const UnitOrder ranked = rank_units(votes);
    for (const OrderConflict& pair : ranked.conflicts)
        audit.add_warning(
            "", 0, "",
            fmt::format("most rows list {} above {}, but the units form a cycle; {} is taken to lie above",
                        listed.units[pair.above], listed.units[pair.below], listed.units[pair.below]));
    return ranked.units;
}

std::vector<std::size_t> stated_order(const ListedSet& listed, const std::vector<std::string>& codes,
                                      Audit& audit) {
    std::vector<std::size_t> order;
    for (const std::string& code : codes) {
        const auto found = std::find(listed.units.begin(), listed.units.end(), code);
        if (found == listed.units.end())
            audit.add_error("", 0, "",
                            fmt::format("the order names unit {}, which the table does not have", code));
        else
            order.push_back(static_cast<std::size_t>(found - listed.units.begin()));
    }
    for (std::size_t unit = 0; unit < listed.units.size(); ++unit)
        if (std::find(order.begin(), order.end(), unit) == order.end())
            audit.add_warning(
                "", 0, "",
                fmt::format("unit {} is not in the order given; its thickness goes to the unit above",
                            listed.units[unit]));
    return order;
}

//! A layer on its way from a row's list to the column: ranked, its thickness and base worked out.
struct Entry {
    std::size_t rank = 0;
    LayerFact fact;
    std::optional<double> base;  // elevation
    bool given = false;
};

class RowReader {
 public:
    RowReader(const ListedSet& listed, const std::vector<std::size_t>& ranks, std::size_t units, Audit& audit)
        : listed_(listed), ranks_(ranks), units_(units), audit_(audit) {}

    Borehole read(ListedHole& hole) {
        hole_ = &hole;
        Borehole result{hole.id, hole.at, {}, {}, hole.row};
        result.layers.resize(units_);
        result.horizons.resize(units_ + 1);
        result.horizons[0] = hole.ground;
        if (listed_.value != ListedValue::Thickness) drop_turning_values();
        std::vector<Entry> entries = ranked_entries();
        bring_into_order(entries);
        write(entries, result);
        return result;
    }

 private:
    void warn(std::string text) {
        audit_.add_warning(listed_.files[hole_->file], hole_->row, "",
                           fmt::format("hole {}: {}", hole_->id, text));
    }

    double depth(double value) const { return listed_.value == ListedValue::BaseDepth ? value : -value; }

    //! Keep the longest run of depths that never turns back; above the ground nothing counts.
    void drop_turning_values() {
        std::vector<std::size_t> places;
        std::vector<double> depths;
        const double top = listed_.value == ListedValue::BaseDepth ? 0
                           : hole_->ground                         ? -*hole_->ground
                                                                   : -HUGE_VAL;
        for (std::size_t i = 0; i < hole_->layers.size(); ++i) {
            ListedLayer& layer = hole_->layers[i];
            if (!layer.given) continue;
            if (depth(layer.value) < top) {
                warn(fmt::format("{} of {} is above the ground; taken as unknown", layer.value,
                                 listed_.units[layer.unit]));
                layer.given = false;
                continue;
            }
            places.push_back(i);
            depths.push_back(depth(layer.value));
        }
        const std::vector<bool> kept = longest_rise(depths);
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (kept[i]) continue;
            ListedLayer& layer = hole_->layers[places[i]];
            warn(fmt::format("{} of {} is out of sequence with the other values; taken as unknown",
                             layer.value, listed_.units[layer.unit]));
            layer.given = false;
        }
    }

    static std::vector<bool> longest_rise(const std::vector<double>& values) {
        if (std::is_sorted(values.begin(), values.end())) return std::vector<bool>(values.size(), true);
        std::vector<double> sorted = values;
        std::sort(sorted.begin(), sorted.end());
        std::vector<std::size_t> ranks;
        for (const double value : values)
            ranks.push_back(static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), value) -
                                                     sorted.begin()));
        return heaviest_chain(ranks, std::vector<double>(values.size(), 1.0));
    }

    std::vector<Entry> ranked_entries() const {
        std::vector<Entry> entries;
        std::optional<double> above;  // depth of the base above, where known
        if (listed_.value == ListedValue::BaseDepth) above = 0;
        if (listed_.value == ListedValue::BaseElevation && hole_->ground) above = -*hole_->ground;
        for (const ListedLayer& layer : hole_->layers) {
            Entry entry{ranks_[layer.unit], {}, {}, layer.given};
            const Knowledge known = layer.at_least ? Knowledge::AtLeast : Knowledge::Measured;
            if (layer.given && listed_.value == ListedValue::Thickness) entry.fact = {known, layer.value};
            if (listed_.value != ListedValue::Thickness) {
                const auto base = layer.given ? std::optional<double>(depth(layer.value)) : std::nullopt;
                if (base && above) entry.fact = {known, *base - *above};
                if (base && !layer.at_least) entry.base = elevation(layer.value);
                above = layer.at_least ? std::nullopt : base;
            }
            if (entry.fact.knowledge == Knowledge::AtLeast && entry.fact.thickness == 0) entry.fact = {};
            entries.push_back(entry);
        }
        return entries;
    }

    std::optional<double> elevation(double value) const {
        if (listed_.value == ListedValue::BaseElevation) return value;
        return hole_->ground ? std::optional<double>(*hole_->ground - value) : std::nullopt;
    }

    void bring_into_order(std::vector<Entry>& entries) {
        const bool in_order =
            std::is_sorted(entries.begin(), entries.end(),
                           [](const Entry& a, const Entry& b) { return a.rank < b.rank; }) &&
            (entries.empty() || entries.back().rank != kUnordered);
        if (in_order) return join_equal_ranks(entries);
        const std::vector<bool> kept = kept_entries(entries);
        std::vector<Entry> column;
        Entry before;  // absorbed ones above the first kept
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (!kept[i] && entries[i].fact.thickness > 0)
                warn(fmt::format("{} ({}) is out of order; added to the unit above",
                                 listed_.units[hole_->layers[i].unit], entries[i].fact.thickness));
            if (kept[i]) {
                column.push_back(entries[i]);
                if (column.size() == 1) column[0].fact.thickness += before.fact.thickness;
            } else {
                absorb(column.empty() ? before : column.back(), entries[i]);
            }
        }
        entries = std::move(column);
        join_equal_ranks(entries);
    }

    std::vector<bool> kept_entries(const std::vector<Entry>& entries) const {
        std::vector<std::size_t> ranks, places;
        std::vector<double> weights;
        double thickest = 0;
        for (const Entry& entry : entries) thickest = std::max(thickest, entry.fact.thickness);
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (entries[i].rank == kUnordered) continue;
            places.push_back(i);
            ranks.push_back(entries[i].rank);
            weights.push_back(entries[i].fact.thickness + 1e-9 * thickest +
                              1e-300);  // zeros count if nothing else does
        }
        const std::vector<bool> chain = heaviest_chain(ranks, weights);
        std::vector<bool> kept(entries.size(), false);
        for (std::size_t i = 0; i < chain.size(); ++i) kept[places[i]] = chain[i];
        return kept;
    }

    static void absorb(Entry& into, const Entry& entry) {
        if (entry.fact.thickness == 0) return;
        into.fact.thickness += entry.fact.thickness;
        into.given = true;
        into.base = entry.base;
        if (entry.fact.knowledge == Knowledge::AtLeast || into.fact.knowledge == Knowledge::Unknown)
            into.fact.knowledge = Knowledge::AtLeast;
    }

    static void join_equal_ranks(std::vector<Entry>& entries) {
        std::vector<Entry> joined;
        for (const Entry& entry : entries)
            if (!joined.empty() && joined.back().rank == entry.rank)
                absorb(joined.back(), entry);
            else
                joined.push_back(entry);
        entries = std::move(joined);
    }

    void write(const std::vector<Entry>& entries, Borehole& out) const {
        const auto deepest =
            std::find_if(entries.rbegin(), entries.rend(), [](const Entry& e) { return e.given; });
        if (deepest == entries.rend()) return;
        for (std::size_t unit = 0; unit < deepest->rank; ++unit) out.layers[unit] = {Knowledge::Measured, 0};
        for (const Entry& entry : entries) {
            out.layers[entry.rank] = entry.fact;
            if (entry.base) out.horizons[entry.rank + 1] = entry.base;
        }
        LayerFact& last = out.layers[deepest->rank];
        if (deepest->rank + 1 < units_ && last.is_present() && !listed_.of_tops) {
            last.knowledge = Knowledge::AtLeast;  // the hole ended in it
            out.horizons[deepest->rank + 1].reset();
        }
        for (std::size_t unit = 0; unit < units_; ++unit)
            if (!out.horizons[unit + 1] && out.horizons[unit] &&
                out.layers[unit].knowledge == Knowledge::Measured)
                out.horizons[unit + 1] = *out.horizons[unit] - out.layers[unit].thickness;
    }

    const ListedSet& listed_;
    const std::vector<std::size_t>& ranks_;
    std::size_t units_;
    Audit& audit_;
    ListedHole* hole_ = nullptr;
};

//! Units between tops: what lies above the first top comes first, and the last top has nothing below it.
void shift_to_bases(std::vector<std::string>& codes, Audit& audit) {
    audit.add_warning(
        "", 0, "",
        fmt::format("values are tops: {} has no base and is no layer; what lies above {} is overburden",
                    codes.back(), codes.front()));
    codes.pop_back();
    codes.insert(codes.begin(), "overburden");
}

}  // namespace

Survey build_survey(ListedSet listed, const StratigraphyOptions& options, Audit& audit) {
    if (options.repeats == RepeatRule::Split) split_repeats(listed);
    if (listed.units.size() > kMostUnits)
        throw InvalidInput(
            fmt::format("{} different units ({}, {}, …): more than {}; are these columns units? State the "
                        "layout or the columns",
                        listed.units.size(), listed.units[0], listed.units[1], kMostUnits));
    const std::vector<std::size_t> order =
        options.order.empty() ? listed_order(listed, audit) : stated_order(listed, options.order, audit);
    std::vector<std::size_t> ranks(listed.units.size(), kUnordered);
    std::vector<std::string> codes;
    for (std::size_t i = 0; i < order.size(); ++i) {
        ranks[order[i]] = i;
        codes.push_back(listed.units[order[i]]);
    }
    Survey survey;
    RowReader rows(listed, ranks, order.size(), audit);
    for (ListedHole& hole : listed.holes) survey.holes.push_back(rows.read(hole));
    if (listed.of_tops && !codes.empty()) shift_to_bases(codes, audit);
    for (const std::string& code : codes) survey.units.push_back({code, code, ""});
    return survey;
}

}  // namespace stratareeb
