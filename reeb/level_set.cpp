// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/level_set.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "boreholes/errors.h"

namespace stratareeb {

namespace {

using Halfedge = TriMesh::HalfedgeHandle;

double distance(const Point3& a, const Point3& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

class Sweep {
 public:
    Sweep(const TriMesh& mesh, const ScalarField& field, std::vector<double> levels)
        : mesh_(mesh), field_(field), levels_(std::move(levels)), visited_(mesh.n_edges(), kNever) {
        below_.reserve(field.size());  // how many levels a vertex is above or at
        for (const double value : field)
            below_.push_back(
                static_cast<std::uint32_t>(std::ranges::upper_bound(levels_, value) - levels_.begin()));
        bucket_edges();
    }

    LevelSet level_set(std::uint32_t level) {
        LevelSet set{.level = levels_[level], .contours = {}};
        // Open contours first: a walk from their start takes them whole.
        for (const bool open : {true, false})
            for (std::size_t i = first_[level]; i < first_[level + 1]; ++i) {
                const Halfedge start = downward(edges_[i], level);
                if (visited_[edges_[i]] == level ||
                    (open && !mesh_.is_boundary(mesh_.opposite_halfedge_handle(start))))
                    continue;
                Contour contour = walk(start, level);
                if (contour.points.size() > 1) set.contours.push_back(std::move(contour));
            }
        return set;
    }

 private:
    static constexpr std::uint32_t kNever = ~0u;

    std::uint32_t levels_below(TriMesh::VertexHandle v) const {
        return below_[static_cast<std::size_t>(v.idx())];
    }

    std::pair<std::uint32_t, std::uint32_t> levels_across(TriMesh::EdgeHandle e) const {
        const Halfedge h = mesh_.halfedge_handle(e, 0);
        return std::minmax(levels_below(mesh_.from_vertex_handle(h)),
                           levels_below(mesh_.to_vertex_handle(h)));
    }

    //! Edges by the levels that cross them, each level's in the order of the mesh (a counting sort).
    void bucket_edges() {
        first_.assign(levels_.size() + 1, 0);
        for (const auto e : mesh_.edges()) {
            const auto [low, high] = levels_across(e);
            for (std::uint32_t k = low; k < high; ++k) ++first_[k + 1];
        }
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        edges_.resize(first_.back());
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        for (const auto e : mesh_.edges()) {
            const auto [low, high] = levels_across(e);
            for (std::uint32_t k = low; k < high; ++k)
                edges_[next[k]++] = static_cast<std::uint32_t>(e.idx());
        }
    }

    bool is_above(TriMesh::VertexHandle v, std::uint32_t level) const { return levels_below(v) > level; }

    //! The half-edge of a crossed edge that leads from above the level to below it: a contour with higher values on its left
    //! enters a counter-clockwise triangle through it.
    Halfedge downward(std::uint32_t edge, std::uint32_t level) const {
        const Halfedge h = mesh_.halfedge_handle(TriMesh::EdgeHandle(static_cast<int>(edge)), 0);
        return is_above(mesh_.from_vertex_handle(h), level) ? h : mesh_.opposite_halfedge_handle(h);
    }

    Contour walk(Halfedge start, std::uint32_t level) {
        Contour contour{.points = {}, .closed = false};
        Halfedge in = start;
        while (true) {
            const auto edge = static_cast<std::size_t>(mesh_.edge_handle(in).idx());
            if (visited_[edge] == level) {
                contour.closed = true;
                break;
            }
            visited_[edge] = level;
            add_crossing(contour, in, level);
            if (mesh_.is_boundary(in)) break;
            // Of the triangle's other two half-edges one leads up through the level: the way out.
            Halfedge out = mesh_.next_halfedge_handle(in);
            if (is_above(mesh_.to_vertex_handle(out), level) ==
                is_above(mesh_.from_vertex_handle(out), level))
                out = mesh_.next_halfedge_handle(out);
            in = mesh_.opposite_halfedge_handle(out);
        }
        if (contour.closed)
            while (contour.points.size() > 1 && contour.points.front() == contour.points.back())
                contour.points.pop_back();
        return contour;
    }

    void add_crossing(Contour& contour, Halfedge h, std::uint32_t level) const {
        const auto from = mesh_.from_vertex_handle(h), to = mesh_.to_vertex_handle(h);  // from above to below
        const double high = field_[static_cast<std::size_t>(from.idx())],
                     low = field_[static_cast<std::size_t>(to.idx())];
        const double share = (high - levels_[level]) / (high - low);
        const auto p = mesh_.point(from) + share * (mesh_.point(to) - mesh_.point(from));
        const Point3 point{p[0], p[1], p[2]};
        if (contour.points.empty() || !(contour.points.back() == point)) contour.points.push_back(point);
    }

    const TriMesh& mesh_;
    const ScalarField& field_;
    std::vector<double> levels_;  // ascending
    std::vector<std::uint32_t> below_, edges_, visited_;
    std::vector<std::size_t> first_;  // of each level in edges_
};

}  // namespace

double Contour::length() const {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) sum += distance(points[i], points[i + 1]);
    return closed && !points.empty() ? sum + distance(points.back(), points.front()) : sum;
}

double Contour::plan_area() const {
    if (!closed || points.empty()) return 0;
    double twice = 0;
    const Point3 o = points.front();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point3 &a = points[i], &b = points[(i + 1) % points.size()];
        twice += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
    }
    return twice / 2;
}

std::vector<LevelSet> level_sets(const TriMesh& mesh, const ScalarField& field,
                                 std::span<const double> levels) {
    check_field(mesh, field);
    for (const double level : levels)
        if (!std::isfinite(level)) throw InvalidInput("a level is not a number");
    std::vector<double> ascending(levels.begin(), levels.end());
    std::ranges::sort(ascending);
    ascending.erase(std::unique(ascending.begin(), ascending.end()), ascending.end());
    Sweep sweep(mesh, field, ascending);
    std::vector<LevelSet> found;
    for (std::uint32_t k = 0; k < ascending.size(); ++k) found.push_back(sweep.level_set(k));
    std::vector<LevelSet> result;  // in the order asked for
    for (const double level : levels)
        result.push_back(
            found[static_cast<std::size_t>(std::ranges::lower_bound(ascending, level) - ascending.begin())]);
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
