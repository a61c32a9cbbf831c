// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boreholes/plan_box.h"
#include "boreholes/point.h"

namespace stratareeb {

//! A site and its squared distance from where one asked.
struct NearSite {
    double squared_distance;
    std::uint32_t site;
    friend auto operator<=>(const NearSite&, const NearSite&) = default;
};

//! A k-d tree over sites (J. L. Bentley, 1975). Answers don't depend on how the tree happens to be built: equal distances are
//! told apart by the site's number.
class NearestSites {
 public:
    //! `at` must outlive this.
    explicit NearestSites(std::span<const Point2> at);

    //! The `count` closest sites (all, if there are fewer), closest first. `found` is overwritten.
    void nearest(const Point2& p, std::size_t count, std::vector<NearSite>& found) const;
    std::vector<NearSite> nearest(const Point2& p, std::size_t count) const;

    //! Sites in the box, ascending.
    std::vector<std::uint32_t> in_box(const PlanBox& box) const;
    //! True if more than `limit` sites are in the box; looks no further than needed.
    bool has_more_in(const PlanBox& box, std::size_t limit) const;

 private:
    struct Node {
        PlanBox box;
        std::uint32_t begin, end;           // of order_
        std::uint32_t left = 0, right = 0;  // 0: a leaf
    };
    std::uint32_t build(std::uint32_t begin, std::uint32_t end);
    void search(std::uint32_t node, const Point2& p, std::size_t count, std::vector<NearSite>& heap) const;
    template <class Visit>
    bool visit_box(std::uint32_t node, const PlanBox& box, Visit&& visit) const;

    std::span<const Point2> at_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace stratareeb
