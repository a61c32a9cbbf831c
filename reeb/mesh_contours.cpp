// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/mesh_contours.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "mesh/ring_crossings.h"
#include "reeb/contour_trace.h"
#include "reeb/correspondence.h"
#include "reeb/cut_crossings.h"

namespace stratareeb {

namespace {

constexpr double kMostCut = 0.05;     // of a contour's length
constexpr double kLeastStep = 1e-11;  // of the mesh's size

double twice_area(const std::vector<Point3>& points) {
    return area_vector(points).z;
}

//! One point for all that are nearer than a step: the first that came.
class PointWelder {
 public:
    explicit PointWelder(double step) : step_(step), cell_(2 * step) {}

    Point3 welded(const Point3& p) {
        const auto [i, k] = cell_of(p);
        for (double di = -1; di <= 1; ++di)
            for (double dk = -1; dk <= 1; ++dk) {
                const auto found = points_.find({i + di, k + dk});
                if (found == points_.end()) continue;
                for (const Point3& known : found->second)
                    if (std::abs(known.x - p.x) <= step_ && std::abs(known.y - p.y) <= step_) return known;
            }
        points_[{i, k}].push_back(p);
        return p;
    }

 private:
    std::pair<double, double> cell_of(const Point3& p) const {
        return {std::floor(p.x / cell_), std::floor(p.y / cell_)};
    }

    double step_, cell_;
    std::map<std::pair<double, double>, std::vector<Point3>> points_;
};

void drop_repeated(std::vector<Point3>& points) {
    points.erase(std::unique(points.begin(), points.end()), points.end());
    while (points.size() > 1 && points.front() == points.back()) points.pop_back();
}

//! Leave out stretches that lead there and straight back, but for one around the seam.
void drop_spurs_inside(std::vector<Point3>& points) {
    std::vector<Point3> kept;
    for (const Point3& p : points) {
        if (kept.size() > 1 && kept[kept.size() - 2] == p)
            kept.pop_back();
        else if (kept.empty() || !(kept.back() == p))
            kept.push_back(p);
    }
    points = std::move(kept);
    drop_repeated(points);
}

void drop_spurs(std::vector<Point3>& points) {
    for (std::size_t before = 0; before != points.size();) {
        before = points.size();
        drop_spurs_inside(points);
        std::ranges::rotate(points, points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2));
        drop_spurs_inside(points);
    }
}

}  // namespace

bool is_sound(const LevelContour& contour, bool may_touch) {
    if (contour.points.size() < 3 || !(twice_area(contour.points) > 0)) return false;
    std::vector<std::vector<Point2>> ring(1);
    for (const Point3& p : contour.points) ring[0].push_back({p.x, p.y});
    return ring_crossings(ring, {.shared_corners = may_touch, .most = 1}).empty();
}

bool make_sound(LevelContour& contour) {
    return is_sound(contour) || (cut_crossings(contour.points, kMostCut) && is_sound(contour));
}

MeshContours::MeshContours(const TriMesh& mesh, const ScalarField& field, const ReebGraph& graph)
    : mesh_(mesh), index_(mesh, field, graph) {
    fallen_.reserve(field.size());
    for (const double value : field) fallen_.push_back(-value);
    for (const auto v : mesh.vertices()) {
        const auto offset = mesh.point(v) - mesh.point(TriMesh::VertexHandle(0));
        least_step_ = std::max(least_step_, kLeastStep * offset.length());
    }
}

LevelContour MeshContours::at(const SweepEdge& edge, double z, const Point3* kept) const {
    const auto segment =
        std::ranges::find_if(edge.segments, [&](const SweepSegment& s) { return s.low < z && z <= s.high; });
    LevelContour contour{z, index_.contour(segment->arc, z).points};
    settle(contour, kept);
    return contour;
}

//! The level set of the field turned upside down, just below it there.
LevelContour MeshContours::above_lower_end(const SweepEdge& edge, const Point3* kept) const {
    const SweepSegment& segment = edge.segments.front();
    const auto start = mesh_.opposite_halfedge_handle(index_.crossed_above(segment.arc, segment.low));
    LevelContour contour{segment.low, trace_contour(mesh_, fallen_, -segment.low, start).points};
    settle(contour, kept);
    return contour;
}

Point3 MeshContours::place(std::uint32_t vertex) const {
    const auto& p = mesh_.point(TriMesh::VertexHandle(static_cast<int>(vertex)));
    return {p[0], p[1], p[2]};
}

bool MeshContours::are_one(const Point3& a, const Point3& b) const {
    return std::abs(a.x - b.x) <= least_step_ && std::abs(a.y - b.y) <= least_step_;
}

void MeshContours::settle(LevelContour& contour, const Point3* kept) const {
    std::vector<Point3> points;
    for (Point3 p : contour.points) {
        p.z = contour.z;
        if (points.empty() || !are_one(points.back(), p))
            points.push_back(p);
        else if (kept && p == *kept)
            points.back() = p;
    }
    while (points.size() > 1 && are_one(points.front(), points.back())) {
        if (kept && points.back() == *kept) points.front() = points.back();
        points.pop_back();
    }
    contour.points = std::move(points);
    if (contour.points.size() > 2 && twice_area(contour.points) < 0) std::ranges::reverse(contour.points);
}

void MeshContours::join_points(std::vector<LevelContour>& contours) const {
    PointWelder welder(4 * least_step_);
    for (LevelContour& contour : contours) {
        for (Point3& p : contour.points) p = welder.welded(p);
        drop_repeated(contour.points);
        drop_spurs(contour.points);
    }
}

}  // namespace stratareeb
