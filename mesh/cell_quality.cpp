// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cell_quality.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/cell_faces.h"
#include "mesh/compensated_sum.h"

namespace stratareeb {

namespace {

using Vector = OpenMesh::Vec3d;

Vector between(const Point3& from, const Point3& to) {
    return {to.x - from.x, to.y - from.y, to.z - from.z};
}

//! Twice the area along the outward normal.
Vector doubled_normal(const VolumeMesh& mesh, const VolumeCell& cell, const CellFace& face) {
    const auto corner = [&](std::uint8_t i) -> const Point3& {
        return mesh.points[cell.node[face.corner[i]]];
    };
    if (face.corners == 3) return cross(between(corner(0), corner(1)), between(corner(0), corner(2)));
    return cross(between(corner(0), corner(2)), between(corner(1), corner(3)));
}

bool has_corner(const CellFace& face, std::uint8_t corner) {
    return std::find(face.corner.begin(), face.corner.begin() + face.corners, corner) !=
           face.corner.begin() + face.corners;
}

double longest_edge(const VolumeMesh& mesh, const VolumeCell& cell) {
    double longest = 0;
    for (const CellFace& face : faces_of(cell.kind))
        for (std::uint8_t i = 0; i < face.corners; ++i) {
            const Point3 &a = mesh.points[cell.node[face.corner[i]]],
                         &b = mesh.points[cell.node[face.corner[(i + 1u) % face.corners]]];
            longest = std::max(longest, between(a, b).norm());
        }
    return longest;
}

double volume_of(const VolumeMesh& mesh, const VolumeCell& cell) {
    double six = 0;
    for (const auto& t : tetrahedra_of(cell)) {
        const Point3& a = mesh.points[t[0]];
        six += dot(cross(between(a, mesh.points[t[1]]), between(a, mesh.points[t[2]])),
                   between(a, mesh.points[t[3]]));
    }
    return six / 6;
}

bool share_edge(const CellFace& a, const CellFace& b) {
    int shared = 0;
    for (std::uint8_t i = 0; i < a.corners; ++i) shared += has_corner(b, a.corner[i]);
    return shared == 2;
}

}  // namespace

CellQuality cell_quality(const VolumeMesh& mesh, const VolumeCell& cell) {
    const auto faces = faces_of(cell.kind);
    std::array<Vector, 5> normal;
    double surface = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        normal[i] = doubled_normal(mesh, cell, faces[i]);
        surface += normal[i].norm() / 2;
    }
    CellQuality quality{
        .volume = volume_of(mesh, cell), .least_dihedral_deg = 180, .largest_dihedral_deg = 0, .aspect = 0};
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t j = i + 1; j < faces.size(); ++j) {
            if (!share_edge(faces[i], faces[j])) continue;
            // atan2 keeps small angles that acos loses
            const double angle =
                std::numbers::pi - std::atan2(cross(normal[i], normal[j]).norm(), dot(normal[i], normal[j]));
            quality.least_dihedral_deg = std::min(quality.least_dihedral_deg, angle * 180 / std::numbers::pi);
            quality.largest_dihedral_deg =
                std::max(quality.largest_dihedral_deg, angle * 180 / std::numbers::pi);
        }
    const double radius = 3 * quality.volume / surface;
    quality.aspect = longest_edge(mesh, cell) / (2 * std::numbers::sqrt2 * std::numbers::sqrt3 * radius);
    return quality;
}

std::vector<CellQuality> cell_qualities(const VolumeMesh& mesh) {
    std::vector<CellQuality> qualities;
    qualities.reserve(mesh.cells.size());
    for (const VolumeCell& cell : mesh.cells) qualities.push_back(cell_quality(mesh, cell));
    return qualities;
}

Spread spread_of(std::vector<double> values) {
    if (values.empty()) return {};
    std::ranges::sort(values);
    const auto at = [&](double share) {
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    };
    return {.least = values.front(),
            .hundredth = at(0.01),
            .median = at(0.5),
            .ninety_ninth = at(0.99),
            .largest = values.back()};
}

std::vector<LayerCells> layer_cells(const VolumeMesh& mesh, const std::vector<CellQuality>& qualities) {
    std::vector<LayerCells> layers(mesh.parts.size());
    std::vector<CompensatedSum> volumes(layers.size());
    for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
        const VolumeCell& cell = mesh.cells[i];
        LayerCells& layer = layers[cell.layer];
        layer.tetrahedra += cell.kind == CellKind::Tetrahedron;
        layer.pyramids += cell.kind == CellKind::Pyramid;
        layer.prisms += cell.kind == CellKind::Prism;
        volumes[cell.layer].add(qualities[i].volume);
    }
    for (std::size_t i = 0; i < layers.size(); ++i) layers[i].volume = volumes[i].value();
    return layers;
}

}  // namespace stratareeb
