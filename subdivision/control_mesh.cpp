// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/control_mesh.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

constexpr double kMaxCount = std::numeric_limits<int>::max();  // OpenSubdiv numbers everything with int
constexpr int kMaxLevels = 10;

void require_face(const ControlMesh& mesh, std::size_t face, std::span<const std::uint32_t> corners) {
    if (corners.size() < 3) throw InvalidInput(fmt::format("face {} has {} corners", face, corners.size()));
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i] >= mesh.vertices)
            throw InvalidInput(fmt::format("face {} names vertex {} of {}", face, corners[i], mesh.vertices));
        for (std::size_t k = 0; k < i; ++k)
            if (corners[i] == corners[k])
                throw InvalidInput(
                    fmt::format("face {} names vertex {} twice", face, place_of(mesh, corners[i])));
    }
    if (mesh.scheme == SubdivisionScheme::Loop && corners.size() != 3)
        throw InvalidInput(
            fmt::format("face {} at vertex {} has {} corners; Loop subdivision needs triangles, "
                        "Catmull-Clark takes any polygons",
                        face, place_of(mesh, corners[0]), corners.size()));
}

void require_polygons(const ControlMesh& mesh) {
    if (mesh.corners.empty()) throw InvalidInput("there are no faces to subdivide");
    const std::size_t faces = mesh.sizes.empty() ? mesh.corners.size() / 3 : mesh.sizes.size();
    std::size_t begin = 0, f = 0;
    for (; f < faces; ++f) {
        const std::size_t size = mesh.sizes.empty() ? 3 : mesh.sizes[f];
        if (size > mesh.corners.size() - begin) break;
        require_face(mesh, f, mesh.corners.subspan(begin, size));
        begin += size;
    }
    if (f < faces || begin != mesh.corners.size())
        throw InvalidInput(
            fmt::format("the faces' sizes do not add up to their {} corners", mesh.corners.size()));
}

void require_countable(const ControlMesh& mesh, int levels) {
    if (levels < 0 || levels > kMaxLevels)
        throw InvalidInput(fmt::format("{} levels; give 0 to {}", levels, kMaxLevels));
    const double corners = static_cast<double>(mesh.corners.size()) * std::pow(4.0, levels);
    if (2 * corners >= kMaxCount || static_cast<double>(mesh.vertices) >= kMaxCount)
        throw InvalidInput(fmt::format(
            "{} levels make about {:.2g} million faces, more than can be numbered; give fewer levels", levels,
            corners / 3e6));
}

void require_sharp(const ControlMesh& mesh, std::uint32_t vertex, double sharpness) {
    if (vertex >= mesh.vertices)
        throw InvalidInput(fmt::format("a crease or corner names vertex {} of {}", vertex, mesh.vertices));
    if (!(sharpness >= 0))
        throw InvalidInput(fmt::format("a sharpness of {} at vertex {}; it is 0 or more", sharpness,
                                       place_of(mesh, vertex)));
}

}  // namespace

std::string place_of(const ControlMesh& mesh, std::size_t vertex) {
    if (vertex >= mesh.points.size()) return fmt::format("{}", vertex);
    const auto& p = mesh.points[vertex];
    return fmt::format("{} at ({}, {}, {})", vertex, p.x, p.y, p.z);
}

void require_faces(const ControlMesh& mesh, int levels) {
    require_countable(mesh, levels);
    require_polygons(mesh);
    for (const auto& crease : mesh.creases) {
        require_sharp(mesh, crease.from, crease.sharpness);
        require_sharp(mesh, crease.to, crease.sharpness);
    }
    for (const auto& corner : mesh.sharp_corners) require_sharp(mesh, corner.vertex, corner.sharpness);
}

}  // namespace stratareeb
