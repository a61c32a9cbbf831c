// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/surface_of_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "boreholes/errors.h"
#include "mesh/ring_fill.h"
#include "mesh/soup_topology.h"
#include "reeb/graph_conditions.h"
#include "reeb/level_pieces.h"

namespace stratareeb {

namespace {

constexpr std::uint32_t kNone = ~0u;
constexpr std::size_t kLeastSteps = 3;  // beside a contour that comes to a corner twice: keeps these apart

using Triangle = std::array<std::uint32_t, 3>;
using Place = std::pair<double, double>;

class Assembly {
 public:
    Assembly(const EnhancedReebGraph& graph, const LevelPieces& pieces, ConstructedSurface surface)
        : graph_(graph), pieces_(pieces), surface_(std::move(surface)) {}

    ConstructedSurface run() {
        turn_pieces();
        open_ends();
        join_ends();
        find_sides();
        for (std::uint32_t n = 0; n < graph_.nodes.size(); ++n)
            if (graph_.nodes[n].form == NodeForm::Flat) fill(n);
        part_fans();
        drop_unused_points();
        return std::move(surface_);
    }

 private:
    void turn_pieces() {
        for (std::size_t t = 0; t < surface_.soup.triangles.size(); ++t)
            if (pieces_.turned[surface_.triangle_edge[t]])
                std::swap(surface_.soup.triangles[t][1], surface_.soup.triangles[t][2]);
    }

    bool is_at(const Triangle& triangle, double z) const {
        return std::ranges::all_of(triangle, [&](std::uint32_t v) { return surface_.soup.points[v].z == z; });
    }

    double height_of(const LevelEnd& end) const { return graph_.nodes[end.node].position.z; }

    //! Leave out the level caps.
    void open_ends() {
        std::vector<std::vector<double>> heights(graph_.edges.size());
        for (const LevelEnd& end : pieces_.ends) heights[end.edge].push_back(height_of(end));
        TriangleSoup& soup = surface_.soup;
        std::size_t kept = 0;
        for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
            const std::uint32_t edge = surface_.triangle_edge[t];
            if (std::ranges::any_of(heights[edge], [&](double z) { return is_at(soup.triangles[t], z); }))
                continue;
            soup.triangles[kept] = soup.triangles[t];
            surface_.triangle_part[kept] = surface_.triangle_part[t];
            surface_.triangle_edge[kept++] = edge;
        }
        soup.triangles.resize(kept);
        surface_.triangle_edge.resize(kept);
        surface_.triangle_part.resize(kept);
    }

    //! One vertex for each place of a node's contours.
    void join_ends() {
        std::map<std::tuple<std::uint32_t, double, double, double>, std::pair<std::uint32_t, Place>>
            at;  // edge, place -> node, place
        for (const LevelEnd& end : pieces_.ends)
            for (std::size_t i = 0; i < end.points.size(); ++i)
                at[{end.edge, end.apart[i].x, end.apart[i].y, end.apart[i].z}] = {
                    end.node, {end.points[i].x, end.points[i].y}};
        vertex_at_.resize(graph_.nodes.size());
        TriangleSoup& soup = surface_.soup;
        for (std::size_t t = 0; t < soup.triangles.size(); ++t)
            for (std::uint32_t& v : soup.triangles[t]) {
                const Point3& p = soup.points[v];
                const auto found = at.find({surface_.triangle_edge[t], p.x, p.y, p.z});
                if (found == at.end()) continue;
                const auto& [node, place] = found->second;
                v = vertex_at_[node].try_emplace(place, v).first->second;
            }
        for (std::uint32_t n = 0; n < vertex_at_.size(); ++n)
            for (const auto& [place, v] : vertex_at_[n])
                soup.points[v] = {place.first, place.second, graph_.nodes[n].position.z};
    }

    //! The level triangles of a node, turned as the pieces around them ask.
    void fill(std::uint32_t n) {
        std::vector<Point2> corners;
        std::vector<std::uint32_t> vertices;
        std::map<Place, std::uint32_t> number;
        for (const auto& [place, v] : vertex_at_[n]) {
            number[place] = static_cast<std::uint32_t>(corners.size());
            corners.push_back({place.first, place.second});
            vertices.push_back(v);
        }
        std::vector<std::vector<std::uint32_t>> rings;
        std::uint32_t edge = kNone;
        for (const LevelEnd& end : pieces_.ends) {
            if (end.node != n) continue;
            edge = std::min(edge, end.edge);
            rings.emplace_back();
            for (const Point3& p : end.points) rings.back().push_back(number.at({p.x, p.y}));
        }
        std::vector<Triangle> triangles = ring_fill(corners, rings);
        for (Triangle& t : triangles)
            for (std::uint32_t& v : t) v = vertices[v];
        face_as_around(n, triangles);
        surface_.soup.triangles.insert(surface_.soup.triangles.end(), triangles.begin(), triangles.end());
        surface_.triangle_edge.resize(surface_.soup.triangles.size(), edge);
        surface_.triangle_part.resize(surface_.soup.triangles.size(), kNoPart);
    }

    //! Sides of triangles that run from one vertex of a node to another.
    void find_sides() {
        std::vector<std::uint32_t> node_of(surface_.soup.points.size(), kNone);
        for (std::uint32_t n = 0; n < vertex_at_.size(); ++n)
            for (const auto& [place, v] : vertex_at_[n]) node_of[v] = n;
        sides_.resize(vertex_at_.size());
        for (const Triangle& t : surface_.soup.triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = t[i], b = t[(i + 1) % 3], n = node_of[a];
                if (n != kNone && node_of[b] == n && !sides_[n].insert({a, b}).second)
                    throw InvalidInput(fmt::format(
                        "node {}: more than two pieces meet along one side, from ({:.10g}, {:.10g})",
                        text_of(graph_.nodes[n].id), surface_.soup.points[a].x, surface_.soup.points[a].y));
            }
    }

    void face_as_around(std::uint32_t n, std::vector<Triangle>& triangles) const {
        const auto& around = sides_[n];
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> first;  // triangle with that side
        DisjointSets patches(triangles.size());
        for (std::uint32_t t = 0; t < triangles.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i) {
                const auto side = std::minmax(triangles[t][i], triangles[t][(i + 1) % 3]);
                const auto [at, is_new] = first.try_emplace(side, t);
                if (!is_new) patches.unite(t, at->second);
            }
        std::vector<bool> turned(triangles.size(), false);
        for (std::uint32_t t = 0; t < triangles.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i)
                if (around.contains({triangles[t][i], triangles[t][(i + 1) % 3]}))
                    turned[patches.find(t)] = true;
        for (std::uint32_t t = 0; t < triangles.size(); ++t)
            if (turned[patches.find(t)]) std::swap(triangles[t][1], triangles[t][2]);
    }

    //! Pieces that only touch in a corner have a vertex each there.
    void part_fans() {
        TriangleSoup& soup = surface_.soup;
        const SoupTopology topology = soup_topology(soup);
        std::map<std::uint32_t, std::uint32_t> copy;  // by fan
        std::vector<Triangle> triangles = soup.triangles;
        for (const std::uint32_t corner : corners_in_further_fans(soup, topology)) {
            const auto [at, is_new] = copy.try_emplace(topology.fan_of_corner[corner],
                                                       static_cast<std::uint32_t>(soup.points.size()));
            if (is_new) soup.points.push_back(Point3(soup.points[vertex_at(soup, corner)]));
            triangles[corner / 3][corner % 3] = at->second;
        }
        soup.triangles = std::move(triangles);
    }

    void drop_unused_points() {
        TriangleSoup& soup = surface_.soup;
        std::vector<std::uint32_t> number(soup.points.size(), kNone);
        for (const Triangle& t : soup.triangles)
            for (const std::uint32_t v : t) number[v] = 0;
        std::uint32_t next = 0;
        for (std::size_t v = 0; v < number.size(); ++v) {
            if (number[v] == kNone) continue;
            soup.points[next] = soup.points[v];
            number[v] = next++;
        }
        soup.points.resize(next);
        for (Triangle& t : soup.triangles)
            for (std::uint32_t& v : t) v = number[v];
    }

    const EnhancedReebGraph& graph_;
    const LevelPieces& pieces_;
    ConstructedSurface surface_;
    std::vector<std::map<Place, std::uint32_t>> vertex_at_;                 // by node
    std::vector<std::set<std::pair<std::uint32_t, std::uint32_t>>> sides_;  // by node, see find_sides
};

}  // namespace

ConstructedSurface surface_of_graph(const EnhancedReebGraph& graph, const SurfaceOptions& options,
                                    SurfaceMemory* memory) {
    if (!has_level_nodes(graph)) return construct_surface(graph, options, {.memory = memory});
    check_graph(graph);
    const LevelPieces pieces = level_pieces(graph, options.samples);
    SurfaceOptions own = options;
    if (pieces.has_pinched_ends) own.steps = std::max(own.steps, kLeastSteps);
    const auto assemble = [&](ConstructedSurface& surface) {
        surface = Assembly(graph, pieces, std::move(surface)).run();
    };
    return construct_surface(pieces.graph, own, {.run = assemble, .named = &graph, .memory = memory});
}

}  // namespace stratareeb
