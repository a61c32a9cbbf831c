// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/graph_of_mesh.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "boreholes/errors.h"
#include "mesh/ring_crossings.h"
#include "reeb/arc_index.h"
#include "reeb/contour_alignment.h"
#include "reeb/contour_trace.h"
#include "reeb/correspondence.h"
#include "reeb/homotopy.h"
#include "reeb/monotone_edge.h"
#include "reeb/point_math.h"

namespace stratareeb {

namespace {

struct LevelContour {
    double z = 0;
    std::vector<Point3> points;  // counter-clockwise seen from above
};

double twice_area(const std::vector<Point3>& points) {
    return area_vector(points).z;
}

//! Distance in plan from some points of one contour to the line of another.
double deviation(const std::vector<Point3>& from, const std::vector<Point3>& to) {
    constexpr std::size_t kPlaces = 64;
    const std::size_t step = 1 + from.size() / kPlaces;
    double furthest = 0;
    for (std::size_t i = 0; i < from.size(); i += step) {
        double least = std::numeric_limits<double>::max();
        for (std::size_t k = 0; k < to.size(); ++k) {
            const Point3 &a = to[k], &b = to[(k + 1) % to.size()];
            const double x = b.x - a.x, y = b.y - a.y, px = from[i].x - a.x, py = from[i].y - a.y;
            const double square = x * x + y * y;
            const double u = square > 0 ? std::clamp((px * x + py * y) / square, 0.0, 1.0) : 0;
            least = std::min(least, std::hypot(px - u * x, py - u * y));
        }
        furthest = std::max(furthest, least);
    }
    return furthest;
}

class GraphOfMesh {
 public:
    GraphOfMesh(const TriMesh& mesh, const MeshGraphOptions& options)
        : mesh_(mesh),
          options_(options),
          field_(height_field(mesh)),
          graph_(reeb_graph(mesh, field_)),
          index_(mesh, field_, graph_),
          levels_(even_levels(field_, options.levels)) {
        check();
        for (const auto v : mesh.vertices()) {
            const auto offset = mesh.point(v) - mesh.point(TriMesh::VertexHandle(0));
            least_step_ = std::max(least_step_, kLeastStep * offset.length());
        }
        for (const double value : field_) fallen_.push_back(-value);
    }

    EnhancedReebGraph run() {
        for (const ReebNode& node : graph_.nodes) {
            result_.nodes.emplace_back().id = static_cast<std::int64_t>(node.vertex);
            result_.nodes.back().position = place(node);
        }
        std::vector<std::vector<LevelContour>> arcs(graph_.arcs.size());
        tbb::parallel_for(std::size_t{0}, arcs.size(),
                          [&](std::size_t a) { arcs[a] = contours_of(static_cast<std::uint32_t>(a)); });
        add_contours_at_saddles(arcs);
        for (std::uint32_t a = 0; a < arcs.size(); ++a) add_edge(a, std::move(arcs[a]));
        return std::move(result_);
    }

 private:
    Point3 place(const ReebNode& node) const {
        const auto& p = mesh_.point(TriMesh::VertexHandle(static_cast<int>(node.vertex)));
        return {p[0], p[1], p[2]};
    }

    void check() const {
        for (const auto e : mesh_.edges())
            if (mesh_.is_boundary(e)) {
                const auto& p = mesh_.point(mesh_.to_vertex_handle(mesh_.halfedge_handle(e, 0)));
                throw InvalidInput(
                    fmt::format("the mesh has a boundary at ({:.7g}, {:.7g}, {:.7g}); a graph with contours "
                                "needs a closed surface",
                                p[0], p[1], p[2]));
            }
        for (const ReebArc& arc : graph_.arcs) {
            const ReebNode &lower = graph_.nodes[arc.lower], &upper = graph_.nodes[arc.upper];
            if (lower.value < upper.value) continue;
            const Point3 p = place(lower);
            throw InvalidInput(fmt::format(
                "critical points {} and {} have one height, {:.7g}, on a plateau at ({:.7g}, {:.7g}); "
                "turn the mesh a little, or sweep along a slightly tilted direction",
                lower.vertex, upper.vertex, lower.value, p.x, p.y));
        }
    }

    LevelContour contour_at(std::uint32_t arc, double z) const {
        LevelContour contour{z, index_.contour(arc, z).points};
        settle(contour);
        return contour;
    }

    //! Level, counter-clockwise, without points that rounding can't tell apart, but for `kept`.
    void settle(LevelContour& contour, const Point3* kept = nullptr) const {
        const auto are_one = [&](const Point3& a, const Point3& b) {
            return std::abs(a.x - b.x) <= least_step_ && std::abs(a.y - b.y) <= least_step_;
        };
        std::vector<Point3> points;
        for (Point3 p : contour.points) {
            p.z = contour.z;
            if (points.empty() || !are_one(points.back(), p))
                points.push_back(p);
            else if (kept && p == *kept)
                points.back() = p;
        }
        while (points.size() > 1 && are_one(points.front(), points.back())) {
            if (kept && points.back() == *kept) points.front() = points.back();
            points.pop_back();
        }
        contour.points = std::move(points);
        if (contour.points.size() > 2 && twice_area(contour.points) < 0) std::ranges::reverse(contour.points);
    }

    static bool is_sound(const LevelContour& contour, bool may_touch = false) {
        if (contour.points.size() < 3 || !(twice_area(contour.points) > 0)) return false;
        std::vector<std::vector<Point2>> ring(1);
        for (const Point3& p : contour.points) ring[0].push_back({p.x, p.y});
        return ring_crossings(ring, {.shared_corners = may_touch, .most = 1}).empty();
    }

    std::vector<LevelContour> contours_of(std::uint32_t arc) const {
        const double low = graph_.nodes[graph_.arcs[arc].lower].value,
                     high = graph_.nodes[graph_.arcs[arc].upper].value;
        std::vector<LevelContour> contours;
        const double margin = kNearNode * (high - low);
        const auto add = [&](double z) {
            if (!(low + margin < z && z < high - margin)) return;
            LevelContour contour = contour_at(arc, z);
            if (is_sound(contour)) contours.push_back(std::move(contour));
        };
        for (const double z : levels_) add(z);
        for (double share = 0.5; contours.empty() && share > 1e-3; share /= 2) {
            add(low + share * (high - low));
            if (contours.empty()) add(high - share * (high - low));
        }
        if (contours.empty())
            throw InvalidInput(
                fmt::format("between heights {:.7g} and {:.7g} a part of the mesh near ({:.7g}, {:.7g}) has "
                            "no contour that "
                            "is a simple curve; does the mesh cross itself there?",
                            low, high, place(graph_.nodes[graph_.arcs[arc].lower]).x,
                            place(graph_.nodes[graph_.arcs[arc].lower]).y));
        if (options_.tolerance > 0) refine(arc, contours);
        return contours;
    }

    //! Between neighbours, half way, until that is near enough to what the homotopy makes there.
    void refine(std::uint32_t arc, std::vector<LevelContour>& contours) const {
        for (std::size_t k = 0; k + 1 < contours.size() && contours.size() < options_.most_per_arc;) {
            const double z = contours[k].z + 0.5 * (contours[k + 1].z - contours[k].z);
            if (!(contours[k].z < z && z < contours[k + 1].z)) {
                ++k;
                continue;
            }
            LevelContour middle = contour_at(arc, z);
            if (!is_sound(middle) ||
                deviation(middle.points, made_between(contours, k)) <= options_.tolerance)
                ++k;
            else
                contours.insert(contours.begin() + static_cast<std::ptrdiff_t>(k) + 1, std::move(middle));
        }
    }

    //! Half way from contour k to the next, by the contours around.
    std::vector<Point3> made_between(const std::vector<LevelContour>& contours, std::size_t k) const {
        const std::size_t first = k > 0 ? k - 1 : 0, last = std::min(k + 2, contours.size() - 1);
        std::vector<SampledContour> shapes;
        std::vector<double> heights;
        for (std::size_t i = first; i <= last; ++i) {
            shapes.push_back(contour_by_perimeter(contours[i].points));
            heights.push_back(contours[i].z);
        }
        return ContourHomotopy(aligned_contours(std::move(shapes)), heights, {.kind = options_.homotopy})
            .contour(k - first, 0.5)
            .points;
    }

    void add_contours_at_saddles(std::vector<std::vector<LevelContour>>& arcs) const {
        std::vector<std::vector<std::uint32_t>> down(graph_.nodes.size()), up(graph_.nodes.size());
        for (std::uint32_t a = 0; a < arcs.size(); ++a) {
            up[graph_.arcs[a].lower].push_back(a);
            down[graph_.arcs[a].upper].push_back(a);
        }
        for (std::uint32_t n = 0; n < graph_.nodes.size(); ++n) {
            if (down[n].empty() || up[n].empty()) continue;
            bool from_below = down[n].size() >= up[n].size();
            auto through = contours_through(graph_.nodes[n], from_below ? down[n] : up[n], from_below);
            if (!through) {
                from_below = !from_below;
                through = contours_through(graph_.nodes[n], from_below ? down[n] : up[n], from_below);
            }
            if (!through) continue;
            const auto& side = from_below ? down[n] : up[n];
            for (std::size_t i = 0; i < side.size(); ++i) {
                auto& contours = arcs[side[i]];
                contours.insert(from_below ? contours.end() : contours.begin(), (*through)[i]);
            }
        }
    }

    //! The contours of all arcs on one side of a saddle, at its height, if they pass through it twice or oftener in all and meet
    //! nowhere else.
    std::optional<std::vector<LevelContour>> contours_through(const ReebNode& node,
                                                              const std::vector<std::uint32_t>& arcs,
                                                              bool from_below) const {
        std::vector<LevelContour> contours;
        std::vector<std::vector<Point2>> rings;
        std::ptrdiff_t visits = 0;
        for (const std::uint32_t a : arcs) {
            LevelContour contour{
                node.value, from_below ? index_.contour(a, node.value).points : points_above(a, node.value)};
            const Point3 critical = place(node);
            settle(contour, &critical);
            const auto own = std::ranges::count(contour.points, critical);
            if (!is_sound(contour, true) || own == 0) return std::nullopt;
            visits += own;
            rings.emplace_back();
            for (const Point3& p : contour.points) rings.back().push_back({p.x, p.y});
            contours.push_back(std::move(contour));
        }
        if (visits < 2 || !ring_crossings(rings, {.shared_corners = true, .most = 1}).empty())
            return std::nullopt;
        return contours;
    }

    //! The contour just above an arc's lower node: the level set of the field turned upside down, just below it there.
    std::vector<Point3> points_above(std::uint32_t arc, double z) const {
        return trace_contour(mesh_, fallen_, -z, mesh_.opposite_halfedge_handle(index_.crossed_above(arc, z)))
            .points;
    }

    void add_edge(std::uint32_t arc, std::vector<LevelContour> contours) {
        EnhancedEdge edge{.from = graph_.arcs[arc].lower,
                          .to = graph_.arcs[arc].upper,
                          .curve = {},
                          .contours = {},
                          .homotopy = {}};
        edge.homotopy.kind = options_.homotopy;
        // A spline would swing out beside a saddle, where the last centre is far from the node.
        const bool between_leaves = graph_.nodes[edge.from].type == CriticalType::Minimum &&
                                    graph_.nodes[edge.to].type == CriticalType::Maximum;
        edge.curve.kind = between_leaves ? CurveKind::Cardinal : CurveKind::Polyline;
        for (LevelContour& contour : contours) {
            const bool at_node =
                contour.z == graph_.nodes[edge.from].value || contour.z == graph_.nodes[edge.to].value;
            if (!at_node) {
                edge.curve.points.push_back(mean_point(contour_by_perimeter(contour.points)));
                edge.curve.points.back().z = contour.z;
            }
            edge.contours.push_back(static_cast<std::uint32_t>(result_.contours.size()));
            result_.contours.emplace_back().id = static_cast<std::int64_t>(result_.contours.size());
            result_.contours.back().curve.closed = true;
            result_.contours.back().curve.points = std::move(contour.points);
        }
        if (between_leaves && !z_monotonicity(ParametricCurve(curve_of(result_, edge))).monotone)
            edge.curve.kind = CurveKind::Polyline;
        result_.edges.push_back(std::move(edge));
    }

    static constexpr double kLeastStep =
        1e-11;  // of the mesh's size: points of a contour closer than that are one
    static constexpr double kNearNode = 1e-6;  // of an arc's height: no contour is closer to its ends

    const TriMesh& mesh_;
    const MeshGraphOptions& options_;
    double least_step_ = 0;
    const ScalarField field_;
    ScalarField fallen_;  // heights with the other sign
    const ReebGraph graph_;
    const ArcIndex index_;
    const std::vector<double> levels_;
    EnhancedReebGraph result_;
};

}  // namespace

EnhancedReebGraph graph_of_mesh(const TriMesh& mesh, const MeshGraphOptions& options) {
    return GraphOfMesh(mesh, options).run();
}

}  // namespace stratareeb
