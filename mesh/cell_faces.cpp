// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cell_faces.h"

#include <fmt/format.h>

#include <algorithm>

#include "boreholes/errors.h"

namespace stratareeb {

namespace {

constexpr std::array<CellFace, 4> kTetrahedron{
    {{3, {0, 2, 1, 0}}, {3, {0, 1, 3, 0}}, {3, {1, 2, 3, 0}}, {3, {2, 0, 3, 0}}}};
constexpr std::array<CellFace, 5> kPyramid{
    {{4, {0, 3, 2, 1}}, {3, {0, 1, 4, 0}}, {3, {1, 2, 4, 0}}, {3, {2, 3, 4, 0}}, {3, {3, 0, 4, 0}}}};
constexpr std::array<CellFace, 5> kPrism{
    {{3, {0, 2, 1, 0}}, {3, {3, 4, 5, 0}}, {4, {0, 1, 4, 3}}, {4, {1, 2, 5, 4}}, {4, {2, 0, 3, 5}}}};

constexpr std::uint32_t kNoNode = ~0u;

//! A face as a set of nodes; the same for both cells that share it.
struct SharedFace {
    std::array<std::uint32_t, 4> nodes{};
    std::uint32_t cell = 0;
    std::uint8_t face = 0;
    bool even = true;  // the nodes' order, turned to start with the least, runs one way or the other

    friend auto operator<=>(const SharedFace&, const SharedFace&) = default;
};

SharedFace shared_face(const VolumeMesh& mesh, std::uint32_t cell, std::uint8_t number) {
    const CellFace& face = faces_of(mesh.cells[cell].kind)[number];
    std::array<std::uint32_t, 4> nodes{kNoNode, kNoNode, kNoNode, kNoNode};
    for (std::uint8_t i = 0; i < face.corners; ++i) nodes[i] = mesh.cells[cell].node[face.corner[i]];
    std::rotate(nodes.begin(), std::min_element(nodes.begin(), nodes.begin() + face.corners),
                nodes.begin() + face.corners);
    SharedFace shared{.nodes = nodes, .cell = cell, .face = number, .even = true};
    shared.even = nodes[1] < nodes[face.corners - 1u];
    std::ranges::sort(shared.nodes);
    return shared;
}

//! Outer faces lie over three plan vertices and look up or down, or stand over two.
BoundarySide side_of(const VolumeMesh& mesh, const BoundaryFace& face) {
    std::array<std::uint32_t, 4> column{};
    for (std::uint8_t i = 0; i < face.corners; ++i) column[i] = mesh.column[face.node[i]];
    if (face.corners == 4 || column[0] == column[1] || column[1] == column[2] || column[2] == column[0])
        return BoundarySide::Side;
    const Point3 &a = mesh.points[face.node[0]], &b = mesh.points[face.node[1]],
                 &c = mesh.points[face.node[2]];
    const bool up = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
    return up ? BoundarySide::Ground : BoundarySide::Base;
}

BoundaryFace boundary_face(const VolumeMesh& mesh, const SharedFace& shared) {
    const VolumeCell& cell = mesh.cells[shared.cell];
    const CellFace& face = faces_of(cell.kind)[shared.face];
    BoundaryFace result{.side = BoundarySide::Side, .corners = face.corners, .node = {}, .cell = shared.cell};
    for (std::uint8_t i = 0; i < face.corners; ++i) result.node[i] = cell.node[face.corner[i]];
    result.side = side_of(mesh, result);
    return result;
}

void check_pair(const VolumeMesh& mesh, std::span<const SharedFace> faces) {
    if (faces.size() == 2 && faces[0].even != faces[1].even) return;
    const Point3& p = mesh.points[faces[0].nodes[0]];
    throw GeometryError(
        fmt::format("a face at x {}, y {}, z {} belongs to {} cells that do not face each other", p.x, p.y,
                    p.z, faces.size()));
}

template <class Wanted>
std::vector<BoundaryFace> single_faces(const VolumeMesh& mesh, Wanted wanted) {
    std::vector<SharedFace> faces;
    for (std::uint32_t cell = 0; cell < mesh.cells.size(); ++cell)
        if (wanted(mesh.cells[cell]))
            for (std::uint8_t f = 0; f < faces_of(mesh.cells[cell].kind).size(); ++f)
                faces.push_back(shared_face(mesh, cell, f));
    std::ranges::sort(faces);
    std::vector<SharedFace> single;
    for (std::size_t i = 0, end = 0; i < faces.size(); i = end) {
        while (end < faces.size() && faces[end].nodes == faces[i].nodes) ++end;
        if (end - i == 1)
            single.push_back(faces[i]);
        else
            check_pair(mesh, std::span(faces).subspan(i, end - i));
    }
    std::ranges::sort(single, {}, [](const SharedFace& f) { return std::pair(f.cell, f.face); });
    std::vector<BoundaryFace> result;
    result.reserve(single.size());
    for (const SharedFace& face : single) result.push_back(boundary_face(mesh, face));
    return result;
}

}  // namespace

std::span<const CellFace> faces_of(CellKind kind) {
    switch (kind) {
        case CellKind::Tetrahedron:
            return kTetrahedron;
        case CellKind::Pyramid:
            return kPyramid;
        case CellKind::Prism:
            return kPrism;
    }
    return {};
}

std::vector<BoundaryFace> boundary_faces(const VolumeMesh& mesh) {
    return single_faces(mesh, [](const VolumeCell&) { return true; });
}

std::vector<BoundaryFace> boundary_faces(const VolumeMesh& mesh, std::size_t layer) {
    return single_faces(mesh, [layer](const VolumeCell& cell) { return cell.layer == layer; });
}

}  // namespace stratareeb
