// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/block_border.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "boreholes/errors.h"

namespace stratareeb {

namespace {

using Vertex = TriMesh::VertexHandle;
using Halfedge = TriMesh::HalfedgeHandle;

Vertex handle(std::uint32_t v) {
    return Vertex(static_cast<int>(v));
}

std::uint32_t number(OpenMesh::BaseHandle h) {
    return static_cast<std::uint32_t>(h.idx());
}

double distance(const TriMesh& mesh, std::uint32_t v, const Point2& p) {
    return std::hypot(mesh.point(handle(v))[0] - p.x, mesh.point(handle(v))[1] - p.y);
}

//! How far p is from the way from a to b, and at which share of it.
std::pair<double, double> place_on(const TriMesh& mesh, std::uint32_t a, std::uint32_t b, const Point2& p) {
    const auto &u = mesh.point(handle(a)), &w = mesh.point(handle(b));
    const double dx = w[0] - u[0], dy = w[1] - u[1], squared = dx * dx + dy * dy;
    const double t =
        squared > 0 ? std::clamp(((p.x - u[0]) * dx + (p.y - u[1]) * dy) / squared, 0.0, 1.0) : 0.0;
    return {std::hypot(p.x - (u[0] + t * dx), p.y - (u[1] + t * dy)), t};
}

}  // namespace

BlockBorder::BlockBorder(LayerModel& model, const Footprint& outline, double same) {
    const std::vector<std::vector<std::uint32_t>> loops = boundary_loops(model.plan.surface);
    for (const auto& ring : outline) {
        const auto closest_on = [&](const std::vector<std::uint32_t>& loop) {
            double best = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < loop.size(); ++i)
                best = std::min(
                    best, place_on(model.plan.surface, loop[i], loop[(i + 1) % loop.size()], ring[0]).first);
            return best;
        };
        std::vector<std::uint32_t> loop = *std::ranges::min_element(loops, {}, closest_on);
        insert_corners(model, ring, loop, same);
    }
}

std::vector<std::vector<std::uint32_t>> BlockBorder::boundary_loops(const TriMesh& mesh) {
    std::vector<char> seen(mesh.n_halfedges(), 0);
    std::vector<std::vector<std::uint32_t>> loops;
    for (const Halfedge start : mesh.halfedges()) {
        if (!mesh.is_boundary(start) || seen[static_cast<std::size_t>(start.idx())]) continue;
        auto& loop = loops.emplace_back();
        for (Halfedge h = start; !seen[static_cast<std::size_t>(h.idx())]; h = mesh.next_halfedge_handle(h)) {
            seen[static_cast<std::size_t>(h.idx())] = 1;
            loop.push_back(number(mesh.from_vertex_handle(h)));
        }
        std::ranges::reverse(loop);  // the inside to the left
    }
    return loops;
}

void BlockBorder::insert_corners(LayerModel& model, const std::vector<Point2>& ring,
                                 std::vector<std::uint32_t>& loop, double same) {
    std::vector<std::uint32_t> corners;
    for (const Point2& p : ring) {
        const auto closest = std::ranges::min_element(
            loop, {}, [&](std::uint32_t v) { return distance(model.plan.surface, v, p); });
        if (distance(model.plan.surface, *closest, p) <= same) {
            model.plan.surface.set_point(handle(*closest), {p.x, p.y, 0});
            corners.push_back(*closest);
            continue;
        }
        std::size_t best = 0;
        std::pair<double, double> place{std::numeric_limits<double>::infinity(), 0};
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const auto here = place_on(model.plan.surface, loop[i], loop[(i + 1) % loop.size()], p);
            if (here.first < place.first) place = here, best = i;
        }
        const std::uint32_t v =
            split_edge(model, loop[best], loop[(best + 1) % loop.size()], p, place.second);
        loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(best + 1), v);
        corners.push_back(v);
    }
    auto& sides = sides_.emplace_back();
    for (std::size_t k = 0; k < corners.size(); ++k) {
        auto& side = sides.emplace_back();
        const std::uint32_t last = corners[(k + 1) % corners.size()];
        auto at = std::ranges::find(loop, corners[k]);
        side.push_back(*at);
        while (side.back() != last && side.size() <= loop.size()) {
            if (++at == loop.end()) at = loop.begin();
            side.push_back(*at);
        }
    }
}

std::uint32_t BlockBorder::split_edge(LayerModel& model, std::uint32_t a, std::uint32_t b, const Point2& at,
                                      double share) {
    TriMesh& mesh = model.plan.surface;
    const Halfedge inner = mesh.find_halfedge(handle(a), handle(b));
    if (!inner.is_valid() || mesh.is_boundary(inner))
        throw GeometryError(fmt::format("the two sides of a fault don't meet near x {:.10g}, y {:.10g}",
                                        at.x + model.origin.x, at.y + model.origin.y));
    const LayerSet layers = model.regions.in_face[static_cast<std::size_t>(mesh.face_handle(inner).idx())];
    const Vertex v = mesh.add_vertex({at.x, at.y, 0});
    mesh.split(mesh.edge_handle(inner), v);
    model.regions.in_face.resize(mesh.n_faces(), layers);
    model.regions.zero_at.push_back(model.regions.zero_at[a] & model.regions.zero_at[b]);
    for (auto& horizon : model.horizons) horizon.push_back(horizon[a] + share * (horizon[b] - horizon[a]));
    return number(v);
}

}  // namespace stratareeb
