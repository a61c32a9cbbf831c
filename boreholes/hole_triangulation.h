// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! Where a place lies among the holes: the corners of its Delaunay triangle and its barycentric weights.
//! Outside the holes' hull: the ends of the hull edge that holds the closest hull point, the third weight 0.
//! Weights are >= 0 and sum to 1; a repeated site has weight 0 in its later places.
struct PlanLocation {
    std::array<std::uint32_t, 3> site{};
    std::array<double, 3> weight{};
    bool inside = false;  // in the hull or on it
};

//! One site with its share in a prediction.
struct SiteWeight {
    std::uint32_t site;
    double weight;
};

//! Sibson's natural neighbour coordinates (R. Sibson, 1981): weights >= 0 of sum 1 whose mean place is `at`. That is the
//! place asked for, but outside the hull its closest hull point, and in a triangle that was peeled off the hull the closest
//! point of the peeled hull; `beyond` then leads from there to the place (or hull point): the way over which a prediction
//! may be extended with its gradient.
struct NaturalPlace {
    Point2 at, beyond;
    std::vector<SiteWeight> weights;
};

//! Delaunay triangulation of the holes in plan. Any number of distinct sites from one up; collinear sites
//! make a chain without triangles. Hull triangles flatter than a limit are
//! left out, by default only those that rounding makes, so that holes in a row along the edge of a survey
//! stay on its hull whatever their last digits say.
class HoleTriangulation {
 public:
    static constexpr double kRoundingSliver = 1e-6;

    //! `hull_sliver`: hull triangles whose height over length is less are peeled off, and sites that all lie
    //! in so thin a strip are taken as a chain along it.
    //! \pre at least one site, all distinct.
    explicit HoleTriangulation(std::vector<Point2> sites, double hull_sliver = kRoundingSliver);
    ~HoleTriangulation();

    const std::vector<Point2>& sites() const { return sites_; }
    //! Counter-clockwise triples of sites.
    const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return triangles_; }
    //! Hull edges, the hull's inside to the left, in order. Collinear sites: there and back again.
    const std::vector<std::array<std::uint32_t, 2>>& hull_edges() const { return hull_edges_; }
    bool is_flat() const { return triangles_.empty(); }
    //! Unit vector square to a hull edge (square to the chain, where sites are flat), away from the inside.
    Point2 outward(std::size_t hull_edge) const;

    std::vector<PlanLocation> locate(std::span<const Point2> where) const;

    //! The natural neighbours of each place; `visit(i, place)` is called once for each, in any order, from one thread.
    template <class Visit>
    void for_each_natural_place(std::span<const Point2> where, Visit&& visit) const {
        NaturalPlace place;
        for (const std::uint32_t i : walking_order(where)) {
            find_natural_place(where[i], place);
            visit(i, static_cast<const NaturalPlace&>(place));
        }
    }

    //! The sites joined to each site by a triangulation edge, ascending.
    std::vector<std::vector<std::uint32_t>> neighbours() const;

 private:
    struct Delaunay;
    void triangulate(double hull_sliver);
    void peel_hull_slivers(double hull_sliver);
    void link_hull();
    void link_rim();
    void chain_collinear();
    std::vector<std::uint32_t> walking_order(std::span<const Point2> where) const;
    PlanLocation locate(const Point2& p) const;
    double along_axis(const Point2& p) const;
    PlanLocation closest_on_chain(const Point2& p) const;
    PlanLocation closest_on(std::span<const std::array<std::uint32_t, 2>> edges, const Point2& p) const;
    Point2 place_of(const PlanLocation& location) const;
    bool on_rim(const Point2& p) const;
    bool find_coordinates(NaturalPlace& place) const;
    void find_natural_place(const Point2& p, NaturalPlace& place) const;

    std::vector<Point2> sites_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<std::array<std::uint32_t, 2>> hull_edges_;
    std::vector<std::array<std::uint32_t, 2>> rim_;  // edges of the convex hull, before peeling
    Point2 axis_start_, axis_;  // of flat sites: a far end and the unit vector towards the other
    std::unique_ptr<Delaunay> delaunay_;
};

}  // namespace stratareeb
