// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_stl.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "boreholes/errors.h"
#include "io/binary_output.h"
#include "io/write_aside.h"

namespace stratareeb {
namespace {

using Corner = std::array<float, 3>;

Corner rounded(const Point3& p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

std::array<Corner, 3> corners(const TriangleSoup& soup, const std::array<std::uint32_t, 3>& t) {
    return {rounded(soup.points[t[0]]), rounded(soup.points[t[1]]), rounded(soup.points[t[2]])};
}

bool collapsed(const std::array<Corner, 3>& c) {
    return c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
}

template <class Visit>
void for_each_triangle(std::span<const PartData> parts, Visit visit) {
    for (const auto& part : parts) {
        for (const auto& t : part.soup.triangles) {
            const auto c = corners(part.soup, t);
            if (!collapsed(c)) visit(c);
        }
    }
}

Corner normal(const std::array<Corner, 3>& c) {
    std::array<double, 3> a, b;
    for (int k = 0; k < 3; ++k) {
        a[k] = double{c[1][k]} - c[0][k];
        b[k] = double{c[2][k]} - c[0][k];
    }
    const std::array<double, 3> n{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                  a[0] * b[1] - a[1] * b[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    if (!(length > 0)) return {0, 0, 0};
    return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length),
            static_cast<float>(n[2] / length)};
}

void put(BinaryOutput& out, const Corner& corner) {
    for (const float value : corner) out.put(value);
}

}  // namespace

void write_stl(const std::filesystem::path& file, std::span<const PartData> parts) {
    std::size_t count = 0;
    for_each_triangle(parts, [&](const auto&) { ++count; });
    if (count > std::numeric_limits<std::uint32_t>::max())
        throw IoError(fmt::format("{}: {} triangles are more than STL can count", file.string(), count));
    write_aside(file, [&](std::ostream& stream) {
        std::string header = "Stratareeb";
        header.resize(80, ' ');
        stream << header;
        BinaryOutput out(stream);
        out.put(static_cast<std::uint32_t>(count));
        for_each_triangle(parts, [&](const auto& c) {
            put(out, normal(c));
            for (const auto& corner : c) put(out, corner);
            out.put(std::uint16_t{0});
        });
    });
}

}  // namespace stratareeb
