// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace stratareeb {

//! All bytes of a file.
//! \throw IoError if it can't be read
std::string file_content(const std::filesystem::path& file);

//! Words and numbers of a text, in any locale, with the line for messages. Works line by line: a word never
//! comes from the next line unless asked for.
class TextScanner {
 public:
    TextScanner(std::string file, std::string_view text, std::size_t line = 1)
        : file_(std::move(file)), rest_(text), line_(line) {}

    bool at_end() const { return rest_.empty(); }
    std::string_view rest() const { return rest_; }

    //! Next word of this line; empty at its end.
    std::string_view word();
    //! Next word, be it on a later line; empty at the end of the text.
    std::string_view word_anywhere();
    //! What is left of this line, without blanks around it; moves to the next line.
    std::string_view rest_of_line();
    void next_line() { rest_of_line(); }

    //! Numbers out of words.
    //! \throw InvalidInput naming file and line if it is none, or not finite
    double number(std::string_view word) const;
    long long integer(std::string_view word) const;

    [[noreturn]] void fail(const std::string& message) const;

 private:
    std::string file_;
    std::string_view rest_;
    std::size_t line_;
};

}  // namespace stratareeb
