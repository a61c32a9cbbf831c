// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/graph_conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "boreholes/errors.h"
#include "mesh/ring_crossings.h"
#include "mesh/ring_fill.h"
#include "reeb/arc_length.h"
#include "reeb/correspondence.h"
#include "reeb/monotone_edge.h"
#include "reeb/plane_frame.h"
#include "reeb/point_math.h"

namespace stratareeb {

namespace {

constexpr std::size_t kSamples = 256;  // of a spline, to judge it by
constexpr double kFlatness = 1e-9;     // of a contour's size: how far from its plane its points may be
constexpr std::uint32_t kNoNode = ~0u;
constexpr std::size_t kMostFaults = 1000;  // more than anybody reads

//! A contour as a polygon, with what is asked of it.
struct Outline {
    std::vector<Point3> points;
    Point3 normal;  // of unit length
    double size = 0, lowest = 0, highest = 0;

    bool is_level() const { return highest - lowest <= kFlatness * size; }
    double height() const { return (lowest + highest) / 2; }
};

class Judge {
 public:
    explicit Judge(const EnhancedReebGraph& graph) : graph_(graph), outlines_(graph.contours.size()) {
        for (const EnhancedNode& node : graph.nodes)
            places_.insert({node.position.x, node.position.y, node.position.z});
    }

    std::vector<std::string> run() {
        check_names();
        check_nodes();
        find_level_ends();
        for (std::size_t c = 0; c < outlines_.size(); ++c) judge_contour(c);
        check_membership();
        for (std::size_t e = 0; e < graph_.edges.size(); ++e) judge_edge(e);
        check_level_contours();
        check_level_nodes();
        check_tilted_contours();
        return std::move(faults_);
    }

 private:
    template <class... Arguments>
    void fault(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        if (faults_.size() < kMostFaults)
            faults_.push_back(fmt::format(format, std::forward<Arguments>(arguments)...));
    }

    std::string node_name(std::uint32_t n) const { return "node " + text_of(graph_.nodes[n].id); }
    std::string contour_name(std::size_t c) const { return "contour " + text_of(graph_.contours[c].id); }
    std::string edge_name(const EnhancedEdge& edge) const {
        return fmt::format("the edge from {} to {}", node_name(edge.from), node_name(edge.to));
    }

    void check_names() {
        const auto check = [&](const auto& things, const char* kind) {
            std::set<GraphId> seen;
            for (const auto& thing : things)
                if (!seen.insert(thing.id).second)
                    fault("two {} are called {}: give each a name of its own", kind, text_of(thing.id));
        };
        check(graph_.nodes, "nodes");
        check(graph_.contours, "contours");
    }

    void check_nodes() {
        for (std::uint32_t n = 0; n < graph_.nodes.size(); ++n)
            if (!is_finite(graph_.nodes[n].position))
                fault("{}: its position is not made of numbers", node_name(n));
    }

    //! Which contours are to stand at the height of a flat or open node.
    void find_level_ends() {
        level_node_.assign(graph_.contours.size(), kNoNode);
        const auto note = [&](std::uint32_t node, std::uint32_t contour) {
            if (graph_.nodes[node].form != NodeForm::Point) level_node_[contour] = node;
        };
        for (const EnhancedEdge& edge : graph_.edges) {
            if (edge.contours.empty()) continue;
            note(edge.from, edge.contours.front());
            note(edge.to, edge.contours.back());
        }
    }

    bool is_at_flat_node(std::size_t c) const {
        return level_node_[c] != kNoNode && graph_.nodes[level_node_[c]].form == NodeForm::Flat;
    }

    void judge_contour(std::size_t c) {
        try {
            Outline outline{.points = sample_contour(graph_.contours[c].curve, kSamples).points,
                            .normal = {}};
            if (outline.points.size() < 3)
                return fault("{}: it has fewer than three points", contour_name(c));
            const auto [low, high] = std::ranges::minmax(outline.points, {}, &Point3::z);
            outline.lowest = low.z;
            outline.highest = high.z;
            for (const Point3& p : outline.points)
                outline.size = std::max(outline.size, magnitude(p - outline.points.front()));
            const Point3 area = area_vector(outline.points);
            if (!(magnitude(area) > 0)) return fault("{}: it encloses no area", contour_name(c));
            outline.normal = (1 / magnitude(area)) * area;
            for (const Point3& p : outline.points)
                if (std::abs(dot_product(p - outline.points.front(), outline.normal)) >
                    1e3 * kFlatness * outline.size)
                    return fault(
                        "{}: its points do not lie in one plane, ({:.7g}, {:.7g}, {:.7g}) is {:.3g} off",
                        contour_name(c), p.x, p.y, p.z,
                        std::abs(dot_product(p - outline.points.front(), outline.normal)));
            if (!(outline.normal.z > 0))
                fault(
                    "{}: it runs clockwise seen from above; all contours run counter-clockwise (turn its "
                    "points round)",
                    contour_name(c));
            check_simple(c, outline);
            outlines_[c] = std::move(outline);
        } catch (const InvalidInput& error) {
            fault("{}: {}", contour_name(c), error.what());
        }
    }

    static std::vector<Point2> in_plane(const Outline& outline, const PlaneFrame& frame) {
        std::vector<Point2> ring;
        for (const Point3& p : outline.points) {
            const Point3 turned = frame.turned(p);
            ring.push_back({turned.x, turned.y});
        }
        return ring;
    }

    void check_simple(std::size_t c, const Outline& outline) {
        if (is_at_flat_node(c)) return;  // see check_flat_node
        const std::vector<std::vector<Point2>> ring{
            in_plane(outline, outline.is_level() ? PlaneFrame{} : plane_frame(outline.normal))};
        for (const RingCrossing& crossing : ring_crossings(ring)) {
            if (meet_in_node(outline, outline, crossing)) continue;
            const Point3& p = outline.points[crossing.edge];
            return fault("{}: it crosses or touches itself near ({:.7g}, {:.7g}, {:.7g})", contour_name(c),
                         p.x, p.y, p.z);
        }
    }

    void check_membership() {
        std::vector<int> edges(graph_.contours.size(), 0);
        for (const EnhancedEdge& edge : graph_.edges)
            for (const std::uint32_t c : edge.contours) ++edges[c];
        for (std::size_t c = 0; c < edges.size(); ++c)
            if (edges[c] != 1)
                fault("{}: it is on {} edges; each contour belongs to one", contour_name(c), edges[c]);
        edges_at_.assign(graph_.nodes.size(), 0);
        for (const EnhancedEdge& edge : graph_.edges) ++edges_at_[edge.from], ++edges_at_[edge.to];
        for (std::uint32_t n = 0; n < edges_at_.size(); ++n)
            if (edges_at_[n] == 0) fault("{}: no edge starts or ends there", node_name(n));
    }

    void judge_edge(std::size_t e) {
        const EnhancedEdge& edge = graph_.edges[e];
        if (edge.from == edge.to) return fault("{}: it has no length", edge_name(edge));
        if (edge.contours.empty()) fault("{}: it has no contour, so nothing says its shape", edge_name(edge));
        try {
            const ZMonotonicity z = z_monotonicity(ParametricCurve(curve_of(graph_, edge)));
            if (!z.monotone)
                fault(
                    "{}: its curve does not rise all the way: from t = {:.4g} (z = {:.7g}) to {:.4g} (z = "
                    "{:.7g})",
                    edge_name(edge), z.from, z.from_z, z.to, z.to_z);
            else if (z.direction < 0)
                fault("{}: it falls; exchange its nodes", edge_name(edge));
        } catch (const InvalidInput& error) {
            fault("{}: {}", edge_name(edge), error.what());
        }
        check_order(edge);
    }

    void check_order(const EnhancedEdge& edge) {
        double below = graph_.nodes[edge.from].position.z;
        for (std::size_t k = 0; k < edge.contours.size(); ++k) {
            const std::uint32_t c = edge.contours[k];
            if (!outlines_[c]) continue;
            const double z = outlines_[c]->height();
            const bool stands_at_node = k == 0 && z == below && may_stand_at(edge.from, c);
            if (!(z > below) && !stands_at_node)
                fault("{}: {} at z = {:.7g} is not above what comes before it on the edge, at {:.7g}",
                      edge_name(edge), contour_name(c), z, below);
            below = z;
        }
        const double top = graph_.nodes[edge.to].position.z;
        if (edge.contours.empty() || below < top) return;
        const std::uint32_t last = edge.contours.back();
        if (outlines_[last] && !(below == top && may_stand_at(edge.to, last)))
            fault("{}: {} at z = {:.7g} is not below the node at its upper end, at {:.7g}", edge_name(edge),
                  contour_name(last), below, top);
    }

    bool may_stand_at(std::uint32_t n, std::uint32_t c) const {
        return edges_at_[n] == 1 || graph_.nodes[n].form != NodeForm::Point || passes_through(c, n);
    }

    bool passes_through(std::size_t c, std::uint32_t n) const {
        return std::ranges::find(outlines_[c]->points, graph_.nodes[n].position) !=
               outlines_[c]->points.end();
    }

    //! Contours of one height must not meet, but in a node.
    void check_level_contours() {
        std::map<double, std::vector<std::uint32_t>> at_height;
        for (std::uint32_t c = 0; c < outlines_.size(); ++c)
            if (outlines_[c] && outlines_[c]->is_level())
                at_height[outlines_[c]->points.front().z].push_back(c);
        for (const auto& [z, contours] : at_height) {
            if (contours.size() < 2) continue;
            std::vector<std::vector<Point2>> rings;
            for (const std::uint32_t c : contours) rings.push_back(in_plane(*outlines_[c], PlaneFrame{}));
            std::set<std::pair<std::uint32_t, std::uint32_t>> told;
            for (const RingCrossing& crossing : ring_crossings(rings)) {
                const std::uint32_t a = contours[crossing.ring], b = contours[crossing.other_ring];
                if (a == b || (is_at_flat_node(a) && is_at_flat_node(b)) ||
                    meet_in_node(*outlines_[a], *outlines_[b], crossing) || !told.insert({a, b}).second)
                    continue;
                fault("{} and {} meet at height {:.7g} near ({:.7g}, {:.7g})", contour_name(a),
                      contour_name(b), z, crossing.place.x, crossing.place.y);
            }
        }
    }

    void check_level_nodes() {
        std::vector<std::vector<std::uint32_t>> contours(graph_.nodes.size());
        for (const EnhancedEdge& edge : graph_.edges)
            for (const bool is_top : {false, true}) {
                const std::uint32_t n = is_top ? edge.to : edge.from;
                if (graph_.nodes[n].form == NodeForm::Point || edge.contours.empty()) continue;
                const std::uint32_t c = is_top ? edge.contours.back() : edge.contours.front();
                contours[n].push_back(c);
                check_level_end(n, c);
            }
        for (std::uint32_t n = 0; n < contours.size(); ++n) {
            if (graph_.nodes[n].form == NodeForm::Flat) check_flat_node(n, contours[n]);
            if (graph_.nodes[n].form == NodeForm::Open && edges_at_[n] > 1)
                fault("{}: it is open, and {} edges start or end there; an open end has one", node_name(n),
                      edges_at_[n]);
        }
    }

    void check_level_end(std::uint32_t n, std::uint32_t c) {
        if (!outlines_[c]) return;
        const double z = graph_.nodes[n].position.z;
        const auto off =
            std::ranges::find_if(outlines_[c]->points, [&](const Point3& p) { return p.z != z; });
        if (off == outlines_[c]->points.end()) return;
        fault("{}: it is {}, so {}, the last there, has to stand at its height, {:.10g}, not at {:.10g}",
              node_name(n), graph_.nodes[n].form == NodeForm::Flat ? "flat" : "open", contour_name(c), z,
              off->z);
    }

    //! Contours at a flat node may meet in corners and along whole sides; they may not cross.
    void check_flat_node(std::uint32_t n, const std::vector<std::uint32_t>& contours) {
        if (!std::ranges::all_of(contours, [&](std::uint32_t c) { return outlines_[c].has_value(); })) return;
        std::map<std::pair<double, double>, std::uint32_t> number;
        std::vector<Point2> corners;
        std::vector<std::vector<std::uint32_t>> rings;
        for (const std::uint32_t c : contours) {
            rings.emplace_back();
            for (const Point3& p : outlines_[c]->points) {
                const auto [at, is_new] =
                    number.try_emplace({p.x, p.y}, static_cast<std::uint32_t>(corners.size()));
                if (is_new) corners.push_back({p.x, p.y});
                rings.back().push_back(at->second);
            }
        }
        try {
            ring_fill(corners, rings);
        } catch (const InvalidInput& error) {
            fault("{}: its contours cross: {}", node_name(n), error.what());
        }
    }

    //! Is what two edges have in common a node that both pass through?
    bool meet_in_node(const Outline& a, const Outline& b, const RingCrossing& crossing) const {
        const auto ends = [](const Outline& outline, std::uint32_t edge) {
            return std::array{outline.points[edge], outline.points[(edge + 1) % outline.points.size()]};
        };
        for (const Point3& p : ends(a, crossing.edge))
            for (const Point3& q : ends(b, crossing.other_edge))
                if (p == q && places_.contains({p.x, p.y, p.z})) return true;
        return false;
    }

    //! Where a contour in a plane of its own passes through the plane of another, it must miss it.
    void check_tilted_contours() {
        for (std::size_t a = 0; a < outlines_.size(); ++a) {
            if (!outlines_[a] || outlines_[a]->is_level()) continue;
            for (std::size_t b = 0; b < outlines_.size(); ++b) {
                if (a == b || !outlines_[b] || (b < a && !outlines_[b]->is_level())) continue;
                if (outlines_[b]->lowest > outlines_[a]->highest ||
                    outlines_[b]->highest < outlines_[a]->lowest)
                    continue;
                if (const auto place = meeting_place(*outlines_[a], *outlines_[b]))
                    fault("{} and {} meet near ({:.7g}, {:.7g}, {:.7g})", contour_name(a), contour_name(b),
                          place->x, place->y, place->z);
            }
        }
    }

    static std::optional<Point3> meeting_place(const Outline& a, const Outline& b) {
        const double near = 1e3 * kFlatness * std::max(a.size, b.size);
        for (std::size_t i = 0; i < a.points.size(); ++i) {
            const Point3 &p = a.points[i], &q = a.points[(i + 1) % a.points.size()];
            const double from = dot_product(p - b.points.front(), b.normal),
                         to = dot_product(q - b.points.front(), b.normal);
            if ((from > 0) == (to > 0) && from != 0) continue;
            const Point3 through = from == to ? p : between(p, q, from / (from - to));
            for (std::size_t k = 0; k < b.points.size(); ++k)
                if (distance_to_line(through, b.points[k], b.points[(k + 1) % b.points.size()]) <= near)
                    return through;
        }
        return std::nullopt;
    }

    static double distance_to_line(const Point3& p, const Point3& a, const Point3& b) {
        const Point3 along = b - a;
        const double length = dot_product(along, along);
        const double u = length > 0 ? std::clamp(dot_product(p - a, along) / length, 0.0, 1.0) : 0;
        return magnitude(p - between(a, b, u));
    }

    const EnhancedReebGraph& graph_;
    std::vector<std::optional<Outline>> outlines_;  // of sound contours
    std::vector<std::uint32_t>
        level_node_;             // by contour: the flat or open node at whose height it is to stand
    std::vector<int> edges_at_;  // by node
    std::set<std::tuple<double, double, double>> places_;  // of nodes
    std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> faults_of(const EnhancedReebGraph& graph) {
    return Judge(graph).run();
}

void check_graph(const EnhancedReebGraph& graph) {
    const std::vector<std::string> faults = faults_of(graph);
    if (faults.empty()) return;
    constexpr std::size_t kTold = 20;
    std::string text = faults.size() == 1 ? "" : fmt::format("{} faults", faults.size());
    for (std::size_t i = 0; i < std::min(faults.size(), kTold); ++i)
        text += (text.empty() ? "" : "\n  ") + faults[i];
    if (faults.size() > kTold) text += fmt::format("\n  and {} more", faults.size() - kTold);
    throw InvalidInput(text);
}

}  // namespace stratareeb
