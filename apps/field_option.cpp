// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/field_option.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "boreholes/errors.h"
#include "io/mesh_format.h"
#include "io/read_field.h"
#include "io/read_ply.h"

namespace stratareeb {

namespace {

constexpr std::string_view kDistance = "distance:", kFile = "file:", kProperty = "property:";

std::optional<Point3> three_numbers(const std::string& text) {
    std::array<double, 3> part{};
    std::size_t from = 0;
    for (int k = 0; k < 3; ++k) {
        const std::size_t comma = k < 2 ? text.find(',', from) : text.size();
        if (comma == std::string::npos ||
            !CLI::detail::lexical_cast(text.substr(from, comma - from), part[k]) || !std::isfinite(part[k]))
            return {};
        from = comma + 1;
    }
    return Point3{part[0], part[1], part[2]};
}

//! What follows a prefix, if the text begins with it.
std::optional<std::string> behind(const std::string& text, std::string_view prefix) {
    if (!text.starts_with(prefix)) return {};
    return text.substr(prefix.size());
}

std::string complaint(const std::string& text) {
    if (const auto place = behind(text, kDistance))
        return three_numbers(*place) ? "" : text + " names no place (expected distance:X,Y,Z)";
    for (const auto prefix : {kFile, kProperty})
        if (const auto name = behind(text, prefix))
            return name->empty() ? fmt::format("{} names no {}", text, prefix.substr(0, prefix.size() - 1))
                                 : "";
    if (field_direction(text)) return {};
    return text + " is none of x, y, z, dx,dy,dz, distance:X,Y,Z, file:PATH, property:NAME";
}

ScalarField values_of_file(const InputMesh& input, const std::string& field) {
    if (const auto file = behind(field, kFile)) return read_field(*file, input.file_vertices);
    if (mesh_format(input.file) != MeshFormat::Ply)
        throw InvalidInput(
            fmt::format("{}: {} asks for a property of a PLY file; give values of other meshes as file:PATH",
                        input.file, field));
    return read_ply_property(input.file, *behind(field, kProperty));
}

}  // namespace

std::optional<Point3> field_direction(const std::string& field) {
    if (field == "x") return Point3{1, 0, 0};
    if (field == "y") return Point3{0, 1, 0};
    if (field == "z") return Point3{0, 0, 1};
    return three_numbers(field);
}

void add_field_option(CLI::App& command, std::string& field) {
    command
        .add_option("--field", field,
                    "Height along x, y, z or dx,dy,dz, distance:X,Y,Z from a place, file:PATH (a number a "
                    "vertex and line) or property:NAME of a PLY file's vertices")
        ->capture_default_str()
        ->check(complaint);
}

ScalarField field_of(const InputMesh& input, const std::string& field) {
    if (const auto direction = field_direction(field)) return height_field(input.mesh, *direction);
    if (const auto place = behind(field, kDistance))
        return distance_field(input.mesh, *three_numbers(*place));
    ScalarField values = values_of_file(input, field);
    if (!input.file_vertex.empty()) {
        ScalarField of_mesh;
        for (const std::uint32_t v : input.file_vertex) of_mesh.push_back(values[v]);
        values = std::move(of_mesh);
    }
    try {
        check_field(input.mesh, values);
    } catch (const InvalidInput& error) {
        throw InvalidInput(fmt::format("{}: {}: {}", input.file, field, error.what()));
    }
    return values;
}

}  // namespace stratareeb
