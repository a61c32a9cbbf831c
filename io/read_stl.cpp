// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_stl.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

#include "boreholes/errors.h"
#include "io/text_scanner.h"
#include "io/weld.h"

namespace stratareeb {
namespace {

constexpr std::size_t kHeaderSize = 84;    // 80 bytes of anything, then the number of triangles
constexpr std::size_t kTriangleSize = 50;  // normal, three corners, two bytes of anything

template <class T>
T little_endian(const char* from) {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), from, sizeof(T));
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<T>(bytes);
}

// A binary file may begin with "solid" too; the size that its count asks for tells.
bool is_binary(std::string_view content) {
    if (content.size() < kHeaderSize) return false;
    const std::uint64_t count = little_endian<std::uint32_t>(content.data() + 80);
    if (content.size() == kHeaderSize + count * kTriangleSize) return true;
    return !content.starts_with("solid") || content.substr(0, 512).find('\0') != std::string_view::npos;
}

std::vector<Point3> binary_corners(const std::string& file, std::string_view content) {
    const std::uint64_t count = little_endian<std::uint32_t>(content.data() + 80);
    if (content.size() < kHeaderSize + count * kTriangleSize)
        throw InvalidInput(
            fmt::format("{}: the file has {} bytes where its {} triangles take {}; it is cut off or no STL",
                        file, content.size(), count, kHeaderSize + count * kTriangleSize));
    if (3 * count >= std::numeric_limits<std::uint32_t>::max())
        throw InvalidInput(file + ": too many triangles");
    std::vector<Point3> corners;
    corners.reserve(3 * count);
    for (std::uint64_t t = 0; t < count; ++t) {
        const char* const triangle = content.data() + kHeaderSize + t * kTriangleSize;
        for (int k = 0; k < 3; ++k) {
            const auto value = [&](int axis) {
                return double{little_endian<float>(triangle + 12 + 12 * k + 4 * axis)};
            };
            const Point3 p{value(0), value(1), value(2)};
            if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
                throw InvalidInput(
                    fmt::format("{}: triangle {} (byte {}) has a coordinate that is not a finite number",
                                file, t, kHeaderSize + t * kTriangleSize));
            corners.push_back(p);
        }
    }
    return corners;
}

std::string lower(std::string_view word) {
    std::string result(word);
    for (auto& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

std::vector<Point3> ascii_corners(const std::string& file, std::string_view content) {
    TextScanner scan(file, content);
    if (lower(scan.word()) != "solid")
        scan.fail("not an STL file: neither binary nor does it begin with 'solid'");
    scan.next_line();
    std::vector<Point3> corners;
    std::size_t in_facet = 0;
    while (!scan.at_end()) {
        const auto word = lower(scan.word());
        if (word == "vertex") {
            Point3 p;
            p.x = scan.number(scan.word());
            p.y = scan.number(scan.word());
            p.z = scan.number(scan.word());
            corners.push_back(p);
            ++in_facet;
        } else if (word == "facet") {
            in_facet = 0;
        } else if (word == "endfacet") {
            if (in_facet != 3) scan.fail(fmt::format("a facet with {} vertices", in_facet));
        } else if (!word.empty() && word != "outer" && word != "endloop" && word != "endsolid" &&
                   word != "solid") {
            scan.fail("unknown line in an ASCII STL file");
        }
        scan.next_line();
    }
    if (corners.size() % 3 != 0) scan.fail("the file ends in the middle of a facet");
    return corners;
}

// Three corners in a row are a triangle.
TriangleSoup soup_of(std::vector<Point3> corners) {
    TriangleSoup soup;
    soup.points = std::move(corners);
    soup.triangles.resize(soup.points.size() / 3);
    for (std::uint32_t t = 0; t < soup.triangles.size(); ++t)
        soup.triangles[t] = {3 * t, 3 * t + 1, 3 * t + 2};
    return soup;
}

}  // namespace

PartData read_stl(const std::filesystem::path& file) {
    const auto content = file_content(file);
    PartData part;
    part.soup = soup_of(is_binary(content) ? binary_corners(file.string(), content)
                                           : ascii_corners(file.string(), content));
    weld(part.soup);
    return part;
}

}  // namespace stratareeb
