// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "boreholes/point.h"
#include "io/table_context.h"

namespace stratareeb {

//! Where a hole is.
struct Collar {
    std::string id;
    Point2 at;
    std::optional<double> ground;  // in length units
    std::size_t row = 0;
};

//! The collars of a table, by hole.
struct CollarTable {
    std::string file;
    std::vector<Collar> collars;
    std::unordered_map<std::string, std::size_t> by_id;
    std::unordered_map<std::string, std::size_t> dropped;  // holes without a place → row

    const Collar* find(const std::string& id) const {
        const auto found = by_id.find(id);
        return found == by_id.end() ? nullptr : &collars[found->second];
    }
};

//! Whether a table has the columns hole, x and y (and no interval columns).
bool is_collar_table(const TableShape& shape);

//! Read hole, x, y and ground. Holes without a place, and repeated ids, are left out with a warning.
CollarTable read_collars(const TableShape& shape, TableContext& context);

}  // namespace stratareeb
