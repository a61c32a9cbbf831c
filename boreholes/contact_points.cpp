// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/contact_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boreholes/contact_checks.h"
#include "boreholes/errors.h"
#include "boreholes/unit_order.h"

namespace stratareeb {
namespace {

constexpr std::size_t kMostUnits = 500;

std::vector<std::size_t> stated_order(const ContactSet& contacts, const std::vector<std::string>& codes,
                                      Audit& audit) {
    std::vector<std::size_t> order;
    for (const std::string& code : codes) {
        const auto found = std::find(contacts.units.begin(), contacts.units.end(), code);
        if (found == contacts.units.end())
            audit.add_error("", 0, "", fmt::format("the order names {}, of which there is no point", code));
        else
            order.push_back(static_cast<std::size_t>(found - contacts.units.begin()));
    }
    for (std::size_t unit = 0; unit < contacts.units.size(); ++unit)
        if (std::find(order.begin(), order.end(), unit) == order.end())
            audit.add_warning(
                "", 0, "",
                fmt::format("{} is not in the order given; its points are left out", contacts.units[unit]));
    return order;
}

void renumber(ContactSet& contacts, const std::vector<std::size_t>& order) {
    std::vector<std::size_t> rank(contacts.units.size(), contacts.units.size());
    std::vector<std::string> codes;
    for (std::size_t i = 0; i < order.size(); ++i) {
        rank[order[i]] = i;
        codes.push_back(contacts.units[order[i]]);
    }
    std::erase_if(contacts.points, [&](ContactPoint& point) {
        point.unit = rank[point.unit];
        return point.unit == contacts.units.size();
    });
    contacts.units = std::move(codes);
}

using Column = std::vector<ContactPoint>;  // the points of one place

//! One height per unit in a column: the mean where there are several.
void average_repeats(Column& column, std::size_t& averaged) {
    std::stable_sort(column.begin(), column.end(),
                     [](const ContactPoint& a, const ContactPoint& b) { return a.unit < b.unit; });
    Column single;
    double count = 1;
    for (const ContactPoint& point : column) {
        if (single.empty() || single.back().unit != point.unit) {
            single.push_back(point);
            count = 1;
            continue;
        }
        averaged += single.back().z != point.z;
        count += 1;
        single.back().z += (point.z - single.back().z) / count;
    }
    column = std::move(single);
}

//! Heights must not rise from unit to unit; the longest run that does not is kept.
void drop_crossings(const ContactSet& contacts, Column& column, Audit& audit) {
    Column by_height = column;
    std::stable_sort(by_height.begin(), by_height.end(),
                     [](const ContactPoint& a, const ContactPoint& b) { return a.z > b.z; });
    std::vector<std::size_t> ranks;
    for (const ContactPoint& point : by_height) ranks.push_back(point.unit);
    if (std::is_sorted(ranks.begin(), ranks.end())) return;
    const std::vector<bool> kept = heaviest_chain(ranks, std::vector<double>(ranks.size(), 1.0));
    column.clear();
    for (std::size_t i = 0; i < by_height.size(); ++i) {
        const ContactPoint& point = by_height[i];
        if (kept[i])
            column.push_back(point);
        else
            audit.add_warning(
                contacts.files[point.file], point.row, "",
                fmt::format("{} at z {} is out of order with the other units at x {}, y {}; left out",
                            contacts.units[point.unit], point.z, point.at.x, point.at.y));
    }
}

Borehole hole_of(const Column& column, std::size_t layers, std::size_t first_horizon) {
    const ContactPoint& first = *std::min_element(column.begin(), column.end(),
                                                  [](const auto& a, const auto& b) { return a.row < b.row; });
    Borehole hole{
        first.hole.empty() ? fmt::format("row {}", first.row) : first.hole, first.at, {}, {}, first.row};
    hole.layers.resize(layers);
    hole.horizons.resize(layers + 1);
    for (const ContactPoint& point : column) {
        hole.horizons[first_horizon + point.unit] = point.z;
        if (point.ground && first_horizon == 1) hole.horizons[0] = point.ground;
    }
    return hole;
}

//! Name the layers between the surfaces. Returns the horizon of the first surface.
std::size_t name_layers(const ContactSet& contacts, PointsMark mark, bool has_ground, Survey& survey,
                        Audit& audit) {
    const auto add = [&](const std::string& code) { survey.units.push_back({code, code, ""}); };
    if (mark == PointsMark::Base) {
        for (const std::string& code : contacts.units) add(code);
        return 1;
    }
    if (has_ground) add("overburden");
    for (std::size_t i = 0; i + 1 < contacts.units.size(); ++i) add(contacts.units[i]);
    audit.add_warning(
        "", 0, "",
        fmt::format("points are on tops: {} surfaces bound {} layers; {} has no base and is no layer",
                    contacts.units.size(), survey.units.size(), contacts.units.back()));
    return has_ground ? 1 : 0;
}

}  // namespace

Survey build_contact_survey(ContactSet contacts, const ContactOptions& options, Audit& audit) {
    drop_faults(contacts, audit);
    Survey survey;
    survey.contact_points = true;
    if (contacts.points.empty()) return survey;
    if (contacts.units.size() > kMostUnits)
        throw InvalidInput(
            fmt::format("{} different units: more than {}; is this the unit column? State it with --columns "
                        "unit=NAME",
                        contacts.units.size(), kMostUnits));
    refuse_overhangs(contacts, audit);
    renumber(contacts, options.order.empty() ? inferred_contact_order(contacts)
                                             : stated_order(contacts, options.order, audit));
    audit.throw_if_errors();

    const bool has_ground =
        options.has_ground || std::any_of(contacts.points.begin(), contacts.points.end(),
                                          [](const ContactPoint& p) { return p.ground.has_value(); });
    if (options.mark == PointsMark::Base && !has_ground)
        throw InvalidInput(
            "contacts at the base of units need the elevation of the ground: give a raster (--ground FILE)");
    const std::size_t first = name_layers(contacts, options.mark, has_ground, survey, audit);
    std::size_t averaged = 0;
    for (const auto& place : points_by_place(contacts)) {
        Column column;
        for (const std::size_t i : place) column.push_back(contacts.points[i]);
        average_repeats(column, averaged);
        drop_crossings(contacts, column, audit);
        survey.holes.push_back(hole_of(column, survey.units.size(), first));
    }
    if (averaged > 0)
        audit.add_warning(
            "", 0, "",
            fmt::format("{} points repeat a place with another height; the mean height is taken", averaged));
    return survey;
}

}  // namespace stratareeb
