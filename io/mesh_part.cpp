// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_part.h"

#include <fmt/format.h>

#include <charconv>

#include "boreholes/errors.h"

namespace stratareeb {

Rgb rgb_from_text(const std::string& color) {
    if (color.empty()) return PartData{}.color;
    unsigned value = 0;
    const char* end = color.data() + color.size();
    const auto [stop, error] = std::from_chars(color.data() + 1, end, value, 16);
    if (color.size() != 7 || color[0] != '#' || error != std::errc{} || stop != end)
        throw InvalidInput(fmt::format("colour '{}' is not of the form #rrggbb", color));
    return {static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8),
            static_cast<std::uint8_t>(value)};
}

std::string text_from_rgb(const Rgb& color) {
    return fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]);
}

}  // namespace stratareeb
