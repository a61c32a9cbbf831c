// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/graph_of_mesh.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <ranges>
#include <set>
#include <utility>

#include "boreholes/errors.h"
#include "mesh/analysis.h"
#include "mesh/ring_crossings.h"
#include "reeb/correspondence.h"
#include "reeb/far_places.h"
#include "reeb/filled_boundaries.h"
#include "reeb/graded_levels.h"
#include "reeb/height_scale.h"
#include "reeb/level_pieces.h"
#include "reeb/level_set.h"
#include "reeb/mesh_contours.h"
#include "reeb/monotone_edge.h"
#include "reeb/reeb_graph.h"
#include "reeb/refined_contours.h"
#include "reeb/surface_of_graph.h"
#include "reeb/sweep_graph.h"

namespace stratareeb {

namespace {

using Contours = std::vector<LevelContour>;

class GraphOfMesh {
 public:
    GraphOfMesh(const TriMesh& mesh, std::size_t first_filled, const MeshGraphOptions& options)
        : mesh_(mesh),
          options_(options),
          first_filled_(first_filled),
          field_(height_field(mesh)),
          graph_(reeb_graph(mesh, field_)),
          sweep_(sweep_graph(mesh, field_, graph_)),
          mesh_contours_(mesh, field_, graph_),
          levels_(even_levels(field_, options.levels)) {}

    EnhancedReebGraph run() {
        for (const SweepNode& node : sweep_.nodes) {
            result_.nodes.emplace_back().id = static_cast<std::int64_t>(node.vertex);
            result_.nodes.back().position = mesh_contours_.place(node.vertex);
        }
        contours_.resize(sweep_.edges.size());
        for (std::uint32_t n = 0; n < sweep_.nodes.size(); ++n) make_level_node(n);
        tbb::parallel_for(std::size_t{0}, contours_.size(), [&](std::size_t e) { add_contours_within(e); });
        add_contours_at_saddles();
        tbb::parallel_for(std::size_t{0}, contours_.size(),
                          [&](std::size_t e) { refine(sweep_.edges[e], contours_[e]); });
        add_edges();
        if (options_.tolerance > 0) {
            far_.emplace(mesh_, first_filled_, graph_, sweep_);
            come_near();
        }
        mend();
        return std::move(result_);
    }

 private:
    const SweepNode& lower_node(const SweepEdge& edge) const { return sweep_.nodes[edge.lower]; }
    const SweepNode& upper_node(const SweepEdge& edge) const { return sweep_.nodes[edge.upper]; }

    std::size_t filled_triangles(const SweepNode& node) const {
        return static_cast<std::size_t>(std::ranges::count_if(
            node.level_triangles, [&](std::uint32_t triangle) { return triangle >= first_filled_; }));
    }

    //! Flat where the mesh is level, or where a level contour passes several critical points; open where it was.
    void make_level_node(std::uint32_t n) {
        const SweepNode& node = sweep_.nodes[n];
        const bool is_leaf = node.down.size() + node.up.size() == 1;
        const std::size_t filled = filled_triangles(node);
        if (filled > 0 && (!is_leaf || filled < node.level_triangles.size())) refuse_open_part(node);
        const bool is_crowded = node.down.size() > 1 && node.up.size() > 1;
        const bool is_needed = !node.level_triangles.empty() || (node.is_plateau && !is_leaf);
        if (!is_needed && !is_crowded) return;
        Contours contours;
        for (const std::uint32_t e : node.down)
            contours.push_back(mesh_contours_.at(sweep_.edges[e], node.value));
        for (const std::uint32_t e : node.up)
            contours.push_back(mesh_contours_.above_lower_end(sweep_.edges[e]));
        mesh_contours_.join_points(contours);
        if (!fit_together(contours))
            for (LevelContour& contour : contours) make_sound(contour);
        if (!fit_together(contours)) {
            if (is_needed && !(is_leaf && filled == 0)) refuse_plateau(node);
            return;  // a point then
        }
        result_.nodes[n].form = filled > 0 ? NodeForm::Open : NodeForm::Flat;
        std::size_t next = 0;
        for (const std::uint32_t e : node.down) contours_[e].push_back(std::move(contours[next++]));
        for (const std::uint32_t e : node.up)
            contours_[e].insert(contours_[e].begin(), std::move(contours[next++]));
    }

    //! Can surface_of_graph join them?
    static bool fit_together(const Contours& contours) {
        std::vector<std::vector<Point3>> rings;
        for (const LevelContour& contour : contours) {
            if (contour.points.size() < 3 || !(area_vector(contour.points).z > 0)) return false;
            rings.push_back(contour.points);
        }
        return fit_at_level_node(rings);
    }

    [[noreturn]] void refuse_plateau(const SweepNode& node) const {
        const Point3 p = mesh_contours_.place(node.vertex);
        throw InvalidInput(
            fmt::format("critical points on a level contour or plateau at ({:.7g}, {:.7g}, {:.7g}) can't be "
                        "told apart; turn "
                        "the mesh a little, or sweep along a slightly tilted direction",
                        p.x, p.y, p.z));
    }

    [[noreturn]] void refuse_open_part(const SweepNode& node) const {
        const Point3 p = mesh_contours_.place(node.vertex);
        throw InvalidInput(
            fmt::format("the boundary at ({:.7g}, {:.7g}, {:.7g}) is not the end of a tube: the surface goes "
                        "on at its height, or "
                        "both up and down from there; close it, or cut the mesh elsewhere",
                        p.x, p.y, p.z));
    }

    bool is_round(std::uint32_t n) const { return result_.nodes[n].form == NodeForm::Point; }

    void add_contours_within(std::size_t e) {
        const SweepEdge& edge = sweep_.edges[e];
        const double low = lower_node(edge).value, high = upper_node(edge).value;
        const double margin = kNearNode * (high - low);
        Contours& ends = contours_[e];
        Contours contours;
        const auto add = [&](double z) {
            if (!(low + margin < z && z < high - margin)) return;
            LevelContour contour = mesh_contours_.at(edge, z);
            if (make_sound(contour)) contours.push_back(std::move(contour));
        };
        for (const double z :
             graded_levels(levels_, low, high, {.low = is_round(edge.lower), .high = is_round(edge.upper)}))
            add(z);
        for (double share = 0.5; contours.empty() && share > 1e-3; share /= 2) {
            add(low + share * (high - low));
            if (contours.empty()) add(high - share * (high - low));
        }
        if (contours.empty() && ends.empty()) refuse_edge(edge);
        for (LevelContour& end : ends)
            contours.insert(end.z == low ? contours.begin() : contours.end(), std::move(end));
        ends = std::move(contours);
    }

    [[noreturn]] void refuse_edge(const SweepEdge& edge) const {
        const SweepNode &lower = lower_node(edge), &upper = upper_node(edge);
        const Point3 p = mesh_contours_.place(lower.vertex);
        throw InvalidInput(
            fmt::format("between heights {:.7g} and {:.7g} a part of the mesh near ({:.7g}, {:.7g}) has no "
                        "contour that is a simple curve; does the mesh cross itself there?",
                        lower.value, upper.value, p.x, p.y));
    }

    void refine(const SweepEdge& edge, Contours& contours) const {
        const HeightScale scale(lower_node(edge).value, upper_node(edge).value, is_round(edge.lower),
                                is_round(edge.upper));
        refine_contours(
            contours, scale, [&](double z) { return mesh_contours_.at(edge, z); },
            {.homotopy = options_.homotopy, .tolerance = options_.tolerance, .most = options_.most_per_arc});
    }

    void add_contours_at_saddles() {
        for (std::uint32_t n = 0; n < sweep_.nodes.size(); ++n) {
            const SweepNode& node = sweep_.nodes[n];
            if (node.down.empty() || node.up.empty() || result_.nodes[n].form != NodeForm::Point) continue;
            bool from_below = node.down.size() >= node.up.size();
            auto through = contours_through(node, from_below);
            if (!through) {
                from_below = !from_below;
                through = contours_through(node, from_below);
            }
            if (!through) continue;
            const auto& side = from_below ? node.down : node.up;
            for (std::size_t i = 0; i < side.size(); ++i) {
                Contours& contours = contours_[side[i]];
                contours.insert(from_below ? contours.end() : contours.begin(), (*through)[i]);
            }
        }
    }

    //! The contours of all edges on one side of a saddle, at its height, if they pass through it twice or oftener in all and
    //! meet nowhere else.
    std::optional<Contours> contours_through(const SweepNode& node, bool from_below) const {
        const Point3 critical = mesh_contours_.place(node.vertex);
        Contours contours;
        std::vector<std::vector<Point2>> rings;
        std::ptrdiff_t visits = 0;
        for (const std::uint32_t e : from_below ? node.down : node.up) {
            const SweepEdge& edge = sweep_.edges[e];
            LevelContour contour = from_below ? mesh_contours_.at(edge, node.value, &critical)
                                              : mesh_contours_.above_lower_end(edge, &critical);
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

    bool is_leaf_point(std::uint32_t n) const {
        const SweepNode& node = sweep_.nodes[n];
        return result_.nodes[n].form == NodeForm::Point && node.down.size() + node.up.size() == 1;
    }

    //! Contours where the surface would cross itself: first where it does when quickly made, then where no other way of joining
    //! mends it, or where that would be too far from the mesh.
    void mend() {
        bool is_mended = false;
        const std::size_t rounds = options_.crossing_rounds + (far_ ? kNearRounds : 0);
        for (std::size_t round = 0; round < rounds; ++round) {
            is_mended = is_mended || round >= kQuickRounds;
            const ConstructedSurface surface =
                surface_of_graph(result_, {.avoid_crossings = is_mended, .fairing = is_mended}, &memory_);
            std::size_t added = 0;
            if (!is_mended || !surface.crossings.empty())
                added += add_contours_between(crossing_places(surface), kHalf);
            else if (far_)
                added += add_contours_between(far_places(surface), kNearEnd);
            if (added > 0)
                add_edges();
            else if (is_mended)
                return;
            else
                is_mended = true;
        }
    }

    std::set<GraphPlace> crossing_places(const ConstructedSurface& surface) {
        std::set<GraphPlace> places;
        for (const auto& pair : memory_.crossings.of(surface.soup, kCrossingsLookedAt).first)
            for (const std::uint32_t t : pair) {
                const auto& [a, b, c] = surface.soup.triangles[t];
                const auto& p = surface.soup.points;
                const double z = p[a].z / 3 + p[b].z / 3 + p[c].z / 3;
                const std::uint32_t e = surface.triangle_edge[t];
                const auto above = std::ranges::lower_bound(contours_[e], z, {}, &LevelContour::z);
                places.emplace(e, static_cast<std::size_t>(above - contours_[e].begin()));
            }
        return places;
    }

    //! Where a surface is farther from the mesh than the tolerance, or the mesh from it.
    std::set<GraphPlace> far_places(const ConstructedSurface& surface) const {
        std::vector<std::vector<double>> heights;
        for (const Contours& contours : contours_) {
            heights.emplace_back();
            for (const LevelContour& contour : contours) heights.back().push_back(contour.z);
        }
        return far_->beyond(kShareOfTolerance * options_.tolerance, options_.tolerance, surface, heights);
    }

    void come_near() {
        for (std::size_t round = 0; round < kNearRounds; ++round) {
            const ConstructedSurface surface =
                surface_of_graph(result_, {.avoid_crossings = false}, &memory_);
            if (add_contours_between(far_places(surface), kNearEnd) == 0) return;
            add_edges();
        }
    }

    //! \param share of the way from a node to the next contour
    std::size_t add_contours_between(const std::set<GraphPlace>& places, double share) {
        std::size_t added = 0;
        for (const auto& [e, below] : std::views::reverse(places))  // from the top, so that numbers stay
            added += add_contour_between(e, below, share);
        return added;
    }

    bool add_contour_between(std::uint32_t e, std::size_t below, double end_share) {
        const SweepEdge& edge = sweep_.edges[e];
        Contours& contours = contours_[e];
        const double bottom = lower_node(edge).value, top = upper_node(edge).value;
        const double low = below == 0 ? bottom : contours[below - 1].z,
                     high = below == contours.size() ? top : contours[below].z;
        const bool is_first = below == 0, is_last = below == contours.size();
        const double share = is_first == is_last ? kHalf : is_first ? end_share : 1 - end_share;
        const double z = height_between(low, high, share);
        if (!has_room(low, high, bottom, top) || !(low < z && z < high) ||
            contours.size() >= options_.most_per_arc)
            return false;
        LevelContour contour = mesh_contours_.at(edge, z);
        if (!make_sound(contour)) return false;
        contours.insert(contours.begin() + static_cast<std::ptrdiff_t>(below), std::move(contour));
        return true;
    }

    //! The middle; in a thin slice the vertex's height closest to it, since between vertices contours cross the same edges.
    double height_between(double low, double high, double share) {
        const double middle = low + share * (high - low);
        if (share != kHalf) return middle;
        if (heights_.empty()) {
            heights_.assign(field_.begin(), field_.end());
            std::ranges::sort(heights_);
        }
        const auto first = std::ranges::upper_bound(heights_, low);
        const auto last = std::ranges::lower_bound(heights_, high);
        if (first >= last || last - first > kFewVertices) return middle;
        return *std::ranges::min_element(first, last, {},
                                         [middle](double z) { return std::abs(z - middle); });
    }

    void add_edges() {
        result_.contours.clear();
        result_.edges.clear();
        for (std::uint32_t e = 0; e < contours_.size(); ++e) add_edge(e);
    }

    void add_edge(std::uint32_t e) {
        EnhancedEdge edge{.from = sweep_.edges[e].lower,
                          .to = sweep_.edges[e].upper,
                          .curve = {},
                          .contours = {},
                          .homotopy = {}};
        edge.homotopy = {.kind = options_.homotopy, .pace = HomotopyPace::Round};
        // A spline would swing out beside a saddle, where the last centre is far from the node.
        const bool between_leaves = is_leaf_point(edge.from) && is_leaf_point(edge.to);
        edge.curve.kind = between_leaves ? CurveKind::Cardinal : CurveKind::Polyline;
        for (const LevelContour& contour : contours_[e]) {
            const bool at_node = contour.z == lower_node(sweep_.edges[e]).value ||
                                 contour.z == upper_node(sweep_.edges[e]).value;
            if (!at_node) {
                edge.curve.points.push_back(mean_point(contour_by_perimeter(contour.points)));
                edge.curve.points.back().z = contour.z;
            }
            edge.contours.push_back(static_cast<std::uint32_t>(result_.contours.size()));
            result_.contours.emplace_back().id = static_cast<std::int64_t>(result_.contours.size());
            result_.contours.back().curve.closed = true;
            result_.contours.back().curve.points = contour.points;
        }
        if (between_leaves && !z_monotonicity(ParametricCurve(curve_of(result_, edge))).monotone)
            edge.curve.kind = CurveKind::Polyline;
        result_.edges.push_back(std::move(edge));
    }

    static constexpr double kHalf = 0.5;
    static constexpr double kNearEnd = 0.3;  // contours spread beside a node like the root of the height
    static constexpr double kShareOfTolerance =
        0.8;  // what is between, and joining otherwise, may bring places farther off
    static constexpr std::ptrdiff_t kFewVertices = 8;  // in a thin slice
    static constexpr std::size_t kNearRounds = 12;
    static constexpr std::size_t kQuickRounds = 2;
    static constexpr std::size_t kCrossingsLookedAt = 5000;  // pairs of triangles
    static constexpr double kNearNode = 1e-6;  // of an edge's height: no contour within is closer to its ends

    const TriMesh& mesh_;
    const MeshGraphOptions& options_;
    const std::size_t first_filled_;  // triangle, of those that close the mesh's boundaries
    const ScalarField field_;
    const ReebGraph graph_;
    const SweepGraph sweep_;
    const MeshContours mesh_contours_;
    const std::vector<double> levels_;
    std::optional<FarPlaces> far_;    // if there is a tolerance
    std::vector<double> heights_;     // of all vertices, ascending
    std::vector<Contours> contours_;  // by edge, bottom to top
    SurfaceMemory memory_;
    EnhancedReebGraph result_;
};

}  // namespace

EnhancedReebGraph graph_of_mesh(const TriMesh& mesh, const MeshGraphOptions& options) {
    if (is_closed(mesh)) return GraphOfMesh(mesh, mesh.n_faces(), options).run();
    const TriMesh filled = filled_boundaries(mesh);
    return GraphOfMesh(filled, mesh.n_faces(), options).run();
}

}  // namespace stratareeb
