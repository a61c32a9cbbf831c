// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "mesh/layer_model.h"

namespace stratareeb {

//! The binary part of the 3D page: lists of whole numbers, each number as a little-endian base-128 varint, lists one after the other.
class ViewStreams {
 public:
    //! \return {"offset", "length", "count"}, where the list stands, in bytes
    nlohmann::json add(std::span<const std::uint32_t> numbers);
    //! The differences from one number to the next (the first from 0), with their signs in the lowest bit.
    nlohmann::json add_differences(std::span<const std::int64_t> numbers);

    const std::string& bytes() const { return bytes_; }

 private:
    void put(std::uint64_t number);
    nlohmann::json listed(std::size_t start, std::size_t count) const;

    std::string bytes_;
};

//! Horizons on a grid of 2^20 steps over the longer side in plan, and 2^20 from the lowest to the highest elevation: 1 mm over a
//! kilometre. A layer without thickness has none here, one with thickness has at least a step, so that horizons stay
//! in order and regions the same.
//! \return {"low": [x, y, z], "step": [x, y, z], "vertices", "triangles" (numbers), "corner": list of "highest vertex so far + 1 - this
//! one" (0: a new one), "x", "y" and "ground": lists of differences, "thickness": a list of differences a layer, in steps}
//! \pre the model is in_view_order and has triangles
nlohmann::json view_surfaces(const LayerModel& model, ViewStreams& streams);

}  // namespace stratareeb
