// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/rim_sides.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stratareeb {
namespace {

using Ring = std::vector<std::uint32_t>;

constexpr double kNoCorner_deg = 1e-3;  // a vertex of a straight side may turn by as much
constexpr double kStraight = 1e-8;      // of a side's length: how far its vertices may be from the line

OpenMesh::VertexHandle handle(std::uint32_t v) {
    return OpenMesh::VertexHandle(static_cast<int>(v));
}

std::vector<Ring> rings_of(const TriMesh& plan) {
    std::vector<char> seen(plan.n_halfedges(), 0);
    std::vector<Ring> rings;
    for (const auto start : plan.halfedges()) {
        if (!plan.is_boundary(start) || seen[static_cast<std::size_t>(start.idx())]) continue;
        Ring ring;
        TriMesh::HalfedgeHandle h = start;
        do {
            seen[static_cast<std::size_t>(h.idx())] = 1;
            ring.push_back(static_cast<std::uint32_t>(plan.to_vertex_handle(h).idx()));
            h = plan.next_halfedge_handle(h);
        } while (h != start);
        std::ranges::reverse(ring);  // boundary half-edges have the inside on their right
        rings.push_back(std::move(ring));
    }
    return rings;
}

double turning_at(const TriMesh& plan, const Ring& ring, std::size_t i) {
    const std::size_t n = ring.size();
    return turning_deg(plan, ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]);
}

std::vector<std::size_t> corners_sharper_than(double degrees, const TriMesh& plan, const Ring& ring) {
    std::vector<std::size_t> corners;
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (turning_at(plan, ring, i) > degrees) corners.push_back(i);
    return corners;
}

// A round ring has no corners to cut it at: quarters do.
void cut_at_least_twice(std::vector<std::size_t>& corners, const Ring& ring) {
    if (corners.size() >= 2) return;
    const std::size_t first = corners.empty() ? 0 : corners[0], parts = std::min<std::size_t>(4, ring.size());
    corners.clear();
    for (std::size_t k = 0; k < parts; ++k)
        corners.push_back((first + k * ring.size() / parts) % ring.size());
    std::ranges::sort(corners);
}

bool is_straight(const TriMesh& plan, const Ring& side) {
    const auto a = plan.point(handle(side.front())), along = plan.point(handle(side.back())) - a;
    return std::ranges::all_of(side, [&](std::uint32_t v) {
        const auto to = plan.point(handle(v)) - a;
        return std::abs(along[0] * to[1] - along[1] * to[0]) <= kStraight * along.sqrnorm();
    });
}

void add_sides(std::vector<RimSide>& sides, const TriMesh& plan, const Ring& ring,
               const std::vector<std::size_t>& corners) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
        RimSide side;
        const std::size_t end = corners[(k + 1) % corners.size()];
        for (std::size_t i = corners[k];; i = (i + 1) % ring.size()) {
            side.vertices.push_back(ring[i]);
            if (side.vertices.size() > 1 && i == end) break;
        }
        side.straight = is_straight(plan, side.vertices);
        sides.push_back(std::move(side));
    }
}

}  // namespace

double turning_deg(const TriMesh& plan, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto u = plan.point(handle(b)) - plan.point(handle(a)),
               v = plan.point(handle(c)) - plan.point(handle(b));
    return std::abs(std::atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1])) * 180 /
           std::numbers::pi;
}

std::vector<RimSide> rim_sides(const TriMesh& plan, const RimSidesOptions& options) {
    const auto rings = rings_of(plan);
    std::size_t all = 0;
    for (const Ring& ring : rings) all += corners_sharper_than(kNoCorner_deg, plan, ring).size();
    std::vector<RimSide> sides;
    for (const Ring& ring : rings) {
        auto corners = corners_sharper_than(
            all <= options.most_sides ? kNoCorner_deg : options.soft_corner_deg, plan, ring);
        cut_at_least_twice(corners, ring);
        add_sides(sides, plan, ring, corners);
    }
    return sides;
}

}  // namespace stratareeb
