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

//! Delaunay triangulation of the holes in plan. Any number of distinct sites from one up; collinear sites
//! make a chain without triangles. Hull triangles flatter than a limit are
//! left out, by default only those that rounding makes, so that holes in a row along the edge of a survey
//! stay on its hull whatever their last digits say.
class HoleTriangulation {
 public:
    static constexpr double kRoundingSliver = 1e-6;

    //! `hull_sliver`: hull triangles whose height over length is less are peeled off, and sites that all lie
    //! in so thin a strip are taken as a chain along it. \pre at least one site, all distinct.
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

    //! Sibson's natural neighbour coordinates (R. Sibson, 1981) of each place; outside the hull those of its
    //! closest hull point. `visit(i, weights)` is called once for each place, in any order, from one thread.
    template <class Visit>
    void for_each_natural_neighbours(std::span<const Point2> where, Visit&& visit) const {
        const std::vector<std::uint32_t> order = walking_order(where);
        std::vector<SiteWeight> weights;
        for (const std::uint32_t i : order) {
            natural_neighbours(where[i], weights);
            visit(i, std::span<const SiteWeight>(weights));
        }
    }

    //! The sites joined to each site by a triangulation edge, ascending.
    std::vector<std::vector<std::uint32_t>> neighbours() const;

 private:
    struct Delaunay;
    void triangulate(double hull_sliver);
    void peel_hull_slivers(double hull_sliver);
    void link_hull();
    void chain_collinear();
    std::vector<std::uint32_t> walking_order(std::span<const Point2> where) const;
    PlanLocation locate(const Point2& p) const;
    double along_axis(const Point2& p) const;
    PlanLocation closest_on_chain(const Point2& p) const;
    PlanLocation closest_on_hull(const Point2& p) const;
    bool on_hull_edge_or_site(const PlanLocation& location) const;
    void natural_neighbours(const Point2& p, std::vector<SiteWeight>& weights) const;

    std::vector<Point2> sites_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<std::array<std::uint32_t, 2>> hull_edges_;
    Point2 axis_start_, axis_;  // of flat sites: a far end and the unit vector towards the other
    std::unique_ptr<Delaunay> delaunay_;
};

}  // namespace stratareeb
