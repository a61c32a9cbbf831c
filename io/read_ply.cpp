// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "boreholes/errors.h"
#include "io/ply_file.h"
#include "io/polygon_fan.h"

namespace stratareeb {
namespace {

// Which of x y z red green blue a property is; 6 for others.
int slot(const PlyProperty& p) {
    constexpr std::string_view names[] = {"x", "y", "z", "red", "green", "blue"};
    if (p.count_type) return 6;
    return static_cast<int>(std::find(std::begin(names), std::end(names), p.name) - std::begin(names));
}

void read_vertices(PlyFile& ply, const PlyElement& element, PartData& part) {
    PlyBody& body = ply.body();
    std::vector<int> slots;
    for (const auto& p : element.properties) slots.push_back(slot(p));
    for (int k = 0; k < 3; ++k)
        if (std::count(slots.begin(), slots.end(), k) != 1) body.fail("vertices need x, y and z once each");
    const bool colored =
        std::count_if(slots.begin(), slots.end(), [](int s) { return s >= 3 && s < 6; }) == 3;
    bool one_color = colored;
    std::array<double, 7> values{};
    Rgb color{};
    part.soup.points.reserve(ply.plausible_count(element));
    for (std::uint64_t v = 0; v < element.count; ++v) {
        for (std::size_t i = 0; i < slots.size(); ++i) {
            if (element.properties[i].count_type)
                body.skip(element.properties[i]);
            else
                values[slots[i]] = body.number(element.properties[i].type);
        }
        if (!std::isfinite(values[0]) || !std::isfinite(values[1]) || !std::isfinite(values[2]))
            body.fail(fmt::format("vertex {} has a coordinate that is not a finite number", v));
        part.soup.points.push_back({values[0], values[1], values[2]});
        if (!one_color) continue;
        Rgb here{};
        for (int k = 0; k < 3; ++k)
            here[k] = static_cast<std::uint8_t>(std::clamp(values[3 + k], 0.0, 255.0));
        if (v == 0) color = here;
        one_color = here == color;
    }
    if (one_color && element.count > 0) part.color = color;
}

void read_faces(PlyFile& ply, const PlyElement& element, PolygonPart& polygons) {
    TriangleSoup& soup = polygons.part.soup;
    PlyBody& body = ply.body();
    const auto is_corners = [](const PlyProperty& p) {
        return p.count_type && (p.name == "vertex_indices" || p.name == "vertex_index");
    };
    soup.triangles.reserve(ply.plausible_count(element));
    std::vector<std::uint32_t> corners;
    for (std::uint64_t f = 0; f < element.count; ++f) {
        for (const auto& p : element.properties) {
            if (!is_corners(p)) {
                body.skip(p);
                continue;
            }
            corners.resize(body.list_length(*p.count_type));
            for (auto& corner : corners) corner = body.index(p.type, soup.points.size());
            if (corners.size() < 3) body.fail(fmt::format("face {} has {} corners", f, corners.size()));
            append_fan(corners, soup.triangles, polygons.fans);
        }
    }
}

//! The place of a vertex property that is one number.
std::size_t scalar_property(const std::filesystem::path& file, const PlyElement& element,
                            const std::string& name) {
    std::string known;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        if (element.properties[i].count_type) continue;
        if (element.properties[i].name == name) return i;
        known += (known.empty() ? "" : ", ") + element.properties[i].name;
    }
    throw InvalidInput(fmt::format("{}: its vertices have no property {}; there are {}", file.string(), name,
                                   known.empty() ? "none" : known));
}

}  // namespace

PolygonPart read_ply_polygons(const std::filesystem::path& file) {
    PlyFile ply(file);
    PlyBody& body = ply.body();
    PolygonPart polygons;
    PartData& part = polygons.part;
    bool vertices_known = false;
    for (const auto& element : ply.elements()) {
        if (element.properties.empty()) continue;  // no bytes, however many are announced
        if (element.name == "vertex") {
            if (vertices_known) body.fail("a second list of vertices");
            if (element.count >= std::numeric_limits<std::uint32_t>::max()) body.fail("too many vertices");
            read_vertices(ply, element, part);
            vertices_known = true;
        } else if (element.name == "face") {
            if (!vertices_known) body.fail("faces come before the vertices");
            read_faces(ply, element, polygons);
        } else {
            body.skip(element);
        }
    }
    if (!vertices_known) body.fail("there are no vertices");
    return polygons;
}

PartData read_ply(const std::filesystem::path& file) {
    return read_ply_polygons(file).part;
}

std::vector<double> read_ply_property(const std::filesystem::path& file, const std::string& property) {
    PlyFile ply(file);
    PlyBody& body = ply.body();
    const auto& elements = ply.elements();
    const auto vertices = std::ranges::find(elements, "vertex", &PlyElement::name);
    if (vertices == elements.end()) body.fail("there are no vertices");
    const std::size_t wanted = scalar_property(file, *vertices, property);
    for (auto before = elements.begin(); before != vertices; ++before) body.skip(*before);
    std::vector<double> values;
    values.reserve(ply.plausible_count(*vertices));
    for (std::uint64_t v = 0; v < vertices->count; ++v)
        for (std::size_t i = 0; i < vertices->properties.size(); ++i)
            if (i == wanted)
                values.push_back(body.number(vertices->properties[i].type));
            else
                body.skip(vertices->properties[i]);
    return values;
}

}  // namespace stratareeb
