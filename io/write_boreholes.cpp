// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_boreholes.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "boreholes/errors.h"
#include "io/write_table.h"

namespace stratareeb {
namespace {

OutputCell thickness_cell(const LayerFact& fact) {
    if (fact.knowledge == Knowledge::Unknown) return {};
    if (fact.knowledge == Knowledge::AtLeast) return fmt::format(">{}", fact.thickness);
    return fact.thickness;
}

OutputCell elevation_cell(const std::optional<double>& elevation) {
    return elevation ? OutputCell(*elevation) : OutputCell();
}

OutputTable wide_table(const Survey& survey) {
    OutputTable table{.columns = {"hole_id", "x", "y", "ground"}, .rows = {}};
    for (const Unit& unit : survey.units) table.columns.push_back(unit.code);
    for (const Borehole& hole : survey.holes) {
        std::vector<OutputCell> row{hole.id, hole.at.x, hole.at.y, elevation_cell(hole.horizons.at(0))};
        for (const LayerFact& fact : hole.layers) row.push_back(thickness_cell(fact));
        table.rows.push_back(std::move(row));
    }
    return table;
}

OutputTable collars(const Survey& survey) {
    OutputTable table{.columns = {"hole_id", "x", "y", "ground"}, .rows = {}};
    for (const Borehole& hole : survey.holes) {
        if (!hole.horizons.at(0))
            throw InvalidInput(
                fmt::format("hole {}: depths need a ground elevation; write it wide", hole.id));
        table.rows.push_back({hole.id, hole.at.x, hole.at.y, *hole.horizons[0]});
    }
    return table;
}

OutputTable interval_table(const Survey& survey) {
    OutputTable table{.columns = {"hole_id", "from", "to", "unit"}, .rows = {}};
    for (const Borehole& hole : survey.holes) {
        double depth = 0;
        for (std::size_t i = 0; i < hole.layers.size(); ++i) {
            const LayerFact& fact = hole.layers[i];
            if (fact.knowledge == Knowledge::Unknown) break;
            const double to = depth + fact.thickness;
            if (to > depth) table.rows.push_back({hole.id, depth, to, survey.units[i].code});
            if (fact.knowledge == Knowledge::AtLeast) break;
            depth = to;
        }
    }
    return table;
}

OutputTable point_table(const Survey& survey) {
    OutputTable table{.columns = {"x", "y", "z", "unit"}, .rows = {}};
    for (const Borehole& hole : survey.holes)
        for (std::size_t k = 0; k < hole.horizons.size(); ++k) {
            const std::string unit = k < survey.units.size() ? survey.units[k].code : "base";
            if (hole.horizons[k]) table.rows.push_back({hole.at.x, hole.at.y, *hole.horizons[k], unit});
        }
    return table;
}

}  // namespace

std::filesystem::path collar_table(const std::filesystem::path& file) {
    return file.parent_path() / (file.stem().string() + "_collars" + file.extension().string());
}

void write_boreholes(const std::filesystem::path& file, const Survey& survey, TableLayout layout) {
    switch (layout) {
        case TableLayout::Auto:
        case TableLayout::Wide:
            return write_table(file, wide_table(survey));
        case TableLayout::Intervals:
            write_table(collar_table(file), collars(survey));
            return write_table(file, interval_table(survey));
        case TableLayout::Points:
            return write_table(file, point_table(survey));
        case TableLayout::Samples:
            break;
    }
    throw InvalidInput(
        fmt::format("{}: boreholes are written wide, as intervals or as points", file.string()));
}

}  // namespace stratareeb
