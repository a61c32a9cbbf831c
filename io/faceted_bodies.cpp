// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/faceted_bodies.h"

#include <BRep_Builder.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <unordered_map>

#include <fmt/format.h>

#include "boreholes/errors.h"
#include "mesh/planar_bodies.h"

namespace stratareeb {
namespace {

constexpr double kTolerance = 1e-7;  // OpenCASCADE's notion of "the same point"

// Turns one shell into OpenCASCADE's boundary representation. Every mesh vertex and every side of a polygon
// is one shared object, so the shell is closed by construction and nothing needs sewing.
class ShellBuilder {
 public:
    explicit ShellBuilder(const PlanarShell& shell) : mesh_(shell.mesh), faces_(shell.faces) {}

    TopoDS_Shell build() {
        TopoDS_Shell result;
        builder_.MakeShell(result);
        for (const auto& region : faces_) builder_.Add(result, face(region));
        result.Closed(true);
        return result;
    }

 private:
    TopoDS_Face face(const PlanarRegion& region) {
        const gp_Pnt at(region.point.x, region.point.y, region.point.z);
        const gp_Dir normal(region.normal.x, region.normal.y, region.normal.z);
        const gp_Pnt a = point(region.loops[0][0]), b = point(region.loops[0][1]);
        TopoDS_Face result;
        builder_.MakeFace(result, new Geom_Plane(gp_Ax3(at, normal, gp_Vec(a, b))), kTolerance);
        for (const auto& loop : region.loops) builder_.Add(result, wire(loop));
        return result;
    }

    TopoDS_Wire wire(const std::vector<std::uint32_t>& loop) {
        TopoDS_Wire result;
        builder_.MakeWire(result);
        for (std::size_t i = 0; i < loop.size(); ++i)
            builder_.Add(result, edge(loop[i], loop[(i + 1) % loop.size()]));
        result.Closed(true);
        return result;
    }

    TopoDS_Edge edge(std::uint32_t from, std::uint32_t to) {
        const auto [low, high] = std::minmax(from, to);
        auto& shared = edges_[(std::uint64_t{low} << 32) | high];
        if (shared.IsNull()) shared = new_edge(low, high);
        return TopoDS::Edge(shared.Oriented(from == low ? TopAbs_FORWARD : TopAbs_REVERSED));
    }

    TopoDS_Edge new_edge(std::uint32_t from, std::uint32_t to) {
        const gp_Vec along(point(from), point(to));
        TopoDS_Edge result;
        builder_.MakeEdge(result, new Geom_Line(point(from), gp_Dir(along)), kTolerance);
        builder_.Add(result, vertex(from).Oriented(TopAbs_FORWARD));
        builder_.Add(result, vertex(to).Oriented(TopAbs_REVERSED));
        builder_.Range(result, 0, along.Magnitude());
        return result;
    }

    const TopoDS_Vertex& vertex(std::uint32_t v) {
        auto& shared = vertices_[v];
        if (shared.IsNull()) builder_.MakeVertex(shared, point(v), kTolerance);
        return shared;
    }

    gp_Pnt point(std::uint32_t v) const {
        const auto& p = mesh_.point(TriMesh::VertexHandle(static_cast<int>(v)));
        return {p[0], p[1], p[2]};
    }

    const TriMesh& mesh_;
    const std::vector<PlanarRegion>& faces_;
    BRep_Builder builder_;
    std::unordered_map<std::uint32_t, TopoDS_Vertex> vertices_;
    std::unordered_map<std::uint64_t, TopoDS_Edge> edges_;  // by their two vertices, the lower first
};

TopoDS_Solid solid(const PlanarBody& body) {
    BRep_Builder builder;
    TopoDS_Solid result;
    builder.MakeSolid(result);
    builder.Add(result, ShellBuilder(body.outer).build());
    for (const auto& cavity : body.cavities) builder.Add(result, ShellBuilder(cavity).build());
    return result;
}

}  // namespace

std::vector<CadBody> faceted_bodies(const LayerSolid& layer) {
    std::vector<CadBody> bodies;
    try {
        for (const auto& body : planar_bodies(layer.surface))
            bodies.push_back({.name = body_name(layer.unit, bodies.size()),
                              .color = rgb_from_text(layer.unit.color),
                              .solid = std::make_shared<const TopoDS_Shape>(solid(body))});
    } catch (const InvalidInput& e) {
        throw InvalidInput(fmt::format("layer '{}': {}", body_name(layer.unit, 0), e.what()));
    }
    return bodies;
}

}  // namespace stratareeb
