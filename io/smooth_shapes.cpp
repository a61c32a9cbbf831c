// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/smooth_shapes.h"

#include <BRep_Builder.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>

#include "subdivision/face_spans.h"

namespace stratareeb {
namespace {

constexpr double kTolerance = 1e-7;  // OpenCASCADE's notion of "the same point"
constexpr double kSlack = 1.5;       // distances are measured at samples
constexpr std::uint32_t kNone = PlanCells::kNone;

struct OcctKnots {
    TColStd_Array1OfReal places;
    TColStd_Array1OfInteger multiplicities;
};

OcctKnots occt_knots(const CubicKnots& knots) {
    const auto& breaks = knots.breaks();
    const int n = static_cast<int>(breaks.size());
    OcctKnots result{{1, n}, {1, n}};
    for (int i = 1; i <= n; ++i) {
        result.places(i) = breaks[static_cast<std::size_t>(i) - 1];
        result.multiplicities(i) = i == 1 || i == n ? 4 : 1;
    }
    return result;
}

// Edges run from 0 to 1: OpenCASCADE's boolean operations give up an edge that coincides with one they found unless it does.
OcctKnots unit_knots(const CubicKnots& knots) {
    std::vector<double> breaks;
    for (const double b : knots.breaks()) breaks.push_back((b - knots.low()) / (knots.high() - knots.low()));
    return occt_knots(CubicKnots(std::move(breaks)));
}

Handle(Geom_Surface) patch_surface(const HeightPatch& patch) {
    const auto x = patch.x.greville(), y = patch.y.greville();
    const int nx = static_cast<int>(x.size()), ny = static_cast<int>(y.size());
    TColgp_Array2OfPnt poles(1, nx, 1, ny);
    for (int i = 0; i < nx; ++i)
        for (int j = 0; j < ny; ++j)
            poles(i + 1, j + 1) =
                gp_Pnt(x[static_cast<std::size_t>(i)], y[static_cast<std::size_t>(j)],
                       patch.coefficients[static_cast<std::size_t>(i) * static_cast<std::size_t>(ny) +
                                          static_cast<std::size_t>(j)]);
    const auto u = occt_knots(patch.x), v = occt_knots(patch.y);
    return new Geom_BSplineSurface(poles, u.places, v.places, u.multiplicities, v.multiplicities, 3, 3);
}

Handle(Geom_Curve) space_curve(const SplineCurve& curve) {
    const auto& c = curve.coefficients;
    TColgp_Array1OfPnt poles(1, static_cast<int>(c[0].size()));
    for (std::size_t i = 0; i < c[0].size(); ++i)
        poles(static_cast<int>(i) + 1) = gp_Pnt(c[0][i], c[1][i], c[2][i]);
    const auto knots = unit_knots(curve.knots);
    return new Geom_BSplineCurve(poles, knots.places, knots.multiplicities, 3);
}

Handle(Geom2d_Curve)
    parameter_curve(const CubicKnots& knots, const std::vector<double>& u, const std::vector<double>& v) {
    TColgp_Array1OfPnt2d poles(1, static_cast<int>(u.size()));
    for (std::size_t i = 0; i < u.size(); ++i) poles(static_cast<int>(i) + 1) = gp_Pnt2d(u[i], v[i]);
    const auto k = unit_knots(knots);
    return new Geom2d_BSplineCurve(poles, k.places, k.multiplicities, 3);
}

// An upright plane, its normal out of the plan.
Handle(Geom_Surface) plane_wall(const SideCurve& side) {
    const gp_Dir along(side.to.x - side.from.x, side.to.y - side.from.y, 0);
    return new Geom_Plane(gp_Ax3(gp_Pnt(side.from.x, side.from.y, 0), along.Crossed(gp_Dir(0, 0, 1)), along));
}

// A curve in plan, drawn up: parameters are the side's and z.
Handle(Geom_Surface) curved_wall(const SideCurve& side, double low, double high) {
    const auto& c = side.curve.coefficients;
    TColgp_Array2OfPnt poles(1, static_cast<int>(c[0].size()), 1, 2);
    for (std::size_t i = 0; i < c[0].size(); ++i) {
        poles(static_cast<int>(i) + 1, 1) = gp_Pnt(c[0][i], c[1][i], low);
        poles(static_cast<int>(i) + 1, 2) = gp_Pnt(c[0][i], c[1][i], high);
    }
    const auto u = occt_knots(side.curve.knots);
    TColStd_Array1OfReal v(1, 2);
    v(1) = low, v(2) = high;
    TColStd_Array1OfInteger twice(1, 2);
    twice.Init(2);
    return new Geom_BSplineSurface(poles, u.places, v, u.multiplicities, twice, 3, 1);
}

class ShapeBuilder {
 public:
    explicit ShapeBuilder(const SmoothBrep& brep) : brep_(brep) {
        make_vertices();
        for (std::uint32_t e = 0; e < brep.edges.size(); ++e) edges_.push_back(edge_pieces(e));
        for (std::uint32_t c = 0; c < brep.cells.cells.size(); ++c) cells_.push_back(cell_face(c));
    }

    TopoDS_Solid solid(const PlanCells::Body& body) {
        TopoDS_Shell shell;
        builder_.MakeShell(shell);
        for (const auto c : body.top) builder_.Add(shell, cells_[c]);
        for (const auto c : body.base) builder_.Add(shell, cells_[c].Reversed());
        for (const auto& wall : body.walls) builder_.Add(shell, wall_face(wall));
        shell.Closed(true);
        TopoDS_Solid result;
        builder_.MakeSolid(result);
        builder_.Add(result, shell);
        return result;
    }

 private:
    // A vertex reaches as far as the edges that end there.
    void make_vertices() {
        std::vector<double> tolerance(brep_.corners.size(), kTolerance);
        for (std::uint32_t e = 0; e < brep_.edges.size(); ++e) {
            const auto& off = brep_.edges[e].tolerances;
            if (off.empty()) continue;
            const auto& ends = brep_.cells.edges[e];
            tolerance[ends.from] = std::max(tolerance[ends.from], kSlack * off.front() + kTolerance);
            tolerance[ends.to] = std::max(tolerance[ends.to], kSlack * off.back() + kTolerance);
        }
        for (std::size_t i = 0; i < tolerance.size(); ++i) {
            const auto& p = brep_.corners[i];
            builder_.MakeVertex(vertices_.emplace_back(), gp_Pnt(p.x, p.y, p.z), tolerance[i]);
        }
    }

    struct Piece {
        SplineCurve curve{CubicKnots({0, 1}), {}};
        double tolerance = kTolerance;
        TopoDS_Edge edge;
    };

    std::vector<Piece> edge_pieces(std::uint32_t e) {
        const auto& ends = brep_.cells.edges[e];
        std::vector<Piece> pieces;
        if (ends.line == kNone) {
            pieces.emplace_back().edge = upright(e);
            return pieces;
        }
        const auto& curve = brep_.edges[e].curve;
        const auto breaks = cad_edge_ends(brep_.edges[e]);
        TopoDS_Vertex from = vertices_[ends.from];
        for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
            const std::size_t first = breaks[k], last = breaks[k + 1];
            Piece& piece = pieces.emplace_back(Piece{part_of(curve, first, last)});
            for (std::size_t s = first; s < last; ++s)
                piece.tolerance =
                    std::max(piece.tolerance, kSlack * brep_.edges[e].tolerances[s] + kTolerance);
            TopoDS_Vertex to =
                last == curve.knots.spans() ? vertices_[ends.to] : end_of(piece.curve, piece.tolerance);
            builder_.UpdateVertex(from, piece.tolerance);
            builder_.UpdateVertex(to, piece.tolerance);
            builder_.MakeEdge(piece.edge, space_curve(piece.curve), piece.tolerance);
            add_ends(piece.edge, from, to, 0, 1);
            from = to;
        }
        return pieces;
    }

    TopoDS_Vertex end_of(const SplineCurve& curve, double tolerance) {
        TopoDS_Vertex vertex;
        const auto& c = curve.coefficients;
        builder_.MakeVertex(vertex, gp_Pnt(c[0].back(), c[1].back(), c[2].back()), tolerance);
        return vertex;
    }

    static SplineCurve part_of(const SplineCurve& curve, std::size_t first, std::size_t last) {
        if (last - first == curve.knots.spans()) return curve;
        const auto breaks = curve.knots.breaks().begin();
        SplineCurve part{CubicKnots({breaks + static_cast<std::ptrdiff_t>(first),
                                     breaks + static_cast<std::ptrdiff_t>(last) + 1}),
                         {}};
        for (std::size_t c = 0; c < 3; ++c)
            part.coefficients.push_back(
                interpolate_spline(part.knots, [&](double t) { return curve.at(c, t); }));
        return part;
    }

    TopoDS_Edge upright(std::uint32_t e) {
        const auto& ends = brep_.cells.edges[e];
        const auto &a = brep_.corners[ends.from], &b = brep_.corners[ends.to];
        TopoDS_Edge result;
        builder_.MakeEdge(result, new Geom_Line(gp_Pnt(a.x, a.y, a.z), gp_Dir(0, 0, b.z < a.z ? -1 : 1)),
                          kTolerance);
        add_ends(result, vertices_[ends.from], vertices_[ends.to], 0, std::abs(b.z - a.z));
        return result;
    }

    void add_ends(TopoDS_Edge& edge, const TopoDS_Vertex& from, const TopoDS_Vertex& to, double first,
                  double last) {
        builder_.Add(edge, from.Oriented(TopAbs_FORWARD));
        builder_.Add(edge, to.Oriented(TopAbs_REVERSED));
        builder_.Range(edge, first, last);
    }

    TopoDS_Wire wire(const PlanCells::Loop& loop) {
        TopoDS_Wire result;
        builder_.MakeWire(result);
        for (const auto& use : loop) {
            const auto& pieces = edges_[use.edge];
            for (std::size_t i = 0; i < pieces.size(); ++i)
                builder_.Add(result, use.forward
                                         ? pieces[i].edge.Oriented(TopAbs_FORWARD)
                                         : pieces[pieces.size() - 1 - i].edge.Oriented(TopAbs_REVERSED));
        }
        result.Closed(true);
        return result;
    }

    // The sheet's spans that the cell reaches into.
    Handle(Geom_Surface) cell_surface(std::uint32_t c) const {
        const HeightPatch& sheet = brep_.sheet(c);
        const FaceSpans spans = face_spans(brep_, c);
        const auto surface = Handle(Geom_BSplineSurface)::DownCast(patch_surface(sheet));
        surface->Segment(sheet.x.breaks()[spans.first_x], sheet.x.breaks()[spans.end_x],
                         sheet.y.breaks()[spans.first_y], sheet.y.breaks()[spans.end_y]);
        return Handle(Geom_Surface)(surface);
    }

    TopoDS_Face cell_face(std::uint32_t c) {
        TopoDS_Face face;
        builder_.MakeFace(face, cell_surface(c), kTolerance);
        for (const auto& loop : brep_.cells.cells[c].loops) {
            for (const auto& use : loop)
                for (auto& [curve, tolerance, edge] : edges_[use.edge])
                    builder_.UpdateEdge(
                        edge, parameter_curve(curve.knots, curve.coefficients[0], curve.coefficients[1]),
                        face, tolerance);
            for (const auto& simple : simple_loops(loop)) builder_.Add(face, wire(simple));
        }
        return face;
    }

    // A loop that comes to a corner again is taken apart there: of wires that touch themselves, programs can't tell which
    // way they go on.
    std::vector<PlanCells::Loop> simple_loops(const PlanCells::Loop& loop) const {
        std::vector<PlanCells::Loop> result;
        PlanCells::Loop open;
        for (const auto& use : loop) {
            open.push_back(use);
            const std::uint32_t here = end_of(use);
            const auto again = std::ranges::find(open, here, [&](const auto& u) { return start_of(u); });
            if (again == open.end()) continue;
            result.emplace_back(again, open.end());
            open.erase(again, open.end());
        }
        return result;
    }

    std::uint32_t start_of(const PlanCells::EdgeUse& use) const {
        const auto& ends = brep_.cells.edges[use.edge];
        return use.forward ? ends.from : ends.to;
    }
    std::uint32_t end_of(const PlanCells::EdgeUse& use) const {
        const auto& ends = brep_.cells.edges[use.edge];
        return use.forward ? ends.to : ends.from;
    }

    TopoDS_Face wall_face(const PlanCells::Wall& wall) {
        const auto& side = brep_.sides[wall.side];
        TopoDS_Face face;
        if (side.straight) {
            builder_.MakeFace(face, plane_wall(side), kTolerance);
        } else {
            const auto [low, high] = heights(wall.loop);
            builder_.MakeFace(face, curved_wall(side, low, high), kTolerance);
            for (const auto& use : wall.loop)
                for (auto& [curve, tolerance, edge] : edges_[use.edge])
                    builder_.UpdateEdge(edge, curve_on_wall(use.edge, curve, wall.side), face, tolerance);
        }
        builder_.Add(face, wire(wall.loop));
        return face;
    }

    Handle(Geom2d_Curve) curve_on_wall(std::uint32_t e, const SplineCurve& curve, std::uint32_t side) const {
        const auto& ends = brep_.cells.edges[e];
        if (ends.line == kNone) {
            const auto vertex = brep_.cells.corners[ends.from].vertex;
            const bool at_start = brep_.cells.sides[side].vertices.front() == vertex;
            const auto& knots = brep_.sides[side].curve.knots;
            const bool up = brep_.corners[ends.to].z >= brep_.corners[ends.from].z;
            return new Geom2d_Line(
                gp_Pnt2d(at_start ? knots.low() : knots.high(), brep_.corners[ends.from].z),
                gp_Dir2d(0, up ? 1 : -1));
        }
        auto along = curve.knots.greville();
        for (double& s : along) s += brep_.edges[e].side_start;
        return parameter_curve(curve.knots, along, curve.coefficients[2]);
    }

    std::pair<double, double> heights(const PlanCells::Loop& loop) const {
        double low = INFINITY, high = -INFINITY;
        for (const auto& use : loop) {
            if (brep_.cells.edges[use.edge].line == kNone) continue;
            const auto [l, h] = std::ranges::minmax(brep_.edges[use.edge].curve.coefficients[2]);
            low = std::min(low, l), high = std::max(high, h);
        }
        const double margin = std::max(0.05 * (high - low), 1e-3);
        return {low - margin, high + margin};
    }

    const SmoothBrep& brep_;
    BRep_Builder builder_;
    std::vector<TopoDS_Vertex> vertices_;
    std::vector<std::vector<Piece>> edges_;
    std::vector<TopoDS_Face> cells_;
};

}  // namespace

std::vector<std::shared_ptr<const TopoDS_Shape>> smooth_shapes(const SmoothBrep& brep) {
    ShapeBuilder builder(brep);
    std::vector<std::shared_ptr<const TopoDS_Shape>> result;
    for (const auto& body : brep.cells.bodies)
        result.push_back(std::make_shared<const TopoDS_Shape>(builder.solid(body)));
    return result;
}

}  // namespace stratareeb
