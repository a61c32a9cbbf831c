// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/volume_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "boreholes/errors.h"
#include "mesh/cell_faces.h"

namespace stratareeb {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

//! How many parts each layer is divided into.
std::vector<std::size_t> parts_of(const LayerModel& model, const VolumeMeshOptions& options) {
    constexpr double kMost = 1e6;
    if (options.parts == 0) throw InvalidInput("0 parts of a layer: give 1 or more");
    if (!(options.max_thickness >= 0))
        throw InvalidInput(fmt::format("a thickness of {}: give a length above 0", options.max_thickness));
    std::vector<std::size_t> parts(model.units.size(), options.parts);
    for (std::size_t i = 0; options.max_thickness > 0 && i < parts.size(); ++i) {
        double thickest = 0;
        for (std::size_t v = 0; v < model.plan.surface.n_vertices(); ++v)
            thickest = std::max(thickest, model.thickness(i, v));
        const double needed = std::ceil(thickest / options.max_thickness * (1 - 1e-12));
        if (!(needed <= kMost))
            throw InvalidInput(fmt::format("layer {} is {} thick: {:.3g} parts; allow thicker ones",
                                           model.units[i].code, thickest, needed));
        parts[i] = std::max(parts[i], static_cast<std::size_t>(needed));
    }
    return parts;
}

//! Horizons without layers thinner than wanted. A column that is thinner as a whole stays as it is.
std::vector<std::vector<double>> without_thin_places(std::vector<std::vector<double>> horizons,
                                                     double thinnest) {
    const std::size_t layers = horizons.size() - 1;
    for (std::size_t v = 0; v < horizons[0].size(); ++v) {
        if (!(horizons[0][v] - horizons[layers][v] >= thinnest)) continue;
        for (std::size_t i = 0; i + 1 < layers; ++i)
            if (horizons[i][v] - horizons[i + 1][v] < thinnest) horizons[i + 1][v] = horizons[i][v];
        for (std::size_t i = layers; i > 1 && horizons[i - 1][v] - horizons[layers][v] < thinnest; --i)
            horizons[i - 1][v] = horizons[layers][v];
    }
    return horizons;
}

//! The points of all columns: one for each elevation, so that levels which coincide share theirs.
class Columns {
 public:
    Columns(const LayerModel& model, VolumeMesh& mesh, double thinnest)
        : model_(model), mesh_(mesh), horizons_(without_thin_places(model.horizons, thinnest)) {
        const std::size_t levels = level_count(), vertices = model.plan.surface.n_vertices();
        if (static_cast<double>(levels) * static_cast<double>(vertices) > 4e9)
            throw InvalidInput(fmt::format("{} levels of {} points: too many; divide layers into fewer parts",
                                           levels, vertices));
        node_.resize(levels * vertices);
        for (std::size_t v = 0; v < vertices; ++v) add_column(v);
    }

    std::size_t level_count() const {
        std::size_t count = 1;
        for (const std::size_t n : mesh_.parts) count += n;
        return count;
    }
    std::uint32_t node(std::size_t level, std::size_t vertex) const {
        return node_[vertex * level_count_ + level];
    }

 private:
    void add_column(std::size_t v) {
        double last = horizons_[0][v];
        add_point(v, last);
        std::size_t level = 0;
        node_[v * level_count_] = newest();
        for (std::size_t i = 0; i < mesh_.parts.size(); ++i)
            for (std::size_t part = 1; part <= mesh_.parts[i]; ++part) {
                const double z = elevation(i, v, part);
                if (z != last) add_point(v, last = z);
                node_[v * level_count_ + ++level] = newest();
            }
    }

    //! Of the base of a part; never above the one over it, and the layer's own base at last.
    double elevation(std::size_t layer, std::size_t v, std::size_t part) const {
        const double top = horizons_[layer][v], base = horizons_[layer + 1][v];
        const auto parts = static_cast<double>(mesh_.parts[layer]);
        if (part == mesh_.parts[layer]) return base;
        return std::max(base, top - (top - base) * (static_cast<double>(part) / parts));
    }

    void add_point(std::size_t v, double z) {
        const auto& p = model_.plan.surface.point(TriMesh::VertexHandle(static_cast<int>(v)));
        mesh_.points.push_back({p[0], p[1], z});
        mesh_.column.push_back(static_cast<std::uint32_t>(v));
    }
    std::uint32_t newest() const { return static_cast<std::uint32_t>(mesh_.points.size() - 1); }

    const LayerModel& model_;
    VolumeMesh& mesh_;
    std::vector<std::vector<double>> horizons_;
    std::size_t level_count_ = level_count();
    std::vector<std::uint32_t> node_;  // [vertex][level]
};

using Corners = std::array<std::uint32_t, 3>;

//! What lies between two levels over a plan triangle; false if they coincide.
bool set_corners(VolumeCell& cell, Corners below, Corners above) {
    const auto turn = [&] {
        std::rotate(below.begin(), below.begin() + 1, below.end());
        std::rotate(above.begin(), above.begin() + 1, above.end());
    };
    const auto is_open = [&](std::size_t i) { return below[i] != above[i]; };
    const int open = is_open(0) + is_open(1) + is_open(2);
    if (open == 0) return false;
    if (open == 3) {
        cell.kind = CellKind::Prism;
        cell.node = {below[0], below[1], below[2], above[0], above[1], above[2]};
        return true;
    }
    while (is_open(0) != (open == 1) || is_open(1) == (open == 1)) turn();
    cell.kind = open == 1 ? CellKind::Tetrahedron : CellKind::Pyramid;
    if (open == 1)
        cell.node = {below[0], below[1], below[2], above[0]};
    else
        cell.node = {below[1], above[1], above[2], below[2], below[0]};
    return true;
}

void add_cells(VolumeMesh& mesh, const VolumeCell& cell, bool tetrahedra) {
    if (!tetrahedra) {
        mesh.cells.push_back(cell);
        return;
    }
    for (const auto& corners : tetrahedra_of(cell)) {
        VolumeCell part = cell;
        part.kind = CellKind::Tetrahedron;
        part.node = {corners[0], corners[1], corners[2], corners[3]};
        mesh.cells.push_back(part);
    }
}

//! Columns in which no layer has thickness, nor around them, have a point without a cell.
void drop_unused_points(VolumeMesh& mesh) {
    constexpr std::uint32_t kUnused = ~0u;
    std::vector<std::uint32_t> number(mesh.points.size(), kUnused);
    for (const VolumeCell& cell : mesh.cells)
        for (std::size_t i = 0; i < corners_of(cell.kind); ++i) number[cell.node[i]] = 0;
    std::uint32_t used = 0;
    for (std::size_t i = 0; i < number.size(); ++i) {
        if (number[i] == kUnused) continue;
        mesh.points[used] = mesh.points[i];
        mesh.column[used] = mesh.column[i];
        number[i] = used++;
    }
    mesh.points.resize(used);
    mesh.column.resize(used);
    for (VolumeCell& cell : mesh.cells)
        for (std::size_t i = 0; i < corners_of(cell.kind); ++i) cell.node[i] = number[cell.node[i]];
}

void check_cells(const VolumeMesh& mesh, const LayerModel& model) {
    const auto point = [&](std::uint32_t node) {
        const Point3& p = mesh.points[node];
        return Kernel::Point_3(p.x, p.y, p.z);
    };
    for (const VolumeCell& cell : mesh.cells)
        for (const auto& t : tetrahedra_of(cell))
            if (CGAL::orientation(point(t[0]), point(t[1]), point(t[2]), point(t[3])) != CGAL::POSITIVE) {
                const Point3& p = mesh.points[t[0]];
                throw GeometryError(
                    fmt::format("a cell of layer {} at x {}, y {}, z {} has no positive volume; keep "
                                "coordinates relative "
                                "to the model's origin",
                                model.units[cell.layer].code, p.x, p.y, p.z));
            }
}

}  // namespace

VolumeMesh volume_mesh(const LayerModel& model, const VolumeMeshOptions& options) {
    VolumeMesh mesh;
    mesh.parts = parts_of(model, options);
    const Columns columns(model, mesh, options.min_thickness);
    for (const auto f : model.plan.surface.faces()) {
        std::array<std::size_t, 3> vertex{};
        std::size_t i = 0;
        for (const auto v : model.plan.surface.fv_range(f)) vertex[i++] = static_cast<std::size_t>(v.idx());
        const auto corners = [&](std::size_t level) {
            return Corners{columns.node(level, vertex[0]), columns.node(level, vertex[1]),
                           columns.node(level, vertex[2])};
        };
        std::size_t level = 0;
        for (std::size_t layer = 0; layer < mesh.parts.size(); ++layer)
            for (std::uint32_t part = 0; part < mesh.parts[layer]; ++part, ++level) {
                VolumeCell cell{.layer = static_cast<std::uint16_t>(layer), .part = part};
                if (set_corners(cell, corners(level + 1), corners(level)))
                    add_cells(mesh, cell, options.tetrahedra);
            }
    }
    drop_unused_points(mesh);
    if (options.map_coordinates)
        for (Point3& p : mesh.points) p = {p.x + model.origin.x, p.y + model.origin.y, p.z + model.origin.z};
    check_cells(mesh, model);
    return mesh;
}

std::vector<std::array<std::uint32_t, 4>> tetrahedra_of(const VolumeCell& cell) {
    if (cell.kind == CellKind::Tetrahedron) return {{cell.node[0], cell.node[1], cell.node[2], cell.node[3]}};
    const auto corners = std::span(cell.node).first(corners_of(cell.kind));
    const std::uint32_t least = *std::ranges::min_element(corners);
    std::vector<std::array<std::uint32_t, 4>> result;
    // The least corner over each face that it is not on; of quadrangles, each half.
    for (const CellFace& face : faces_of(cell.kind)) {
        std::array<std::uint32_t, 4> node{};
        for (std::uint8_t i = 0; i < face.corners; ++i) node[i] = cell.node[face.corner[i]];
        const auto end = node.begin() + face.corners;
        if (std::find(node.begin(), end, least) != end) continue;
        std::rotate(node.begin(), std::min_element(node.begin(), end), end);
        for (std::uint8_t i = 1; i + 1 < face.corners; ++i)
            result.push_back({node[0], node[i + 1u], node[i], least});
    }
    return result;
}

}  // namespace stratareeb
