// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_soup.h"
#include "reeb/plan_sheet.h"
#include "reeb/sampled_contour.h"

namespace stratareeb {

//! A contour whose points are vertices of a surface. A single point is the tip of a cap.
struct Ring {
    SampledContour shape;
    std::vector<std::uint32_t> vertices;
};

//! The same ring with parameters counted from `origin` (see with_origin of contours).
Ring with_origin(const Ring& ring, double origin);

enum class BandTriangulation {
    Automatic,  // least area where that is quick, else greedy
    Exact,      // least area
    Greedy,     // shortest next span
};

//! Which coordinates of a vertex no given contour holds fast.
enum class Freedom : std::uint8_t { None, Height, Space };

//! By vertex: what may move, and the part of the surface with which it moves.
struct FreeVertices {
    static constexpr std::uint32_t kNoGroup = ~0u;

    std::vector<Freedom> freedom;
    std::vector<std::uint32_t> group;
};

//! A surface that grows band by band between rings.
class BandSurface {
 public:
    //! Bands of no more than so many spans are triangulated exactly by BandTriangulation::Automatic.
    static constexpr std::size_t kQuickSpans = 4'000'000;

    explicit BandSurface(BandTriangulation triangulation) : triangulation_(triangulation) {}

    std::uint32_t add_point(const Point3& p);
    Ring add_ring(SampledContour shape);
    void let_free(std::uint32_t vertex, Freedom freedom, std::uint32_t group) {
        free_.freedom[vertex] = freedom;
        free_.group[vertex] = group;
    }
    void let_free(const Ring& ring, Freedom freedom, std::uint32_t group) {
        for (const std::uint32_t vertex : ring.vertices) let_free(vertex, freedom, group);
    }
    const FreeVertices& free_vertices() const { return free_; }
    //! \pre no triangle has them
    void drop_points_from(std::size_t first) {
        soup_.points.resize(first);
        resize_free(first);
    }
    //! What is added from now on belongs to this part.
    void begin_part(std::uint32_t part) { part_ = part; }
    //! Triangles between two rings, both counter-clockwise seen from above, facing outward, or inward around a hole. Where one
    //! has all parameters of the other they are joined parameter by parameter.
    void add_band(const Ring& lower, const Ring& upper, bool is_hole);
    //! The same by least area, unless that joins a vertex that is on one ring twice to the same vertex of the other: then nothing.
    bool add_sound_band(const Ring& lower, const Ring& upper, bool is_hole);
    //! A sheet between rings whose vertices, ring by ring, are these; its own move up and down if they have a group.
    void add_sheet(const PlanSheet& sheet, std::vector<std::uint32_t> vertices, std::uint32_t group);
    //! The flat inside of a ring, facing up at a top.
    //! \throw InvalidInput if the ring crosses or touches itself
    void add_flat_cap(const Ring& ring, bool is_top, bool is_hole);

    const std::vector<Point3>& points() const { return soup_.points; }
    const TriangleSoup& soup() const { return soup_; }
    const std::vector<std::uint32_t>& triangle_parts() const { return parts_; }

 private:
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turned);
    void resize_free(std::size_t size) {
        free_.freedom.resize(size, Freedom::None);
        free_.group.resize(size, FreeVertices::kNoGroup);
    }
    void join_by_parameters(const Ring& few, const Ring& many, bool turned);
    void add_side(std::uint32_t a, std::uint32_t b, const std::vector<std::uint32_t>& side, bool turned);

    BandTriangulation triangulation_;
    TriangleSoup soup_;
    std::vector<std::uint32_t> parts_;  // by triangle
    FreeVertices free_;
    std::uint32_t part_ = 0;
};

}  // namespace stratareeb
