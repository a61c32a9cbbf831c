// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "boreholes/rule_columns.h"

namespace stratareeb {

void drop_thinner(RuleColumns& rules, double thinnest) {
    for (std::size_t i = 0; i < rules.thickness.size(); ++i)
        for (std::size_t h = 0; h < rules.thickness[i].size(); ++h) {
            double &there = rules.columns.thickness[i][h], &uncut = rules.thickness[i][h];
            if (there < thinnest) there = 0;
            uncut = std::max(uncut, there);
            if (uncut < thinnest) uncut = 0;
        }
}

std::vector<UncutColumn> uncut_columns(const RuleColumns& rules, const ThicknessField& field,
                                       const Interpolator& interpolator, std::span<const Point2> where,
                                       std::span<const double> ground) {
    std::vector<SiteField> fields;
    for (const auto& anchor : rules.anchor)
        if (!anchor.empty()) fields.push_back({anchor, {}});
    const auto elevation = interpolator.predict(where, fields);
    const auto thickness = field.predict(where);
    const std::vector<PlanLocation> locations = field.holes().locate(where);
    std::vector<UncutColumn> result(where.size());
    for (std::size_t p = 0; p < where.size(); ++p) {
        UncutColumn& column = result[p];
        column.ground = ground[p];
        std::size_t next = 0;
        for (const auto& anchor : rules.anchor)
            column.anchor.push_back(anchor.empty() ? 0 : elevation[next++][p]);
        for (std::size_t i = 0; i < field.layers(); ++i) {
            column.thickness.push_back(std::max(0.0, thickness[i][p]));
            column.taper.push_back(field.taper(i, locations[p]));
        }
    }
    return result;
}

}  // namespace stratareeb
