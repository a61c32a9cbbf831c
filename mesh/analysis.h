// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesh/tri_mesh.h"
#include "mesh/triangle_soup.h"

namespace stratareeb {

//! The health of a mesh. Lengths, areas and volumes are in (squared, cubed) input units.
struct MeshReport {
    std::size_t vertices = 0;  // as in the file, unused ones too
    std::size_t unused_vertices = 0;
    std::size_t triangles = 0;
    std::size_t components = 0;        // joined by shared vertices; unused vertices are none
    long long euler = 0;               // used vertices - edges + triangles that name three vertices
    std::optional<std::size_t> genus;  // handles, summed over components, boundary loops thought filled;
                                       // none for a surface that is not manifold or not orientable

    std::size_t boundary_edges = 0;
    std::size_t boundary_loops = 0;         // after taking apart fans that touch in one vertex only
    std::size_t non_manifold_edges = 0;     // more than two triangles
    std::size_t non_manifold_vertices = 0;  // more than one fan of triangles
    std::size_t misoriented_edges = 0;      // triangles on both sides run along it the same way
    std::size_t degenerate_triangles = 0;   // no area, decided exactly
    std::size_t self_intersections = 0;     // pairs of triangles, decided exactly
    std::size_t inverted_components = 0;    // closed components that don't enclose a positive volume

    bool closed = false;      // has triangles, and no edge has one only
    bool manifold = false;    // at most two triangles an edge, one fan a vertex
    bool oriented = false;    // neighbours are wound the same way
    bool orientable = false;  // or could be
    bool watertight =
        false;  // closed, manifold, oriented outward, no self-intersection, no degenerate triangle

    double volume = 0;  // signed; means something for a closed mesh only
    double area = 0;
    Point3 box_min, box_max;
    double min_edge = 0, max_edge = 0;
    double min_angle_deg = 0, max_angle_deg = 0;
    double worst_aspect_ratio = 0;  // longest side over the height on it: 1.155 for an equilateral triangle
    std::optional<std::uint32_t> worst_triangle;
    Point3 worst_place;  // its centroid

    std::vector<std::string> problems;  // one sentence each, naming a place; empty = watertight
};

struct AnalysisOptions {
    bool self_intersections = true;  // the slowest part; false takes their absence for granted
};

//! Examine any triangles, sound or not.
//! \throw InvalidInput if a triangle names a vertex that is not there.
MeshReport analyze(const TriangleSoup& soup, const AnalysisOptions& options = {});
MeshReport analyze(const TriMesh& mesh, const AnalysisOptions& options = {});

//! Signed volume by the divergence theorem around the middle of the box, with compensated summation: no
//! precision is lost far from the origin. Positive if the triangles are counter-clockwise seen from outside.
double volume(const TriangleSoup& soup);
double volume(const TriMesh& mesh);

double area(const TriangleSoup& soup);
double area(const TriMesh& mesh);

//! Has triangles, and no edge has one only.
bool is_closed(const TriMesh& mesh);

}  // namespace stratareeb
