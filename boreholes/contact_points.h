// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "boreholes/audit.h"
#include "boreholes/borehole.h"

namespace stratareeb {

//! Whether a contact point lies on the top or the base of the unit it names.
enum class PointsMark { Auto, Top, Base };

//! A point on the top or the base of a unit.
struct ContactPoint {
    Point2 at;
    double z = 0;
    std::size_t unit = 0;          // index into ContactSet::units
    std::string hole;              // may be empty
    std::optional<double> ground;  // elevation, where the hole's is known
    std::size_t row = 0;
    std::uint32_t file = 0;
};

struct ContactSet {
    std::vector<std::string> units;  // by first appearance
    std::vector<ContactPoint> points;
    std::vector<std::string> files;
};

struct ContactOptions {
    std::vector<std::string> order;     // unit codes from top to bottom; empty = inferred
    PointsMark mark = PointsMark::Top;  // Auto is Top
    bool has_ground = false;            // the ground will come from elsewhere
};

//! Turn contact points into holes with single known horizons (Survey::contact_points). Points at one place
//! become one hole; two heights of one surface there become their mean. Tops: n surfaces bound n - 1 layers,
//! the first surface being horizon 0; the last unit has no base and is no layer. Where a ground is known or
//! will be, a first unit "overburden" lies between it and the first surface. Bases: n layers under a ground
//! that must be known from elsewhere. Order: of points at one place, then of nearest neighbours. Points of
//! faults (a name with the word fault) are left out.
//! \throw InvalidInput if a surface has two clearly
//! different heights at nearly one place (an overhang, fold or fault).
Survey build_contact_survey(ContactSet contacts, const ContactOptions& options, Audit& audit);

}  // namespace stratareeb
