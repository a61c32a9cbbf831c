// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boreholes/nearest_sites.h"

namespace stratareeb {

struct PatchCoverOptions {
    std::size_t single = 400;   // so many sites or fewer make one patch of them all
    std::size_t largest = 120;  // most sites in the reach of a patch
    std::size_t fewest = 60;    // a patch with fewer looks to its nearest sites beyond
};

//! One patch's share in a place.
struct PatchWeight {
    std::uint32_t patch;
    double weight;
};

//! Overlapping boxes over scattered sites with smooth weights that sum to 1 at every place: a partition of unity, over which
//! surfaces fitted patch by patch are blended without a jump (R. Franke, "Locally determined smooth interpolation at irregularly
//! spaced points in several variables", 1977). Boxes are halved until few enough sites are in their reach, so that clusters
//! get small ones. Weights have two continuous derivatives.
class PatchCover {
 public:
    //! `at` must outlive this. \pre at least one site.
    explicit PatchCover(std::span<const Point2> at, const PatchCoverOptions& options = {});

    std::size_t size() const { return cells_.size(); }
    //! Sites of a patch, ascending: all in its reach, and at least so many as the options say.
    std::vector<std::uint32_t> sites(std::uint32_t patch) const;
    //! True if the site at `p` lies in the patch's own box. Each place is in one box, or on an edge.
    bool owns(std::uint32_t patch, const Point2& p) const { return cells_[patch].box.contains(p); }
    //! Patches that have a say at a place, ascending, and their weights. Places beyond the sites' box count as
    //! the closest place in it.
    void weights(const Point2& p, std::vector<PatchWeight>& result) const;

 private:
    struct Cell {
        PlanBox box, reach;
    };
    struct Node {
        PlanBox reach;                                 // of all patches below
        std::uint32_t left = 0, right = 0, patch = 0;  // left 0: a leaf
    };
    std::uint32_t split(const PlanBox& box, int depth);
    void collect(std::uint32_t node, const Point2& p, std::vector<PatchWeight>& result) const;

    std::span<const Point2> at_;
    PatchCoverOptions options_;
    NearestSites index_;
    PlanBox box_;
    std::vector<Cell> cells_;
    std::vector<Node> nodes_;
};

}  // namespace stratareeb
