// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/layer_rules.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "boreholes/errors.h"

namespace stratareeb {

namespace {

constexpr std::array<std::string_view, 4> kNames{"conformable", "erode", "onlap", "base"};

std::size_t unit_of(const std::vector<Unit>& units, const std::string& code) {
    const auto found = std::ranges::find(units, code, &Unit::code);
    if (found != units.end()) return static_cast<std::size_t>(found - units.begin());
    std::vector<std::string> codes;
    for (const Unit& unit : units) codes.push_back(unit.code);
    throw InvalidInput(fmt::format("a rule for '{}', which is no unit of the table; its units are {}", code,
                                   fmt::join(codes, ", ")));
}

void apply(LayerRules& rules, std::size_t unit, const NamedRule& word) {
    if (word.rule) rules.rule[unit] = *word.rule;
    if (word.min_thickness) rules.min_thickness[unit] = *word.min_thickness;
}

}  // namespace

LayerRule layer_rule(std::string_view name) {
    const auto found = std::ranges::find(kNames, name);
    if (found == kNames.end())
        throw InvalidInput(
            fmt::format("unknown layer rule '{}' (expected conformable, erode, onlap or base)", name));
    return static_cast<LayerRule>(found - kNames.begin());
}

std::string_view name_of(LayerRule rule) {
    return kNames[static_cast<std::size_t>(rule)];
}

bool LayerRules::cut() const {
    return std::ranges::any_of(rule, [](LayerRule r) { return r != LayerRule::Conformable; });
}

bool LayerRules::any() const {
    return cut() || std::ranges::any_of(min_thickness, [](double t) { return t > 0; });
}

LayerRules layer_rules(const std::vector<Unit>& units, const std::vector<NamedRule>& named) {
    LayerRules rules;
    rules.rule.assign(units.size(), LayerRule::Conformable);
    rules.min_thickness.assign(units.size(), 0.0);
    for (const NamedRule& word : named) {
        if (word.min_thickness && !(*word.min_thickness >= 0 && std::isfinite(*word.min_thickness)))
            throw InvalidInput(
                fmt::format("a minimum thickness of {} (expected a length, 0 or more)", *word.min_thickness));
        if (!word.code.empty()) continue;
        for (std::size_t i = 0; i < units.size(); ++i) apply(rules, i, word);
    }
    for (const NamedRule& word : named)
        if (!word.code.empty()) apply(rules, unit_of(units, word.code), word);
    return rules;
}

std::vector<LayerSequence> layer_sequences(const LayerRules& rules, std::size_t units) {
    std::vector<LayerSequence> sequences;
    for (std::size_t first = 0; first < units;) {
        LayerSequence s{.first = first, .last = first};
        const auto ends_below = [&](std::size_t i) {
            return rules.of(i) == LayerRule::Erode || rules.of(i) == LayerRule::Base || i + 1 == units ||
                   rules.of(i + 1) == LayerRule::Onlap;
        };
        while (!ends_below(s.last)) ++s.last;
        const bool under_erosion = first > 0 && rules.of(first - 1) == LayerRule::Erode;
        const bool own_base = rules.of(s.last) == LayerRule::Erode || rules.of(s.last) == LayerRule::Base;
        s.onlaps = rules.of(first) == LayerRule::Onlap && !under_erosion;
        s.stands = rules.of(s.last) == LayerRule::Base || under_erosion || s.onlaps;
        s.on_onlap = !own_base && s.last + 1 < units;
        s.anchored = s.stands || own_base || s.on_onlap;
        sequences.push_back(s);
        first = s.last + 1;
    }
    return sequences;
}

}  // namespace stratareeb
