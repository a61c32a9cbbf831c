// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/step_sharing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <iterator>
#include <ostream>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

constexpr std::string_view kData = "DATA;";

// What may be shared, by rounds: those of a round refer to earlier ones only.
constexpr int kRounds = 3;
constexpr std::array<std::pair<std::string_view, int>, 6> kShared{{{"CARTESIAN_POINT", 1},
                                                                   {"DIRECTION", 1},
                                                                   {"VECTOR", 2},
                                                                   {"LINE", 3},
                                                                   {"B_SPLINE_CURVE_WITH_KNOTS", 2},
                                                                   {"B_SPLINE_SURFACE_WITH_KNOTS", 2}}};

struct Entity {
    std::string_view text;    // between '=' and ';'
    int round = 0;            // 0: stays as it is
    std::size_t same_as = 0;  // itself, or the first that says the same
    std::size_t number = 0;   // in the new file; 0: left out
};

bool is_space(char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

int round_of(std::string_view text) {
    const std::string_view name = text.substr(0, text.find_first_of("( \n\r\t"));
    const auto found = std::ranges::find(kShared, name, &std::pair<std::string_view, int>::first);
    return found == kShared.end() ? 0 : found->second;
}

class Sharing {
 public:
    explicit Sharing(std::string_view text) { read(text); }

    void write(std::ostream& stream) {
        for (int round = 1; round <= kRounds; ++round) find_same(round);
        std::size_t number = 0;
        for (std::size_t i = 0; i < entities_.size(); ++i)
            if (entities_[i].same_as == i) entities_[i].number = ++number;
        stream << head_;
        std::string line;
        for (std::size_t i = 0; i < entities_.size(); ++i) {
            if (entities_[i].same_as != i) continue;
            line = fmt::format("#{} = ", entities_[i].number);
            walk(
                entities_[i].text, [&](char c, bool) { line += c; },
                [&](std::size_t other) {
                    fmt::format_to(std::back_inserter(line), "#{}",
                                   entities_[entities_[other].same_as].number);
                });
            stream << (line += ";\n");
        }
        stream << tail_;
    }

 private:
    [[noreturn]] static void fail(std::string_view what) {
        throw InvalidInput(fmt::format("no STEP file: {}", what));
    }

    static std::size_t number_at(std::string_view text, std::size_t& at) {
        std::size_t number = 0;
        const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), number);
        if (error != std::errc()) fail("'#' without a number");
        at = static_cast<std::size_t>(end - text.data());
        return number;
    }

    void read(std::string_view text) {
        const std::size_t data = text.find(kData);
        if (data == std::string_view::npos) fail("it has no data section");
        std::size_t at = data + kData.size();
        while (at < text.size() && is_space(text[at])) ++at;
        head_ = text.substr(0, at);
        while (at < text.size() && text[at] == '#') {
            const std::size_t number = number_at(text, ++at);
            while (at < text.size() && (is_space(text[at]) || text[at] == '=')) ++at;
            const std::size_t begin = at;
            for (bool in_quotes = false; at < text.size() && (in_quotes || text[at] != ';'); ++at)
                if (text[at] == '\'') in_quotes = !in_quotes;
            if (at == text.size()) fail("an entity does not end");
            add(number, text.substr(begin, at - begin));
            ++at;
            while (at < text.size() && is_space(text[at])) ++at;
        }
        tail_ = text.substr(at);
    }

    void add(std::size_t number, std::string_view text) {
        const std::size_t i = entities_.size();
        if (!place_of_.try_emplace(number, i).second) fail(fmt::format("#{} is there twice", number));
        entities_.push_back({.text = text, .round = round_of(text), .same_as = i});
    }

    // Character by character, with references as places of entities.
    template <class Character, class Reference>
    void walk(std::string_view text, Character character, Reference reference) const {
        bool in_quotes = false;
        for (std::size_t at = 0; at < text.size();) {
            if (text[at] == '\'') in_quotes = !in_quotes;
            if (in_quotes || text[at] != '#') {
                character(text[at++], in_quotes);
                continue;
            }
            const std::size_t number = number_at(text, ++at);
            const auto found = place_of_.find(number);
            if (found == place_of_.end()) fail(fmt::format("#{} is missing", number));
            reference(found->second);
        }
    }

    void find_same(int round) {
        std::unordered_map<std::string, std::size_t> first;
        std::string key;
        for (std::size_t i = 0; i < entities_.size(); ++i) {
            if (entities_[i].round != round) continue;
            key.clear();
            walk(
                entities_[i].text,
                [&](char c, bool in_quotes) {
                    if (in_quotes || !is_space(c)) key += c;  // lines break where numbers are longer
                },
                [&](std::size_t other) {
                    fmt::format_to(std::back_inserter(key), "#{}", entities_[other].same_as);
                });
            entities_[i].same_as = first.try_emplace(key, i).first->second;
        }
    }

    std::string_view head_, tail_;
    std::vector<Entity> entities_;
    std::unordered_map<std::size_t, std::size_t> place_of_;  // [number in the file]
};

}  // namespace

void share_step_geometry(std::string_view text, std::ostream& stream) {
    Sharing(text).write(stream);
}

}  // namespace stratareeb
