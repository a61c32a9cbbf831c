// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/graph_of_stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>

#include "boreholes/errors.h"
#include "reeb/inner_point.h"
#include "reeb/ring_gap.h"
#include "reeb/stack_cell.h"
#include "reeb/stack_level.h"
#include "reeb/stack_transition.h"

namespace stratareeb {

namespace {

constexpr std::uint32_t kNone = ~0u;
constexpr double kDomeHeight = 0.75;  // of the spacing: two thirds of a dome's prism, half a spacing's
constexpr double kFlatHeight = 0.5;
constexpr double kShortHeight = 0.45;  // beside others, which may come as far from the other level

Curve ring_curve(const StackContour& contour, double z) {
    Curve curve;
    curve.closed = true;
    for (const Point2& p : contour.points) curve.points.push_back({p.x, p.y, z});
    return curve;
}

class Builder {
 public:
    Builder(const SortedStack& stack, const StackGraphOptions& options)
        : stack_(stack),
          options_(options),
          next_(stack.contours.size(), kNone),
          node_below_(next_.size(), kNone),
          node_above_(next_.size(), kNone),
          flat_below_(next_.size(), kNone),
          flat_above_(next_.size(), kNone) {}

    StackGraph run() {
        for (const StackContour& contour : stack_.contours) add_contour(ring_curve(contour, contour.z));
        result_.source = stack_.source;
        result_.levels = stack_.levels();
        const StackLevel nothing(std::span<const StackContour>{});
        StackLevel lower = nothing;
        for (std::size_t l = 0; l <= stack_.levels(); ++l) {
            StackLevel upper = l < stack_.levels() ? StackLevel(contours_of(l)) : nothing;
            if (is_gap(l)) {
                step(lower, nothing, l);
                step(nothing, upper, l);
            } else {
                step(lower, upper, l);
            }
            lower = std::move(upper);
        }
        add_edges();
        sort_nodes();
        return std::move(result_);
    }

 private:
    std::span<const StackContour> contours_of(std::size_t l) const {
        return std::span(stack_.contours).subspan(stack_.first[l], stack_.first[l + 1] - stack_.first[l]);
    }
    double z_of(std::size_t l) const { return stack_.contours[stack_.first[l]].z; }

    std::uint32_t add_contour(Curve curve) {
        const auto c = static_cast<std::uint32_t>(result_.graph.contours.size());
        EnhancedContour& contour = result_.graph.contours.emplace_back();
        contour.id = std::int64_t{c} + 1;
        contour.curve = std::move(curve);
        return c;
    }

    std::uint32_t add_node(const Point2& place, double z) {
        result_.graph.nodes.emplace_back().position = {place.x, place.y, z};
        return static_cast<std::uint32_t>(result_.graph.nodes.size() - 1);
    }

    //! Is the space under level l, or over the last one, between two bodies?
    bool is_gap(std::size_t l) const {
        return options_.most_spacing && l > 0 && l < stack_.levels() &&
               z_of(l) - z_of(l - 1) > *options_.most_spacing;
    }

    bool is_joined(std::size_t l) const { return l > 0 && l < stack_.levels() && !is_gap(l); }

    //! For what ends over level l - 1, which is under level l, if any.
    double spacing_above(std::size_t l) const {
        return is_joined(l) ? z_of(l) - z_of(l - 1) : end_spacing(l, l - 1);
    }
    //! For what starts under level l.
    double spacing_below(std::size_t l) const {
        return is_joined(l) ? z_of(l) - z_of(l - 1) : end_spacing(l, l + 1);
    }

    //! In the open space under level l: as asked for, or as on the other side of the level that ends there.
    double end_spacing(std::size_t l, std::size_t other_side) const {
        double spacing = 0;
        if (options_.end_spacing)
            spacing = *options_.end_spacing;
        else if (is_joined(other_side))
            spacing = z_of(other_side) - z_of(other_side - 1);
        else
            spacing = options_.most_spacing.value_or(0);
        return is_gap(l) ? std::min(spacing, (z_of(l) - z_of(l - 1)) / 2) : spacing;
    }

    void step(const StackLevel& lower, const StackLevel& upper, std::size_t l) {
        const std::uint32_t first_lower = l > 0 ? stack_.first[l - 1] : 0, first_upper = stack_.first[l];
        const StackTransitions transitions = stack_transitions(lower, upper, options_.least_share);
        std::set<std::uint32_t> done;  // sheets
        for (const StackTransition& cell : transitions.cells)
            if (join_cell(cell, first_lower, first_upper)) done.insert(cell.sheet);
        std::vector<std::size_t> beside(transitions.pieces.size(), 0);  // pieces by sheet
        for (const StackTransition& piece : transitions.pieces) ++beside[piece.sheet];
        for (const StackTransition& piece : transitions.pieces) {
            if (done.contains(piece.sheet)) continue;
            const bool alone = beside[piece.sheet] == 1;
            std::vector<std::uint32_t> below, above;
            for (const std::uint32_t r : piece.lower) below.push_back(first_lower + r);
            for (const std::uint32_t r : piece.upper) above.push_back(first_upper + r);
            if (below.size() == 1 && above.size() == 1)
                next_[below.front()] = above.front();
            else if (above.empty())
                end(below, z_of(l - 1), spacing_above(l), alone, node_above_, flat_above_);
            else if (below.empty())
                end(above, z_of(l), -spacing_below(l), alone, node_below_, flat_below_);
            else
                branch(below, above, lower, upper);
        }
        for (const DroppedOverlap& drop : transitions.dropped)
            if (!done.contains(drop.sheet))
                result_.dropped.push_back({first_lower + drop.lower, first_upper + drop.upper, drop.share});
    }

    //! Several contours and several, with what is between them. \return whether there is a way
    bool join_cell(const StackTransition& cell, std::uint32_t first_lower, std::uint32_t first_upper) {
        std::vector<std::uint32_t> contours;
        std::vector<CellRing> rings;
        for (const std::uint32_t r : cell.lower) contours.push_back(first_lower + r);
        for (const std::uint32_t r : cell.upper) contours.push_back(first_upper + r);
        for (std::size_t i = 0; i < contours.size(); ++i)
            rings.push_back({stack_.contours[contours[i]].points, i < cell.lower.size()});
        const auto graph =
            cell_graph(rings, stack_.contours[contours.front()].z, stack_.contours[contours.back()].z);
        if (!graph) return false;
        const auto first_node = static_cast<std::uint32_t>(result_.graph.nodes.size());
        for (const Point3& p : graph->nodes) add_node({p.x, p.y}, p.z);
        const auto node = [&](std::uint32_t end) {
            return first_node + end - static_cast<std::uint32_t>(rings.size());
        };
        for (const CellEdge& edge : graph->edges) {
            std::vector<std::uint32_t> between;
            for (const auto& points : edge.contours) {
                between.push_back(add_contour({}));
                result_.graph.contours.back().curve.closed = true;
                result_.graph.contours.back().curve.points = points;
            }
            if (edge.from < rings.size()) {
                node_above_[contours[edge.from]] = node(edge.to);
                beyond_[contours[edge.from]] = between;
            } else if (edge.to < rings.size()) {
                node_below_[contours[edge.to]] = node(edge.from);
                before_[contours[edge.to]] = between;
            } else {
                result_.graph.edges.push_back({.from = node(edge.from),
                                               .to = node(edge.to),
                                               .curve = {},
                                               .contours = between,
                                               .homotopy = options_.homotopy});
            }
        }
        return true;
    }

    std::vector<std::vector<Point2>> rings_of(const std::vector<std::uint32_t>& contours) const {
        std::vector<std::vector<Point2>> rings;
        for (const std::uint32_t c : contours) rings.push_back(stack_.contours[c].points);
        return rings;
    }

    void end(const std::vector<std::uint32_t>& contours, double z, double beyond, bool alone,
             std::vector<std::uint32_t>& node_at, std::vector<std::uint32_t>& flat_at) {
        const bool flat = (options_.ends == StackEnds::Flat && contours.size() == 1) || contours.size() > 2;
        const double share = !alone ? kShortHeight : flat ? kFlatHeight : kDomeHeight;
        const double height = z + share * beyond;
        const std::uint32_t node = add_node(inner_point(rings_of(contours)), height);
        for (const std::uint32_t c : contours) node_at[c] = node;
        if (!flat) return;
        if (contours.size() > 1) result_.graph.nodes[node].form = NodeForm::Flat;
        for (const std::uint32_t c : contours)
            flat_at[c] = add_contour(ring_curve(stack_.contours[c], height));
    }

    void branch(const std::vector<std::uint32_t>& below, const std::vector<std::uint32_t>& above,
                const StackLevel& lower, const StackLevel& upper) {
        const Point2 place = ring_gap(rings_of(below.size() > 1 ? below : above), [&](const Point2& p) {
            return lower.is_solid(p) != upper.is_solid(p);
        });
        const std::uint32_t node = add_node(place, lower.z() + (upper.z() - lower.z()) / 2);
        for (const std::uint32_t c : below) node_above_[c] = node;
        for (const std::uint32_t c : above) node_below_[c] = node;
    }

    void add_edges() {
        for (std::uint32_t c = 0; c < next_.size(); ++c) {
            if (node_below_[c] == kNone) continue;  // it goes on from another one
            EnhancedEdge edge;
            edge.homotopy = options_.homotopy;
            edge.from = node_below_[c];
            if (flat_below_[c] != kNone) edge.contours.push_back(flat_below_[c]);
            std::uint32_t last = c;
            append(edge.contours, before_, c);
            edge.contours.push_back(last);
            while (next_[last] != kNone) edge.contours.push_back(last = next_[last]);
            append(edge.contours, beyond_, last);
            edge.to = node_above_[last];
            if (flat_above_[last] != kNone) edge.contours.push_back(flat_above_[last]);
            result_.graph.edges.push_back(std::move(edge));
        }
    }

    using Between = std::map<std::uint32_t, std::vector<std::uint32_t>>;  // contours, by contour of the stack
    static void append(std::vector<std::uint32_t>& contours, const Between& between, std::uint32_t c) {
        const auto own = between.find(c);
        if (own != between.end()) contours.insert(contours.end(), own->second.begin(), own->second.end());
    }

    //! They were made in order of the levels below them; ends under a level may be lower than ends over the one before.
    void sort_nodes() {
        auto& nodes = result_.graph.nodes;
        std::vector<std::uint32_t> order(nodes.size()), place(nodes.size());
        for (std::uint32_t n = 0; n < order.size(); ++n) order[n] = n;
        std::ranges::stable_sort(order, {}, [&](std::uint32_t n) { return nodes[n].position.z; });
        std::vector<EnhancedNode> sorted(nodes.size());
        for (std::uint32_t n = 0; n < order.size(); ++n) {
            place[order[n]] = n;
            sorted[n].id = std::int64_t{n} + 1;
            sorted[n].position = nodes[order[n]].position;
            sorted[n].form = nodes[order[n]].form;
        }
        nodes = std::move(sorted);
        for (EnhancedEdge& edge : result_.graph.edges) {
            edge.from = place[edge.from];
            edge.to = place[edge.to];
        }
    }

    const SortedStack& stack_;
    const StackGraphOptions& options_;
    StackGraph result_;
    // By contour of the stack: the one it goes on in, the nodes it starts and ends at, its copy at a flat end.
    std::vector<std::uint32_t> next_, node_below_, node_above_, flat_below_, flat_above_;
    Between before_, beyond_;  // contours of a cell under and over one
};

}  // namespace

StackGraph graph_of_stack(const ContourStack& stack, const StackGraphOptions& options) {
    if (stack.contours.empty()) throw InvalidInput("there is no contour to make a graph of");
    for (const auto& spacing : {options.end_spacing, options.most_spacing})
        if (spacing && !(*spacing > 0 && std::isfinite(*spacing)))
            throw InvalidInput(fmt::format("a spacing of levels of {}; it must be positive", *spacing));
    if (!(options.least_share > 0 && options.least_share <= 1))
        throw InvalidInput(fmt::format("contours sharing {} of their area; give a part between 0 and 1",
                                       options.least_share));
    const SortedStack sorted = sorted_stack(stack);
    if (sorted.levels() == 1 && !options.end_spacing && !options.most_spacing)
        throw InvalidInput(
            fmt::format("all contours are at height {}: give the spacing of levels, which is the height "
                        "of a body with one",
                        sorted.contours.front().z));
    return Builder(sorted, options).run();
}

}  // namespace stratareeb
