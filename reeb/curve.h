// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

enum class CurveKind {
    Polyline,    // straight lines from point to point
    Circle,      // `center`, `radius`, `normal`; always closed
    Bezier,      // one piece of degree points.size() - 1
    Nurbs,       // rational B-spline
    Cardinal,    // cubic through all points, tangents `tension` * (next - previous)
    CatmullRom,  // cubic through all points, tangents weighted by `a` and `b`
};

//! A curve as it stands in a file. Only the parameters of its kind count.
//! A closed curve ends where it starts: its first point need not be repeated as the last, and may be.
struct Curve {
    CurveKind kind = CurveKind::Polyline;
    bool closed = false;
    std::vector<Point3> points;  // vertices or control points; none for a circle

    Point3 center;
    double radius = 0;
    Point3 normal{0, 0, 1};  // the circle runs counter-clockwise seen from its tip; any length but 0

    int degree = 3;  // of a NURBS curve
    // points.size() + degree + 1 ascending numbers; none = uniform (clamped, or periodic if closed)
    std::vector<double> knots;
    std::vector<double> weights;  // one per point, > 0; none = all 1

    double tension = 0.5;  // of a Cardinal spline: the thesis's a
    double a = 0.5;  // of a Catmull-Rom spline: share of the next chord in the tangent where a piece starts
    double b = 0.5;  // the same where a piece ends

    friend bool operator==(const Curve&, const Curve&) = default;
};

//! "polygon" (closed) or "line" (open), "circle", "bezier", "nurbs", "cardinal", "catmull-rom".
std::string_view curve_name(CurveKind kind, bool closed);
//! The kind of that name ("polyline" too); nothing for any other name.
std::optional<CurveKind> curve_kind(std::string_view name);

//! A curve as a function of t in [0, 1], checked and made ready once (thesis 2.1.2.1.1).
//! Joints lie at even steps of t: one piece per side of a polyline or spline; a NURBS curve's at its knots, the whole
//! range of knots mapped to [0, 1]; a circle's t is its angle / 2 pi from its frame's x axis (plane_frame of `normal`).
//!
//! Continuity: Bezier and circle smooth; Cardinal C1; NURBS C^(degree - multiplicity) at a knot; Catmull-Rom C1 if a = b,
//! else only C0: a joint's tangent mixes its two chords by (1 - b, b) for the piece before and by (1 - a, a) for the one after.
//! At an open spline's ends a point is added that mirrors the second in the first.
//!
//! Against the printed formulas: the Catmull-Rom vector's last entry is d_{i+1}; the B-spline recursion starts at degree 1,
//! with 0/0 = 0 and the last span closed on the right, so that the basis adds up to 1 on all of [0, 1].
class ParametricCurve {
 public:
    //! \throw InvalidInput if the curve lacks points, has numbers that are not finite, a radius, weight or knot vector that
    //! makes no curve, or is said to be closed and its ends (of a NURBS curve with knots) don't meet.
    explicit ParametricCurve(Curve curve);

    //! The point at t. A closed curve goes round and round, an open one stays at its ends outside [0, 1].
    //! \throw InvalidInput if t is not a number.
    Point3 at(double t) const;
    //! d/dt of the point; at a joint that of the piece after it, at an open curve's end that of the last piece.
    Point3 derivative(double t) const;

    //! The number of pieces: polynomial, of one degree, between joints. 1 for a circle.
    std::size_t pieces() const { return joints_.size() - 1; }
    //! The ends of the pieces in t: 0, ..., 1.
    const std::vector<double>& joints() const { return joints_; }

    //! Piece i of a polyline or a cubic spline as c0 + c1 u + c2 u^2 + c3 u^3 for u in [0, 1].
    //! \pre kind is Polyline, Cardinal or CatmullRom.
    std::array<Point3, 4> cubic(std::size_t i) const;

    //! The curve as made ready (prepared_curve), not as given: a periodic NURBS curve's points stand repeated, for one.
    const Curve& curve() const { return curve_; }

 private:
    Point3 value(double t, bool derived) const;
    const Point3& point(std::ptrdiff_t i) const;
    Point3 control(std::ptrdiff_t i) const;

    Curve curve_;
    std::vector<double> joints_;
};

}  // namespace stratareeb
