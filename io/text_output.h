// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <ostream>
#include <utility>

namespace stratareeb {

//! Formatted text to a stream in big blocks, the same in any locale. "{}" prints the shortest digits that
//! read back as the same double.
class TextOutput {
 public:
    explicit TextOutput(std::ostream& stream) : stream_(stream) {}
    TextOutput(const TextOutput&) = delete;
    TextOutput& operator=(const TextOutput&) = delete;
    ~TextOutput() { flush(); }

    template <class... Arguments>
    void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(buffer_), format, std::forward<Arguments>(arguments)...);
        if (buffer_.size() > (1 << 18)) flush();
    }

 private:
    void flush() {
        stream_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
        buffer_.clear();
    }

    std::ostream& stream_;
    fmt::memory_buffer buffer_;
};

}  // namespace stratareeb
