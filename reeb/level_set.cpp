// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/level_set.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "boreholes/errors.h"

namespace stratareeb {

namespace {

using Halfedge = TriMesh::HalfedgeHandle;

double distance(const Point3& a, const Point3& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

//! How many of ascending levels a value reaches. Equal bins narrow the search to a level or none, and rounding moves a value
//! and a level to their bins alike, so that the answer is exact.
class LevelTable {
 public:
    explicit LevelTable(const std::vector<double>& levels) : levels_(levels) {
        if (levels.empty()) return;
        low_ = levels.front();
        const double scale = static_cast<double>(4 * levels.size()) / (levels.back() - low_);
        scale_ = std::isfinite(scale) ? scale : 0;
        first_.assign(4 * levels.size() + 2, 0);
        for (const double level : levels) ++first_[bin(level) + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
    }

    //! \pre there are levels
    std::uint32_t reached(double value) const {
        const std::size_t b = bin(value);
        const auto from = levels_.begin() + first_[b], to = levels_.begin() + first_[b + 1];
        return static_cast<std::uint32_t>(std::upper_bound(from, to, value) - levels_.begin());
    }

 private:
    std::size_t bin(double value) const {
        const double place = (value - low_) * scale_;
        const std::size_t last = first_.size() - 2;
        return !(place > 0) ? 0 : place < static_cast<double>(last) ? static_cast<std::size_t>(place) : last;
    }

    const std::vector<double>& levels_;
    std::vector<std::uint32_t> first_;  // number of levels before each bin
    double low_ = 0, scale_ = 0;
};

//! The edges that each level crosses, in the order of the mesh.
class CrossedEdges {
 public:
    CrossedEdges(const TriMesh& mesh, const ScalarField& field, const std::vector<double>& levels)
        : reached_(field.size()), crossed_(mesh.n_edges() / kBlock + 1) {
        const LevelTable table(levels);
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, field.size(), kBlock), [&](const auto& range) {
            for (std::size_t v = range.begin(); v < range.end(); ++v) reached_[v] = table.reached(field[v]);
        });
        tbb::parallel_for(std::size_t{0}, crossed_.size(), [&](std::size_t block) { find(mesh, block); });
        sort_by_level(levels.size());
    }

    std::span<const std::uint32_t> at(std::size_t level) const {
        return std::span(edges_).subspan(first_[level], first_[level + 1] - first_[level]);
    }

 private:
    static constexpr std::size_t kBlock = 1 << 15;  // a task's share of vertices or edges

    struct Crossed {
        std::uint32_t edge, low, high;  // by levels low <= k < high
    };

    std::uint32_t reached(TriMesh::VertexHandle v) const {
        return reached_[static_cast<std::size_t>(v.idx())];
    }

    void find(const TriMesh& mesh, std::size_t block) {
        const std::size_t end = std::min((block + 1) * kBlock, mesh.n_edges());
        for (std::size_t e = block * kBlock; e < end; ++e) {
            const TriMesh::EdgeHandle edge(static_cast<int>(e));
            const auto a = reached(mesh.to_vertex_handle(mesh.halfedge_handle(edge, 0)));
            const auto b = reached(mesh.to_vertex_handle(mesh.halfedge_handle(edge, 1)));
            if (a != b && !mesh.status(edge).deleted())
                crossed_[block].push_back({static_cast<std::uint32_t>(e), std::min(a, b), std::max(a, b)});
        }
    }

    //! A counting sort that keeps the order of edges.
    void sort_by_level(std::size_t levels) {
        std::vector<std::int64_t> change(levels + 1,
                                         0);  // of the number of edges from each level to the next
        for (const auto& block : crossed_)
            for (const auto& [edge, low, high] : block) ++change[low], --change[high];
        first_.assign(levels + 1, 0);
        std::int64_t crossing = 0;
        for (std::size_t k = 0; k < levels; ++k)
            first_[k + 1] = first_[k] + static_cast<std::size_t>(crossing += change[k]);
        edges_.resize(first_.back());
        std::vector<std::size_t> next(first_);
        for (const auto& block : crossed_)
            for (const auto& [edge, low, high] : block)
                for (std::uint32_t k = low; k < high; ++k) edges_[next[k]++] = edge;
    }

    std::vector<std::uint32_t> reached_;         // by vertex
    std::vector<std::vector<Crossed>> crossed_;  // by block of edges
    std::vector<std::size_t> first_;             // of each level in edges_
    std::vector<std::uint32_t> edges_;
};

//! Walks the contours of one level after another.
class ContourWalk {
 public:
    ContourWalk(const TriMesh& mesh, const ScalarField& field)
        : mesh_(mesh), field_(field), places_(mesh.points()), seen_(mesh.n_edges(), 0) {}

    LevelSet level_set(double level, std::span<const std::uint32_t> edges) {
        level_ = level;
        LevelSet set{.level = level, .contours = {}};
        // Open contours first: a walk from their start takes them whole.
        for (const bool open : {true, false})
            for (const auto edge : edges) {
                if (seen_[edge]) continue;
                const Halfedge start = downward(edge);
                if (open && !mesh_.is_boundary(mesh_.opposite_halfedge_handle(start))) continue;
                walk(start, !open);
                if (points_.size() > 1)
                    set.contours.push_back({.points = {points_.begin(), points_.end()}, .closed = !open});
            }
        for (const auto edge : edges) seen_[edge] = 0;
        return set;
    }

 private:
    struct End {  // of a crossed edge
        const TriMesh::Point* place;
        double value;
    };

    End end(TriMesh::VertexHandle v) const {
        return {places_ + v.idx(), field_[static_cast<std::size_t>(v.idx())]};
    }

    //! The half-edge of a crossed edge that leads from above the level to below it: a contour with higher values on its left
    //! enters a counter-clockwise triangle through it.
    Halfedge downward(std::uint32_t edge) const {
        const Halfedge h(static_cast<int>(2 * edge));
        return end(mesh_.from_vertex_handle(h)).value >= level_ ? h : mesh_.opposite_halfedge_handle(h);
    }

    //! From triangle to triangle until the start or the boundary is reached; each brings one vertex, which takes the place of
    //! that end of the crossed edge which lies on its side.
    void walk(Halfedge start, bool closed) {
        points_.clear();
        End above = end(mesh_.from_vertex_handle(start)), below = end(mesh_.to_vertex_handle(start));
        Halfedge in = start;
        do {
            seen_[static_cast<std::size_t>(in.idx()) / 2] = 1;
            add_crossing(above, below);
            if (mesh_.is_boundary(in)) break;
            Halfedge out = mesh_.next_halfedge_handle(in);
            const End apex = end(mesh_.to_vertex_handle(out));
            if (apex.value >= level_) {
                above = apex;
            } else {
                below = apex;
                out = mesh_.next_halfedge_handle(out);
            }
            in = mesh_.opposite_halfedge_handle(out);
        } while (in != start);
        if (closed)
            while (points_.size() > 1 && points_.front() == points_.back()) points_.pop_back();
    }

    void add_crossing(const End& above, const End& below) {
        const double share = (above.value - level_) / (above.value - below.value);
        const auto p = *above.place + share * (*below.place - *above.place);
        const Point3 point{p[0], p[1], p[2]};
        if (points_.empty() || !(points_.back() == point)) points_.push_back(point);
    }

    const TriMesh& mesh_;
    const ScalarField& field_;
    const TriMesh::Point* places_;
    std::vector<std::uint8_t> seen_;  // by edge, in the level at hand
    std::vector<Point3> points_;      // of the contour at hand
    double level_ = 0;
};

std::vector<double> ascending(std::span<const double> levels) {
    std::vector<double> sorted(levels.begin(), levels.end());
    std::ranges::sort(sorted);
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    return sorted;
}

}  // namespace

double Contour::length() const {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) sum += distance(points[i], points[i + 1]);
    return closed && !points.empty() ? sum + distance(points.back(), points.front()) : sum;
}

double Contour::area(const Point3& direction) const {
    const double size = std::hypot(direction.x, direction.y, direction.z);
    if (!closed || points.empty() || size == 0) return 0;
    const Point3 o = points.front();
    double x = 0, y = 0, z = 0;  // twice the vector area, by fans from the first point
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Point3 a{points[i].x - o.x, points[i].y - o.y, points[i].z - o.z};
        const Point3 b{points[i + 1].x - o.x, points[i + 1].y - o.y, points[i + 1].z - o.z};
        x += a.y * b.z - a.z * b.y;
        y += a.z * b.x - a.x * b.z;
        z += a.x * b.y - a.y * b.x;
    }
    return (x * (direction.x / size) + y * (direction.y / size) + z * (direction.z / size)) / 2;
}

std::vector<LevelSet> level_sets(const TriMesh& mesh, const ScalarField& field,
                                 std::span<const double> levels) {
    check_field(mesh, field);
    for (const double level : levels)
        if (!std::isfinite(level)) throw InvalidInput("a level is not a number");
    if (levels.empty()) return {};
    const std::vector<double> sorted = ascending(levels);
    const CrossedEdges crossed(mesh, field, sorted);
    std::vector<LevelSet> found(sorted.size());
    tbb::enumerable_thread_specific<ContourWalk> walks(std::cref(mesh), std::cref(field));
    tbb::parallel_for(std::size_t{0}, sorted.size(),
                      [&](std::size_t k) { found[k] = walks.local().level_set(sorted[k], crossed.at(k)); });
    if (std::ranges::equal(levels, sorted)) return found;
    std::vector<LevelSet> result;  // in the order asked for
    for (const double level : levels)
        result.push_back(
            found[static_cast<std::size_t>(std::ranges::lower_bound(sorted, level) - sorted.begin())]);
    return result;
}

std::vector<double> even_levels(const ScalarField& field, std::size_t count) {
    std::vector<double> levels;
    if (field.empty()) return levels;
    const auto [low, high] = std::ranges::minmax(field);
    for (std::size_t k = 1; k <= count; ++k)
        levels.push_back(low + (high - low) * static_cast<double>(k) / static_cast<double>(count + 1));
    return levels;
}

}  // namespace stratareeb
