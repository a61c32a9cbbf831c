// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "boreholes/borehole.h"
#include "mesh/layer_model.h"

namespace stratareeb {

//! The file in a model's folder that keeps its boreholes.
constexpr const char* kModelHolesFile = "boreholes.json";

struct ModelHoles {
    Survey survey;
    std::vector<std::uint32_t> vertex;  // of the plan mesh, PlanMesh::kNoVertex where a hole stands outside
};

//! What each hole says, in map coordinates: {"contact_points", "holes": [{"id", "row", "x", "y", "vertex" (null outside the
//! footprint), "horizons": [elevation or null], "layers": [thickness, null = unknown, or {"at_least": thickness}]}]}.
//! One hole a line; numbers with the digits that give the same double again.
void write_model_holes(const std::filesystem::path& file, const Survey& survey,
                       const std::vector<std::uint32_t>& vertex);

//! \throw IoError, InvalidInput naming the hole.
ModelHoles read_model_holes(const std::filesystem::path& file, const std::vector<Unit>& units,
                            std::size_t plan_vertices);

}  // namespace stratareeb
