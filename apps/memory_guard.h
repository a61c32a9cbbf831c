// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace stratareeb {

//! Bytes that a build needs at its peak, estimated from its plan triangles and layers; `all_solids` if they
//! are held together, as whole-model formats need.
double estimated_memory(double plan_triangles, std::size_t layers, bool all_solids);

//! \throw InvalidInput if the estimate is more than what the machine has free; the message says both and the
//! way out.
void check_memory(double plan_triangles, std::size_t layers, bool all_solids);

//! Bytes that `refine` needs at its peak, estimated from the faces that it makes.
double estimated_refine_memory(double faces, bool are_quads);

//! Whether the machine has that much free.
bool has_refine_memory(double faces, bool are_quads);

//! \throw InvalidInput as check_memory does
void check_refine_memory(double faces, bool are_quads);

}  // namespace stratareeb
