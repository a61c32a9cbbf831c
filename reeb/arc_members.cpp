// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/arc_members.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "reeb/arc_curves.h"

namespace stratareeb {

namespace {

constexpr double kShortArc = 1.0 / 512;  // of the field's range: what a sample should at least stand for
constexpr std::size_t kManyArcs = 4096;

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // fine arc, coarse arc

void add_pairs(const std::vector<std::uint32_t>& fine, const std::vector<std::uint32_t>& coarse,
               const std::vector<bool>& is_known, Pairs& pairs) {
    std::pair<std::uint32_t, std::uint32_t> last{ReebGraph::kNone, ReebGraph::kNone};
    for (std::size_t i = 0; i < std::min(fine.size(), coarse.size()); ++i) {
        const std::pair here{fine[i], coarse[i]};
        if (here == last || here.first == ReebGraph::kNone || here.second == ReebGraph::kNone) continue;
        if (!is_known[here.first]) pairs.push_back(here);
        last = here;
    }
}

Point3 place(const TriMesh& mesh, const ReebNode& node) {
    const auto& p = mesh.point(TriMesh::VertexHandle(static_cast<int>(node.vertex)));
    return {p[0], p[1], p[2]};
}

bool spans(const ReebGraph& graph, std::uint32_t arc, double level) {
    return graph.nodes[graph.arcs[arc].lower].value < level &&
           level <= graph.nodes[graph.arcs[arc].upper].value;
}

//! The centre of the longest contour at a level among those of some arcs.
std::optional<Point3> main_center(const ReebGraph& fine, const ArcIndex& index,
                                  const std::vector<std::uint32_t>& arcs, double level) {
    std::optional<Point3> center;
    double longest = -1;
    for (const std::uint32_t arc : arcs) {
        if (!spans(fine, arc, level)) continue;
        const Contour contour = index.contour(arc, level);
        if (contour.points.empty() || contour.length() <= longest) continue;
        longest = contour.length();
        center = center_of(contour);
    }
    return center;
}

//! Contours of a long family can be as long as the surface is wide, and a noisy surface has many families that reach hardly up:
//! those get fewer samples, in large graphs none, so that the work stays that of some hundred levels.
std::size_t samples_of(const ReebGraph& graph, double range, double span, std::size_t most) {
    const double worth = range > 0 ? span / range / kShortArc : 0;
    const std::size_t least = graph.arcs.size() > kManyArcs ? 0 : 1;
    return worth >= static_cast<double>(most)
               ? most
               : std::min(most, std::max(least, static_cast<std::size_t>(worth)));
}

double range_of(const ReebGraph& graph) {
    if (graph.nodes.empty()) return 0;
    const auto [low, high] = std::ranges::minmax(graph.nodes, {}, &ReebNode::value);
    return high.value - low.value;
}

ArcMembers each_its_own(std::size_t arcs) {
    ArcMembers members;
    for (std::uint32_t a = 0; a < arcs; ++a) {
        members.fine_of.push_back({a});
        members.coarse_of.push_back({a});
    }
    return members;
}

}  // namespace

ArcMembers arc_members(const ReebGraph& fine, const ReebGraph& coarse) {
    if (&fine == &coarse) return each_its_own(fine.arcs.size());
    Pairs pairs;
    std::vector<bool> is_known(fine.arcs.size(), false);
    add_pairs(fine.triangle_arc, coarse.triangle_arc, is_known, pairs);
    for (const auto& pair : pairs) is_known[pair.first] = true;
    add_pairs(fine.vertex_arc, coarse.vertex_arc, is_known, pairs);
    std::ranges::sort(pairs);
    const auto repeated = std::ranges::unique(pairs);
    pairs.erase(repeated.begin(), repeated.end());
    ArcMembers members;
    members.fine_of.resize(coarse.arcs.size());
    members.coarse_of.resize(fine.arcs.size());
    for (const auto& [f, c] : pairs) {
        members.fine_of[c].push_back(f);
        members.coarse_of[f].push_back(c);
    }
    return members;
}

std::vector<std::vector<Point3>> coarse_arc_curves(const TriMesh& mesh, const ReebGraph& fine,
                                                   const ArcIndex& index, const ReebGraph& coarse,
                                                   const ArcMembers& members, std::size_t samples) {
    std::vector<std::vector<Point3>> curves(coarse.arcs.size());
    const double range = range_of(coarse);
    tbb::parallel_for(std::size_t{0}, curves.size(), [&](std::size_t a) {
        const ReebNode &lower = coarse.nodes[coarse.arcs[a].lower],
                       &upper = coarse.nodes[coarse.arcs[a].upper];
        curves[a].push_back(place(mesh, lower));
        const std::size_t here = samples_of(coarse, range, upper.value - lower.value, samples);
        for (std::size_t k = 1; k <= here; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(here + 1);
            const double level = lower.value + share * (upper.value - lower.value);
            if (!(lower.value < level && level < upper.value)) continue;
            if (const auto center = main_center(fine, index, members.fine_of[a], level))
                curves[a].push_back(*center);
        }
        curves[a].push_back(place(mesh, upper));
    });
    return curves;
}

}  // namespace stratareeb
