// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/rule_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "boreholes/errors.h"
#include "io/cell_value.h"
#include "io/read_layer_rules.h"

namespace stratareeb {

namespace {

NamedRule rule_word(const std::string& text) {
    const auto equals = text.rfind('=');
    if (equals == std::string::npos || equals == 0) throw InvalidInput(text + " is not CODE=RULE");
    return {.code = text.substr(0, equals), .rule = layer_rule(text.substr(equals + 1)), .min_thickness = {}};
}

NamedRule minimum_word(const std::string& text) {
    const auto equals = text.rfind('=');
    const CellValue value = cell_value(equals == std::string::npos ? text : text.substr(equals + 1));
    if (value.kind != CellKind::Number || !(value.number >= 0))
        throw InvalidInput(text + " is neither a length nor CODE=LENGTH");
    return {.code = equals == std::string::npos ? "" : text.substr(0, equals),
            .rule = {},
            .min_thickness = value.number};
}

template <class Word>
std::string complaint(const std::string& text, Word word) {
    try {
        word(text);
        return {};
    } catch (const InvalidInput& error) {
        return error.what();
    }
}

}  // namespace

LayerRules RuleArguments::of(const std::vector<Unit>& units) const {
    std::vector<NamedRule> named;
    if (!file.empty()) named = read_layer_rules(file);
    for (const std::string& text : rules) named.push_back(rule_word(text));
    for (const std::string& text : minima) named.push_back(minimum_word(text));
    return named.empty() ? LayerRules{} : layer_rules(units, named);
}

std::string RuleArguments::record() const {
    std::vector<std::string> words;
    if (!file.empty()) words.push_back(file);
    words.insert(words.end(), rules.begin(), rules.end());
    for (const std::string& text : minima) words.push_back("min " + text);
    return fmt::format("{}", fmt::join(words, ", "));
}

void add_rule_options(CLI::App& command, RuleArguments& arguments) {
    command.add_option("--rules", arguments.file, "Table of code, rule and min_thickness, for layer rules");
    command
        .add_option("--rule", arguments.rules,
                    "CODE=RULE: how a unit lies on older ones: conformable, erode, onlap or base")
        ->delimiter(',')
        ->check([](const std::string& text) { return complaint(text, rule_word); });
    command
        .add_option("--min-thickness", arguments.minima,
                    "CODE=LENGTH, or LENGTH for all: the least of a unit between holes where it is present")
        ->delimiter(',')
        ->check([](const std::string& text) { return complaint(text, minimum_word); });
}

}  // namespace stratareeb
