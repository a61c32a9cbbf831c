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
    double plan_area() const;
};

struct LevelSet {
    double level = 0;
    std::vector<Contour> contours;  // in the order of their first edge in the mesh
};

//! The level sets of a field at given levels, all in one sweep over the edges: time in proportion to the mesh plus what is
//! returned. A vertex at exactly a level counts as above it, so that contours are simple lines there too: they run through
//! that vertex (which then stands once in a row), and around a plateau along its lower rim. A contour that shrinks to one
//! point, a minimum exactly at the level, is left out.
//! \throw InvalidInput if the field does not fit the mesh or a level is not a number.
std::vector<LevelSet> level_sets(const TriMesh& mesh, const ScalarField& field,
                                 std::span<const double> levels);

//! `count` levels that part the field's range evenly, its ends left out.
std::vector<double> even_levels(const ScalarField& field, std::size_t count);

}  // namespace stratareeb
