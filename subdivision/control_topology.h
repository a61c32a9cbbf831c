// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "boreholes/point.h"
#include "subdivision/control_mesh.h"
#include "subdivision/sparse_rows.h"

namespace stratareeb {

//! Points on the limit surface and its unit normals there, (0, 0, 1) where it has none.
struct LimitSurface {
    std::vector<Point3> points, normals;
};

//! Limits need neighbours in the last level, which cost memory and time.
enum class LimitsWanted { Yes, No };

//! What a vertex lies on; the surface has one normal inside and on outlines.
enum class VertexKind : std::uint8_t { Inside, Outline, Crease, Corner };

//! A control mesh and its uniform refinement by OpenSubdiv, held for as many values as one likes. The outline is a smooth curve
//! that ends at sharp corners. Vertices keep their numbers: those of a level come first in the next. The
//! limit of a vertex that is still semi-sharp in the last level is the one it has if it stays sharp from there on.
class ControlTopology {
 public:
    //! \throw InvalidInput naming the place: a vertex that is not there; a face that is no polygon, or no triangle where the scheme is
    //! Loop; an edge of more than two faces or wound the same way by both; a vertex where two fans meet; a crease that is no edge;
    //! counts beyond 2^31
    ControlTopology(const ControlMesh& mesh, int levels, LimitsWanted limits = LimitsWanted::Yes);
    ~ControlTopology();
    ControlTopology(ControlTopology&&) noexcept;
    ControlTopology& operator=(ControlTopology&&) noexcept;

    int levels() const;
    //! Of a level, 0 = the control mesh.
    std::size_t vertex_count(int level) const;
    std::size_t face_count(int level) const;
    //! The corners of all faces of a level, face after face: three each (Loop), from level 1 on four each (Catmull-Clark).
    std::vector<std::uint32_t> corners(int level) const;

    //! Values at the vertices of the last level, from one for each control vertex.
    std::vector<double> refined(std::span<const double> control) const;
    std::vector<Point3> refined(std::span<const Point3> control) const;

    //! Limits at the vertices of the last level, from their refined values.
    //! \pre made with LimitsWanted::Yes
    std::vector<double> limit(std::span<const double> refined) const;
    std::vector<Point3> limit(std::span<const Point3> refined) const;
    LimitSurface limit_surface(std::span<const Point3> refined) const;
    //! What the vertices of the last level lie on.
    std::vector<VertexKind> kinds() const;

    //! Each vertex of the last level as weights of control vertices: to apply them is faster than `refined` for many values, but it
    //! takes the time of some fifty.
    SparseRows refined_rows() const;

    //! The limit of each control vertex as weights of control vertices that add up to one.
    //! \pre no semi-sharp creases or corners; the scheme's own faces only (Catmull-Clark: quads)
    SparseRows limit_rows(std::span<const std::uint32_t> control_vertices) const;

 private:
    struct Osd;
    std::unique_ptr<Osd> osd_;
};

}  // namespace stratareeb
