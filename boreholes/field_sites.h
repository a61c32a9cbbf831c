// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boreholes/interpolator.h"
#include "boreholes/point.h"

namespace stratareeb {

//! Coordinates near zero and of size one, in which systems of equations are well scaled. Made by a shift and by powers of
//! two, so that local coordinates are as exact as the differences of the given ones; a later linear map may stretch them.
struct PlanFrame {
    Point2 origin;
    double xx = 1, xy = 0, yx = 0, yy = 1;  // local = matrix · (p − origin)

    Point2 to_local(const Point2& p) const {
        const double dx = p.x - origin.x, dy = p.y - origin.y;
        return {xx * dx + xy * dy, yx * dx + yy * dy};
    }
    //! This frame followed by the linear map (a b; c d) of local coordinates.
    PlanFrame then(double a, double b, double c, double d) const;
};

//! The sites of one field that have a say, in the order of the field: each place once, the first of a repeated place, a
//! measured value before a bound.
struct FieldSites {
    PlanFrame frame;
    std::vector<std::uint32_t> site;  // number among all sites
    std::vector<Point2> at;           // local coordinates
    std::vector<double> value;        // as given
    std::vector<char> at_least;       // the value is a lower bound
    std::size_t measured = 0;         // how many are not

    std::size_t size() const { return at.size(); }
};

//! `sites` are all sites of the triangulation that the field is about.
FieldSites field_sites(std::span<const Point2> sites, const SiteField& field);

//! The same sites in another frame.
FieldSites in_frame(const FieldSites& sites, std::span<const Point2> all_sites, const PlanFrame& frame);

//! Finds the site that stands exactly at a place.
class SiteLookup {
 public:
    //! Measured sites of a field.
    SiteLookup(std::span<const Point2> all_sites, const FieldSites& sites);
    //! The value there, or null.
    const double* value_at(const Point2& p) const;

 private:
    struct Entry {
        Point2 at;
        double value;
    };
    std::vector<Entry> entries_;  // by x, then y
};

//! What a prediction among these values is kept within, so that steep data can't make it run away: their range widened
//! by half of it on either side, and, where all of them are positive, at least half of the smallest.
struct ValueLimits {
    double lowest = 0, highest = 0;
    double clamp(double value) const { return value < lowest ? lowest : value > highest ? highest : value; }
};
ValueLimits value_limits(std::span<const double> values);

}  // namespace stratareeb
