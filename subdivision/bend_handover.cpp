// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/bend_handover.h"

#include <algorithm>

#include "subdivision/crease_field.h"

namespace stratareeb {

namespace {

// What a hole's contact leaves to be taken over at most, of the layer's thickness there.
constexpr double kMostOfContact = 0.5;

using Receivers = std::map<std::size_t, std::vector<std::uint32_t>>;  // edges whose bend a layer takes over

//! Where creases have been given up for one layer after the other, from the top down: differences between steps.
std::map<std::size_t, std::vector<double>> differences(const LayerModel& control, const LayerCreases& creases,
                                                       const LoopTopology& topology, std::size_t layer,
                                                       const std::vector<double>& control_thickness,
                                                       const std::vector<double>& thickness,
                                                       const Receivers& receivers) {
    std::map<std::size_t, std::vector<double>> result;
    std::vector<double> previous = thickness;
    std::vector<std::uint32_t> gone;
    for (const auto& [to, edges] : receivers) {
        gone.insert(gone.end(), edges.begin(), edges.end());
        std::ranges::sort(gone);
        std::vector<double> next =
            limit_values(topology, without_edges(control, creases, layer, gone), control_thickness);
        std::vector<double> bend(next.size());
        for (std::size_t v = 0; v < next.size(); ++v) bend[v] = next[v] - previous[v];
        result.emplace(to, std::move(bend));
        previous = std::move(next);
    }
    return result;
}

//! Holes that can't bear what their layer would take over.
std::vector<char> overdrawn(const LayerModel& control,
                            const std::map<std::size_t, std::vector<double>>& handed) {
    std::vector<char> flags(control.plan.surface.n_vertices(), 0);
    for (const auto& [to, bend] : handed)
        for (const auto v : control.plan.hole_vertex)
            if (v != PlanMesh::kNoVertex && bend[v] > kMostOfContact * control.thickness(to, v)) flags[v] = 1;
    return flags;
}

//! Leave the bend in place at edges that end at flagged vertices.
bool drop_edges(Receivers& receivers, const LoopLevel& level, const std::vector<char>& flags) {
    bool any = false;
    for (auto& [to, edges] : receivers)
        any |= std::erase_if(edges, [&](std::uint32_t e) {
                   return flags[level.ends[e][0]] || flags[level.ends[e][1]];
               }) > 0;
    std::erase_if(receivers, [](const auto& entry) { return entry.second.empty(); });
    return any;
}

}  // namespace

std::map<std::size_t, std::vector<double>> bends_handed_over(const LayerModel& control,
                                                             const LayerCreases& creases,
                                                             const LoopTopology& topology, std::size_t layer,
                                                             const std::vector<double>& control_thickness,
                                                             const std::vector<double>& thickness) {
    Receivers receivers;
    for (const Handover& h : handovers(control, layer))
        if (h.to != Handover::kNobody && !std::ranges::binary_search(creases.plan.edges, h.edge))
            receivers[h.to].push_back(h.edge);
    while (!receivers.empty()) {
        auto result = differences(control, creases, topology, layer, control_thickness, thickness, receivers);
        if (!drop_edges(receivers, topology.level(0), overdrawn(control, result))) return result;
    }
    return {};
}

}  // namespace stratareeb
