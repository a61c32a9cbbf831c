// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "boreholes/point.h"
#include "mesh/tri_mesh.h"
#include "reeb/scalar_field.h"

namespace stratareeb {

//! One connected piece of a level set: a polyline on the mesh. Higher values lie on its left, seen from outside the mesh.
struct Contour {
    std::vector<Point3> points;  // a closed contour's first point is not repeated
    bool closed = true;          // an open contour starts and ends on the mesh's boundary

    double length() const;
    //! Signed area in plan (x, y) of a closed contour: positive if it runs counter-clockwise seen from above.
    double plan_area() const { return area({0, 0, 1}); }
    //! The same seen from where a direction comes from: from its tip, looking back. It need not be of unit length.
    double area(const Point3& direction) const;
};

struct LevelSet {
    double level = 0;
    std::vector<Contour>
        contours;  // open ones first, then closed ones, in the order of their first edge in the mesh
};

//! The level sets of a field at given levels, all in one sweep over the edges: time in proportion to the mesh plus what is
//! returned. A vertex at exactly a level counts as above it, so that a contour is the limit of those just below the level:
//! it runs through that vertex (which then stands once in a row), around a plateau along its lower rim, and there and back
//! along a ridge of that height. Contours, or parts of one, may so touch there; they never cross. One that shrinks to a
//! point, a summit exactly at the level, is left out. Uses the threads there are; what is returned does not depend on them.
//! \throw InvalidInput if the field does not fit the mesh or a level is not a number.
std::vector<LevelSet> level_sets(const TriMesh& mesh, const ScalarField& field,
                                 std::span<const double> levels);

//! `count` levels that part the field's range evenly, its ends left out.
std::vector<double> even_levels(const ScalarField& field, std::size_t count);

}  // namespace stratareeb
