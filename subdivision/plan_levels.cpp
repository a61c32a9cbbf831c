// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/plan_levels.h"

#include <algorithm>
#include <numeric>

namespace stratareeb {
namespace {

constexpr std::uint32_t kNone = PlanLevels::kNone;

std::uint32_t root(std::vector<std::uint32_t>& parent, std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

// The lower number stays the root, so that roots come first.
void join(std::vector<std::uint32_t>& parent, std::uint32_t a, std::uint32_t b) {
    a = root(parent, a), b = root(parent, b);
    parent[std::max(a, b)] = std::min(a, b);
}

}  // namespace

PlanLevels::PlanLevels(const LayerModel& model)
    : model_(model),
      plan_(model.plan.surface),
      layers_(static_cast<std::uint32_t>(model.units.size())),
      open_(plan_.n_edges()) {
    const auto& in_face = model.regions.in_face;
    for (const auto e : plan_.edges()) {
        LayerSet& open = open_[index(e)];
        open.set();
        for (const int side : {0, 1}) {
            const auto h = plan_.halfedge_handle(e, side);
            if (!plan_.is_boundary(h)) open &= in_face[index(plan_.face_handle(h))];
        }
        const auto h = plan_.halfedge_handle(e, 0);
        open &= ~(model.regions.zero_at[index(plan_.from_vertex_handle(h))] &
                  model.regions.zero_at[index(plan_.to_vertex_handle(h))]);
    }
    for (const LayerSet& present : in_face) {
        first_.push_back(interfaces_.size());
        if (present.none()) continue;
        std::uint32_t above = kNone;
        const auto add = [&](std::uint32_t below, std::uint32_t horizon) {
            interfaces_.push_back({static_cast<std::uint32_t>(interfaces_.size()), above, below, horizon});
            above = below;
        };
        for (std::uint32_t layer = 0; layer < layers_; ++layer)
            if (present[layer]) add(layer, layer);
        add(kNone, layers_);
    }
    first_.push_back(interfaces_.size());
}

bool PlanLevels::all_go_on_across(TriMesh::EdgeHandle e) const {
    if (plan_.is_boundary(e)) return false;
    const auto present = [&](int side) {
        return model_.regions.in_face[index(plan_.face_handle(plan_.halfedge_handle(e, side)))];
    };
    return present(0) == open_[index(e)] && present(1) == open_[index(e)];
}

std::uint32_t PlanLevels::on_edge(TriMesh::EdgeHandle e, std::uint32_t horizon) const {
    while (horizon > 0 && !open_[index(e)][horizon - 1]) --horizon;
    return horizon;
}

std::uint32_t PlanLevels::at_vertex(std::uint32_t vertex, std::uint32_t horizon) const {
    while (horizon > 0 && model_.regions.zero_at[vertex][horizon - 1]) --horizon;
    return horizon;
}

std::vector<std::uint32_t> PlanLevels::layer_parts(std::uint32_t layer) const {
    std::vector<std::uint32_t> parent(plan_.n_faces());
    std::iota(parent.begin(), parent.end(), 0u);
    for (const auto e : plan_.edges())
        if (!plan_.is_boundary(e) && is_open(e, layer))
            join(parent, static_cast<std::uint32_t>(plan_.face_handle(plan_.halfedge_handle(e, 0)).idx()),
                 static_cast<std::uint32_t>(plan_.face_handle(plan_.halfedge_handle(e, 1)).idx()));
    std::vector<std::uint32_t> part(parent.size(), kNone);
    std::uint32_t count = 0;
    for (std::uint32_t f = 0; f < part.size(); ++f) {
        if (!model_.regions.in_face[f][layer]) continue;
        const std::uint32_t r = root(parent, f);
        part[f] = r == f ? count++ : part[r];
    }
    return part;
}

std::vector<std::uint32_t> PlanLevels::interface_parts() const {
    std::vector<std::uint32_t> parent(interfaces_.size());
    std::iota(parent.begin(), parent.end(), 0u);
    for (const auto e : plan_.edges()) {
        if (plan_.is_boundary(e)) continue;
        const auto here = interfaces(index(plan_.face_handle(plan_.halfedge_handle(e, 0))));
        const auto there = interfaces(index(plan_.face_handle(plan_.halfedge_handle(e, 1))));
        for (const Interface& i : here) {
            const auto goes_on = [&](std::uint32_t layer) { return layer == kNone || is_open(e, layer); };
            if (!goes_on(i.above) || !goes_on(i.below)) continue;
            for (const Interface& j : there)
                if (i.above == j.above && i.below == j.below) join(parent, i.id, j.id);
        }
    }
    std::vector<std::uint32_t> part(parent.size());
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < part.size(); ++i) {
        const std::uint32_t r = root(parent, i);
        part[i] = r == i ? count++ : part[r];
    }
    return part;
}

}  // namespace stratareeb
