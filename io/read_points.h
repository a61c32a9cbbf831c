// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "boreholes/contact_points.h"
#include "boreholes/hole_log.h"
#include "io/collars.h"
#include "io/table_context.h"

namespace stratareeb {

//! Columns of a table with one row per contact point or sample: x, y, z and unit; or hole, depth and unit.
struct PointColumns {
    std::size_t unit = 0;
    std::optional<std::size_t> x, y, z, hole, depth;
};

//! The point columns of a table; nullopt if it is of another layout. Needs x, y, z or hole and depth.
std::optional<PointColumns> find_point_columns(const TableShape& shape, TableValues values);

//! Whether the points are samples: holes that meet a unit more than twice on average, at ten places or in ten
//! rows.
bool looks_like_samples(const TableShape& shape, const PointColumns& columns);

//! Append a table's contacts.
void read_points(const TableShape& shape, const PointColumns& columns, const CollarTable* collars,
                 ContactSet& contacts, TableContext& context);

//! Append a table's samples as logs: each stands for the stretch half way to its neighbours in the hole.
//! Where two are more than 1.5 times the usual spacing apart, half a spacing each, and a gap between. The
//! ground is the top of the first sample unless collars give it.
void read_samples(const TableShape& shape, const PointColumns& columns, const CollarTable* collars,
                  LogSet& logs, TableContext& context);

}  // namespace stratareeb
