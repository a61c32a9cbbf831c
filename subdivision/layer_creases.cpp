// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/layer_creases.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "subdivision/leaning_edges.h"

namespace stratareeb {

namespace {

using Vertex = TriMesh::VertexHandle;
using Edge = TriMesh::EdgeHandle;
using Halfedge = TriMesh::HalfedgeHandle;

constexpr double kStraight = 1e-6;     // radians; the outline's rounding stays below
constexpr double kTurnsInwards = 0.1;  // radians beyond which a corner of the outline needs an inner crease

std::size_t index(OpenMesh::BaseHandle handle) {
    return static_cast<std::size_t>(handle.idx());
}

std::uint32_t number(OpenMesh::BaseHandle handle) {
    return static_cast<std::uint32_t>(handle.idx());
}

double angle_between(const TriMesh::Point& u, const TriMesh::Point& v) {
    return std::atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]);
}

//! How the outline turns at a rim vertex: left, positive, at the convex corners of an outer ring.
double turn_at(const TriMesh& mesh, Vertex v) {
    const Halfedge out = mesh.halfedge_handle(v);  // a boundary half-edge, with the inside on its right
    const Halfedge in = mesh.prev_halfedge_handle(out);
    return -angle_between(mesh.calc_edge_vector(in), mesh.calc_edge_vector(out));
}

//! The inner edge at a rim vertex that comes closest to halving the angle there.
Edge halving_edge(const TriMesh& mesh, Vertex v, const std::vector<char>& is_hole) {
    const Halfedge rim = mesh.halfedge_handle(v);
    const TriMesh::Point first = mesh.calc_edge_vector(rim);
    const double half = (std::numbers::pi - turn_at(mesh, v)) / 2;
    Edge best;
    double off = 0;
    for (const Halfedge h : mesh.voh_range(v)) {
        if (mesh.is_boundary(mesh.edge_handle(h))) continue;
        double angle = angle_between(first, mesh.calc_edge_vector(h));
        if (angle < 0) angle += 2 * std::numbers::pi;
        // A hole at the crease's end would not be met exactly.
        const double here = std::abs(2 * std::numbers::pi - angle - half) +
                            (is_hole[index(mesh.to_vertex_handle(h))] ? std::numbers::pi : 0);
        if (!best.is_valid() || here < off) best = mesh.edge_handle(h), off = here;
    }
    return best;
}

std::vector<char> hole_flags(const LayerModel& model) {
    std::vector<char> flags(model.plan.surface.n_vertices(), 0);
    for (const auto v : model.plan.hole_vertex)
        if (v != PlanMesh::kNoVertex) flags[v] = 1;
    return flags;
}

LayerSet ending_at(const LayerModel& model, Edge e) {
    const TriMesh& mesh = model.plan.surface;
    if (mesh.is_boundary(e)) return {};
    return model.regions.in_face[index(mesh.face_handle(mesh.halfedge_handle(e, 0)))] ^
           model.regions.in_face[index(mesh.face_handle(mesh.halfedge_handle(e, 1)))];
}

LayerSet present_around(const LayerModel& model, Vertex v) {
    LayerSet set = LayerSet().set();
    for (const auto f : model.plan.surface.vf_range(v)) set &= model.regions.in_face[index(f)];
    return set;
}

//! Vertices without thickness that would not stay so: not amid two creases along which the thickness is 0.
std::vector<std::uint32_t> zero_corners(const LayerModel& model, std::size_t layer,
                                        const std::vector<std::uint32_t>& inner_creases) {
    const TriMesh& mesh = model.plan.surface;
    std::vector<std::uint8_t> creases(mesh.n_vertices(), 0), zero_ends(mesh.n_vertices(), 0);
    const auto count = [&](Edge e) {
        const Halfedge h = mesh.halfedge_handle(e, 0);
        const std::size_t ends[2] = {index(mesh.from_vertex_handle(h)), index(mesh.to_vertex_handle(h))};
        for (const int i : {0, 1}) {
            if (creases[ends[i]] < 3) ++creases[ends[i]];
            if (model.regions.zero_at[ends[1 - i]][layer] && zero_ends[ends[i]] < 3) ++zero_ends[ends[i]];
        }
    };
    for (const std::uint32_t e : inner_creases) count(Edge(static_cast<int>(e)));
    for (const Edge e : mesh.edges())
        if (mesh.is_boundary(e)) count(e);
    std::vector<std::uint32_t> corners;
    for (const Vertex v : mesh.vertices()) {
        const std::size_t i = index(v);
        if (!model.regions.zero_at[i][layer] || (creases[i] == 2 && zero_ends[i] == 2)) continue;
        bool beside_layer = false;
        for (const auto f : mesh.vf_range(v)) beside_layer |= model.regions.in_face[index(f)][layer];
        if (beside_layer) corners.push_back(number(v));
    }
    return corners;
}

std::vector<std::uint32_t> merged(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    std::vector<std::uint32_t> result;
    std::ranges::set_union(a, b, std::back_inserter(result));
    return result;
}

}  // namespace

FieldCreases plan_creases(const LayerModel& model) {
    const TriMesh& mesh = model.plan.surface;
    const std::vector<char> is_hole = hole_flags(model);
    FieldCreases creases;
    for (const Vertex v : mesh.vertices()) {
        if (!mesh.is_boundary(v)) continue;
        const double turn = turn_at(mesh, v);
        if (std::abs(turn) > kStraight) creases.corners.push_back(number(v));
        if (turn > -kTurnsInwards || mesh.valence(v) < 3) continue;
        const Edge e = halving_edge(mesh, v, is_hole);
        creases.edges.push_back(number(e));
    }
    for (const std::uint32_t e : creases.edges) {  // a crease that ends at a hole ends in a corner
        const Halfedge h = mesh.halfedge_handle(Edge(static_cast<int>(e)), 0);
        for (const Vertex v : {mesh.from_vertex_handle(h), mesh.to_vertex_handle(h)})
            if (is_hole[index(v)]) creases.corners.push_back(number(v));
    }
    for (auto* list : {&creases.edges, &creases.corners}) {
        std::ranges::sort(*list);
        list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    return creases;
}

LayerCreases layer_creases(const LayerModel& model, FieldCreases plan) {
    const TriMesh& mesh = model.plan.surface;
    const std::size_t layers = model.units.size();
    std::vector<std::vector<std::uint32_t>> lines(layers);
    for (const Edge e : mesh.edges()) {
        const LayerSet ending = ending_at(model, e);
        if (ending.none()) continue;
        for (std::size_t i = 0; i < layers; ++i)
            if (ending[i]) lines[i].push_back(number(e));
    }
    LayerCreases creases{std::move(plan), {}};
    for (std::size_t i = 0; i < layers; ++i) {
        FieldCreases own;
        own.edges = merged(creases.plan.edges, lines[i]);
        own.corners = merged(creases.plan.corners, zero_corners(model, i, own.edges));
        own.leaning = leaning_edges(model, i, creases.plan);
        creases.thickness.push_back(std::move(own));
    }
    return creases;
}

std::vector<Handover> handovers(const LayerModel& model, std::size_t layer) {
    const TriMesh& mesh = model.plan.surface;
    std::vector<Handover> result;
    for (const Edge e : mesh.edges()) {
        if (!ending_at(model, e)[layer]) continue;
        const Halfedge h = mesh.halfedge_handle(e, 0);
        const LayerSet around = present_around(model, mesh.from_vertex_handle(h)) &
                                present_around(model, mesh.to_vertex_handle(h));
        std::size_t to = layer + 1;
        while (to < model.units.size() && !around[to]) ++to;
        result.push_back({number(e), to < model.units.size() ? to : Handover::kNobody});
    }
    return result;
}

FieldCreases without_edges(const LayerModel& model, const LayerCreases& creases, std::size_t layer,
                           const std::vector<std::uint32_t>& edges) {
    const TriMesh& mesh = model.plan.surface;
    const FieldCreases &full = creases.thickness[layer], &plan = creases.plan;
    FieldCreases result;
    std::ranges::set_difference(full.edges, edges, std::back_inserter(result.edges));
    result.edges = merged(result.edges, plan.edges);
    std::vector<char> at_gone(mesh.n_vertices(), 0), let_go(mesh.n_vertices(), 0);
    const auto flag = [&](std::vector<char>& flags, std::uint32_t e, char value) {
        const Halfedge h = mesh.halfedge_handle(Edge(static_cast<int>(e)), 0);
        for (const Vertex v : {mesh.from_vertex_handle(h), mesh.to_vertex_handle(h)}) flags[index(v)] = value;
    };
    for (const std::uint32_t e : edges) flag(at_gone, e, 1);
    let_go = at_gone;
    for (const std::uint32_t e : result.edges)
        if (ending_at(model, Edge(static_cast<int>(e)))[layer]) flag(let_go, e, 0);
    for (const LeaningEdge& e : full.leaning)
        if (!at_gone[e.vertex]) result.leaning.push_back(e);
    for (const std::uint32_t v : full.corners)
        if (!let_go[v] || std::ranges::binary_search(plan.corners, v)) result.corners.push_back(v);
    return result;
}

}  // namespace stratareeb
