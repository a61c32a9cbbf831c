// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces over a grid of places, against the heights that are true there; and the linear rival, triangles between contours.
#pragma once

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "mesh/triangle_soup.h"
#include "reeb/contour_stack.h"

namespace stratareeb::testing {

//! Columns from west to east, rows from south to north; value (c, r) at low + step (c, r).
struct HeightGrid {
    Point2 low;
    double step = 1;
    std::size_t columns = 0, rows = 0;
    std::vector<double> heights;  // NaN = none

    double& at(std::size_t column, std::size_t row) { return heights[row * columns + column]; }
    Point2 place(std::size_t column, std::size_t row) const {
        return {low.x + step * static_cast<double>(column), low.y + step * static_cast<double>(row)};
    }
    HeightGrid empty() const {
        HeightGrid grid = *this;
        grid.heights.assign(columns * rows, std::numeric_limits<double>::quiet_NaN());
        return grid;
    }
};

//! The highest upward triangle over each place.
inline HeightGrid heights_of(const TriangleSoup& soup, const HeightGrid& like) {
    HeightGrid grid = like.empty();
    const auto cell = [&](double from, double low, std::size_t count, double (*round)(double)) {
        return static_cast<std::size_t>(
            std::clamp(round((from - low) / grid.step), 0.0, static_cast<double>(count)));
    };
    for (const auto& t : soup.triangles) {
        const Point3 &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
        const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        if (!(area > 0)) continue;
        const auto [x0, x1] = std::minmax({a.x, b.x, c.x});
        const auto [y0, y1] = std::minmax({a.y, b.y, c.y});
        for (auto row = cell(y0, grid.low.y, grid.rows, std::ceil);
             row < grid.rows && grid.place(0, row).y <= y1; ++row)
            for (auto column = cell(x0, grid.low.x, grid.columns, std::ceil);
                 column < grid.columns && grid.place(column, 0).x <= x1; ++column) {
                const Point2 p = grid.place(column, row);
                const double u = ((p.x - a.x) * (c.y - a.y) - (c.x - a.x) * (p.y - a.y)) / area,
                             v = ((b.x - a.x) * (p.y - a.y) - (p.x - a.x) * (b.y - a.y)) / area;
                if (u < 0 || v < 0 || u + v > 1) continue;
                double& height = grid.at(column, row);
                const double z = a.z + u * (b.z - a.z) + v * (c.z - a.z);
                if (!(height > z)) height = z;
            }
    }
    return grid;
}

//! Plain linear interpolation: the constrained Delaunay triangulation of all contours.
inline TriangleSoup contour_tin(const ContourStack& stack) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
    using Face = CGAL::Constrained_triangulation_face_base_2<Kernel>;
    using Tin =
        CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>,
                                                   CGAL::No_constraint_intersection_tag>;
    Tin tin;
    TriangleSoup soup;
    for (const StackContour& contour : stack.contours) {
        std::vector<Tin::Vertex_handle> ring;
        for (const Point2& p : contour.points) {
            ring.push_back(tin.insert({p.x, p.y}));
            ring.back()->info() = static_cast<std::uint32_t>(soup.points.size());
            soup.points.push_back({p.x, p.y, contour.z});
        }
        for (std::size_t i = 0; i < ring.size(); ++i)
            tin.insert_constraint(ring[i], ring[(i + 1) % ring.size()]);
    }
    for (const auto face : tin.finite_face_handles())
        soup.triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    return soup;
}

//! How many rings lie around each place.
inline std::vector<int> ring_depths(const ContourStack& stack, const HeightGrid& grid) {
    std::vector<int> depth(grid.columns * grid.rows, 0);
    for (const StackContour& ring : stack.contours)
        for (std::size_t row = 0; row < grid.rows; ++row) {
            const double y = grid.place(0, row).y;
            std::vector<double> passages;
            for (std::size_t i = 0; i < ring.points.size(); ++i) {
                const Point2 &a = ring.points[i], &b = ring.points[(i + 1) % ring.points.size()];
                if ((a.y > y) != (b.y > y)) passages.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
            }
            std::ranges::sort(passages);
            std::size_t passed = 0;
            for (std::size_t column = 0; column < grid.columns; ++column) {
                while (passed < passages.size() && passages[passed] < grid.place(column, row).x) ++passed;
                depth[row * grid.columns + column] += static_cast<int>(passed % 2);
            }
        }
    return depth;
}

struct HeightErrors {
    std::size_t places = 0;
    double mean = 0, rms = 0, most = 0, most_of_95_percent = 0;
};

//! Over places with a height in each that at least one ring lies around.
inline HeightErrors errors_of(const HeightGrid& found, const HeightGrid& truth,
                              const std::vector<int>& depth) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < depth.size(); ++i)
        if (depth[i] > 0 && std::isfinite(found.heights[i]) && std::isfinite(truth.heights[i]))
            errors.push_back(std::abs(found.heights[i] - truth.heights[i]));
    HeightErrors result{.places = errors.size()};
    if (errors.empty()) return result;
    std::ranges::sort(errors);
    for (const double e : errors) {
        result.mean += e / static_cast<double>(errors.size());
        result.rms += e * e / static_cast<double>(errors.size());
    }
    result.rms = std::sqrt(result.rms);
    result.most = errors.back();
    result.most_of_95_percent = errors[errors.size() * 95 / 100];
    return result;
}

}  // namespace stratareeb::testing
