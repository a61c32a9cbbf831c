// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "mesh/analysis.h"

namespace stratareeb {

//! A mesh report for people: several lines, problems last. `what` is the file, and the part where there are
//! several.
std::string report_text(const std::string& what, const MeshReport& report);

//! The same for programs: one object; genus is null where there is none.
nlohmann::json report_json(const MeshReport& report);

//! A file and, if it has several, one of its parts: "model.glb" or "model.glb, part Clay".
std::string part_label(const std::string& file, const std::string& part, std::size_t parts);

//! JSON as text for stdout, with names of any encoding.
std::string json_text(const nlohmann::json& value);

}  // namespace stratareeb
