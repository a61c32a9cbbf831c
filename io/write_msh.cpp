// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_msh.h"

#include <algorithm>
#include <ostream>
#include <string>

#include "io/text_output.h"
#include "io/write_aside.h"
#include "mesh/cell_faces.h"

namespace stratareeb {

namespace {

int gmsh_type(CellKind kind) {
    return kind == CellKind::Tetrahedron ? 4 : kind == CellKind::Pyramid ? 7 : 6;
}

//! Names stand between quotation marks on one line.
std::string quotable(std::string name) {
    std::ranges::replace_if(
        name, [](char c) { return c == '"' || c == '\n' || c == '\r'; }, '\'');
    return name;
}

void write_groups(TextOutput& out, const std::vector<Unit>& units) {
    out.print("$PhysicalNames\n{}\n", units.size() + 3);
    std::size_t number = units.size();
    for (const char* side : {"ground", "base", "sides"})  // in the order of BoundarySide
        out.print("2 {} \"{}\"\n", ++number, side);
    for (std::size_t i = 0; i < units.size(); ++i) out.print("3 {} \"{}\"\n", i + 1, quotable(units[i].code));
    out.print("$EndPhysicalNames\n");
}

void write_points(TextOutput& out, const VolumeMesh& mesh) {
    out.print("$Nodes\n{}\n", mesh.points.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        out.print("{} {} {} {}\n", i + 1, mesh.points[i].x, mesh.points[i].y, mesh.points[i].z);
    out.print("$EndNodes\n");
}

void write_elements(TextOutput& out, const VolumeMesh& mesh, std::size_t layers) {
    const auto outside = boundary_faces(mesh);
    out.print("$Elements\n{}\n", outside.size() + mesh.cells.size());
    std::size_t number = 0;
    for (const BoundaryFace& face : outside) {
        const std::size_t group = layers + 1 + static_cast<std::size_t>(face.side);
        out.print("{} {} 2 {} {}", ++number, face.corners == 3 ? 2 : 3, group, group);
        for (std::uint8_t i = 0; i < face.corners; ++i) out.print(" {}", face.node[i] + 1);
        out.print("\n");
    }
    for (const VolumeCell& cell : mesh.cells) {
        out.print("{} {} 2 {} {}", ++number, gmsh_type(cell.kind), cell.layer + 1, cell.layer + 1);
        for (std::size_t i = 0; i < corners_of(cell.kind); ++i) out.print(" {}", cell.node[i] + 1);
        out.print("\n");
    }
    out.print("$EndElements\n");
}

}  // namespace

void write_msh(const std::filesystem::path& file, const VolumeMesh& mesh, const CellRecord& record) {
    write_aside(file, [&](std::ostream& stream) {
        TextOutput out(stream);
        out.print("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
        const Point3& origin = record.origin;
        out.print("$Comments\nadd {} {} {} for map coordinates\n$EndComments\n", origin.x, origin.y,
                  origin.z);
        write_groups(out, record.units);
        write_points(out, mesh);
        write_elements(out, mesh, record.units.size());
    });
}

}  // namespace stratareeb
