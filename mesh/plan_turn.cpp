// SPDX-License-Identifier: GPL-3.0-or-later
// The part of PlanCollapse that turns edges.
#include <algorithm>

#include "mesh/plan_collapse.h"

namespace stratareeb {

namespace {

std::size_t index(OpenMesh::BaseHandle handle) {
    return static_cast<std::size_t>(handle.idx());
}

}  // namespace

//! The two triangles at an edge that is no line, as they are with the other diagonal; none where they would fold over.
std::optional<PlanCollapse::Turn> PlanCollapse::turn_of(Halfedge h) const {
    if (is_line(h) || !mesh_.is_flip_ok(mesh_.edge_handle(h))) return std::nullopt;
    const Halfedge o = mesh_.opposite_halfedge_handle(h);
    const Vertex from = mesh_.from_vertex_handle(h), to = mesh_.to_vertex_handle(h),
                 left = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h)),
                 right = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(o));
    const Turn turn{{mesh_.face_handle(h), mesh_.face_handle(o)},
                    {Corners{from, right, left}, Corners{to, left, right}}};
    if (!is_unfolded(turn.after[0]) || !is_unfolded(turn.after[1])) return std::nullopt;
    return turn;
}

bool PlanCollapse::is_within_limits(const Turn& turn) const {
    const auto& [from, right, left] = turn.after[0];
    const auto& zero = model_.regions.zero_at;
    const auto smallest = [&](const Corners& a, const Corners& b) {
        return std::min(sine_of(a), sine_of(b));
    };
    if (smallest(turn.after[0], turn.after[1]) <
        std::min(limits_.min_sine, smallest(corners_of(turn.faces[0]), corners_of(turn.faces[1]))))
        return false;
    if ((model_.regions.in_face[index(turn.faces[0])] & zero[index(left)] & zero[index(right)]).any())
        return false;
    double largest = before_.along(left, right);
    const std::vector<Corners> pair(turn.after.begin(), turn.after.end());
    for (const Face f : turn.faces)
        for (auto p = first_in_face_[index(f)]; p != kNone && largest <= limits_.deviation;
             p = next_in_face_[p]) {
            const Vertex removed(static_cast<int>(p));
            largest = std::max(largest, before_.at_vertex(removed, pair[place_in(pair, removed)]));
        }
    return largest <= limits_.deviation;
}

void PlanCollapse::turn(Halfedge h, const Turn& turn) {
    std::vector<std::uint32_t> moved;
    for (const Face f : turn.faces) {
        for (auto p = first_in_face_[index(f)]; p != kNone; p = next_in_face_[p]) moved.push_back(p);
        first_in_face_[index(f)] = kNone;
    }
    mesh_.flip(mesh_.edge_handle(h));
    const std::vector<Corners> pair{corners_of(turn.faces[0]), corners_of(turn.faces[1])};
    for (const auto p : moved) {
        auto& first = first_in_face_[index(turn.faces[place_in(pair, Vertex(static_cast<int>(p)))])];
        next_in_face_[p] = first;
        first = p;
    }
}

bool PlanCollapse::turn_edge_away(Vertex v) {
    if (fixed_[index(v)] || lines_at(v).size() % 2 != 0 || lines_at(v).size() > 2) return false;
    std::optional<std::pair<Halfedge, Turn>> best;
    double best_sine = 0;
    for (const Halfedge h : mesh_.voh_range(v)) {
        const auto turn = turn_of(h);
        if (!turn) continue;
        const double sine = std::min(sine_of(turn->after[0]), sine_of(turn->after[1]));
        if (sine > best_sine && is_within_limits(*turn)) best = {h, *turn}, best_sine = sine;
    }
    if (best) turn(best->first, best->second);
    return best.has_value();
}

}  // namespace stratareeb
