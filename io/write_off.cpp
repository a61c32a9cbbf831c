// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_off.h"

#include "io/text_output.h"
#include "io/write_aside.h"

namespace stratareeb {

void write_off(const std::filesystem::path& file, std::span<const PartData> parts) {
    write_aside(file, [&](std::ostream& stream) {
        TextOutput out(stream);
        std::size_t vertices = 0, triangles = 0;
        for (const auto& part : parts) {
            vertices += part.soup.points.size();
            triangles += part.soup.triangles.size();
        }
        out.print("OFF\n# Stratareeb\n{} {} 0\n", vertices, triangles);
        for (const auto& part : parts)
            for (const auto& p : part.soup.points) out.print("{} {} {}\n", p.x, p.y, p.z);
        std::size_t offset = 0;
        for (const auto& part : parts) {
            for (const auto& t : part.soup.triangles)
                out.print("3 {} {} {} {} {} {}\n", t[0] + offset, t[1] + offset, t[2] + offset, part.color[0],
                          part.color[1], part.color[2]);
            offset += part.soup.points.size();
        }
    });
}

}  // namespace stratareeb
