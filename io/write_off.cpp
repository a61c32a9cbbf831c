// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_off.h"

#include "io/text_output.h"
#include "io/write_aside.h"

namespace stratareeb {
namespace {

// `fans` are those of a part that is alone; parts of several are triangles.
void write_parts(const std::filesystem::path& file, std::span<const PartData> parts, const Fans& fans) {
    write_aside(file, [&](std::ostream& stream) {
        TextOutput out(stream);
        std::size_t vertices = 0, faces = 0;
        for (const auto& part : parts) {
            vertices += part.soup.points.size();
            faces += fans.empty() ? part.soup.triangles.size() : fans.size();
        }
        out.print("OFF\n# Stratareeb\n{} {} 0\n", vertices, faces);
        for (const auto& part : parts)
            for (const auto& p : part.soup.points) out.print("{} {} {}\n", p.x, p.y, p.z);
        std::size_t offset = 0;
        for (const auto& part : parts) {
            for_each_polygon(part.soup, fans, [&](std::span<const std::uint32_t> corners) {
                out.print("{}", corners.size());
                for (const auto v : corners) out.print(" {}", v + offset);
                out.print(" {} {} {}\n", part.color[0], part.color[1], part.color[2]);
            });
            offset += part.soup.points.size();
        }
    });
}

}  // namespace

void write_off(const std::filesystem::path& file, std::span<const PartData> parts) {
    write_parts(file, parts, {});
}

void write_off_polygons(const std::filesystem::path& file, const PolygonPart& polygons) {
    write_parts(file, {&polygons.part, 1}, polygons.fans);
}

}  // namespace stratareeb
