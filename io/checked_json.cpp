// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/checked_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <utility>

#include "boreholes/errors.h"

namespace stratareeb {

namespace {

using nlohmann::json;

constexpr std::size_t kDeepest = 32;  // nobody writes more by hand; a hostile file has millions
constexpr std::size_t kTold = 20;
constexpr std::size_t kShown = 48;  // bytes of a value in a message

//! The start of a text, not cut within a letter.
std::string beginning(const std::string& text) {
    if (text.size() <= kShown) return text;
    std::size_t end = kShown;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
    return text.substr(0, end) + "…";
}

std::string shown(const json& value) {
    if (value.is_array()) return fmt::format("a list of {}", value.size());
    if (value.is_object()) return "an object";
    return beginning(value.dump());
}

//! Follows the parser: where it is, and which keys an object has had.
class Watch {
 public:
    explicit Watch(const std::string& file) : file_(file) {}

    bool operator()(json::parse_event_t event, const json& parsed) {
        using Event = json::parse_event_t;
        if (event == Event::object_end || event == Event::array_end) {
            path_.pop_back();
            return true;
        }
        if (event == Event::key) {
            enter_key(parsed.get_ref<const std::string&>());
            return true;
        }
        if (!path_.empty() && path_.back().is_list) ++path_.back().next;
        if (event == Event::value) return true;
        if (path_.size() == kDeepest)
            throw InvalidInput(
                fmt::format("{}: {} is nested more than {} deep", file_, beginning(place()), kDeepest));
        path_.push_back({.is_list = event == Event::array_start});
        return true;
    }

    //! Of the value that comes next.
    std::string place() const {
        std::string text;
        for (std::size_t i = 0; i < path_.size(); ++i) {
            const Level& level = path_[i];
            if (level.is_list)
                text += fmt::format("[{}]", level.next - (i + 1 < path_.size() ? 1 : 0));
            else
                text += (text.empty() ? "" : ".") + level.key;
        }
        return text.empty() ? "the file" : text;
    }

 private:
    struct Level {
        bool is_list = false;
        std::size_t next = 0;  // the number of the entry that comes next
        std::string key;
        std::set<std::string> keys;
    };

    void enter_key(const std::string& key) {
        Level& level = path_.back();
        level.key = key;
        if (!level.keys.insert(key).second)
            throw InvalidInput(fmt::format("{}: {}: it stands there twice; leave one", file_, place()));
    }

    const std::string& file_;
    std::vector<Level> path_;
};

//! What the parser says, for people: without its own number, and without bytes that are no text.
std::string parser_words(std::string text) {
    for (const std::string_view before : {"parse error at", " - "})
        if (const auto at = text.find(before); at != std::string::npos) text.erase(0, at + before.size());
    for (char& c : text)
        if (c < 32 || c == 127) c = '?';
    if (text.size() > 160) text = text.substr(0, 160) + "...";
    return text;
}

[[noreturn]] void refuse_syntax(std::string_view text, const std::string& file,
                                const json::parse_error& error) {
    const std::string_view before =
        text.substr(0, std::min(text.size(), std::max<std::size_t>(error.byte, 1) - 1));
    const auto line = 1 + std::ranges::count(before, '\n');
    const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;
    throw InvalidInput(
        fmt::format("{}:{}: column {}: not JSON: {}", file, line, column, parser_words(error.what())));
}

void refuse_other_encodings(std::string_view text, const std::string& file) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw InvalidInput(file + ": it is in UTF-16; save it as UTF-8");
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        throw InvalidInput(file + ": it is empty (expected a JSON object)");
}

std::size_t changes(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t k = 0; k < b.size(); ++k) {
            const std::size_t changed = diagonal + (a[i] != b[k]);
            diagonal = row[k + 1];
            row[k + 1] = std::min({changed, diagonal + 1, row[k] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string_view nearest_word(std::string_view word, std::span<const std::string_view> words) {
    std::string_view best;
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (const std::string_view candidate : words) {
        const std::size_t count = changes(word.substr(0, kShown), candidate.substr(0, kShown));
        if (count < fewest) {
            fewest = count;
            best = candidate;
        }
    }
    return best;
}

json parse_json(std::string_view text, const std::string& file) {
    refuse_other_encodings(text, file);
    Watch watch(file);
    const json::parser_callback_t follow = [&](int, json::parse_event_t event, const json& parsed) {
        return watch(event, parsed);
    };
    try {
        return json::parse(text, follow);
    } catch (const json::parse_error& error) {
        refuse_syntax(text, file, error);
    } catch (const json::out_of_range&) {
        throw InvalidInput(
            fmt::format("{}: {}: the number is too large (expected less than 1.8e308)", file, watch.place()));
    }
}

void FileFaults::add(std::string_view place, std::string_view text) {
    ++count_;
    if (told_.size() == kTold) return;
    told_.push_back(place.empty() ? std::string(text) : fmt::format("{}: {}", place, text));
}

void FileFaults::throw_if_any() const {
    if (count_ == 0) return;
    if (count_ == 1) throw InvalidInput(fmt::format("{}: {}", file_, told_.front()));
    const std::string rest = count_ > kTold ? fmt::format("\n  and {} more", count_ - kTold) : "";
    throw InvalidInput(fmt::format("{}: {} faults\n  {}{}", file_, count_, fmt::join(told_, "\n  "), rest));
}

void JsonItem::expected(std::string_view what) const {
    fault(fmt::format("is {} (expected {})", shown(*value_), what));
}

bool JsonItem::is_text() const {
    return value_->is_string();
}

bool JsonItem::is_whole_number() const {
    return value_->is_number_integer();
}

bool JsonItem::is_null() const {
    return value_->is_null();
}

bool JsonItem::is_object() const {
    return value_->is_object();
}

bool JsonItem::need_object(std::string_view what) const {
    if (!value_->is_object()) expected(what);
    return value_->is_object();
}

void JsonItem::know_keys(std::span<const std::string_view> keys) const {
    for (const auto& entry : value_->items())
        if (std::ranges::find(keys, entry.key()) == keys.end())
            fault(fmt::format("unknown key {}; did you mean \"{}\"? (known: {})",
                              beginning(json(entry.key()).dump()), nearest_word(entry.key(), keys),
                              fmt::join(keys, ", ")));
}

std::optional<JsonItem> JsonItem::find(std::string_view key) const {
    const auto found = value_->find(key);
    if (found == value_->end()) return std::nullopt;
    return JsonItem(*found, place_.empty() ? std::string(key) : fmt::format("{}.{}", place_, key), *faults_);
}

std::optional<JsonItem> JsonItem::need(std::string_view key) const {
    auto found = find(key);
    if (!found) fault(fmt::format("\"{}\" is missing", key));
    return found;
}

std::vector<JsonItem> JsonItem::list(std::string_view what) const {
    std::vector<JsonItem> items;
    if (!value_->is_array()) {
        expected(what);
        return items;
    }
    items.reserve(value_->size());
    for (std::size_t i = 0; i < value_->size(); ++i)
        items.emplace_back((*value_)[i], fmt::format("{}[{}]", place_, i), *faults_);
    return items;
}

std::optional<double> JsonItem::number() const {
    if (value_->is_number()) return value_->get<double>();
    expected("a number");
    return std::nullopt;
}

std::optional<std::int64_t> JsonItem::whole_number() const {
    const bool fits = value_->is_number_integer() &&
                      (!value_->is_number_unsigned() ||
                       value_->get<std::uint64_t>() <=
                           static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()));
    if (fits) return value_->get<std::int64_t>();
    expected("a whole number");
    return std::nullopt;
}

std::optional<bool> JsonItem::flag() const {
    if (value_->is_boolean()) return value_->get<bool>();
    expected("true or false");
    return std::nullopt;
}

std::optional<std::string> JsonItem::text() const {
    if (is_text()) return value_->get<std::string>();
    expected("a text");
    return std::nullopt;
}

std::optional<std::vector<double>> JsonItem::numbers() const {
    if (!value_->is_array()) {
        expected("a list of numbers");
        return std::nullopt;
    }
    std::vector<double> result;
    result.reserve(value_->size());
    for (std::size_t i = 0; i < value_->size(); ++i) {
        if ((*value_)[i].is_number())
            result.push_back((*value_)[i].get<double>());
        else
            JsonItem((*value_)[i], fmt::format("{}[{}]", place_, i), *faults_).expected("a number");
    }
    if (result.size() != value_->size()) return std::nullopt;
    return result;
}

}  // namespace stratareeb
