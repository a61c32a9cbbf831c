// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/triangle_soup.h"

namespace stratareeb {

using Rgb = std::array<std::uint8_t, 3>;

//! A named, coloured mesh as the readers and writers of single formats hand it on.
struct PartData {
    std::string name;
    Rgb color{200, 200, 200};
    TriangleSoup soup;
    std::vector<Point3> normals;  // one a vertex; readers leave it empty
};

//! "#rrggbb" as three bytes; light grey for an empty text.
//! \throw InvalidInput for anything else
Rgb rgb_from_text(const std::string& color);
std::string text_from_rgb(const Rgb& color);

}  // namespace stratareeb
