// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/plan_mesh.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hilbert_sort_2.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "boreholes/errors.h"
#include "mesh/clip_lines.h"

namespace stratareeb {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// Vertices that CGAL makes itself, in refinement and where lines cross, start without a number.
struct VertexNumber {
    std::uint32_t value = PlanMesh::kNoVertex;
};

using VertexBase =
    CGAL::Delaunay_mesh_vertex_base_2<Kernel,
                                      CGAL::Triangulation_vertex_base_with_info_2<VertexNumber, Kernel>>;

struct Visit {
    bool done = false;
};

using FaceBase = CGAL::Delaunay_mesh_face_base_2<
    Kernel, CGAL::Constrained_Delaunay_triangulation_face_base_2<
                Kernel, CGAL::Constrained_triangulation_face_base_2<
                            Kernel, CGAL::Triangulation_face_base_with_info_2<Visit, Kernel>>>>;
using DataStructure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, DataStructure, CGAL::Exact_predicates_tag>;
using SizeCriteria = CGAL::Delaunay_mesh_size_criteria_2<Cdt>;

//! Angles and sizes, but nothing is asked of triangles with a very short edge: where given lines meet at a small angle,
//! refinement may halve the same two edges in turn without end.
class Criteria : public SizeCriteria {
 public:
    Criteria(double squared_sine, double size, double shortest)
        : SizeCriteria(squared_sine, size), squared_shortest_(shortest * shortest) {}

    // The mesher's name for it. NOLINTNEXTLINE(readability-identifier-naming)
    class Is_bad : public SizeCriteria::Is_bad {
     public:
        Is_bad(double squared_sine, double size, double squared_shortest, const Kernel& traits)
            : SizeCriteria::Is_bad(squared_sine, size, traits), squared_shortest_(squared_shortest) {}

        using SizeCriteria::Is_bad::operator();
        CGAL::Mesh_2::Face_badness operator()(const Cdt::Face_handle& face, Quality& quality) const {
            for (int i = 0; i < 3; ++i)
                if (CGAL::squared_distance(face->vertex(i)->point(), face->vertex(Cdt::ccw(i))->point()) <
                    squared_shortest_) {
                    quality = Quality(1, 0);
                    return CGAL::Mesh_2::NOT_BAD;
                }
            return SizeCriteria::Is_bad::operator()(face, quality);
        }

     private:
        double squared_shortest_;
    };
    Is_bad is_bad_object() const { return {bound(), size_bound(), squared_shortest_, traits}; }

 private:
    double squared_shortest_;
};

using CgalPoint = Kernel::Point_2;

constexpr double kOnRing =
    1e-9;  // of the extent: points as close to the outline as that become corners of it
constexpr double kRingOfHole = 1.0 / 3, kRingOfLine = 0.5;   // of the way from a hole to what is closest
constexpr double kWidestRing = 0.75, kNarrowestRing = 0.02;  // of the spacing
constexpr double kFrameMargin = 0.25;  // of the extent: keeps the outline off the triangulation's own hull

double extent_of(const Footprint& footprint) {
    double x0 = footprint[0][0].x, x1 = x0, y0 = footprint[0][0].y, y1 = y0;
    for (const auto& ring : footprint)
        for (const Point2& p : ring) {
            x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
            y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
        }
    return std::hypot(x1 - x0, y1 - y0);
}

class PlanBuilder {
 public:
    PlanBuilder(const Footprint& footprint, const std::vector<Point2>& holes, const PlanLines& lines)
        : holes_(holes) {
        const double tolerance = kOnRing * extent_of(footprint);
        lines_ = clipped_lines(lines, footprint, tolerance);
        snap_to_corners(footprint, tolerance);
        std::vector<Point2> given = holes;
        given.insert(given.end(), lines_.points.begin(), lines_.points.end());
        footprint_ = with_points_on_rings(footprint, given, tolerance);
    }

    void triangulate(const PlanMeshOptions& options) {
        insert_frame();
        const auto handles = insert_points();
        std::size_t first = holes_.size() + lines_.points.size();
        for (const auto& ring : footprint_) {
            for (std::size_t i = 0; i < ring.size(); ++i)
                constrain(handles[first + i], handles[first + (i + 1) % ring.size()]);
            first += ring.size();
        }
        for (const auto& [a, b] : lines_.segments)
            constrain(handles[holes_.size() + a], handles[holes_.size() + b]);
        if (options.ring_holes && options.spacing > 0) insert_rings(options.spacing);
        mark_domain();
    }

    void refine(const PlanMeshOptions& options) {
        const double sine = std::sin(options.min_angle_deg * std::numbers::pi / 180);
        CGAL::Delaunay_mesher_2<Cdt, Criteria> mesher(
            cdt_, Criteria(sine * sine, options.spacing, shortest_useful(options.spacing)));
        mesher.init(true);
        constexpr std::size_t kReportEvery = 4096;
        for (std::size_t steps = 0; !mesher.is_refinement_done(); ++steps) {
            mesher.step_by_step_refine_mesh();
            if (options.progress && steps % kReportEvery == 0) options.progress(cdt_.number_of_vertices());
        }
    }

    PlanMesh take() {
        PlanMesh plan;
        number_holes(plan);
        for (const auto face : cdt_.finite_face_handles())
            if (face->is_in_domain()) add_face(plan, face);
        return plan;
    }

 private:
    //! A line that meets the outline in a corner, but for rounding, ends in that corner.
    void snap_to_corners(const Footprint& footprint, double tolerance) {
        std::vector<Point2> corners;
        for (const auto& ring : footprint) corners.insert(corners.end(), ring.begin(), ring.end());
        std::ranges::sort(corners, {}, [](const Point2& p) { return std::pair(p.x, p.y); });
        for (Point2& p : lines_.points)
            for (auto c = std::ranges::lower_bound(corners, p.x - tolerance, {}, &Point2::x);
                 c != corners.end() && c->x <= p.x + tolerance; ++c)
                if (std::abs(c->y - p.y) <= tolerance) p = *c;
        std::erase_if(lines_.segments,
                      [this](const auto& s) { return lines_.points[s[0]] == lines_.points[s[1]]; });
    }

    //! Edges much shorter than what was given serve nobody, nor do hair-breadths where lines all but touch.
    double shortest_useful(double spacing) const {
        constexpr double kShare = 0.02, kHair = 1e-4;
        double shortest = spacing * spacing;
        for (const auto& edge : cdt_.finite_edges())
            shortest = std::min(shortest, cdt_.segment(edge).squared_length());
        return std::max(kShare * std::sqrt(shortest), kHair * spacing);
    }

    // Four far points around everything: no outline edge is then an edge of the hull, where a rounded
    // midpoint could fall outside of the triangulation.
    void insert_frame() {
        double x0 = footprint_[0][0].x, x1 = x0, y0 = footprint_[0][0].y, y1 = y0;
        const auto widen = [&](const Point2& p) {
            x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
            y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
        };
        for (const auto& ring : footprint_) std::ranges::for_each(ring, widen);
        std::ranges::for_each(holes_, widen);
        std::ranges::for_each(lines_.points, widen);
        const double margin = kFrameMargin * std::hypot(x1 - x0, y1 - y0);
        for (const double x : {x0 - margin, x1 + margin})
            for (const double y : {y0 - margin, y1 + margin}) cdt_.insert(CgalPoint(x, y));
    }

    // Holes, then the lines' points, then the outline's corners; the same place is the same vertex.
    std::vector<Cdt::Vertex_handle> insert_points() {
        std::vector<CgalPoint> points;
        for (const Point2& p : holes_) points.emplace_back(p.x, p.y);
        for (const Point2& p : lines_.points) points.emplace_back(p.x, p.y);
        for (const auto& ring : footprint_)
            for (const Point2& p : ring) points.emplace_back(p.x, p.y);
        std::vector<std::uint32_t> order(points.size());
        std::iota(order.begin(), order.end(), 0u);
        using Map = CGAL::Pointer_property_map<CgalPoint>::const_type;
        using Traits = CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>;
        CGAL::Hilbert_sort_2<Traits, CGAL::Hilbert_sort_median_policy> sort(Traits(Map(points.data())));
        sort(order.begin(), order.end());

        std::vector<Cdt::Vertex_handle> handles(points.size());
        Cdt::Face_handle near;
        for (const std::uint32_t i : order) {
            handles[i] = cdt_.insert(points[i], near);
            if (i < holes_.size()) handles[i]->info().value = i;
            near = handles[i]->face();
        }
        return handles;
    }

    void constrain(Cdt::Vertex_handle a, Cdt::Vertex_handle b) {
        if (a != b) cdt_.insert_constraint(a, b);
    }

    void insert_rings(double spacing) {
        std::vector<CgalPoint> points;
        for (const auto vertex : cdt_.finite_vertex_handles()) {
            if (vertex->info().value >= holes_.size()) continue;
            const double radius = std::min(kWidestRing * spacing, room_around(vertex));
            if (radius < kNarrowestRing * spacing) continue;
            for (int k = 0; k < 6; ++k) {
                const double angle = k * std::numbers::pi / 3;
                points.emplace_back(vertex->point().x() + radius * std::cos(angle),
                                    vertex->point().y() + radius * std::sin(angle));
            }
        }
        cdt_.insert(points.begin(), points.end());
    }

    // What is closest to a hole is among its neighbours and the edges that face it. 0 on lines and the outline.
    double room_around(Cdt::Vertex_handle hole) const {
        double room = std::numeric_limits<double>::max();
        auto face = cdt_.incident_faces(hole), first = face;
        do {
            const int i = face->index(hole);
            if (face->is_constrained(cdt_.cw(i)) || face->is_constrained(cdt_.ccw(i))) return 0;
            const auto a = face->vertex(cdt_.ccw(i)), b = face->vertex(cdt_.cw(i));
            const double share = a->info().value < holes_.size() ? kRingOfHole : kRingOfLine;
            room = std::min(room, share * std::sqrt(CGAL::squared_distance(hole->point(), a->point())));
            if (face->is_constrained(i))
                room = std::min(room,
                                kRingOfLine * std::sqrt(CGAL::squared_distance(
                                                  hole->point(), Kernel::Segment_2(a->point(), b->point()))));
        } while (++face != first);
        return room;
    }

    // Regions bounded by constrained edges lie wholly inside or wholly outside of the outline: ask one face
    // of each, the largest, whose centre is the farthest from any doubt.
    void mark_domain() {
        const InsideTest is_inside(footprint_);
        std::vector<Cdt::Face_handle> region;
        for (const auto face : cdt_.all_face_handles()) face->set_in_domain(false);
        for (const auto seed : cdt_.finite_face_handles()) {
            if (seed->info().done) continue;
            region.assign(1, seed);
            seed->info().done = true;
            for (std::size_t next = 0; next < region.size(); ++next)
                for (int i = 0; i < 3; ++i) {
                    const auto other = region[next]->neighbor(i);
                    if (region[next]->is_constrained(i) || other->info().done || cdt_.is_infinite(other))
                        continue;
                    other->info().done = true;
                    region.push_back(other);
                }
            const auto largest =
                *std::ranges::max_element(region, {}, [&](auto f) { return cdt_.triangle(f).area(); });
            const CgalPoint centre = CGAL::centroid(cdt_.triangle(largest));
            const bool inside = is_inside({centre.x(), centre.y()});
            for (const auto face : region) face->set_in_domain(inside);
        }
    }

    // Holes come first, in their order; from here on a vertex's number is that in the mesh.
    void number_holes(PlanMesh& plan) {
        std::vector<Cdt::Vertex_handle> used(holes_.size());
        for (const auto face : cdt_.finite_face_handles())
            if (face->is_in_domain())
                for (int i = 0; i < 3; ++i)
                    if (const auto hole = face->vertex(i)->info().value; hole < holes_.size())
                        used[hole] = face->vertex(i);
        for (const auto vertex : cdt_.finite_vertex_handles()) vertex->info() = {};
        plan.hole_vertex.assign(holes_.size(), PlanMesh::kNoVertex);
        for (std::size_t hole = 0; hole < holes_.size(); ++hole)
            if (used[hole] != nullptr)
                plan.hole_vertex[hole] = static_cast<std::uint32_t>(mesh_vertex(plan, used[hole]).idx());
    }

    TriMesh::VertexHandle mesh_vertex(PlanMesh& plan, Cdt::Vertex_handle vertex) {
        std::uint32_t& number = vertex->info().value;
        if (number == PlanMesh::kNoVertex)
            number = static_cast<std::uint32_t>(
                plan.surface.add_vertex({vertex->point().x(), vertex->point().y(), 0}).idx());
        return TriMesh::VertexHandle(static_cast<int>(number));
    }

    void add_face(PlanMesh& plan, Cdt::Face_handle face) {
        const CgalPoint &p = face->vertex(0)->point(), &q = face->vertex(1)->point(),
                        &r = face->vertex(2)->point();
        if (CGAL::orientation(p, q, r) != CGAL::LEFT_TURN)
            throw GeometryError(fmt::format(
                "the plan triangulation folds over near x {:.10g}, y {:.10g} (give a larger --spacing)",
                p.x(), p.y()));
        const auto added =
            plan.surface.add_face(mesh_vertex(plan, face->vertex(0)), mesh_vertex(plan, face->vertex(1)),
                                  mesh_vertex(plan, face->vertex(2)));
        if (!added.is_valid()) throw GeometryError("the footprint touches itself at a point");
    }

    const std::vector<Point2>& holes_;
    PlanLines lines_;
    Footprint footprint_;
    Cdt cdt_;
};

}  // namespace

PlanMesh build_plan_mesh(const Footprint& footprint, const std::vector<Point2>& holes, const PlanLines& lines,
                         const PlanMeshOptions& options) {
    PlanBuilder builder(footprint, holes, lines);
    builder.triangulate(options);
    if (options.spacing > 0) builder.refine(options);
    return builder.take();
}

double suitable_spacing(const Footprint& footprint, std::size_t holes) {
    constexpr double kTrianglesPerHole = 9, kFewestTriangles = 2500;
    const double triangles = std::max(kTrianglesPerHole * static_cast<double>(holes), kFewestTriangles);
    return std::sqrt(4 / std::numbers::sqrt3 * area(footprint) / triangles);
}

}  // namespace stratareeb
