// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "mesh/triangle_soup.h"

namespace stratareeb {

//! How far places are from a surface: the distance to the nearest point of its triangles.
class SurfaceDistance {
 public:
    //! \pre the soup has a triangle; triangles without area count as what they are, segments or points
    explicit SurfaceDistance(const TriangleSoup& surface);
    ~SurfaceDistance();
    SurfaceDistance(const SurfaceDistance&) = delete;
    SurfaceDistance& operator=(const SurfaceDistance&) = delete;

    //! The distance of each place; runs on several threads.
    std::vector<double> of(const std::vector<Point3>& places) const;

    //! Whether a place is no farther than that: faster than its distance.
    bool is_within(const Point3& place, double distance) const;

 private:
    struct Tree;
    std::unique_ptr<const Tree> tree_;
};

//! Points of every triangle: its corners, and an even grid between them that leaves no side longer than `spacing`.
std::vector<Point3> surface_samples(const TriangleSoup& surface, double spacing);

}  // namespace stratareeb
