// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/contour_trace.h"

namespace stratareeb {

namespace {

using Halfedge = TriMesh::HalfedgeHandle;

Point3 crossing(const TriMesh& mesh, const ScalarField& field, double level, Halfedge h) {
    const auto from = mesh.from_vertex_handle(h), to = mesh.to_vertex_handle(h);  // from above to below
    const double high = field[static_cast<std::size_t>(from.idx())],
                 low = field[static_cast<std::size_t>(to.idx())];
    const auto p = mesh.point(from) + (high - level) / (high - low) * (mesh.point(to) - mesh.point(from));
    return {p[0], p[1], p[2]};
}

}  // namespace

Contour trace_contour(const TriMesh& mesh, const ScalarField& field, double level, Halfedge start) {
    Contour contour{.points = {}, .closed = false};
    Halfedge in = start;
    while (true) {
        const Point3 point = crossing(mesh, field, level, in);
        if (contour.points.empty() || !(contour.points.back() == point)) contour.points.push_back(point);
        if (mesh.is_boundary(in)) return contour;
        // Of the triangle's other two half-edges one leads up through the level: the way out.
        Halfedge out = mesh.next_halfedge_handle(in);
        const auto apex = static_cast<std::size_t>(mesh.to_vertex_handle(out).idx());
        if (field[apex] < level) out = mesh.next_halfedge_handle(out);
        in = mesh.opposite_halfedge_handle(out);
        if (in == start) break;
    }
    contour.closed = true;
    while (contour.points.size() > 1 && contour.points.front() == contour.points.back())
        contour.points.pop_back();
    return contour;
}

}  // namespace stratareeb
