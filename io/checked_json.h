// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stratareeb {

//! A JSON document, as strict as the standard, and more: an object may not have a key twice, numbers must fit a double,
//! values are nested at most 32 deep. A byte order mark is skipped.
//! `file`: its name for messages.
//! \throw InvalidInput that names line and column, or the place as in `contours[3].points[2]`
nlohmann::json parse_json(std::string_view text, const std::string& file);

//! What is wrong in one file, all told at once.
class FileFaults {
 public:
    explicit FileFaults(std::string file) : file_(std::move(file)) {}

    void add(std::string_view place, std::string_view text);
    std::size_t count() const { return count_; }
    //! \throw InvalidInput with the first 20 faults, if there are any
    void throw_if_any() const;

 private:
    std::string file_;
    std::vector<std::string> told_;
    std::size_t count_ = 0;
};

//! A value in a JSON document that knows its place in it. What it is asked for and is not becomes a fault with that place,
//! and nothing is returned.
class JsonItem {
 public:
    JsonItem(const nlohmann::json& value, std::string place, FileFaults& faults)
        : value_(&value), place_(std::move(place)), faults_(&faults) {}

    const std::string& place() const { return place_; }
    void fault(std::string_view text) const { faults_->add(place_, text); }
    //! "is 5 (expected a text)"
    void expected(std::string_view what) const;

    bool is_text() const;
    bool is_whole_number() const;
    bool is_null() const;
    bool is_object() const;

    //! Whether it is an object: `{what}` says in the fault which.
    bool need_object(std::string_view what) const;
    //! Faults for the object's keys that are none of these, each with the one that is nearest.
    void know_keys(std::span<const std::string_view> keys) const;
    //! A member, or nothing if the object has none.
    std::optional<JsonItem> find(std::string_view key) const;
    //! The same, where its lack is a fault.
    std::optional<JsonItem> need(std::string_view key) const;

    //! The entries of a list; none if it is not one.
    std::vector<JsonItem> list(std::string_view what) const;
    std::optional<double> number() const;
    std::optional<std::int64_t> whole_number() const;
    std::optional<bool> flag() const;  // true or false
    std::optional<std::string> text() const;
    std::optional<std::vector<double>> numbers() const;

 private:
    const nlohmann::json* value_;
    std::string place_;
    FileFaults* faults_;
};

//! The word that is most like another: fewest letters to change, insert or leave out; the first of several.
//! \return empty if there are no words
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> words);

}  // namespace stratareeb
