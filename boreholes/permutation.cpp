// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/permutation.h"

#include <array>
#include <bit>
#include <numeric>
#include <utility>

namespace stratareeb {

namespace {

__extension__ typedef unsigned __int128 Wide;

//! NumPy's SeedSequence: a seed spread over as many words as are wanted.
std::array<std::uint32_t, 8> seed_words(std::uint64_t seed) {
    std::array<std::uint32_t, 4> pool{static_cast<std::uint32_t>(seed),
                                      static_cast<std::uint32_t>(seed >> 32), 0, 0};
    std::uint32_t key = 0x43b0d7e5;
    const auto hashed = [&key](std::uint32_t value) {
        value ^= key;
        key *= 0x931e8875;
        value *= key;
        return value ^ (value >> 16);
    };
    for (auto& word : pool) word = hashed(word);
    for (std::size_t from = 0; from < 4; ++from)
        for (std::size_t to = 0; to < 4; ++to) {
            if (from == to) continue;
            const std::uint32_t mixed = 0xca01f9dd * pool[to] - 0x4973f715 * hashed(pool[from]);
            pool[to] = mixed ^ (mixed >> 16);
        }
    std::array<std::uint32_t, 8> words{};
    key = 0x8b51f9dd;
    for (std::size_t i = 0; i < words.size(); ++i) {
        std::uint32_t value = pool[i % 4] ^ key;
        key *= 0x58f38ded;
        value *= key;
        words[i] = value ^ (value >> 16);
    }
    return words;
}

class Pcg64 {
 public:
    explicit Pcg64(std::uint64_t seed) {
        const auto words = seed_words(seed);
        const auto pair = [&](std::size_t i) {
            return (static_cast<std::uint64_t>(words[i + 1]) << 32) | words[i];
        };
        step_ = (((static_cast<Wide>(pair(4)) << 64) | pair(6)) << 1) | 1;
        advance();
        state_ += (static_cast<Wide>(pair(0)) << 64) | pair(2);
        advance();
    }

    //! Evenly distributed over 0 … last: bits as many as `last` has, until they are no more than it.
    std::uint32_t below_or_at(std::uint32_t last) {
        const std::uint32_t mask = last == 0 ? 0 : UINT32_MAX >> std::countl_zero(last);
        if (mask == 0) return 0;
        for (;;)
            if (const std::uint32_t value = half() & mask; value <= last) return value;
    }

 private:
    void advance() {
        constexpr Wide kFactor = (static_cast<Wide>(0x2360ed051fc65da4) << 64) | 0x4385df649fccf645;
        state_ = state_ * kFactor + step_;
    }

    //! 32 bits: the low half of a word first, then its high half.
    std::uint32_t half() {
        if (has_half_) {
            has_half_ = false;
            return rest_;
        }
        advance();
        const auto folded = static_cast<std::uint64_t>(state_ >> 64) ^ static_cast<std::uint64_t>(state_);
        const auto turn = static_cast<unsigned>(state_ >> 122);
        const std::uint64_t word = (folded >> turn) | (folded << (-turn & 63U));
        has_half_ = true;
        rest_ = static_cast<std::uint32_t>(word >> 32);
        return static_cast<std::uint32_t>(word);
    }

    Wide state_ = 0, step_ = 0;
    std::uint32_t rest_ = 0;
    bool has_half_ = false;
};

}  // namespace

std::vector<std::size_t> random_permutation(std::size_t count, std::uint64_t seed) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    Pcg64 random(seed);
    for (std::size_t i = count; i-- > 1;)
        std::swap(order[i], order[random.below_or_at(static_cast<std::uint32_t>(i))]);
    return order;
}

}  // namespace stratareeb
