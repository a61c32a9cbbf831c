// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/input_mesh.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "boreholes/errors.h"
#include "io/read_mesh.h"
#include "mesh/orient_soup.h"

namespace stratareeb {

namespace {

std::string changes(const OrientedSoup& repaired) {
    std::string text;
    const auto add = [&](std::size_t count, const char* what) {
        if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
    };
    add(repaired.copies, "vertices added where surfaces were cut apart");
    add(repaired.turned, "triangles turned over");
    add(repaired.degenerate, "triangles without three corners dropped");
    add(repaired.duplicate, "repeated triangles dropped");
    return text.empty() ? "nothing to repair" : text;
}

void repair_mesh(TriangleSoup& soup, InputMesh& input) {
    OrientedSoup repaired = orient_soup(soup);
    fmt::print(stderr, "{}: {}\n", input.file, changes(repaired));
    if (!repaired.is_changed()) return;
    soup = std::move(repaired.soup);
    input.file_vertex = std::move(repaired.source_point);
}

}  // namespace

void add_repair_option(CLI::App& command, bool& repair) {
    command.add_flag(
        "--repair", repair,
        "Cut the mesh apart where it is no 2-manifold, wind its triangles alike, drop repeated ones");
}

InputMesh read_input_mesh(const std::string& file, bool repair) {
    TriangleSoup soup = read_mesh(file);
    InputMesh input{.file = file, .mesh = {}, .file_vertex = {}, .file_vertices = soup.points.size()};
    if (repair) repair_mesh(soup, input);
    try {
        input.mesh = half_edge_mesh(soup);
    } catch (const InvalidInput& error) {
        throw InvalidInput(fmt::format(
            "{}: {}; --repair cuts the mesh there, winds triangles alike or drops them", file, error.what()));
    }
    return input;
}

}  // namespace stratareeb
