// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_mesh.h"

#include <algorithm>

#include "io/mesh_format.h"
#include "io/polygon_fan.h"
#include "io/read_3mf.h"
#include "io/read_glb.h"
#include "io/read_obj.h"
#include "io/read_off.h"
#include "io/read_ply.h"
#include "io/read_stl.h"

namespace stratareeb {
namespace {

std::vector<PartData> parts_by_format(const std::filesystem::path& file) {
    switch (mesh_format(file)) {
        case MeshFormat::Ply:
            return {read_ply(file)};
        case MeshFormat::Obj:
            return read_obj(file);
        case MeshFormat::Stl:
            return {read_stl(file)};
        case MeshFormat::Off:
            return {read_off(file)};
        case MeshFormat::Glb:
            return read_glb(file);
        case MeshFormat::ThreeMf:
            return read_3mf(file);
    }
    return {};
}

std::vector<PolygonPart> polygons_by_format(const std::filesystem::path& file) {
    switch (mesh_format(file)) {
        case MeshFormat::Ply:
            return {read_ply_polygons(file)};
        case MeshFormat::Obj:
            return read_obj_polygons(file);
        case MeshFormat::Off:
            return {read_off_polygons(file)};
        default:
            break;
    }
    std::vector<PolygonPart> triangles;
    for (auto& part : parts_by_format(file)) triangles.push_back({std::move(part), {}});
    return triangles;
}

void append(TriangleSoup& all, const TriangleSoup& part) {
    const auto offset = static_cast<std::uint32_t>(all.points.size());
    all.points.insert(all.points.end(), part.points.begin(), part.points.end());
    for (const auto& t : part.triangles)
        all.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

}  // namespace

std::vector<PartData> read_mesh_parts(const std::filesystem::path& file) {
    auto parts = parts_by_format(file);
    for (auto& part : parts)
        if (part.name.empty()) part.name = file.stem().string();
    return parts;
}

PolygonMesh read_polygons(const std::filesystem::path& file) {
    PolygonMesh mesh;
    const auto parts = polygons_by_format(file);
    const bool mixed = std::ranges::any_of(parts, [](const PolygonPart& part) { return !part.fans.empty(); });
    for (const auto& [part, fans] : parts) {
        const auto offset = static_cast<std::uint32_t>(mesh.points.size());
        mesh.points.insert(mesh.points.end(), part.soup.points.begin(), part.soup.points.end());
        for_each_polygon(part.soup, fans, [&](std::span<const std::uint32_t> corners) {
            for (const auto v : corners) mesh.corners.push_back(v + offset);
            if (mixed) mesh.sizes.push_back(static_cast<std::uint32_t>(corners.size()));
        });
    }
    return mesh;
}

TriangleSoup read_mesh(const std::filesystem::path& file) {
    auto parts = read_mesh_parts(file);
    if (parts.empty()) return {};
    TriangleSoup all = std::move(parts[0].soup);
    for (std::size_t i = 1; i < parts.size(); ++i) append(all, parts[i].soup);
    return all;
}

}  // namespace stratareeb
