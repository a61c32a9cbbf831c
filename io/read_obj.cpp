// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "boreholes/errors.h"
#include "io/polygon_fan.h"
#include "io/text_scanner.h"

namespace stratareeb {
namespace {

using Colors = std::map<std::string, Rgb, std::less<>>;

// Faces under one object name, with vertex numbers of the whole file.
struct Group {
    std::string name, material;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    Fans fans;
};

struct Content {
    std::vector<Point3> points;
    std::vector<Group> groups;
    std::vector<std::string> material_files;
};

// "7", "7/1", "7//3", "7/1/3" or relative to the end, "-1": the vertex number, from 0.
std::uint32_t corner(const TextScanner& scan, std::string_view word, std::size_t vertices) {
    const auto n = scan.integer(word.substr(0, word.find('/')));
    const auto limit = static_cast<long long>(vertices);
    if (n == 0 || n > limit || n < -limit)
        scan.fail(fmt::format("vertex index {} is out of range; there are {} vertices so far", n, vertices));
    return static_cast<std::uint32_t>(n > 0 ? n - 1 : limit + n);
}

// Lines that end in a backslash go on in the next one.
std::string_view next_word(TextScanner& scan) {
    auto word = scan.word();
    while (word == "\\") {
        scan.next_line();
        word = scan.word();
    }
    return word;
}

void read_face(TextScanner& scan, Content& content) {
    std::vector<std::uint32_t> corners;
    for (auto word = next_word(scan); !word.empty() && word[0] != '#'; word = next_word(scan))
        corners.push_back(corner(scan, word, content.points.size()));
    if (corners.size() < 3) scan.fail(fmt::format("a face with {} corners", corners.size()));
    append_fan(corners, content.groups.back().triangles, content.groups.back().fans);
}

// A name opens a group; a group that has no faces yet takes the name over, so that "o" and "g" lines in a row
// are one.
void open_group(Content& content, std::string name) {
    if (!content.groups.back().triangles.empty())
        content.groups.push_back({"", content.groups.back().material, {}, {}});
    content.groups.back().name = std::move(name);
}

Content read_content(TextScanner& scan) {
    Content content;
    content.groups.emplace_back();
    while (!scan.at_end()) {
        const auto word = scan.word();
        if (word == "v") {
            Point3 p;
            p.x = scan.number(next_word(scan));
            p.y = scan.number(next_word(scan));
            p.z = scan.number(next_word(scan));
            content.points.push_back(p);
        } else if (word == "f") {
            read_face(scan, content);
        } else if (word == "o") {
            open_group(content, std::string(scan.rest_of_line()));
            continue;
        } else if (word == "usemtl") {
            content.groups.back().material = scan.rest_of_line();
            continue;
        } else if (word == "mtllib") {
            content.material_files.emplace_back(scan.rest_of_line());
            continue;
        } else if (!word.empty() && word[0] != '#' && !(word[0] >= 'a' && word[0] <= 'z')) {
            scan.fail("not a line of an OBJ file");
        }
        scan.next_line();
    }
    return content;
}

// Diffuse colours of an MTL file. It only adds colour: one that is missing or damaged is passed over.
void read_colors(const std::filesystem::path& file, Colors& colors) {
    try {
        const auto content = file_content(file);
        TextScanner scan(file.string(), content);
        std::string material;
        while (!scan.at_end()) {
            const auto word = scan.word();
            if (word == "newmtl") {
                material = scan.rest_of_line();
                continue;
            }
            if (word == "Kd")
                for (auto& c : colors[material])
                    c = static_cast<std::uint8_t>(
                        std::lround(255 * std::clamp(scan.number(scan.word()), 0.0, 1.0)));
            scan.next_line();
        }
    } catch (const std::runtime_error&) {
        return;
    }
}

// The triangles of a group with just the vertices that they use, in file order.
TriangleSoup soup_of(const Group& group, const std::vector<Point3>& points) {
    std::vector<std::uint32_t> used;
    for (const auto& t : group.triangles) used.insert(used.end(), t.begin(), t.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    TriangleSoup soup;
    for (const auto v : used) soup.points.push_back(points[v]);
    const auto number = [&](std::uint32_t v) {
        return static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
    };
    for (const auto& t : group.triangles)
        soup.triangles.push_back({number(t[0]), number(t[1]), number(t[2])});
    return soup;
}

}  // namespace

std::vector<PolygonPart> read_obj_polygons(const std::filesystem::path& file) {
    const auto text = file_content(file);
    TextScanner scan(file.string(), text);
    auto content = read_content(scan);
    if (content.points.empty()) scan.fail("there are no vertices; is this an OBJ file?");
    std::erase_if(content.groups, [](const Group& g) { return g.triangles.empty(); });
    Colors colors;
    for (const auto& name : content.material_files) read_colors(file.parent_path() / name, colors);
    std::vector<PolygonPart> parts;
    const auto color_of = [&](const std::string& material) {
        const auto found = colors.find(material);
        return found == colors.end() ? PartData{}.color : found->second;
    };
    if (content.groups.size() <= 1) {  // all vertices belong to the one mesh, unused ones too
        Group group = content.groups.empty() ? Group{} : std::move(content.groups[0]);
        parts.push_back({{group.name,
                          color_of(group.material),
                          {std::move(content.points), std::move(group.triangles)},
                          {}},
                         std::move(group.fans)});
        return parts;
    }
    for (const auto& group : content.groups)
        parts.push_back(
            {{group.name, color_of(group.material), soup_of(group, content.points), {}}, group.fans});
    return parts;
}

std::vector<PartData> read_obj(const std::filesystem::path& file) {
    std::vector<PartData> parts;
    for (auto& polygons : read_obj_polygons(file)) parts.push_back(std::move(polygons.part));
    return parts;
}

}  // namespace stratareeb
