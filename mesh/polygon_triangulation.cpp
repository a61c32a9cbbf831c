// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/polygon_triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

#include "boreholes/errors.h"

namespace stratareeb {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Face = CGAL::Triangulation_face_base_with_info_2<int, Kernel,
                                                       CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>,
                                               CGAL::No_constraint_intersection_tag>;

constexpr int kUnknown = 0, kOutside = 1, kInside = 2;

//! From outside inwards, a side changes at each edge of the polygon.
void mark_sides(Triangulation& triangulation) {
    for (const auto face : triangulation.all_face_handles()) face->info() = kUnknown;
    std::vector<Triangulation::Face_handle> front{triangulation.infinite_face()};
    front.front()->info() = kOutside;
    while (!front.empty()) {
        const auto face = front.back();
        front.pop_back();
        for (int i = 0; i < 3; ++i) {
            const auto next = face->neighbor(i);
            if (next->info() != kUnknown) continue;
            next->info() = face->is_constrained(i) ? kOutside + kInside - face->info() : face->info();
            front.push_back(next);
        }
    }
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate_polygon(std::span<const Point2> corners) {
    Triangulation triangulation;
    std::vector<Triangulation::Vertex_handle> vertices;
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
        vertices.push_back(triangulation.insert({corners[i].x, corners[i].y}));
        vertices.back()->info() = i;
    }
    if (triangulation.number_of_vertices() != corners.size())
        throw InvalidInput("a polygon to be triangulated has the same corner twice");
    try {
        for (std::size_t i = 0; i < corners.size(); ++i)
            triangulation.insert_constraint(vertices[i], vertices[(i + 1) % corners.size()]);
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
        throw InvalidInput("a polygon to be triangulated crosses itself");
    }
    mark_sides(triangulation);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const auto face : triangulation.finite_face_handles())
        if (face->info() == kInside)
            triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    for (auto& t : triangles) std::ranges::rotate(t, std::ranges::min_element(t));
    std::ranges::sort(triangles);
    if (triangles.size() + 2 != corners.size())
        throw InvalidInput("a polygon to be triangulated touches itself");
    return triangles;
}

}  // namespace stratareeb
