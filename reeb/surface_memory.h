// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "reeb/plan_sheet.h"
#include "reeb/surface_crossings.h"

namespace stratareeb {

//! Sheets that were made before, by what they are made of.
class SheetMemory {
 public:
    //! plan_sheet, made once.
    const std::optional<PlanSheet>& sheet(std::span<const SheetRing> rings, const std::optional<Point3>& node,
                                          std::size_t steps);

 private:
    std::map<std::vector<double>, std::optional<PlanSheet>> made_;
};

//! What surfaces that are made one after the other, each a little other than the one before, have in common. It saves time and changes
//! nothing.
struct SurfaceMemory {
    SheetMemory sheets;
    CrossingSearch crossings;
};

}  // namespace stratareeb
