// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/stack_cell.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "boreholes/errors.h"
#include "mesh/region_triangulation.h"
#include "mesh/tri_mesh.h"
#include "reeb/graph_of_mesh.h"
#include "reeb/harmonic_heights.h"
#include "reeb/link_signs.h"

namespace stratareeb {

namespace {

constexpr double kStretched = 0.05;  // of the heights, see harmonic_heights
constexpr double kEdgesAcross = 6;   // of the region's mean width
constexpr double kMostPoints = 60'000;
constexpr std::size_t kAttempts = 3;
constexpr double kFiner = 2.5;
constexpr std::size_t kLevels = 3;  // of contours between

double edge_length(std::span<const CellRing> rings) {
    double largest = 0, all = 0, length = 0;
    for (const CellRing& ring : rings) {
        double twice = 0;
        for (std::size_t i = 0; i < ring.points.size(); ++i) {
            const Point2 &o = ring.points[0], &a = ring.points[i],
                         &b = ring.points[(i + 1) % ring.points.size()];
            twice += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
            length += std::hypot(b.x - a.x, b.y - a.y);
        }
        largest = std::max(largest, std::abs(twice) / 2);
        all += std::abs(twice) / 2;
    }
    const double area = 2 * largest - all;  // of the outer ring without the others
    return std::max(2 * area / length / kEdgesAcross, std::sqrt(area / kMostPoints));
}

//! A sheet over the region, facing up; nothing if it has other critical points than saddles.
std::optional<TriangleSoup> harmonic_sheet(std::span<const CellRing> rings, double low, double high,
                                           double edge) {
    std::vector<RegionRing> around;
    TriangleSoup sheet;
    for (const CellRing& ring : rings) {
        around.push_back({ring.points, ring.is_lower ? 0u : 1u});
        for (const Point2& p : ring.points) sheet.points.push_back({p.x, p.y, ring.is_lower ? low : high});
    }
    const std::size_t given = sheet.points.size();
    auto region = triangulate_region(around, {}, {.largest_edge = edge});
    for (const Point2& p : region.added) sheet.points.push_back({p.x, p.y, low});
    sheet.triangles = std::move(region.triangles);
    std::vector<std::optional<double>> fixed(sheet.points.size());
    for (std::size_t v = 0; v < given; ++v) fixed[v] = sheet.points[v].z;
    const auto heights = harmonic_heights(sheet, fixed, kStretched);
    if (!heights) return std::nullopt;
    std::vector<bool> is_free(sheet.points.size(), false);
    for (std::size_t v = given; v < sheet.points.size(); ++v) {
        sheet.points[v].z = (*heights)[v];
        is_free[v] = true;
        if (!(low < sheet.points[v].z && sheet.points[v].z < high)) return std::nullopt;
    }
    const auto signs = link_signs(sheet, is_free);
    for (std::size_t v = given; v < signs.size(); ++v)
        if (signs[v] == kLowest || signs[v] == kHighest) return std::nullopt;
    return sheet;
}

class CellReader {
 public:
    CellReader(std::span<const CellRing> rings, double low, double high) : rings_(rings.size()) {
        for (std::uint32_t r = 0; r < rings.size(); ++r)
            for (const Point2& p : rings[r].points) ring_at_[{p.x, p.y, rings[r].is_lower ? low : high}] = r;
    }

    //! \return nothing if it isn't one tree of edges from every ring to saddles
    std::optional<CellGraph> read(const EnhancedReebGraph& graph) {
        std::vector<std::uint32_t> end(graph.nodes.size());
        for (std::uint32_t n = 0; n < graph.nodes.size(); ++n) {
            const EnhancedNode& node = graph.nodes[n];
            const Point3& p = node.position;
            if (node.form == NodeForm::Flat) return std::nullopt;
            if (node.form == NodeForm::Open) {
                const auto at = ring_at_.find({p.x, p.y, p.z});
                if (at == ring_at_.end()) return std::nullopt;
                end[n] = at->second;
            } else {
                end[n] = static_cast<std::uint32_t>(rings_ + result_.nodes.size());
                result_.nodes.push_back(p);
            }
        }
        std::vector<std::size_t> ends_at(rings_, 0);
        for (const EnhancedEdge& edge : graph.edges) {
            CellEdge& own = result_.edges.emplace_back();
            own.from = end[edge.from];
            own.to = end[edge.to];
            for (const std::uint32_t e : {own.from, own.to})
                if (e < rings_) ++ends_at[e];
            for (const std::uint32_t c : edge.contours) {
                const auto& points = graph.contours[c].curve.points;
                const double z = points.front().z;
                const bool is_ring = (own.from < rings_ && z == graph.nodes[edge.from].position.z) ||
                                     (own.to < rings_ && z == graph.nodes[edge.to].position.z);
                if (!is_ring) own.contours.push_back(points);
            }
        }
        if (!std::ranges::all_of(ends_at, [](std::size_t count) { return count == 1; })) return std::nullopt;
        return std::move(result_);
    }

 private:
    std::size_t rings_;
    std::map<std::tuple<double, double, double>, std::uint32_t> ring_at_;
    CellGraph result_;
};

}  // namespace

std::optional<CellGraph> cell_graph(std::span<const CellRing> rings, double low, double high) {
    double edge = edge_length(rings);
    for (std::size_t attempt = 0; attempt < kAttempts; ++attempt, edge /= kFiner) try {
            const auto sheet = harmonic_sheet(rings, low, high, edge);
            if (!sheet) continue;
            const EnhancedReebGraph graph =
                graph_of_mesh(half_edge_mesh(*sheet), {.levels = kLevels, .crossing_rounds = 0});
            if (auto cell = CellReader(rings, low, high).read(graph)) return cell;
        } catch (const InvalidInput&) {
            // Rings too close for triangles, or contours that touch: finer ones may do.
        }
    return std::nullopt;
}

}  // namespace stratareeb
