// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stratareeb {

//! What a column of a file of contours can mean.
enum class ContourColumn { Part, Ring, Order, Elevation };

//! The column of that meaning by its name in the wild, units of measure left out; the best name wins, then the first.
std::optional<std::size_t> find_contour_column(std::span<const std::string> names, ContourColumn column);

//! The column that the user calls so (letter case does not matter).
//! \throw InvalidInput naming the file's columns
std::size_t stated_contour_column(std::span<const std::string> names, std::string_view stated,
                                  const std::string& file);

}  // namespace stratareeb
