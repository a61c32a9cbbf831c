// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// QuadricT.hh does not include what it uses.
// clang-format off
#include <OpenMesh/Core/Utils/vector_traits.hh>
#include <OpenMesh/Core/Geometry/QuadricT.hh>
// clang-format on

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/moving_box_tree.h"
#include "mesh/surface_distance.h"
#include "mesh/tri_mesh.h"
#include "mesh/triangle_soup.h"

namespace stratareeb {

//! A mesh while vertices are taken out of it by half-edge collapses: which may go, into which neighbour, at what quadric
//! error, and whether the surface stays near. Faces and vertices keep their numbers; deleted ones are marked.
class SurfaceCollapse {
 public:
    using Vertex = TriMesh::VertexHandle;
    using Halfedge = TriMesh::HalfedgeHandle;
    using Face = TriMesh::FaceHandle;

    struct Limits {
        std::optional<double> distance;  // between what was and what is, both ways
        double sample_spacing = 0;       // of the places that stand for a new triangle
        double min_cosine = 0;           // between a triangle's normals before and after
        double min_sine = 0;             // of the angles of new triangles
        double straight = 0;             // what counts as straight of a boundary
        bool crossings = false;          // may appear
    };

    struct Choice {
        Halfedge into;  // from the vertex to the neighbour that takes its place
        double error = 0;
        double length = 0;
    };

    //! \param mesh around the origin
    //! \param soup the same triangles and vertices where they really are; crossings are looked for there
    //! \param kept vertices that have to stay (not 0), one for each vertex
    SurfaceCollapse(const TriMesh& mesh, const TriangleSoup& soup, std::vector<char> kept,
                    const Limits& limits);

    //! The ways to take v out that keep topology and shape, the best first. Distance is not looked at.
    std::vector<Choice> choices(Vertex v);

    //! Whether the surface stays near enough and does not come to cross itself.
    bool is_sound(Halfedge into);

    //! Take the vertex out. \pre choices() names the way
    void collapse(Halfedge into);

    const TriMesh& mesh() const { return mesh_; }
    std::size_t triangles() const { return triangles_; }

 private:
    using Point = TriMesh::Point;
    using Quadric = OpenMesh::Geometry::QuadricT<double>;
    using Corners = std::array<Point, 3>;
    static constexpr std::uint32_t kNone = ~0u;

    struct Fan {  // the triangles around a vertex that stay
        std::vector<Face> faces;
        std::vector<Corners> before, after;
        std::vector<std::array<std::uint32_t, 3>> vertices;  // after
    };

    void add_quadrics();
    Fan fan_of(Halfedge into) const;
    bool keeps_topology(Halfedge into);
    bool keeps_boundary(Halfedge into) const;
    bool keeps_shape(Halfedge into) const;
    bool is_near(Halfedge into) const;
    bool comes_to_cross(Halfedge into);
    void update_boxes(const Fan& fan);
    bool is_near_new(const Corners& triangle) const;
    bool is_near_old(Vertex gone, const Fan& fan) const;

    Limits limits_;
    TriMesh mesh_;
    TriangleSoup soup_;
    std::optional<MovingBoxTree> boxes_;
    std::size_t triangles_;
    std::vector<char> kept_;
    std::vector<Quadric> quadric_;
    std::optional<SurfaceDistance> original_;
    std::vector<std::uint32_t> first_in_face_,
        next_in_face_;  // removed vertices, by the triangle nearest to them
};

}  // namespace stratareeb
