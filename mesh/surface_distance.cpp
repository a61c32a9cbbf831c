// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface_distance.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace stratareeb {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

constexpr double kMostParts = 1000;  // of a triangle's side

Kernel::Point_3 point(const Point3& p) {
    return {p.x, p.y, p.z};
}

Triangles triangles_of(const TriangleSoup& soup) {
    Triangles triangles;
    triangles.reserve(soup.triangles.size());
    for (const auto& t : soup.triangles)
        triangles.emplace_back(point(soup.points[t[0]]), point(soup.points[t[1]]), point(soup.points[t[2]]));
    return triangles;
}

double distance(const Point3& a, const Point3& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

Point3 between(const Point3& a, const Point3& b, const Point3& c, double u, double v) {
    return {a.x + u * (b.x - a.x) + v * (c.x - a.x), a.y + u * (b.y - a.y) + v * (c.y - a.y),
            a.z + u * (b.z - a.z) + v * (c.z - a.z)};
}

}  // namespace

struct SurfaceDistance::Tree {
    explicit Tree(const TriangleSoup& soup)
        : triangles(triangles_of(soup)), tree(triangles.cbegin(), triangles.cend()) {
        tree.build();
        tree.accelerate_distance_queries();
    }
    Triangles triangles;
    AabbTree tree;
};

SurfaceDistance::SurfaceDistance(const TriangleSoup& surface) : tree_(std::make_unique<Tree>(surface)) {}

SurfaceDistance::~SurfaceDistance() = default;

std::vector<double> SurfaceDistance::of(const std::vector<Point3>& places) const {
    std::vector<double> distances(places.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, places.size(), 1024), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            distances[i] = std::sqrt(tree_->tree.squared_distance(point(places[i])));
    });
    return distances;
}

bool SurfaceDistance::is_within(const Point3& place, double distance) const {
    return tree_->tree.do_intersect(Kernel::Sphere_3(point(place), distance * distance));
}

std::vector<Point3> surface_samples(const TriangleSoup& surface, double spacing) {
    std::vector<Point3> samples = surface.points;
    for (const auto& t : surface.triangles) {
        const Point3 &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
        const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
        const int parts = static_cast<int>(std::clamp(std::ceil(longest / spacing), 1.0, kMostParts));
        for (int i = 0; i <= parts; ++i)
            for (int j = 0; i + j <= parts; ++j)
                samples.push_back(between(a, b, c, double(i) / parts, double(j) / parts));
        if (parts == 1) samples.push_back(between(a, b, c, 1.0 / 3, 1.0 / 3));
    }
    return samples;
}

}  // namespace stratareeb
