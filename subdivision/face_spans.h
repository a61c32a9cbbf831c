// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "subdivision/smooth_brep.h"

namespace stratareeb {

//! The spans of its sheet that a face reaches into, from the first to the one after the last: the surface that CAD programs get.
struct FaceSpans {
    std::size_t first_x = 0, end_x = 0, first_y = 0, end_y = 0;
};

FaceSpans face_spans(const SmoothBrep& brep, std::uint32_t cell);

}  // namespace stratareeb
