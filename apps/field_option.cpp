// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/field_option.h"

#include <array>
#include <vector>

#include "boreholes/errors.h"
#include "io/read_mesh.h"
#include "mesh/triangle_soup.h"

namespace stratareeb {

namespace {

Point3 direction_of(const std::string& text) {
    if (text == "x") return {1, 0, 0};
    if (text == "y") return {0, 1, 0};
    if (text == "z") return {0, 0, 1};
    std::array<double, 3> part{};
    std::size_t from = 0;
    for (int k = 0; k < 3; ++k) {
        const std::size_t comma = k < 2 ? text.find(',', from) : text.size();
        if (comma == std::string::npos ||
            !CLI::detail::lexical_cast(text.substr(from, comma - from), part[k]))
            throw CLI::ValidationError("--field", text + " is none of x, y, z and no direction dx,dy,dz");
        from = comma + 1;
    }
    return {part[0], part[1], part[2]};
}

}  // namespace

void add_field_option(CLI::App& command, std::string& field) {
    command.add_option("--field", field, "Height along x, y, z or a direction dx,dy,dz")
        ->capture_default_str()
        ->check([](const std::string& text) {
            try {
                direction_of(text);
                return std::string();
            } catch (const CLI::ValidationError& error) {
                return std::string(error.what());
            }
        });
}

ScalarField field_of(const TriMesh& mesh, const std::string& field) {
    return height_field(mesh, direction_of(field));
}

TriMesh half_edge_mesh_of(const std::string& file) {
    try {
        return half_edge_mesh(read_mesh(file));
    } catch (const InvalidInput& error) {
        const std::string text = error.what();
        throw InvalidInput(text.rfind(file, 0) == 0 ? text : file + ": " + text);
    }
}

void keep_existing(const std::filesystem::path& file, bool overwrite) {
    if (!overwrite && std::filesystem::exists(file))
        throw IoError(file.string() + ": is there already; give another name or --overwrite");
}

}  // namespace stratareeb
