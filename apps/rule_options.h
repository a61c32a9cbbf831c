// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "boreholes/layer_rules.h"

namespace stratareeb {

//! Options that say how units lie on older ones, the same in every command that predicts.
struct RuleArguments {
    std::string file;
    std::vector<std::string> rules, minima;  // CODE=RULE; CODE=LENGTH or LENGTH

    //! What they say of a survey's units; options go before the file.
    LayerRules of(const std::vector<Unit>& units) const;
    //! As words, for records; empty without rules.
    std::string record() const;
};
void add_rule_options(CLI::App& command, RuleArguments& arguments);

}  // namespace stratareeb
