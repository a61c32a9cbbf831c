// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_mesh.h"

#include <cmath>

#include "io/write_3mf.h"
#include "io/write_glb.h"
#include "io/write_obj.h"
#include "io/write_off.h"
#include "io/write_ply.h"
#include "io/write_stl.h"
#include "mesh/normals.h"

namespace stratareeb {
namespace {

// The normals that the mesh carries; none if any has not length one. OpenMesh leaves normals that were never
// set to chance.
std::vector<Point3> normals_of(const TriMesh& mesh) {
    std::vector<Point3> normals;
    for (const auto v : mesh.vertices()) {
        const auto& n = mesh.normal(v);
        if (!(std::abs(n.sqrnorm() - 1) < 1e-6)) return {};
        normals.push_back({n[0], n[1], n[2]});
    }
    return normals;
}

PartData part_data(const MeshPart& part) {
    return {part.name, rgb_from_text(part.color), triangle_soup(*part.mesh), normals_of(*part.mesh)};
}

}  // namespace

void write_mesh_parts(const std::filesystem::path& file, std::vector<PartData> parts) {
    for (auto& part : parts)
        if (part.normals.size() != part.soup.points.size()) part.normals = vertex_normals(part.soup);
    switch (mesh_format(file)) {
        case MeshFormat::Ply:
            return write_ply(file, parts);
        case MeshFormat::Obj:
            return write_obj(file, parts);
        case MeshFormat::Stl:
            return write_stl(file, parts);
        case MeshFormat::Off:
            return write_off(file, parts);
        case MeshFormat::Glb:
            return write_glb(file, parts);
        case MeshFormat::ThreeMf:
            return write_3mf(file, parts);
    }
}

void write_meshes(const std::filesystem::path& file, std::span<const MeshPart> parts) {
    std::vector<PartData> data;
    for (const auto& part : parts) data.push_back(part_data(part));
    write_mesh_parts(file, std::move(data));
}

void write_mesh(const std::filesystem::path& file, const MeshPart& part) {
    write_meshes(file, {&part, 1});
}

void write_polygons(const std::filesystem::path& file, const std::string& name, const PolygonMesh& mesh,
                    std::vector<Point3> normals) {
    PolygonPart polygons{{.name = name, .soup = triangle_fans(mesh), .normals = std::move(normals)}, {}};
    for (const auto size : mesh.sizes) polygons.fans.push_back(size - 2);
    auto& [part, fans] = polygons;
    if (part.normals.size() != part.soup.points.size()) part.normals = vertex_normals(part.soup);
    switch (mesh_format(file)) {
        case MeshFormat::Ply:
            return write_ply_polygons(file, polygons);
        case MeshFormat::Obj:
            return write_obj_polygons(file, polygons);
        case MeshFormat::Off:
            return write_off_polygons(file, polygons);
        default:
            return write_mesh_parts(file, {std::move(part)});
    }
}

}  // namespace stratareeb
