// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "boreholes/point.h"
#include "mesh/tri_mesh.h"

namespace stratareeb {

//! A place in a plan triangle: weights >= 0 of its three vertices, which sum to 1.
struct PlanPlace {
    std::uint32_t face = 0;
    std::array<std::uint32_t, 3> vertex{};
    std::array<double, 3> weight{};

    //! A quantity that is linear over each triangle.
    double value(const std::vector<double>& at_vertex) const {
        // The corner's own value to the last bit where the other two have no weight.
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i)
            if (weight[i] > 0)
                sum += weight[i] == 1 ? at_vertex[vertex[i]] : weight[i] * at_vertex[vertex[i]];
        return sum;
    }
};

//! Finds the triangle of a plan mesh that a place lies in: buckets of equal size, about one a triangle, and exact
//! orientation tests. Building takes time linear in the triangles, a search constant time on meshes of even size.
class PlanLocator {
 public:
    //! `plan`: counter-clockwise in x, y, unfolded. A copy of what is needed is kept.
    explicit PlanLocator(const TriMesh& plan);

    //! The triangle of lowest index that has the place in it or on its border; nothing outside the plan. A place that
    //! lies outside by no more than 1e-12 of the plan's size, as rounding leaves one on an outline, is taken to be on it.
    std::optional<PlanPlace> locate(const Point2& place) const;

    //! Triangles whose bounding boxes meet a box, ascending.
    std::vector<std::uint32_t> near(const Point2& low, const Point2& high) const;
    //! Triangles near a segment, ascending: all that it meets, and a few beside. Time grows with the buckets on its way.
    std::vector<std::uint32_t> along(const Point2& from, const Point2& to) const;

 private:
    void add_near(const Point2& low, const Point2& high, std::vector<std::uint32_t>& faces) const;
    std::array<std::size_t, 2> bucket_of(const Point2& p) const;
    std::optional<PlanPlace> place_in(std::uint32_t face, const Point2& p, double outside) const;
    std::optional<PlanPlace> search(const Point2& p, double outside) const;

    std::vector<Point2> points_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    Point2 low_, high_;
    std::array<std::size_t, 2> count_{1, 1};  // buckets along x and y
    std::array<double, 2> step_{1, 1};
    double tolerance_ = 0;
    std::vector<std::uint32_t> first_,
        in_bucket_;  // triangles of bucket b: in_bucket_[first_[b] … first_[b + 1]]
};

}  // namespace stratareeb
