// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace stratareeb {

inline std::string from_base64(std::string_view text) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int held = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = bits << 6 | static_cast<std::uint32_t>(kDigits.find(c));
        held += 6;
        if (held < 8) continue;
        held -= 8;
        bytes += static_cast<char>(bits >> held & 255);
    }
    return bytes;
}

inline std::string inflated(const std::string& packed) {
    std::string bytes(packed.size() * 50 + 1000, '\0');
    uLongf size = bytes.size();
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                         reinterpret_cast<const Bytef*>(packed.data()), packed.size()),
              Z_OK);
    bytes.resize(size);
    return bytes;
}

//! What stands in the page's element for the model.
inline std::string model_text(const std::string& page) {
    const std::string start = "<script id=\"model\" type=\"text/plain\">";
    const auto from = page.find(start) + start.size();
    return page.substr(from, page.find("</script>", from) - from);
}

//! The payload of a page, read as io/view_payload.h and io/view_streams.h say it is written.
struct Payload {
    using json = nlohmann::json;
    json header;
    std::string lists;

    explicit Payload(const std::string& bytes) {
        std::size_t length = 0;
        for (std::size_t i = 4; i-- > 0;) length = length << 8 | static_cast<unsigned char>(bytes[i]);
        header = json::parse(bytes.substr(4, length));
        lists = bytes.substr(4 + length);
    }

    std::vector<std::uint64_t> numbers(const json& list) const {
        std::vector<std::uint64_t> result;
        std::size_t at = list.at("offset");
        for (std::size_t i = 0; i < list.at("count"); ++i) {
            std::uint64_t value = 0;
            for (int shift = 0;; shift += 7) {
                const auto byte = static_cast<unsigned char>(lists.at(at++));
                value |= static_cast<std::uint64_t>(byte & 127) << shift;
                if (byte < 128) break;
            }
            result.push_back(value);
        }
        EXPECT_EQ(at, list.at("offset").get<std::size_t>() + list.at("length").get<std::size_t>());
        return result;
    }

    std::vector<std::int64_t> sums(const json& list) const {
        std::vector<std::int64_t> result;
        std::int64_t sum = 0;
        for (const std::uint64_t code : numbers(list)) {
            const auto half = static_cast<std::int64_t>(code / 2);
            sum += code % 2 == 1 ? -half - 1 : half;
            result.push_back(sum);
        }
        return result;
    }

    std::vector<std::uint32_t> corners(const json& surfaces) const {
        std::vector<std::uint32_t> result;
        std::uint32_t met = 0;
        for (const std::uint64_t code : numbers(surfaces.at("corner"))) {
            const auto v = code == 0 ? met++ : met - static_cast<std::uint32_t>(code);
            EXPECT_LT(v, met);
            result.push_back(v);
        }
        EXPECT_EQ(met, surfaces.at("vertices").get<std::uint32_t>());
        EXPECT_EQ(result.size(), 3 * surfaces.at("triangles").get<std::size_t>());
        return result;
    }
};

}  // namespace stratareeb
