// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <string>

namespace stratareeb {

//! An option whose value is one of some words; any other word is wrong usage, answered with the list.
template <class Choice>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Choice& choice,
                        const std::map<std::string, Choice>& words, const std::string& help) {
    std::string list;
    for (const auto& [word, value] : words) list += (list.empty() ? "" : "|") + word;
    const auto choose = [&choice, words, list, name](const std::string& word) {
        const auto found = words.find(word);
        if (found == words.end())
            throw CLI::ValidationError(name, fmt::format("{} is none of {}", word, list));
        choice = found->second;
    };
    return command.add_option_function<std::string>(name, choose, help)->option_text(list);
}

}  // namespace stratareeb
