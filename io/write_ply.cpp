// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_ply.h"

#include <fmt/format.h>

#include <limits>

#include "boreholes/errors.h"
#include "io/binary_output.h"
#include "io/write_aside.h"

namespace stratareeb {
namespace {

struct Counts {
    std::size_t vertices = 0, triangles = 0;
};

Counts counts(std::span<const PartData> parts) {
    Counts sum;
    for (const auto& part : parts) {
        sum.vertices += part.soup.points.size();
        sum.triangles += part.soup.triangles.size();
    }
    return sum;
}

std::string header(const Counts& n) {
    return fmt::format(
        "ply\nformat binary_little_endian 1.0\ncomment Stratareeb\nelement vertex {}\n"
        "property double x\nproperty double y\nproperty double z\n"
        "property double nx\nproperty double ny\nproperty double nz\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\n"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        n.vertices, n.triangles);
}

void put(BinaryOutput& out, const Point3& p) {
    out.put(p.x);
    out.put(p.y);
    out.put(p.z);
}

}  // namespace

void write_ply(const std::filesystem::path& file, std::span<const PartData> parts) {
    const auto n = counts(parts);
    if (n.vertices > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
        throw IoError(fmt::format("{}: {} vertices are more than PLY's int indices can name", file.string(),
                                  n.vertices));
    write_aside(file, [&](std::ostream& stream) {
        stream << header(n);
        BinaryOutput out(stream);
        for (const auto& part : parts) {
            for (std::size_t v = 0; v < part.soup.points.size(); ++v) {
                put(out, part.soup.points[v]);
                put(out, part.normals[v]);
                for (const auto c : part.color) out.put(c);
            }
        }
        std::int32_t offset = 0;
        for (const auto& part : parts) {
            for (const auto& triangle : part.soup.triangles) {
                out.put(std::uint8_t{3});
                for (const auto v : triangle) out.put(offset + static_cast<std::int32_t>(v));
            }
            offset += static_cast<std::int32_t>(part.soup.points.size());
        }
    });
}

}  // namespace stratareeb
