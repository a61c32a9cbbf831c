// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "boreholes/point.h"
#include "mesh/tri_mesh.h"
#include "reeb/arc_index.h"
#include "reeb/reeb_graph.h"
#include "reeb/scalar_field.h"
#include "reeb/sweep_graph.h"

namespace stratareeb {

//! A closed contour of height z, counter-clockwise seen from above.
struct LevelContour {
    double z = 0;
    std::vector<Point3> points;
};

//! May it stand in an enhanced Reeb graph: three points at least, an area above 0, without crossing itself?
//! \param may_touch itself in corners
bool is_sound(const LevelContour& contour, bool may_touch = false);
//! A small part by which it crosses itself is cut off. \return whether it is sound then
bool make_sound(LevelContour& contour);

//! Contours of a mesh over height z, as an enhanced Reeb graph takes them: level, counter-clockwise, without points that
//! rounding can't tell apart.
class MeshContours {
 public:
    //! \pre `field` is height_field(mesh), `graph` is reeb_graph(mesh, field); all outlive this
    MeshContours(const TriMesh& mesh, const ScalarField& field, const ReebGraph& graph);

    //! The contour of an edge at a height above its lower end and up to its upper end, as the limit of those below.
    //! \param kept a point that stays when others as good as coincide with it
    LevelContour at(const SweepEdge& edge, double z, const Point3* kept = nullptr) const;
    //! The limit of those above the lower end of an edge.
    LevelContour above_lower_end(const SweepEdge& edge, const Point3* kept = nullptr) const;

    //! Contours of one height that meet, made to meet exactly: points that rounding can't tell apart become one, and stretches that
    //! lead there and back are left out.
    void join_points(std::vector<LevelContour>& contours) const;

    Point3 place(std::uint32_t vertex) const;

 private:
    bool are_one(const Point3& a, const Point3& b) const;
    void settle(LevelContour& contour, const Point3* kept) const;

    const TriMesh& mesh_;
    ScalarField fallen_;  // heights with the other sign
    ArcIndex index_;
    double least_step_ = 0;  // points closer than that are one
};

}  // namespace stratareeb
