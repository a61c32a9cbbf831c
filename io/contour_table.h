// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "io/read_contour_stack.h"
#include "io/text_table.h"

namespace stratareeb {

//! Contours from a table with a row for each of their points, as read_contour_stack says.
ContourStack contours_of_table(const TextTable& table, const ReadContourStackOptions& options);

}  // namespace stratareeb
