// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_format.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

constexpr std::array<std::pair<const char*, MeshFormat>, 6> kExtensions{{{".ply", MeshFormat::Ply},
                                                                         {".obj", MeshFormat::Obj},
                                                                         {".stl", MeshFormat::Stl},
                                                                         {".off", MeshFormat::Off},
                                                                         {".glb", MeshFormat::Glb},
                                                                         {".3mf", MeshFormat::ThreeMf}}};

std::optional<MeshFormat> known_format(const std::filesystem::path& file) {
    auto extension = file.extension().string();
    for (auto& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    for (const auto& [name, format] : kExtensions)
        if (extension == name) return format;
    return {};
}

}  // namespace

MeshFormat mesh_format(const std::filesystem::path& file) {
    if (const auto format = known_format(file)) return *format;
    throw IoError(
        fmt::format("{}: not a known mesh format; use .ply, .obj, .stl, .off, .glb or .3mf", file.string()));
}

bool is_mesh_file(const std::filesystem::path& file) {
    return known_format(file).has_value();
}

}  // namespace stratareeb
