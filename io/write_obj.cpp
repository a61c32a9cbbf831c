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

void print_part(TextOutput& out, const PartData& part, std::size_t offset) {
    for (const auto& p : part.soup.points) out.print("v {} {} {}\n", p.x, p.y, p.z);
    for (const auto& n : part.normals) out.print("vn {:.6g} {:.6g} {:.6g}\n", n.x, n.y, n.z);
    for (const auto& t : part.soup.triangles) {
        const auto a = t[0] + offset, b = t[1] + offset, c = t[2] + offset;
        out.print("f {}//{} {}//{} {}//{}\n", a, a, b, b, c, c);
    }
}

}  // namespace

void write_obj(const std::filesystem::path& file, std::span<const PartData> parts) {
    auto materials = file;
    materials.replace_extension(".mtl");
    write_materials(materials, parts);
    write_aside(file, [&](std::ostream& stream) {
        TextOutput out(stream);
        out.print("# Stratareeb\nmtllib {}\n", materials.filename().string());
        std::size_t offset = 1;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            out.print("o {0}\ng {0}\nusemtl {1}\n", word(parts[i].name), material(i, parts[i]));
            print_part(out, parts[i], offset);
            offset += parts[i].soup.points.size();
        }
    });
}

}  // namespace stratareeb
