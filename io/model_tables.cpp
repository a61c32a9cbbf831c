// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model_tables.h"

#include <algorithm>

#include "mesh/model_column.h"
#include "mesh/section_holes.h"

namespace stratareeb {
namespace {

OutputCell number(std::size_t value) {
    return static_cast<double>(value);
}

}  // namespace

OutputTable volumes_table(const LayerModel& model, const SavedRecord& record) {
    const std::string& u = model.length_unit;
    OutputTable table{
        {"order", "code", "name", "color", "volume_" + u + "3", "plan_area_" + u + "2", "mean_thickness_" + u,
         "max_thickness_" + u, "bodies", "holes_present", "holes_absent", "holes_unknown", "holes_at_least"},
        {}};
    const auto& units = record.record.units;
    for (std::size_t i = 0; i < std::min(units.size(), model.units.size()); ++i) {
        const UnitSummary& sum = units[i];
        table.rows.push_back({number(i + 1), model.units[i].code, model.units[i].name, model.units[i].color,
                              sum.volume, sum.plan_area, sum.mean_thickness, sum.max_thickness,
                              number(sum.components), number(sum.holes_present), number(sum.holes_absent),
                              number(sum.holes_unknown), number(sum.holes_at_least)});
    }
    return table;
}

OutputTable logs_table(const Survey& survey) {
    OutputTable table{{"hole", "x", "y", "order", "code", "name", "top", "base", "thickness", "ends_in_it"},
                      {}};
    for (const Borehole& hole : survey.holes)
        for (const LogInterval& interval : log_of(hole)) {
            const Unit& unit = survey.units[interval.layer];
            table.rows.push_back({hole.id, hole.at.x, hole.at.y, number(interval.layer + 1), unit.code,
                                  unit.name, interval.top, interval.base, interval.top - interval.base,
                                  interval.goes_on ? 1.0 : 0.0});
        }
    return table;
}

OutputTable model_logs_table(const SavedModel& saved) {
    OutputTable table{{"hole", "x", "y", "order", "code", "name", "top", "base", "thickness"}, {}};
    const ColumnQuery query(saved.model);
    for (const Borehole& hole : saved.survey.holes) {
        const auto column = query.column(hole.at);
        if (!column) continue;
        for (std::size_t i = 0; i < saved.model.units.size(); ++i) {
            const Unit& unit = saved.model.units[i];
            table.rows.push_back({hole.id, hole.at.x, hole.at.y, number(i + 1), unit.code, unit.name,
                                  column->horizons[i], column->horizons[i + 1], column->thickness(i)});
        }
    }
    return table;
}

}  // namespace stratareeb
