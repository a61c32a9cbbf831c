// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace stratareeb {

//! The vertices from bottom to top, in the order of `is_below` (value, then index), and each vertex's place in it.
struct VertexOrder {
    std::vector<std::uint32_t> vertices, rank;
};

//! Sort indices by value, equal values by index: a radix sort of the values' places in their range, then a comparison
//! sort where places coincide and values don't. Linear for values that are spread over their range.
//! \pre all values are finite
VertexOrder vertex_order(std::span<const double> values);

}  // namespace stratareeb
