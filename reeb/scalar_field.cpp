// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/scalar_field.h"

#include <fmt/format.h>

#include <cmath>

#include "boreholes/errors.h"

namespace stratareeb {

ScalarField height_field(const TriMesh& mesh, const Point3& direction) {
    const bool sound = std::isfinite(direction.x) && std::isfinite(direction.y) && std::isfinite(direction.z);
    if (!sound || (direction.x == 0 && direction.y == 0 && direction.z == 0))
        throw InvalidInput("the direction of a height field has no length");
    ScalarField field;
    field.reserve(mesh.n_vertices());
    for (const auto v : mesh.vertices()) {
        const auto& p = mesh.point(v);
        field.push_back(p[0] * direction.x + p[1] * direction.y + p[2] * direction.z);
    }
    return field;
}

ScalarField distance_field(const TriMesh& mesh, const Point3& from) {
    ScalarField field;
    field.reserve(mesh.n_vertices());
    for (const auto v : mesh.vertices()) {
        const auto& p = mesh.point(v);
        field.push_back(std::hypot(p[0] - from.x, p[1] - from.y, p[2] - from.z));
    }
    return field;
}

void check_field(const TriMesh& mesh, const ScalarField& field) {
    if (field.size() != mesh.n_vertices())
        throw InvalidInput(fmt::format("{} field values for {} vertices", field.size(), mesh.n_vertices()));
    for (std::size_t v = 0; v < field.size(); ++v)
        if (!std::isfinite(field[v]))
            throw InvalidInput(fmt::format("the field has no number at vertex {}", v));
}

}  // namespace stratareeb
