// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/plan_areas.h"

#include <algorithm>
#include <map>

#include "mesh/ring_stitching.h"

namespace stratareeb {

namespace {

std::vector<Point2> map_points(const LayerModel& model) {
    std::vector<Point2> points;
    for (const auto v : model.plan.surface.vertices()) {
        const auto& p = model.plan.surface.point(v);
        points.push_back({p[0] + model.origin.x, p[1] + model.origin.y});
    }
    return points;
}

}  // namespace

std::vector<PlanArea> plan_areas(const LayerModel& model,
                                 const std::function<std::size_t(std::size_t face)>& label) {
    const TriMesh& plan = model.plan.surface;
    const std::vector<Point2> points = map_points(model);
    std::vector<std::size_t> labels(plan.n_faces());
    for (std::size_t f = 0; f < labels.size(); ++f) labels[f] = label(f);
    std::map<std::size_t, std::vector<std::array<std::uint32_t, 2>>> borders;
    for (const auto h : plan.halfedges()) {
        if (plan.is_boundary(h)) continue;
        const std::size_t here = labels[static_cast<std::size_t>(plan.face_handle(h).idx())];
        const auto twin = plan.opposite_halfedge_handle(h);
        const bool inside =
            !plan.is_boundary(twin) && labels[static_cast<std::size_t>(plan.face_handle(twin).idx())] == here;
        if (here == kNoLabel || inside) continue;
        borders[here].push_back({static_cast<std::uint32_t>(plan.from_vertex_handle(h).idx()),
                                 static_cast<std::uint32_t>(plan.to_vertex_handle(h).idx())});
    }
    std::vector<PlanArea> areas;
    for (auto& [value, sides] : borders) {
        std::vector<std::vector<Point2>> rings;
        for (const auto& ring : stitch_rings(points, std::move(sides))) {
            auto& outline = rings.emplace_back();
            for (const std::uint32_t v : ring) outline.push_back(points[v]);
        }
        for (auto& nested : nest_rings(std::move(rings))) areas.push_back({value, std::move(nested)});
    }
    return areas;
}

std::vector<std::vector<Point2>> plan_outline(const LayerModel& model) {
    std::vector<std::vector<Point2>> outline;
    for (auto& area : plan_areas(model, [](std::size_t) { return std::size_t{0}; }))
        outline.insert(outline.end(), area.rings.begin(), area.rings.end());
    return outline;
}

std::vector<PlanArea> geological_map(const LayerModel& model) {
    return plan_areas(model, [&](std::size_t face) {
        for (std::size_t layer = 0; layer < model.units.size(); ++layer)
            if (model.regions.in_face[face][layer]) return layer;
        return kNoLabel;
    });
}

}  // namespace stratareeb
