// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/region_triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "boreholes/errors.h"

namespace stratareeb {

namespace {

constexpr std::uint32_t kNoSide = ~0u;
constexpr double kGrowth = 0.25;  // of the edges' length over the distance from a ring
constexpr double kLargestRadius =
    0.8;  // of a circumcircle, in edge lengths; an equilateral triangle's is 0.58
constexpr double kLeastDistance = 0.5;  // of a new point from others, in edge lengths
constexpr std::size_t kPasses = 40;

struct VertexInfo {
    std::uint32_t number = 0, side = kNoSide;
    double size = 0;  // of edges here
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexInfo, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>, CGAL::No_constraint_intersection_tag>;
using Vertex = Triangulation::Vertex_handle;
using Face = Triangulation::Face_handle;
using Place = Triangulation::Point;

constexpr int kUnknown = 0, kOutside = 1, kInside = 2;

double distance(const Place& a, const Place& b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

class RegionMesher {
 public:
    RegionMesher(std::span<const RegionRing> rings, const RegionTriangulationOptions& options)
        : options_(options) {
        std::vector<std::vector<Vertex>> vertices;
        std::size_t points = 0;
        for (const RegionRing& ring : rings) {
            vertices.push_back(insert_ring(ring));
            points += ring.points.size();
        }
        if (plane_.number_of_vertices() != points) throw InvalidInput("rings around a region touch");
        try {
            for (const auto& ring : vertices)
                for (std::size_t i = 0; i < ring.size(); ++i)
                    plane_.insert_constraint(ring[i], ring[(i + 1) % ring.size()]);
        } catch (const Triangulation::Intersection_of_constraints_exception&) {
            throw InvalidInput("rings around a region cross");
        }
        mark_region();
    }

    void insert_inside(const RegionPoint& p) {
        const Place place(p.place.x, p.place.y);
        Triangulation::Locate_type type{};
        int corner = 0;
        const Face face = plane_.locate(place, type, corner);
        const bool is_inside = face->info() == kInside && type != Triangulation::VERTEX &&
                               (type != Triangulation::EDGE || !face->is_constrained(corner));
        if (!is_inside) throw InvalidInput("a point to be in a region is not inside of it");
        insert(place, face, std::min(p.size, size_at(place, face)));
    }

    RegionTriangulation run() {
        const std::uint32_t first = count_;
        refine();
        split_chords();
        RegionTriangulation result;
        result.added.resize(count_ - first);
        for (const Vertex v : plane_.finite_vertex_handles())
            if (v->info().number >= first)
                result.added[v->info().number - first] = {v->point().x(), v->point().y()};
        for (const Face face : plane_.finite_face_handles()) {
            if (face->info() != kInside) continue;
            auto& t = result.triangles.emplace_back();
            for (int i = 0; i < 3; ++i) t[static_cast<std::size_t>(i)] = face->vertex(i)->info().number;
            std::ranges::rotate(t, std::ranges::min_element(t));
        }
        std::ranges::sort(result.triangles);
        return result;
    }

 private:
    std::vector<Vertex> insert_ring(const RegionRing& ring) {
        std::vector<Vertex> vertices;
        const std::size_t n = ring.points.size();
        const auto length = [&](std::size_t i) {
            const Point2 &a = ring.points[i % n], &b = ring.points[(i + 1) % n];
            return std::hypot(b.x - a.x, b.y - a.y);
        };
        for (std::size_t i = 0; i < n; ++i) {
            vertices.push_back(plane_.insert({ring.points[i].x, ring.points[i].y}));
            vertices.back()->info() = {count_++, ring.side,
                                       std::min(options_.largest_edge, (length(i) + length(i + n - 1)) / 2)};
        }
        return vertices;
    }

    //! From outside inwards, a side changes at each edge of a ring.
    void mark_region() {
        for (const Face face : plane_.all_face_handles()) face->info() = kUnknown;
        std::vector<Face> front{plane_.infinite_face()};
        front.front()->info() = kOutside;
        while (!front.empty()) {
            const Face face = front.back();
            front.pop_back();
            for (int i = 0; i < 3; ++i) {
                const Face next = face->neighbor(i);
                if (next->info() != kUnknown) continue;
                next->info() = face->is_constrained(i) ? kOutside + kInside - face->info() : face->info();
                front.push_back(next);
            }
        }
    }

    //! All triangles that change are around the new point.
    void insert(const Place& place, Face near, double size) {
        const Vertex v = plane_.insert(place, near);
        v->info() = {count_++, kNoSide, size};
        auto face = plane_.incident_faces(v);
        const auto end = face;
        do face->info() = kInside;
        while (++face != end);
    }

    double size_at(const Place& place, Face face) const {
        double size = options_.largest_edge;
        for (int i = 0; i < 3; ++i)
            if (!plane_.is_infinite(face->vertex(i)))
                size = std::min(
                    size, face->vertex(i)->info().size + kGrowth * distance(place, face->vertex(i)->point()));
        return size;
    }

    //! Points in the middle of circles that are too large, the largest first, until none is, or as many as may be.
    void refine() {
        struct Candidate {
            double excess;
            Place place, centroid;
            Face near;  // it may turn into another one there, but stays one
        };
        const std::size_t most = count_ + options_.most_added;
        for (std::size_t pass = 0; pass < kPasses && count_ < most; ++pass) {
            std::vector<Candidate> candidates;
            for (const Face face : plane_.finite_face_handles()) {
                if (face->info() != kInside) continue;
                const Place center = plane_.circumcenter(face);
                const double radius = distance(center, face->vertex(0)->point()),
                             size = size_at(center, face);
                if (radius > kLargestRadius * size)
                    candidates.push_back({radius / size, center, centroid(face), face});
            }
            std::ranges::sort(candidates, [](const Candidate& a, const Candidate& b) {
                return std::tuple(-a.excess, a.place.x(), a.place.y()) <
                       std::tuple(-b.excess, b.place.x(), b.place.y());
            });
            const std::uint32_t before = count_;
            for (const Candidate& candidate : candidates)
                if (count_ < most && !insert_if_free(candidate.place, candidate.near))
                    insert_if_free(candidate.centroid, candidate.near);
            if (count_ == before) return;
        }
    }

    static Place centroid(Face face) {
        return CGAL::centroid(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point());
    }

    //! Unless it is outside, or close to a corner or a ring's edge.
    bool insert_if_free(const Place& place, Face near) {
        if (!std::isfinite(place.x()) || !std::isfinite(place.y())) return false;
        Triangulation::Locate_type type{};
        int corner = 0;
        const Face face = plane_.locate(place, type, corner, near);
        if (plane_.is_infinite(face) || face->info() != kInside) return false;
        const double size = size_at(place, face);
        for (int i = 0; i < 3; ++i) {
            if (distance(place, face->vertex(i)->point()) < kLeastDistance * size) return false;
            if (is_close_to_ring(place, face, i, size)) return false;
            const Face next = face->neighbor(i);
            if (face->is_constrained(i) || next->info() != kInside) continue;
            for (int k = 0; k < 3; ++k)
                if (is_close_to_ring(place, next, k, size)) return false;
        }
        insert(place, face, size);
        return true;
    }

    static bool is_close_to_ring(const Place& p, Face face, int edge, double size) {
        if (!face->is_constrained(edge)) return false;
        const Place &a = face->vertex(Triangulation::ccw(edge))->point(),
                    &b = face->vertex(Triangulation::cw(edge))->point();
        const double length = distance(a, b), reach = kLeastDistance * std::min(size, length);
        const double across =
            ((b.x() - a.x()) * (p.y() - a.y()) - (p.x() - a.x()) * (b.y() - a.y())) / length;
        const double along = ((p.x() - a.x()) * (b.x() - a.x()) + (p.y() - a.y()) * (b.y() - a.y())) / length;
        return std::abs(across) < reach && along > -reach && along < length + reach;
    }

    //! Each split takes one such edge away and makes none.
    void split_chords() {
        std::vector<std::pair<Vertex, Vertex>> chords;
        for (const auto& [face, i] : plane_.finite_edges()) {
            if (face->is_constrained(i) || face->info() != kInside) continue;
            const Vertex a = face->vertex(Triangulation::ccw(i)), b = face->vertex(Triangulation::cw(i));
            if (a->info().side != kNoSide && a->info().side == b->info().side)
                chords.push_back(std::minmax(
                    a, b, [](Vertex u, Vertex v) { return u->info().number < v->info().number; }));
        }
        std::ranges::sort(chords, {}, [](const auto& c) {
            return std::pair(c.first->info().number, c.second->info().number);
        });
        for (const auto& [a, b] : chords) {
            Face face{};
            int i = 0;
            if (!plane_.is_edge(a, b, face, i)) continue;  // gone with another one
            const Place middle = CGAL::midpoint(a->point(), b->point());
            if (middle == a->point() || middle == b->point())
                throw InvalidInput("rings around a region are too close to part them");
            insert(middle, face, size_at(middle, face));
        }
    }

    RegionTriangulationOptions options_;
    Triangulation plane_;
    std::uint32_t count_ = 0;
};

}  // namespace

RegionTriangulation triangulate_region(std::span<const RegionRing> rings, std::span<const RegionPoint> inside,
                                       const RegionTriangulationOptions& options) {
    RegionMesher mesher(rings, options);
    for (const RegionPoint& p : inside) mesher.insert_inside(p);
    return mesher.run();
}

}  // namespace stratareeb
