// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_obj.h"

#include <algorithm>
#include <string>

#include "io/text_output.h"
#include "io/write_aside.h"

namespace stratareeb {
namespace {

// OBJ ends names at blanks, and lines at line ends.
std::string word(const std::string& name) {
    if (name.empty()) return "part";
    std::string result = name;
    std::replace_if(
        result.begin(), result.end(), [](unsigned char c) { return c <= ' '; }, '_');
    return result;
}

std::string material(std::size_t i, const PartData& part) {
    return fmt::format("{:02}_{}", i + 1, word(part.name));
}

void write_materials(const std::filesystem::path& file, std::span<const PartData> parts) {
    write_aside(file, [&](std::ostream& stream) {
        TextOutput out(stream);
        out.print("# Stratareeb\n");
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const auto& c = parts[i].color;
            out.print("newmtl {}\nKd {:.6g} {:.6g} {:.6g}\nillum 1\n", material(i, parts[i]), c[0] / 255.0,
                      c[1] / 255.0, c[2] / 255.0);
        }
    });
}

void print_part(TextOutput& out, const PartData& part, const Fans& fans, std::size_t offset) {
    for (const auto& p : part.soup.points) out.print("v {} {} {}\n", p.x, p.y, p.z);
    for (const auto& n : part.normals) out.print("vn {:.6g} {:.6g} {:.6g}\n", n.x, n.y, n.z);
    for_each_polygon(part.soup, fans, [&](std::span<const std::uint32_t> corners) {
        out.print("f");
        for (const auto v : corners) out.print(" {0}//{0}", v + offset);
        out.print("\n");
    });
}

// `fans` are those of a part that is alone; parts of several are triangles.
void write_parts(const std::filesystem::path& file, std::span<const PartData> parts, const Fans& fans) {
    auto materials = file;
    materials.replace_extension(".mtl");
    write_materials(materials, parts);
    write_aside(file, [&](std::ostream& stream) {
        TextOutput out(stream);
        out.print("# Stratareeb\nmtllib {}\n", materials.filename().string());
        std::size_t offset = 1;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            out.print("o {0}\ng {0}\nusemtl {1}\n", word(parts[i].name), material(i, parts[i]));
            print_part(out, parts[i], fans, offset);
            offset += parts[i].soup.points.size();
        }
    });
}

}  // namespace

void write_obj(const std::filesystem::path& file, std::span<const PartData> parts) {
    write_parts(file, parts, {});
}

void write_obj_polygons(const std::filesystem::path& file, const PolygonPart& polygons) {
    write_parts(file, {&polygons.part, 1}, polygons.fans);
}

}  // namespace stratareeb
