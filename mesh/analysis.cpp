// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/analysis.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "boreholes/errors.h"
#include "mesh/compensated_sum.h"
#include "mesh/measures.h"
#include "mesh/self_intersection.h"
#include "mesh/soup_topology.h"
#include "mesh/triangle_contact.h"

namespace stratareeb {
namespace {

constexpr auto kNone = SoupTopology::kNone;

std::string text(const Point3& p) {
    return fmt::format("({:.10g}, {:.10g}, {:.10g})", p.x, p.y, p.z);
}

// The sums over one component that genus and orientation need.
struct Component {
    long long vertices = 0, edges = 0, triangles = 0, boundary_loops = 0;
    CompensatedSum six_volumes;
    std::uint32_t some_vertex = kNone;
    bool closed = true;

    long long euler() const { return vertices - edges + triangles; }
};

class Examination {
 public:
    Examination(const TriangleSoup& soup, const AnalysisOptions& options) : soup_(soup), options_(options) {}

    MeshReport report() {
        require_indices();
        topology_ = soup_topology(soup_);
        measure();
        count_degenerate();
        number_components();
        count_edges();
        count_fans();
        count_boundary_loops();
        decide_orientation();
        sum_components();
        decide_genus();
        if (options_.self_intersections) intersect();
        r_.watertight = r_.closed && r_.manifold && r_.oriented && r_.inverted_components == 0 &&
                        r_.self_intersections == 0 && r_.degenerate_triangles == 0;
        return std::move(r_);
    }

 private:
    void require_indices() const {
        for (std::size_t t = 0; t < soup_.triangles.size(); ++t)
            for (const auto v : soup_.triangles[t])
                if (v >= soup_.points.size())
                    throw InvalidInput(
                        fmt::format("triangle {} names vertex {} of {}", t, v, soup_.points.size()));
    }

    void measure() {
        r_.vertices = soup_.points.size();
        r_.triangles = soup_.triangles.size();
        const auto box = bounding_box(soup_.points);
        r_.box_min = box.min;
        r_.box_max = box.max;
        if (soup_.triangles.empty()) {
            problem("there are no triangles");
            return;
        }
        r_.volume = volume(soup_);
        r_.area = area(soup_);
        const auto quality = triangle_quality(soup_);
        r_.min_edge = quality.min_edge;
        r_.max_edge = quality.max_edge;
        r_.min_angle_deg = quality.min_angle;
        r_.max_angle_deg = quality.max_angle;
        r_.worst_aspect_ratio = quality.worst_aspect_ratio;
        r_.worst_triangle = quality.worst_triangle;
        r_.worst_place = centroid(quality.worst_triangle);
    }

    void count_degenerate() {
        const TriangleContact contact(soup_);
        std::uint32_t first = kNone;
        for (std::uint32_t t = 0; t < soup_.triangles.size(); ++t) {
            if (!contact.is_degenerate(t)) continue;
            ++r_.degenerate_triangles;
            first = std::min(first, t);
        }
        if (r_.degenerate_triangles > 0)
            problem(fmt::format("{} without area, first triangle {} at {}",
                                counted(r_.degenerate_triangles, "triangle"), first, text(centroid(first))));
    }

    void number_components() {
        DisjointSets sets(soup_.points.size());
        component_.assign(soup_.points.size(), kNone);
        for (const auto& t : soup_.triangles) {
            sets.unite(t[0], t[1]);
            sets.unite(t[0], t[2]);
            for (const auto v : t) component_[v] = 0;  // used
        }
        std::vector<std::uint32_t> number(soup_.points.size(), kNone);
        for (std::uint32_t v = 0; v < component_.size(); ++v) {
            if (component_[v] == kNone) {
                ++r_.unused_vertices;
                continue;
            }
            auto& n = number[sets.find(v)];
            if (n == kNone) {
                n = static_cast<std::uint32_t>(parts_.size());
                parts_.push_back({});
                parts_.back().some_vertex = v;
            }
            component_[v] = n;
            ++parts_[n].vertices;
        }
        r_.components = parts_.size();
    }

    void count_edges() {
        std::uint32_t open = kNone, crowded = kNone, opposed = kNone;
        for (std::size_t e = 0; e < topology_.edge_count(); ++e) {
            const auto sides = topology_.sides_of(e);
            auto& part = parts_[component_[vertex_at(soup_, sides[0])]];
            ++part.edges;
            if (sides.size() == 1) {
                ++r_.boundary_edges;
                part.closed = false;
                open = std::min(open, sides[0]);
            }
            if (sides.size() > 2) {
                ++r_.non_manifold_edges;
                crowded = std::min(crowded, sides[0]);
            }
            if (runs_one_way(sides)) {
                ++r_.misoriented_edges;
                opposed = std::min(opposed, sides[0]);
            }
        }
        r_.closed = !soup_.triangles.empty() && r_.boundary_edges == 0;
        edge_problem(r_.boundary_edges, "with a triangle on one side only", open);
        edge_problem(r_.non_manifold_edges, "with more than two triangles", crowded);
        edge_problem(r_.misoriented_edges, "between triangles wound against each other", opposed);
    }

    // Where more than two triangles meet, as many should run along the edge one way as the other.
    bool runs_one_way(std::span<const std::uint32_t> sides) const {
        if (sides.size() < 2) return false;
        long balance = 0;
        for (const auto side : sides)
            balance += vertex_at(soup_, side) < vertex_at(soup_, next_corner(side)) ? 1 : -1;
        return std::abs(balance) > 1;
    }

    void count_fans() {
        std::set<std::uint32_t> vertices;
        for (const std::uint32_t corner : corners_in_further_fans(soup_, topology_))
            vertices.insert(vertex_at(soup_, corner));
        r_.non_manifold_vertices = vertices.size();
        r_.manifold = !soup_.triangles.empty() && r_.non_manifold_edges == 0 && r_.non_manifold_vertices == 0;
        if (!vertices.empty())
            problem(fmt::format("{} with more than one fan of triangles, first vertex {} at {}",
                                counted(vertices.size(), "vertex", "vertices"), *vertices.begin(),
                                text(soup_.points[*vertices.begin()])));
    }

    // Boundary edges follow each other around a fan; fans that merely touch in a vertex are taken apart.
    void count_boundary_loops() {
        DisjointSets ends(3 * soup_.triangles.size());
        std::vector<std::uint32_t> open_sides;
        for (std::size_t e = 0; e < topology_.edge_count(); ++e) {
            const auto sides = topology_.sides_of(e);
            if (sides.size() != 1) continue;
            open_sides.push_back(sides[0]);
            ends.unite(topology_.fan_of_corner[sides[0]], topology_.fan_of_corner[next_corner(sides[0])]);
        }
        std::vector<std::uint32_t> loops;
        for (const auto side : open_sides) loops.push_back(ends.find(topology_.fan_of_corner[side]));
        std::sort(loops.begin(), loops.end());
        loops.erase(std::unique(loops.begin(), loops.end()), loops.end());
        r_.boundary_loops = loops.size();
        for (const auto corner : loops) ++parts_[component_[vertex_at(soup_, corner)]].boundary_loops;
    }

    // Colour triangles with two windings: element 2t stands for triangle t as it is, 2t + 1 for it turned
    // over.
    void decide_orientation() {
        r_.oriented = !soup_.triangles.empty() && r_.misoriented_edges == 0;
        r_.orientable = r_.oriented;
        if (r_.oriented || soup_.triangles.empty()) return;
        DisjointSets windings(2 * soup_.triangles.size());
        for (std::size_t e = 0; e < topology_.edge_count(); ++e) {
            const auto sides = topology_.sides_of(e);
            if (sides.size() != 2) continue;
            const std::uint32_t s = 2 * (sides[0] / 3), t = 2 * (sides[1] / 3);
            const std::uint32_t turned = vertex_at(soup_, sides[0]) == vertex_at(soup_, sides[1]) ? 1 : 0;
            windings.unite(s, t + turned);
            windings.unite(s + 1, t + 1 - turned);
        }
        r_.orientable = true;
        for (std::uint32_t t = 0; t < soup_.triangles.size() && r_.orientable; ++t)
            r_.orientable = windings.find(2 * t) != windings.find(2 * t + 1);
        if (!r_.orientable) problem("the surface has one side only (not orientable)");
    }

    void sum_components() {
        for (std::uint32_t t = 0; t < soup_.triangles.size(); ++t) {
            auto& part = parts_[component_[soup_.triangles[t][0]]];
            if (!names_a_vertex_twice(soup_.triangles[t])) ++part.triangles;
            // From a vertex of its own: the volume of a small component far from others is not lost in rounding.
            part.six_volumes.add(six_volumes(soup_, t, soup_.points[part.some_vertex]));
        }
        std::uint32_t first = kNone;
        for (const auto& part : parts_) {
            r_.euler += part.euler();
            if (!part.closed || part.six_volumes.value() > 0) continue;
            ++r_.inverted_components;
            first = std::min(first, part.some_vertex);
        }
        if (first != kNone)
            problem(fmt::format("{} turned inside out or without volume, first with vertex {} at {}",
                                counted(r_.inverted_components, "closed component"), first,
                                text(soup_.points[first])));
    }

    void decide_genus() {
        if (!r_.manifold || !r_.orientable) return;
        long long twice = 0;
        for (const auto& part : parts_) twice += 2 - part.euler() - part.boundary_loops;
        r_.genus = static_cast<std::size_t>(twice / 2);
    }

    void intersect() {
        const auto found = self_intersections(soup_);
        r_.self_intersections = found.count;
        if (found.count == 0) return;
        const auto [s, t] = found.first[0];
        problem(fmt::format("{} of triangles intersect, first {} and {} near {}",
                            counted(found.count, "pair"), s, t, text(centroid(s))));
    }

    void edge_problem(std::size_t count, const char* what, std::uint32_t side) {
        if (count == 0) return;
        const auto a = vertex_at(soup_, side), b = vertex_at(soup_, next_corner(side));
        problem(fmt::format("{} {}, first edge {}-{} from {} to {}", counted(count, "edge"), what, a, b,
                            text(soup_.points[a]), text(soup_.points[b])));
    }

    static std::string counted(std::size_t n, std::string_view one, std::string_view many = "") {
        if (n == 1) return fmt::format("1 {}", one);
        return many.empty() ? fmt::format("{} {}s", n, one) : fmt::format("{} {}", n, many);
    }

    Point3 centroid(std::uint32_t triangle) const {
        const auto& [a, b, c] = soup_.triangles[triangle];
        const auto &p = soup_.points[a], &q = soup_.points[b], &r = soup_.points[c];
        return {p.x / 3 + q.x / 3 + r.x / 3, p.y / 3 + q.y / 3 + r.y / 3, p.z / 3 + q.z / 3 + r.z / 3};
    }

    void problem(std::string sentence) { r_.problems.push_back(std::move(sentence)); }

    const TriangleSoup& soup_;
    const AnalysisOptions& options_;
    SoupTopology topology_;
    std::vector<std::uint32_t> component_;  // of each vertex; kNone for an unused one
    std::vector<Component> parts_;
    MeshReport r_;
};

}  // namespace

MeshReport analyze(const TriangleSoup& soup, const AnalysisOptions& options) {
    return Examination(soup, options).report();
}

MeshReport analyze(const TriMesh& mesh, const AnalysisOptions& options) {
    return analyze(triangle_soup(mesh), options);
}

bool is_closed(const TriMesh& mesh) {
    for (const auto edge : mesh.edges())
        if (mesh.is_boundary(edge)) return false;
    return mesh.faces_begin() != mesh.faces_end();
}

}  // namespace stratareeb
