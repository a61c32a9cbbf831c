// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/horizontal_section.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "mesh/ring_stitching.h"

namespace stratareeb {

namespace {

//! A corner of a layer's part of the level: a plan vertex, or where a horizon crosses the level on a plan edge. Horizons that
//! coincide on an edge cross it in one place.
using Corner = std::uint64_t;

class LevelCut {
 public:
    LevelCut(const LayerModel& model, double z)
        : model_(model), plan_(model.plan.surface), z_(z - model.origin.z), borders_(model.units.size()) {
        count_above();
        for (const auto f : plan_.faces()) cut_face(f);
    }

    std::vector<LevelPolygon> polygons() {
        std::vector<LevelPolygon> result;
        for (std::size_t layer = 0; layer < borders_.size(); ++layer)
            for (auto& rings : nest_rings(rings_of(layer))) result.push_back({layer, std::move(rings)});
        return result;
    }

 private:
    using Side = std::array<Corner, 2>;
    static constexpr std::uint32_t kAtVertex = ~0u;

    //! How many horizons lie at the level or above, by vertex: horizons are in order, so it is the first that many.
    void count_above() {
        above_.resize(plan_.n_vertices());
        for (const std::vector<double>& horizon : model_.horizons)
            for (std::size_t v = 0; v < above_.size(); ++v) above_[v] += horizon[v] >= z_;
    }

    static std::size_t index(TriMesh::VertexHandle v) { return static_cast<std::size_t>(v.idx()); }

    void cut_face(TriMesh::FaceHandle f) {
        std::size_t fewest = model_.horizons.size(), most = 0;
        bool outer = false;
        for (const auto h : plan_.fh_range(f)) {
            const std::size_t above = above_[index(plan_.from_vertex_handle(h))];
            fewest = std::min(fewest, above);
            most = std::max(most, above);
            outer |= plan_.is_boundary(plan_.opposite_halfedge_handle(h));
        }
        if (fewest == most && !outer) return;  // within one layer, or none
        const LayerSet& present = model_.regions.in_face[static_cast<std::size_t>(f.idx())];
        for (std::size_t layer = fewest == 0 ? 0 : fewest - 1; layer < most && layer < borders_.size();
             ++layer)
            if (present[layer]) add_part(f, layer);
    }

    //! The convex part of a triangle in which the layer is at the level, as sides in turn. Sides along an edge of the plan are those
    //! of the triangle beyond too, turned round, since what is on an edge is told by its ends alone: they go out at once.
    void add_part(TriMesh::FaceHandle f, std::size_t layer) {
        corners_.clear();
        on_.clear();
        for (const auto h : plan_.fh_range(f)) {
            const std::size_t u = index(plan_.from_vertex_handle(h)), v = index(plan_.to_vertex_handle(h));
            const auto edge = static_cast<std::uint32_t>(plan_.edge_handle(h).idx());
            if (above_[u] == layer + 1) push(vertex_corner(u), h);
            const bool top_at_u = above_[u] > layer, top_at_v = above_[v] > layer;
            const bool base_at_u = above_[u] > layer + 1, base_at_v = above_[v] > layer + 1;
            // From above, the base comes down to the level before the top does; from below, the top rises first.
            if (base_at_u && !base_at_v) push(crossing(edge, layer + 1), h);
            if (top_at_u != top_at_v) push(crossing(edge, layer), h);
            if (!base_at_u && base_at_v) push(crossing(edge, layer + 1), h);
        }
        while (corners_.size() > 1 && corners_.front() == corners_.back()) corners_.pop_back();
        if (corners_.size() < 3) return;
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const std::size_t next = (i + 1) % corners_.size();
            const auto h = on_[i];
            const bool along_edge =
                on_[next] == h || corners_[next] == vertex_corner(index(plan_.to_vertex_handle(h)));
            if (!along_edge || plan_.is_boundary(plan_.opposite_halfedge_handle(h)))
                borders_[layer].push_back({corners_[i], corners_[next]});
        }
    }

    //! A corner at the start of a half-edge or on it.
    void push(Corner corner, TriMesh::HalfedgeHandle h) {
        if (!corners_.empty() && corners_.back() == corner) return;
        corners_.push_back(corner);
        on_.push_back(h);
    }

    static Corner vertex_corner(std::size_t v) { return (static_cast<Corner>(v) << 32) | kAtVertex; }

    Corner crossing(std::uint32_t edge, std::size_t horizon) const {
        const auto [u, v] = ends(edge);
        const auto& z = model_.horizons;
        while (horizon > 0 && z[horizon][u] == z[horizon - 1][u] && z[horizon][v] == z[horizon - 1][v])
            --horizon;
        return (static_cast<Corner>(plan_.n_vertices() + edge) << 32) | horizon;
    }

    std::array<std::size_t, 2> ends(std::uint32_t edge) const {
        const auto h = plan_.halfedge_handle(TriMesh::EdgeHandle(static_cast<int>(edge)), 0);
        return {index(plan_.from_vertex_handle(h)), index(plan_.to_vertex_handle(h))};
    }

    Point2 point_of(Corner corner) const {
        const auto number = static_cast<std::size_t>(corner >> 32);
        const auto map_point = [&](std::size_t v) {
            const auto& p = plan_.point(TriMesh::VertexHandle(static_cast<int>(v)));
            return Point2{p[0] + model_.origin.x, p[1] + model_.origin.y};
        };
        if (number < plan_.n_vertices()) return map_point(number);
        const auto [u, v] = ends(static_cast<std::uint32_t>(number - plan_.n_vertices()));
        const auto& z = model_.horizons[static_cast<std::uint32_t>(corner)];
        const double share = (z_ - z[u]) / (z[v] - z[u]);
        const Point2 p = map_point(u), q = map_point(v);
        return {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)};
    }

    std::vector<std::vector<Point2>> rings_of(std::size_t layer) {
        auto& sides = borders_[layer];
        std::ranges::sort(sides);
        std::vector<Corner> corners;
        for (const Side& side : sides) corners.push_back(side[0]);
        std::ranges::sort(corners);
        const auto repeated = std::ranges::unique(corners);
        corners.erase(repeated.begin(), repeated.end());
        const auto number = [&](Corner corner) {
            return static_cast<std::uint32_t>(std::ranges::lower_bound(corners, corner) - corners.begin());
        };
        std::vector<Point2> points;
        for (const Corner corner : corners) points.push_back(point_of(corner));
        std::vector<std::array<std::uint32_t, 2>> borders;
        for (const Side& side : sides) borders.push_back({number(side[0]), number(side[1])});
        std::vector<std::vector<Point2>> rings;
        for (const auto& ring : stitch_rings(points, std::move(borders))) {
            auto& outline = rings.emplace_back();
            for (const std::uint32_t p : ring)
                if (outline.empty() || !(outline.back() == points[p])) outline.push_back(points[p]);
            while (outline.size() > 1 && outline.front() == outline.back()) outline.pop_back();
            if (outline.size() < 3) rings.pop_back();
        }
        return rings;
    }

    const LayerModel& model_;
    const TriMesh& plan_;
    double z_;
    std::vector<std::uint32_t> above_;
    std::vector<Corner> corners_;
    std::vector<TriMesh::HalfedgeHandle> on_;  // of each corner
    std::vector<std::vector<Side>> borders_;   // by layer
};

}  // namespace

std::vector<LevelPolygon> horizontal_section(const LayerModel& model, double z) {
    return LevelCut(model, z).polygons();
}

double area(const LevelPolygon& polygon) {
    double sum = 0;
    for (const auto& ring : polygon.rings) sum += ring_area(ring);
    return sum;
}

}  // namespace stratareeb
