// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/ring_fill.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

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
using Side = std::pair<std::uint32_t, std::uint32_t>;  // the lower number first

constexpr int kUnknown = -1;

[[noreturn]] void refuse(std::string_view what, const Point2& place) {
    throw InvalidInput(fmt::format("{} at ({:.10g}, {:.10g})", what, place.x, place.y));
}

class Fill {
 public:
    Fill(std::span<const Point2> corners, std::span<const std::vector<std::uint32_t>> rings)
        : corners_(corners) {
        for (const auto& ring : rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
                ++sides_[std::minmax(ring[i], ring[(i + 1) % ring.size()])];
    }

    std::vector<std::array<std::uint32_t, 3>> run() {
        insert_corners();
        insert_sides();
        if (triangulation_.dimension() < 2) return {};
        mark_depths();
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (const auto face : triangulation_.finite_face_handles()) {
            if (face->info() % 2 == 0) continue;
            auto& t = triangles.emplace_back();
            for (int i = 0; i < 3; ++i) t[static_cast<std::size_t>(i)] = face->vertex(i)->info();
            std::ranges::rotate(t, std::ranges::min_element(t));
        }
        std::ranges::sort(triangles);
        return triangles;
    }

 private:
    void insert_corners() {
        for (std::uint32_t i = 0; i < corners_.size(); ++i) {
            vertices_.push_back(triangulation_.insert({corners_[i].x, corners_[i].y}));
            if (triangulation_.number_of_vertices() != vertices_.size())
                refuse("two corners have one place,", corners_[i]);
            vertices_.back()->info() = i;
        }
    }

    void insert_sides() {
        for (const auto& [side, times] : sides_) {
            const auto a = vertices_[side.first], b = vertices_[side.second];
            if (a == b) refuse("a side has no length", corners_[side.first]);
            try {
                triangulation_.insert_constraint(a, b);
            } catch (const Triangulation::Intersection_of_constraints_exception&) {
                refuse("a side crosses another one, beginning", corners_[side.first]);
            }
            if (!triangulation_.is_edge(a, b))
                refuse("a side passes through a corner, beginning", corners_[side.first]);
        }
    }

    bool is_border(Triangulation::Face_handle face, int i) const {
        if (!face->is_constrained(i)) return false;
        const Side side = std::minmax(face->vertex(Triangulation::cw(i))->info(),
                                      face->vertex(Triangulation::ccw(i))->info());
        return sides_.at(side) % 2 == 1;
    }

    //! From outside inwards, counting modulo 2.
    void mark_depths() {
        for (const auto face : triangulation_.all_face_handles()) face->info() = kUnknown;
        std::vector<Triangulation::Face_handle> front{triangulation_.infinite_face()};
        front.front()->info() = 0;
        while (!front.empty()) {
            const auto face = front.back();
            front.pop_back();
            for (int i = 0; i < 3; ++i) {
                const auto next = face->neighbor(i);
                if (next->info() != kUnknown) continue;
                next->info() = is_border(face, i) ? 1 - face->info() : face->info();
                front.push_back(next);
            }
        }
    }

    std::span<const Point2> corners_;
    std::map<Side, int> sides_;  // how often each comes
    Triangulation triangulation_;
    std::vector<Triangulation::Vertex_handle> vertices_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> ring_fill(std::span<const Point2> corners,
                                                    std::span<const std::vector<std::uint32_t>> rings) {
    return Fill(corners, rings).run();
}

}  // namespace stratareeb
