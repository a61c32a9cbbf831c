// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_arc_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "boreholes/errors.h"
#include "io/arc_colors.h"
#include "io/binary_output.h"
#include "io/mesh_format.h"
#include "io/write_aside.h"
#include "io/write_mesh.h"
#include "mesh/triangle_soup.h"

namespace stratareeb {

namespace {

constexpr Rgb kNoArc{160, 160, 160};

std::string header(const TriMesh& mesh) {
    return fmt::format(
        "ply\nformat binary_little_endian 1.0\ncomment Stratareeb: arcs of the Reeb graph\nelement vertex "
        "{}\n"
        "property double x\nproperty double y\nproperty double z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\n"
        "element face {}\nproperty list uchar int vertex_indices\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int arc\nend_header\n",
        mesh.n_vertices(), mesh.n_faces());
}

//! Colours by arc; `kNone` has its own.
class Colors {
 public:
    explicit Colors(const ReebGraph& graph) : colors_(arc_colors(graph)) {}
    void put(BinaryOutput& out, std::uint32_t arc) const {
        for (const std::uint8_t c : arc == ReebGraph::kNone ? kNoArc : colors_[arc]) out.put(c);
    }

 private:
    std::vector<Rgb> colors_;
};

void write_ply(std::ostream& stream, const TriMesh& mesh, const ReebGraph& graph) {
    stream << header(mesh);
    BinaryOutput out(stream);
    const Colors colors(graph);
    for (const auto v : mesh.vertices()) {
        for (int k = 0; k < 3; ++k) out.put(mesh.point(v)[k]);
        colors.put(out, graph.vertex_arc[static_cast<std::size_t>(v.idx())]);
    }
    const TriangleSoup soup = triangle_soup(mesh);
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
        out.put(std::uint8_t{3});
        for (const auto v : soup.triangles[f]) out.put(static_cast<std::int32_t>(v));
        const std::uint32_t arc = graph.triangle_arc[f];
        colors.put(out, arc);
        out.put(static_cast<std::int32_t>(arc));  // kNone is -1
    }
}

PartData part_of(const TriMesh& mesh, const LoopHandle& handle, std::size_t number) {
    PartData part{
        .name = fmt::format("loop_{}", number), .color = palette_color(number), .soup = {}, .normals = {}};
    std::vector<std::pair<int, std::uint32_t>>
        named;  // vertices of the mesh, ascending, and their new numbers
    for (const std::uint32_t t : handle.triangles)
        for (const auto v : mesh.fv_range(TriMesh::FaceHandle(static_cast<int>(t))))
            named.emplace_back(v.idx(), 0);
    std::ranges::sort(named);
    const auto repeated = std::ranges::unique(named);
    named.erase(repeated.begin(), repeated.end());
    for (auto& [vertex, number_here] : named) {
        number_here = static_cast<std::uint32_t>(part.soup.points.size());
        const auto& p = mesh.point(TriMesh::VertexHandle(vertex));
        part.soup.points.push_back({p[0], p[1], p[2]});
    }
    for (const std::uint32_t t : handle.triangles) {
        auto& corners = part.soup.triangles.emplace_back();
        int k = 0;
        for (const auto v : mesh.fv_range(TriMesh::FaceHandle(static_cast<int>(t))))
            corners[k++] = std::ranges::lower_bound(named, std::pair<int, std::uint32_t>(v.idx(), 0))->second;
    }
    return part;
}

}  // namespace

void write_arc_colors(const std::filesystem::path& file, const TriMesh& mesh, const ReebGraph& graph) {
    if (mesh_format(file) != MeshFormat::Ply)
        throw IoError(file.string() + ": a mesh coloured by arc is written as .ply");
    write_aside(file, [&](std::ostream& stream) { write_ply(stream, mesh, graph); });
}

void write_loop_handles(const std::filesystem::path& file, const TriMesh& mesh,
                        std::span<const LoopHandle> handles) {
    std::vector<PartData> parts;
    for (std::size_t i = 0; i < handles.size(); ++i)
        if (!handles[i].triangles.empty()) parts.push_back(part_of(mesh, handles[i], i));
    write_mesh_parts(file, std::move(parts));
}

}  // namespace stratareeb
