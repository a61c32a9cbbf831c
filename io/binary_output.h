// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <ostream>
#include <string>

namespace stratareeb {

//! Little-endian numbers to a stream in big blocks.
class BinaryOutput {
 public:
    explicit BinaryOutput(std::ostream& stream) : stream_(stream) { buffer_.reserve(kBlock + 256); }
    BinaryOutput(const BinaryOutput&) = delete;
    BinaryOutput& operator=(const BinaryOutput&) = delete;
    ~BinaryOutput() { flush(); }

    template <class T>
    void put(T value) {
        auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
        if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
        buffer_.append(bytes.data(), bytes.size());
        if (buffer_.size() >= kBlock) flush();
    }

 private:
    static constexpr std::size_t kBlock = 1 << 18;

    void flush() {
        stream_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
        buffer_.clear();
    }

    std::ostream& stream_;
    std::string buffer_;
};

}  // namespace stratareeb
