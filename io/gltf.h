// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

//! Numbers of the glTF 2.0 specification that its reader and its writer share.
namespace stratareeb::gltf {

inline constexpr std::uint32_t kMagic = 0x46546C67;        // "glTF"
inline constexpr std::uint32_t kJsonChunk = 0x4E4F534A;    // "JSON"
inline constexpr std::uint32_t kBinaryChunk = 0x004E4942;  // "BIN"

inline constexpr int kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;
inline constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;
inline constexpr int kTriangles = 4, kTriangleStrip = 5, kTriangleFan = 6;

//! Colours are bytes of sRGB to people and linear numbers to glTF.
inline double linear(std::uint8_t srgb) {
    const double c = srgb / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
inline std::uint8_t srgb(double linear_value) {
    const double c = std::clamp(linear_value, 0.0, 1.0);
    return static_cast<std::uint8_t>(
        std::lround(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055)));
}

}  // namespace stratareeb::gltf
