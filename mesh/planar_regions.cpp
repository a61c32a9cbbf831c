// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/planar_regions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

using Vec = OpenMesh::Vec3d;
using Loop = std::vector<std::uint32_t>;

constexpr int kFree = -1;

struct Plane {
    Vec point, normal;
    double distance(const Vec& p) const { return std::abs(dot(p - point, normal)); }
};

// Grows the regions. After `run`, every triangle has one, and every region is a polygon with simple, disjoint
// loops.
class Grower {
 public:
    Grower(const TriMesh& mesh, double tolerance)
        : mesh_(mesh),
          tolerance_(tolerance),
          region_(mesh.n_faces(), kFree),
          allowed_(mesh.n_faces(), kFree),
          in_region_(mesh.n_vertices(), kFree),
          on_border_(mesh.n_vertices(), kFree) {
        compute_normals();
    }

    void run() {
        for (const int seed : seeds_by_area())
            if (region_[seed] == kFree) grow_from(seed);
    }

    int region_of(TriMesh::FaceHandle f) const { return region_[f.idx()]; }
    std::size_t size() const { return members_.size(); }
    const std::vector<int>& members(std::size_t id) const { return members_[id]; }
    const Plane& plane(std::size_t id) const { return planes_[id]; }

    bool is_border(TriMesh::HalfedgeHandle h) const {
        return region_of(mesh_.face_handle(h)) != region_of(mesh_.opposite_halfedge_handle(h));
    }

    //! The border loops of a region in the order of its triangles; empty if the border touches itself.
    std::vector<Loop> loops(int id) {
        std::vector<Loop> result;
        ++border_stamp_;
        for (const int t : members_[id]) {
            for (const auto h : mesh_.fh_range(TriMesh::FaceHandle(t))) {
                if (!is_border(h) || on_border_[mesh_.from_vertex_handle(h).idx()] == border_stamp_) continue;
                result.push_back(walk(h));
                if (result.back().empty()) return {};
            }
        }
        return result;
    }

    double signed_area(const Loop& loop, const Vec& normal) const {
        const Vec o = point(loop[0]);
        Vec sum(0, 0, 0);
        for (std::size_t i = 1; i + 1 < loop.size(); ++i)
            sum += cross(point(loop[i]) - o, point(loop[i + 1]) - o);
        return 0.5 * dot(sum, normal);
    }

    Vec point(std::uint32_t v) const { return mesh_.point(TriMesh::VertexHandle(static_cast<int>(v))); }

 private:
    int region_of(TriMesh::HalfedgeHandle h) const { return region_of(mesh_.face_handle(h)); }

    std::array<int, 3> corners(int t) const {
        auto v = mesh_.cfv_iter(TriMesh::FaceHandle(t));
        const int a = (v++)->idx(), b = (v++)->idx();
        return {a, b, v->idx()};
    }

    void compute_normals() {
        area_.resize(mesh_.n_faces());
        normals_.resize(mesh_.n_faces());
        for (std::size_t t = 0; t < mesh_.n_faces(); ++t) {
            const auto [a, b, c] = corners(static_cast<int>(t));
            const Vec n = cross(point(b) - point(a), point(c) - point(a));
            area_[t] = n.norm();
            if (!(area_[t] > 0))
                throw GeometryError(fmt::format("triangle {} at ({:.3f}, {:.3f}, {:.3f}) has no area", t,
                                                point(a)[0], point(a)[1], point(a)[2]));
            normals_[t] = n / area_[t];
        }
    }

    std::vector<int> seeds_by_area() const {
        std::vector<int> seeds(mesh_.n_faces());
        std::iota(seeds.begin(), seeds.end(), 0);
        std::stable_sort(seeds.begin(), seeds.end(), [&](int a, int b) { return area_[a] > area_[b]; });
        return seeds;
    }

    void grow_from(int seed) {
        const int id = open_region(seed);
        spread(seed, id, kFree, false);
        fit_plane(id);
        if (has_sound_loops(id)) return;
        cut_into_discs(id);
    }

    int open_region(int seed) {
        members_.emplace_back();
        planes_.push_back({point(corners(seed)[0]), normals_[seed]});
        return static_cast<int>(members_.size()) - 1;
    }

    // Breadth first over edges. With `discs`, a triangle that would close a ring or touch the region at a
    // lone vertex waits; it may fit later, when more of its neighbours have joined.
    void spread(int seed, int id, int among, bool discs) {
        std::vector<int> queue{seed};
        add(seed, id);
        for (std::size_t i = 0; i < queue.size(); ++i) {
            for (const auto h : mesh_.fh_range(TriMesh::FaceHandle(queue[i]))) {
                const int t = mesh_.face_handle(mesh_.opposite_halfedge_handle(h)).idx();
                if (region_[t] != kFree || allowed_[t] != among || !fits(t, planes_[id])) continue;
                if (discs && !keeps_disc(t, id)) continue;
                add(t, id);
                queue.push_back(t);
            }
        }
    }

    void add(int t, int id) {
        region_[t] = id;
        members_[id].push_back(t);
        for (const int v : corners(t)) in_region_[v] = id;
    }

    bool fits(int t, const Plane& plane) const {
        if (dot(normals_[t], plane.normal) < 0.5)
            return false;  // a sliver's normal is noisy, a fold's is opposite
        return std::ranges::all_of(corners(t), [&](int v) { return plane.distance(point(v)) <= tolerance_; });
    }

    bool keeps_disc(int t, int id) const {
        int shared = 0, opposite = 0;
        for (const auto h : mesh_.fh_range(TriMesh::FaceHandle(t))) {
            if (region_of(mesh_.opposite_halfedge_handle(h)) != id) continue;
            ++shared;
            opposite = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h)).idx();
        }
        return shared >= 2 || in_region_[opposite] != id;
    }

    // The seed's plane is uncertain far from the seed; the mean plane of the region serves unless it fits
    // worse.
    void fit_plane(int id) {
        if (members_[id].size() == 1) return;
        Vec normal(0, 0, 0), centre(0, 0, 0);
        for (const int t : members_[id]) {
            normal += area_[t] * normals_[t];
            for (const int v : corners(t)) centre += point(v) - planes_[id].point;
        }
        const Plane fitted{planes_[id].point + centre / (3.0 * static_cast<double>(members_[id].size())),
                           normal.normalized()};
        if (worst_distance(id, fitted) < worst_distance(id, planes_[id])) planes_[id] = fitted;
    }

    double worst_distance(int id, const Plane& plane) const {
        double worst = 0;
        for (const int t : members_[id])
            for (const int v : corners(t)) worst = std::max(worst, plane.distance(point(v)));
        return worst;
    }

    bool has_sound_loops(int id) {
        if (members_[id].size() == 1) return true;
        const auto found = loops(id);
        return std::ranges::count_if(
                   found, [&](const Loop& loop) { return signed_area(loop, planes_[id].normal) > 0; }) == 1;
    }

    // The first disc keeps the region's number and plane; the others are new regions in the same plane.
    void cut_into_discs(int id) {
        const Plane plane = planes_[id];
        auto pool = std::move(members_[id]);
        for (const int t : pool) {
            region_[t] = kFree;
            allowed_[t] = id;
            for (const int v : corners(t)) in_region_[v] = kFree;
        }
        members_[id].clear();
        int disc = id;
        for (const int t : pool) {
            if (region_[t] != kFree) continue;
            if (disc != id || !members_[id].empty()) disc = open_region(t);
            planes_[disc] = plane;
            spread(t, disc, id, true);
        }
    }

    // Follows the region's border with the region on the left.
    Loop walk(TriMesh::HalfedgeHandle start) {
        Loop loop;
        const int id = region_of(start);
        auto h = start;
        do {
            const int v = mesh_.from_vertex_handle(h).idx();
            if (on_border_[v] == border_stamp_) return {};
            on_border_[v] = border_stamp_;
            loop.push_back(static_cast<std::uint32_t>(v));
            h = mesh_.next_halfedge_handle(h);
            while (region_of(mesh_.opposite_halfedge_handle(h)) == id)
                h = mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(h));
        } while (h != start);
        return loop;
    }

    const TriMesh& mesh_;
    double tolerance_;
    std::vector<int> region_;     // per triangle
    std::vector<int> allowed_;    // per triangle: the torn-up region it came from
    std::vector<int> in_region_;  // per vertex: the last region that took a triangle there
    std::vector<int> on_border_;  // per vertex: the last border walk that passed
    int border_stamp_ = 0;
    std::vector<double> area_;  // twice the area
    std::vector<Vec> normals_;
    std::vector<std::vector<int>> members_;
    std::vector<Plane> planes_;
};

// Finds vertices in the middle of straight sides. Sides are chains of border edges between vertices where
// three or more regions meet; both regions of a chain lose the same vertices, so they keep fitting together.
class Straightener {
 public:
    Straightener(const TriMesh& mesh, const Grower& grower, double tolerance)
        : mesh_(mesh), grower_(grower), tolerance_(tolerance), valence_(mesh.n_vertices(), 0) {
        for (const auto e : mesh.edges()) {
            if (!grower.is_border(mesh.halfedge_handle(e, 0))) continue;
            for (const int side : {0, 1})
                ++valence_[mesh.to_vertex_handle(mesh.halfedge_handle(e, side)).idx()];
        }
    }

    std::vector<bool> dropped_vertices() {
        dropped_.assign(mesh_.n_vertices(), false);
        visited_.assign(mesh_.n_vertices(), false);
        for (std::size_t v = 0; v < valence_.size(); ++v)
            if (valence_[v] > 2) open_chains_from(static_cast<int>(v));
        for (std::size_t v = 0; v < valence_.size(); ++v)
            if (valence_[v] == 2 && !visited_[v]) closed_chain_through(static_cast<int>(v));
        return dropped_;
    }

 private:
    void open_chains_from(int v) {
        for (const auto h : mesh_.voh_range(TriMesh::VertexHandle(v))) {
            const int next = mesh_.to_vertex_handle(h).idx();
            if (grower_.is_border(h) && valence_[next] == 2 && !visited_[next]) {
                const auto chain = follow(h);
                simplify(chain, 0, chain.size() - 1);
            }
        }
    }

    // Two corners of a ring: the farthest vertex from any one, and the farthest from that.
    void closed_chain_through(int v) {
        for (const auto h : mesh_.voh_range(TriMesh::VertexHandle(v))) {
            if (!grower_.is_border(h)) continue;
            auto ring = follow(h);
            ring.pop_back();
            std::rotate(ring.begin(), ring.begin() + farthest(ring, 0), ring.end());
            const auto middle = static_cast<std::size_t>(farthest(ring, 0));
            ring.push_back(ring[0]);
            simplify(ring, 0, middle);
            simplify(ring, middle, ring.size() - 1);
            return;
        }
    }

    std::vector<int> follow(TriMesh::HalfedgeHandle h) {
        const int start = mesh_.from_vertex_handle(h).idx();
        std::vector<int> chain{start};
        for (;;) {
            const int v = mesh_.to_vertex_handle(h).idx();
            chain.push_back(v);
            if (valence_[v] != 2 || v == start) break;
            visited_[v] = true;
            const auto back = mesh_.opposite_halfedge_handle(h);
            for (const auto out : mesh_.voh_range(TriMesh::VertexHandle(v)))
                if (out != back && grower_.is_border(out)) h = out;
        }
        visited_[start] = true;
        return chain;
    }

    std::ptrdiff_t farthest(const std::vector<int>& ring, std::size_t from) const {
        const auto far =
            std::ranges::max_element(ring, {}, [&](int v) { return (at(v) - at(ring[from])).sqrnorm(); });
        return far - ring.begin();
    }

    // Douglas and Peucker's split at the vertex farthest from the chord, with an explicit stack.
    void simplify(const std::vector<int>& chain, std::size_t first, std::size_t last) {
        std::vector<std::pair<std::size_t, std::size_t>> stack{{first, last}};
        while (!stack.empty()) {
            const auto [a, b] = stack.back();
            stack.pop_back();
            double worst = -1;
            std::size_t split = a;
            for (std::size_t i = a + 1; i < b; ++i) {
                const double d = distance_to_segment(at(chain[i]), at(chain[a]), at(chain[b]));
                if (d > worst) worst = d, split = i;
            }
            if (worst > tolerance_) {
                stack.emplace_back(a, split);
                stack.emplace_back(split, b);
            } else {
                for (std::size_t i = a + 1; i < b; ++i) dropped_[chain[i]] = true;
            }
        }
    }

    static double distance_to_segment(const Vec& p, const Vec& a, const Vec& b) {
        const Vec d = b - a;
        const double length2 = d.sqrnorm();
        const double t = length2 > 0 ? std::clamp(dot(p - a, d) / length2, 0.0, 1.0) : 0.0;
        return (p - (a + t * d)).norm();
    }

    Vec at(int v) const { return mesh_.point(TriMesh::VertexHandle(v)); }

    const TriMesh& mesh_;
    const Grower& grower_;
    double tolerance_;
    std::vector<int> valence_;  // border edges at a vertex
    std::vector<bool> dropped_, visited_;
};

double box_diagonal(const TriMesh& mesh) {
    Vec low(0, 0, 0), high(0, 0, 0);
    bool first = true;
    for (const auto v : mesh.vertices()) {
        const Vec p = mesh.point(v);
        low = first ? p : low.min(p);
        high = first ? p : high.max(p);
        first = false;
    }
    return (high - low).norm();
}

void require_closed(const TriMesh& mesh) {
    for (const auto h : mesh.halfedges()) {
        if (!mesh.is_boundary(h)) continue;
        const Vec p = mesh.point(mesh.to_vertex_handle(h));
        throw InvalidInput(
            fmt::format("the surface is open at ({:.3f}, {:.3f}, {:.3f}); close it first", p[0], p[1], p[2]));
    }
}

// A sliver may be so thin that a side and its two others look straight: it keeps all its vertices.
void keep_slivers(const std::vector<PlanarRegion>& regions, std::vector<bool>& dropped) {
    for (const auto& region : regions)
        for (const auto& loop : region.loops)
            if (std::ranges::count_if(loop, [&](auto v) { return !dropped[v]; }) < 3)
                for (const auto v : loop) dropped[v] = false;
}

PlanarRegion polygon(Grower& grower, std::size_t id) {
    const Plane& plane = grower.plane(id);
    PlanarRegion region{.point = {plane.point[0], plane.point[1], plane.point[2]},
                        .normal = {plane.normal[0], plane.normal[1], plane.normal[2]},
                        .loops = grower.loops(static_cast<int>(id)),
                        .triangles = grower.members(id).size()};
    if (region.loops.size() > 1)
        std::ranges::stable_partition(
            region.loops, [&](const Loop& loop) { return grower.signed_area(loop, plane.normal) > 0; });
    return region;
}

}  // namespace

std::vector<PlanarRegion> planar_regions(const TriMesh& mesh, const PlanarRegionOptions& options) {
    if (mesh.n_faces() == 0) return {};
    require_closed(mesh);
    const double tolerance = options.tolerance * box_diagonal(mesh);
    Grower grower(mesh, tolerance);
    grower.run();

    std::vector<PlanarRegion> regions;
    regions.reserve(grower.size());
    for (std::size_t id = 0; id < grower.size(); ++id) regions.push_back(polygon(grower, id));
    if (!options.drop_straight_vertices) return regions;

    auto dropped = Straightener(mesh, grower, tolerance).dropped_vertices();
    keep_slivers(regions, dropped);
    for (auto& region : regions)
        for (auto& loop : region.loops) std::erase_if(loop, [&](auto v) { return dropped[v]; });
    return regions;
}

}  // namespace stratareeb
