// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_vtu.h"

#include <fmt/format.h>

#include <ostream>
#include <string>

#include "io/binary_output.h"
#include "io/text_output.h"
#include "io/write_aside.h"

namespace stratareeb {

namespace {

//! Arrays that stand after the XML part, each behind its size in bytes.
class AppendedArrays {
 public:
    //! The attributes of one more array of so many bytes.
    std::string add(std::string_view type, std::string_view name, std::size_t bytes,
                    std::size_t components = 1) {
        std::string attributes =
            fmt::format("type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"",
                        type, name, components, offset_);
        offset_ += sizeof(std::uint64_t) + bytes;
        return attributes;
    }

 private:
    std::size_t offset_ = 0;
};

std::uint8_t vtk_type(CellKind kind) {
    return kind == CellKind::Tetrahedron ? 10 : kind == CellKind::Pyramid ? 14 : 13;
}

//! The corners of a prism (0, 1, 2) are those whose normal points away from the others: the upper ones.
std::uint32_t vtk_node(const VolumeCell& cell, std::size_t i) {
    return cell.node[cell.kind == CellKind::Prism ? (i + 3) % 6 : i];
}

//! Text as VTK keeps it in XML: the codes of its bytes, each text closed by a 0.
std::string byte_codes(const std::vector<Unit>& units) {
    std::string codes;
    for (const Unit& unit : units) {
        for (const char c : unit.code) codes += fmt::format("{} ", static_cast<unsigned char>(c));
        codes += "0 ";
    }
    return codes;
}

std::size_t corner_count(const VolumeMesh& mesh) {
    std::size_t count = 0;
    for (const VolumeCell& cell : mesh.cells) count += corners_of(cell.kind);
    return count;
}

void write_head(TextOutput& out, const VolumeMesh& mesh, const CellRecord& record) {
    const std::size_t cells = mesh.cells.size();
    out.print(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
        "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n<FieldData>\n"
        "<DataArray type=\"Float64\" Name=\"origin\" NumberOfComponents=\"3\" NumberOfTuples=\"1\" "
        "format=\"ascii\">{} {} {}</DataArray>\n"
        "<Array type=\"String\" Name=\"layer_codes\" NumberOfTuples=\"{}\" format=\"ascii\">{}</Array>\n"
        "</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
        record.origin.x, record.origin.y, record.origin.z, record.units.size(), byte_codes(record.units),
        mesh.points.size(), cells);
    AppendedArrays arrays;
    const auto add = [&](const char* type, const char* name, std::size_t bytes, std::size_t components = 1) {
        out.print("<DataArray {}/>\n", arrays.add(type, name, bytes, components));
    };
    out.print("<Points>\n");
    add("Float64", "Points", 24 * mesh.points.size(), 3);
    out.print("</Points>\n<Cells>\n");
    add("Int64", "connectivity", 8 * corner_count(mesh));
    add("Int64", "offsets", 8 * cells);
    add("UInt8", "types", cells);
    out.print("</Cells>\n<CellData Scalars=\"MaterialIDs\">\n");
    for (const char* name : {"MaterialIDs", "layer", "part"}) add("Int32", name, 4 * cells);
    for (const char* name : {"volume", "least_dihedral_deg", "aspect"}) add("Float64", name, 8 * cells);
    out.print("</CellData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");
}

void write_geometry(BinaryOutput& out, const VolumeMesh& mesh) {
    const auto begin = [&](std::size_t bytes) { out.put<std::uint64_t>(bytes); };
    begin(24 * mesh.points.size());
    for (const Point3& p : mesh.points)
        for (const double value : {p.x, p.y, p.z}) out.put(value);
    begin(8 * corner_count(mesh));
    for (const VolumeCell& cell : mesh.cells)
        for (std::size_t i = 0; i < corners_of(cell.kind); ++i) out.put<std::int64_t>(vtk_node(cell, i));
    begin(8 * mesh.cells.size());
    std::int64_t end = 0;
    for (const VolumeCell& cell : mesh.cells)
        out.put(end += static_cast<std::int64_t>(corners_of(cell.kind)));
    begin(mesh.cells.size());
    for (const VolumeCell& cell : mesh.cells) out.put(vtk_type(cell.kind));
}

void write_data(BinaryOutput& out, const VolumeMesh& mesh, const std::vector<CellQuality>& qualities) {
    const auto integers = [&](auto value_of) {
        out.put<std::uint64_t>(4 * mesh.cells.size());
        for (const VolumeCell& cell : mesh.cells) out.put(static_cast<std::int32_t>(value_of(cell)));
    };
    integers([](const VolumeCell& cell) { return cell.layer; });
    integers([](const VolumeCell& cell) { return cell.layer + 1; });
    integers([](const VolumeCell& cell) { return cell.part; });
    for (const auto value : {&CellQuality::volume, &CellQuality::least_dihedral_deg, &CellQuality::aspect}) {
        out.put<std::uint64_t>(8 * qualities.size());
        for (const CellQuality& quality : qualities) out.put(quality.*value);
    }
}

}  // namespace

void write_vtu(const std::filesystem::path& file, const VolumeMesh& mesh,
               const std::vector<CellQuality>& qualities, const CellRecord& record) {
    write_aside(file, [&](std::ostream& stream) {
        {
            TextOutput head(stream);
            write_head(head, mesh, record);
        }
        {
            BinaryOutput data(stream);
            write_geometry(data, mesh);
            write_data(data, mesh, qualities);
        }
        stream << "\n</AppendedData>\n</VTKFile>\n";
    });
}

}  // namespace stratareeb
