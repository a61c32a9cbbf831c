// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>
#include <set>
#include <vector>

#include "boreholes/point.h"
#include "subdivision/horizon_sheets.h"
#include "subdivision/plan_cells.h"

namespace stratareeb {

//! Two sheets and how far one is to be above the other where a line ends a body.
struct SheetGap {
    std::uint32_t above, below;
    double gap;
    auto operator<=>(const SheetGap&) const = default;
};

using SheetGaps = std::set<SheetGap>;

//! Of the bases that end along each line and the sheets above them, as `sheets.gaps` has them.
//! \return [cells.lines]
std::vector<SheetGaps> sheet_gaps(const PlanCells& cells, const HorizonSheets& sheets);

//! Whether sheets are to be apart where bodies end.
bool has_gaps(const HorizonSheets& sheets);

//! How much farther apart than they are to be sheets are at a place; negative = too close.
double off_gap(const HorizonSheets& sheets, const SheetGap& gap, const Point2& p);

//! The place nearest to having its gaps in a direction of unit length from p, no further away than `reach`, by damped Gauss-Newton
//! steps. Too little of a gap is worse than too much. Where going as far as one may would not change much, it stays near p.
//! \param size of the model
Point2 closest_to_gaps(const HorizonSheets& sheets, const SheetGaps& gaps, const Point2& p,
                       const Point2& direction, double reach, double size);

//! The place where sheets are closest to meeting, whatever their gaps; steps beyond `reach` are halved.
Point2 closest_to_meeting(const HorizonSheets& sheets, const SheetGaps& pairs, const Point2& p,
                          const Point2& direction, double reach, double size);

//! The same as with gaps, in all directions.
Point2 closest_to_gaps(const HorizonSheets& sheets, const SheetGaps& gaps, const Point2& p, double reach,
                       double size);

}  // namespace stratareeb
