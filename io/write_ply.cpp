// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_ply.h"

#include <fmt/format.h>

#include <array>
#include <limits>

#include "boreholes/errors.h"
#include "io/binary_output.h"
#include "io/write_aside.h"

namespace stratareeb {
namespace {

struct Counts {
    std::size_t vertices = 0, faces = 0;
};

// A polygon's corners are counted in one byte.
bool fits(std::span<const std::uint32_t> corners) {
    return corners.size() <= std::numeric_limits<std::uint8_t>::max();
}

std::size_t face_count(const PartData& part, const Fans& fans) {
    std::size_t count = 0;
    for_each_polygon(part.soup, fans, [&](std::span<const std::uint32_t> corners) {
        count += fits(corners) ? 1 : corners.size() - 2;
    });
    return count;
}

Counts counts(std::span<const PartData> parts, const Fans& fans) {
    Counts sum;
    for (const auto& part : parts) {
        sum.vertices += part.soup.points.size();
        sum.faces += face_count(part, fans);
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
        n.vertices, n.faces);
}

void put(BinaryOutput& out, const Point3& p) {
    out.put(p.x);
    out.put(p.y);
    out.put(p.z);
}

// `fans` are those of a part that is alone; parts of several are triangles.
void write_parts(const std::filesystem::path& file, std::span<const PartData> parts, const Fans& fans) {
    const auto n = counts(parts, fans);
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
            const auto put_face = [&](std::span<const std::uint32_t> corners) {
                out.put(static_cast<std::uint8_t>(corners.size()));
                for (const auto v : corners) out.put(offset + static_cast<std::int32_t>(v));
            };
            for_each_polygon(part.soup, fans, [&](std::span<const std::uint32_t> corners) {
                if (fits(corners)) return put_face(corners);
                for (std::size_t i = 2; i < corners.size(); ++i)
                    put_face(std::array{corners[0], corners[i - 1], corners[i]});
            });
            offset += static_cast<std::int32_t>(part.soup.points.size());
        }
    });
}

}  // namespace

void write_ply(const std::filesystem::path& file, std::span<const PartData> parts) {
    write_parts(file, parts, {});
}

void write_ply_polygons(const std::filesystem::path& file, const PolygonPart& polygons) {
    write_parts(file, {&polygons.part, 1}, polygons.fans);
}

}  // namespace stratareeb
