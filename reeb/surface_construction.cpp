// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/surface_construction.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "boreholes/errors.h"
#include "reeb/contour_alignment.h"
#include "reeb/graph_conditions.h"
#include "reeb/graph_strands.h"
#include "reeb/plan_sheet.h"
#include "reeb/saddle_construction.h"
#include "reeb/strand_surface.h"
#include "reeb/surface_fairing.h"

namespace stratareeb {

namespace {

using Kind = StrandEnd::Kind;

constexpr std::size_t kRounds = 8;  // of joining otherwise what crosses
constexpr std::size_t kCrossingsLookedAt =
    5000;  // pairs of triangles; where there are more, they come up again

//! An edge, and a place on it (see Strand::joins).
using EdgePlace = std::pair<std::uint32_t, std::size_t>;
constexpr std::size_t kFilling = ~std::size_t{0};  // no place, but what a flat node is filled with

//! What is done otherwise so that nothing crosses.
struct Remedies {
    std::set<std::uint32_t> rigid;  // nodes beside which the surface stays as guiding curves make it
    std::map<EdgePlace, Join> joins;
};

class Construction {
 public:
    using Place = EdgePlace;

    Construction(const EnhancedReebGraph& graph, const SurfaceOptions& options, const Remedies& remedies,
                 SurfaceMemory& memory)
        : graph_(graph),
          options_(options),
          remedies_(remedies),
          memory_(memory),
          surface_(options.triangulation) {
        const auto shapes = strands_of(graph, options.samples);
        const auto is_hole = hole_edges(graph, shapes);
        down_.resize(graph.nodes.size());
        up_.resize(graph.nodes.size());
        for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
            const EnhancedEdge& edge = graph.edges[e];
            strands_.push_back({.contours = shapes[e].contours,
                                .heights = shapes[e].heights,
                                .homotopy = edge.homotopy,
                                .lean = std::nullopt,
                                .is_hole = is_hole[e],
                                .bottom = {.node = graph.nodes[edge.from].position, .group = edge.from},
                                .top = {.node = graph.nodes[edge.to].position, .group = edge.to}});
            const auto is_polygon = [&](std::uint32_t contour) {
                return graph.contours[contour].curve.kind == CurveKind::Polyline;
            };
            strands_.back().bottom.is_outline = is_polygon(edge.contours.front());
            strands_.back().top.is_outline = is_polygon(edge.contours.back());
            strands_.back().is_terrain = options.terrain && edge.curve.points.empty();
            if (!edge.curve.points.empty() && edge.homotopy.pace == HomotopyPace::Even)
                strands_.back().lean = curve_of(graph, edge);
            up_[edge.from].push_back(e);
            down_[edge.to].push_back(e);
        }
        for (const auto& [place, join] : remedies.joins) strands_[place.first].joins[place.second] = join;
    }

    ConstructedSurface run() {
        for (std::uint32_t n = 0; n < graph_.nodes.size(); ++n) make_node(n);
        ConstructedSurface result;
        for (std::uint32_t e = 0; e < strands_.size(); ++e)
            result.straightened +=
                add_strand(surface_, strands_[e], options_.steps, memory_.sheets, [&](std::size_t place) {
                    const auto part = begin_place({e, place});
                    return static_cast<std::uint32_t>(graph_.nodes.size()) + part;
                });
        for (const NodeSheet& sheet : node_sheets_) {
            const auto& [e, at] = sheet.place;
            begin_place({e, std::min(at, rings_of(strands_[e]))});
            surface_.add_sheet(*sheet.sheet, sheet.vertices, sheet.node);
        }
        result.soup = surface_.soup();
        if (options_.fairing) fair_surface(result.soup, surface_.free_vertices(), remedies_.rigid);
        result.triangle_part = surface_.triangle_parts();
        for (const std::uint32_t part : result.triangle_part)
            result.triangle_edge.push_back(places_[part].first);
        return result;
    }

    //! Join a place otherwise the next time. \return whether there is another way
    bool find_remedy(const Place& place, Remedies& remedies) const {
        const auto& [e, at] = place;
        if (at == kFilling) return false;
        const Strand& strand = strands_[e];
        for (const StrandEnd* end : {&strand.bottom, &strand.top}) {
            const bool is_beside =
                at == (end == &strand.bottom ? 0 : rings_of(strand)) ||
                (end->kind == Kind::Ring && at == (end == &strand.bottom ? 1 : rings_of(strand) - 1));
            const bool is_saddle =
                end->kind == Kind::Approach || end->kind == Kind::Ring || end->kind == Kind::Sheet;
            if (is_beside && is_saddle && options_.fairing && remedies.rigid.insert(end->group).second)
                return true;
            if (is_beside && end->kind == Kind::Sheet) return false;
        }
        return join_otherwise(place, remedies);
    }

    //! Pairs of places whose triangles cross. A place without a number is what a flat node is filled with.
    std::set<std::pair<Place, Place>> crossing_places(const ConstructedSurface& surface) const {
        std::set<std::pair<Place, Place>> pairs;
        const auto place = [&](std::uint32_t triangle) {
            const std::uint32_t part = surface.triangle_part[triangle];
            return part < places_.size() ? places_[part] : Place{surface.triangle_edge[triangle], kFilling};
        };
        for (const auto& [a, b] : memory_.crossings.of(surface.soup, kCrossingsLookedAt).first)
            pairs.emplace(std::minmax(place(a), place(b)));
        return pairs;
    }

    //! A place in words, as a graph with the same edges names it.
    std::string text_of_place(const EnhancedReebGraph& named, const Place& place) const {
        const auto& [e, at] = place;
        const EnhancedEdge& edge = named.edges[e];
        const auto name = [&](std::uint32_t n) { return "node " + text_of(named.nodes[n].id); };
        if (at == kFilling)
            return "a level piece beside contour " + text_of(named.contours[edge.contours.front()].id);
        const bool node_first = strands_[e].bottom.kind == Kind::Ring;
        const auto ring = [&](std::size_t k) {  // counted from 0, those at nodes included
            const std::size_t first = node_first ? 1 : 0;
            if (k < first) return name(edge.from);
            if (k - first >= edge.contours.size()) return name(edge.to);
            return "contour " + text_of(named.contours[edge.contours[k - first]].id);
        };
        const std::string lower = at == 0 ? name(edge.from) : ring(at - 1);
        const std::string upper = ring(at);
        return fmt::format("between {} and {}", lower, upper);
    }

 private:
    //! A sheet first where it is cheap or nothing else does: for ends, and on ground.
    bool join_otherwise(const Place& place, Remedies& remedies) const {
        const auto& [e, at] = place;
        static const std::vector<Join> kEnd{Join::Sheet, Join::Straight},
            kBand{Join::ByShape, Join::Straight, Join::Sheet};
        const auto& ways = at == 0 || at == rings_of(strands_[e]) ? kEnd : kBand;
        const auto [known, is_new] = remedies.joins.try_emplace(place, ways.front());
        if (is_new) return true;
        if (known->second == ways.back()) return false;
        known->second = *std::next(std::ranges::find(ways, known->second));
        return true;
    }

    //! A sheet at a node, and the vertices of its rings.
    struct NodeSheet {
        std::uint32_t node;
        const PlanSheet* sheet;  // the memory's
        std::vector<std::uint32_t> vertices;
        Place place;
    };

    std::uint32_t begin_place(const Place& place) {
        const auto part = static_cast<std::uint32_t>(places_.size());
        surface_.begin_part(part);
        places_.push_back(place);
        return part;
    }

    static std::size_t rings_of(const Strand& strand) {
        return strand.contours.size() + (strand.bottom.kind == Kind::Ring) + (strand.top.kind == Kind::Ring);
    }

    std::string name(std::uint32_t n) const { return "node " + text_of(graph_.nodes[n].id); }

    void make_node(std::uint32_t n) {
        const NodeSide lower{down_[n], true}, upper{up_[n], false};
        const std::size_t below = lower.edges.size(), above = upper.edges.size();
        if (below + above == 1) return make_leaf(n, below == 1 ? lower : upper);
        if (below + above == 2 && (below == 0 || above == 0))
            return make_ridge(n, below == 0 ? upper : lower);
        if (below == 0 || above == 0)
            throw InvalidInput(fmt::format(
                "{}: {} edges start or end there on one side and none on the other; let them meet in a "
                "saddle first",
                name(n), below + above));
        if (below == 1 && above == 1)
            throw InvalidInput(
                name(n) + ": one edge ends and one starts there, so it is no critical point; join the edges");
        if ((below == 1 || above == 1) && make_sheet(n, lower, upper)) return;
        make_saddle({name(n), graph_.nodes[n].position}, lower, upper, options_, strands_, surface_);
    }

    //! One height for each place between the contours around the node, where that can be.
    bool make_sheet(std::uint32_t n, const NodeSide& lower, const NodeSide& upper) {
        std::vector<SheetRing> rings;
        for (const NodeSide& side : {lower, upper})
            for (const std::uint32_t e : side.edges) {
                const StrandEnd& far = side.is_lower ? strands_[e].bottom : strands_[e].top;
                if (strands_[e].contours.size() == 1 && far.node.z == end_height(strands_, side, e))
                    return false;
                rings.push_back({end_contour(strands_, side, e).points, side.is_lower, strands_[e].is_hole});
            }
        const auto& made = memory_.sheets.sheet(rings, graph_.nodes[n].position, options_.steps);
        if (!made) return false;
        NodeSheet sheet{.node = n, .sheet = &*made, .vertices = {}, .place = {}};
        for (const NodeSide& side : {lower, upper})
            for (const std::uint32_t e : side.edges) {
                const Ring ring = sheet_ring(side, e);
                sheet.vertices.insert(sheet.vertices.end(), ring.vertices.begin(), ring.vertices.end());
            }
        const bool is_merge = upper.edges.size() == 1;
        const std::uint32_t e = is_merge ? upper.edges.front() : lower.edges.front();
        sheet.place = {e, is_merge ? 0 : ~std::size_t{0}};  // the top, once its strand knows its rings
        node_sheets_.push_back(std::move(sheet));
        return true;
    }

    //! An edge's only contour may bound sheets on both sides.
    const Ring& sheet_ring(const NodeSide& side, std::uint32_t e) {
        StrandEnd& own = end_of(strands_, side, e);
        const StrandEnd& far = side.is_lower ? strands_[e].bottom : strands_[e].top;
        const bool is_shared = strands_[e].contours.size() == 1 && far.kind == Kind::Sheet;
        own.kind = Kind::Sheet;
        own.ring = is_shared ? *far.ring : surface_.add_ring(end_contour(strands_, side, e));
        return *own.ring;
    }

    void make_leaf(std::uint32_t n, const NodeSide& side) {
        const std::uint32_t edge = side.edges.front();
        const bool flat = end_height(strands_, side, edge) == graph_.nodes[n].position.z;
        end_of(strands_, side, edge).kind = flat ? Kind::Flat : Kind::Tip;
    }

    //! Half way between an outer contour and the hole in it, at the node's height.
    void make_ridge(std::uint32_t n, const NodeSide& side) {
        const bool first_is_outer = !strands_[side.edges[0]].is_hole;
        if (strands_[side.edges[1]].is_hole != first_is_outer)
            throw InvalidInput(name(n) +
                               ": two edges start or end there that are not a contour and the hole in it; "
                               "let them meet in a "
                               "saddle first");
        const std::uint32_t outer = side.edges[first_is_outer ? 0 : 1],
                            hole = side.edges[first_is_outer ? 1 : 0];
        SampledContour ridge = end_contour(strands_, side, outer);
        const SampledContour& inner = end_contour(strands_, side, hole);
        const auto across = points_at(with_origin(inner, aligned_origin(ridge, inner)), ridge.parameters);
        for (std::size_t i = 0; i < across.size(); ++i)
            ridge.points[i] = {(ridge.points[i].x + across[i].x) / 2, (ridge.points[i].y + across[i].y) / 2,
                               graph_.nodes[n].position.z};
        const Ring ring = surface_.add_ring(std::move(ridge));
        for (const std::uint32_t e : side.edges) {
            end_of(strands_, side, e).kind = Kind::Ridge;
            end_of(strands_, side, e).ring = ring;
        }
    }

    const EnhancedReebGraph& graph_;
    const SurfaceOptions& options_;
    const Remedies& remedies_;
    SurfaceMemory& memory_;
    BandSurface surface_;
    std::vector<Strand> strands_;
    std::vector<NodeSheet> node_sheets_;
    std::vector<Place> places_;  // by part of the surface
    std::vector<std::vector<std::uint32_t>> down_,
        up_;  // by node: edges that end there, edges that start there
};

std::set<EdgePlace> places_in(const std::set<std::pair<EdgePlace, EdgePlace>>& pairs) {
    std::set<EdgePlace> places;
    for (const auto& [a, b] : pairs) places.insert({a, b});
    return places;
}

}  // namespace

ConstructedSurface construct_surface(const EnhancedReebGraph& graph, const SurfaceOptions& options,
                                     const SurfaceFinish& finish) {
    check_graph(graph);
    Remedies remedies;
    SurfaceMemory own;
    SurfaceMemory& memory = finish.memory ? *finish.memory : own;
    std::optional<ConstructedSurface> best;  // with the fewest crossings so far
    for (std::size_t round = 1;; ++round) {
        Construction construction(graph, options, remedies, memory);
        ConstructedSurface surface = construction.run();
        if (finish.run) finish.run(surface);
        if (!options.avoid_crossings) return surface;
        const auto pairs = construction.crossing_places(surface);
        const auto text = [&](const EdgePlace& place) {
            return construction.text_of_place(finish.named ? *finish.named : graph, place);
        };
        for (const auto& [a, b] : pairs)
            surface.crossings.push_back(text(a) + (a == b ? ", with itself" : ", and " + text(b)));
        if (!best || pairs.size() < best->crossings.size()) best = std::move(surface);
        bool is_new = false;
        for (const EdgePlace& place : places_in(pairs)) is_new |= construction.find_remedy(place, remedies);
        if (!is_new || round == kRounds) return std::move(*best);
    }
}

ConstructedSurface construct_surface(const EnhancedReebGraph& graph, const SurfaceOptions& options) {
    return construct_surface(graph, options, {});
}

}  // namespace stratareeb
