// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/folded_graph.h"

#include <algorithm>
#include <cmath>

namespace stratareeb {

namespace {

std::uint32_t middle_vertex(const TriMesh& mesh, OpenMesh::FaceHandle face, const ScalarField& field) {
    std::array<std::uint32_t, 3> corners{};
    auto corner = corners.begin();
    for (const auto v : mesh.fv_range(face)) *corner++ = static_cast<std::uint32_t>(v.idx());
    std::ranges::sort(corners, [&](std::uint32_t a, std::uint32_t b) { return is_below(field, a, b); });
    return corners[1];
}

}  // namespace

FoldedGraph::FoldedGraph(const ReebGraph& graph, const ScalarField& field)
    : graph_(graph), field_(field), nodes_(graph.nodes.size()) {
    arcs_.reserve(2 * graph.arcs.size());
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
        nodes_[n].arcs[Down].reserve(graph.nodes[n].down);
        nodes_[n].arcs[Up].reserve(graph.nodes[n].up);
    }
    for (const ReebArc& arc : graph.arcs) add_arc(arc);
}

double FoldedGraph::persistence(std::uint32_t a, std::uint32_t b) const {
    return std::abs(value(a) - value(b));
}

std::uint32_t FoldedGraph::add_arc(const ReebArc& arc) {
    arcs_.push_back({.end = {arc.lower, arc.upper}, .slot = {}, .below_top = arc.below_top, .top = arc.top});
    const auto index = static_cast<std::uint32_t>(arcs_.size() - 1);
    attach(index, Down);
    attach(index, Up);
    return index;
}

//! Enter an arc among those of its lower or upper node.
void FoldedGraph::attach(std::uint32_t arc, Side end) {
    auto& list = nodes_[arcs_[arc].end[end]].arcs[opposite(end)];
    arcs_[arc].slot[end] = static_cast<std::uint32_t>(list.size());
    list.push_back(arc);
}

void FoldedGraph::detach(std::uint32_t arc, Side end) {
    auto& list = nodes_[arcs_[arc].end[end]].arcs[opposite(end)];
    const std::uint32_t slot = arcs_[arc].slot[end];
    list[slot] = list.back();
    arcs_[list[slot]].slot[end] = slot;
    list.pop_back();
}

FoldedGraph::Fork FoldedGraph::zip(std::uint32_t a, std::uint32_t b, Side side) {
    const std::uint32_t end_a = end(a, side), end_b = end(b, side);
    if (end_a == end_b) {
        detach(b, Down);
        detach(b, Up);
        arcs_[b].next = a;
        return {end_a, a, kNone};
    }
    const bool a_is_nearer = (side == Down) == (end_a > end_b);
    const Fork fork{a_is_nearer ? end_a : end_b, a_is_nearer ? a : b, a_is_nearer ? b : a};
    const Side cut = opposite(side);
    detach(fork.rest, cut);
    arcs_[fork.rest].end[cut] = fork.node;
    arcs_[fork.rest].cuts[cut].push_back({fork.node, fork.nearer});
    attach(fork.rest, cut);
    return fork;
}

void FoldedGraph::slide(std::uint32_t arc, std::uint32_t node, std::uint32_t root_arc, Side side) {
    const Side cut = opposite(side);
    const std::uint32_t root = end(arc, cut);
    detach(arc, cut);
    arcs_[arc].end[cut] = node;
    arcs_[arc].cuts[cut].push_back({node, root_arc, root});
    attach(arc, cut);
}

void FoldedGraph::prune(std::uint32_t arc, Side side) {
    const std::uint32_t root = end(arc, opposite(side));
    nodes_[end(arc, side)].alive = false;
    detach(arc, Down);
    detach(arc, Up);
    arcs_[arc].root = root;
    arcs_[arc].next =
        arcs(root, side).empty() ? arcs(root, opposite(side)).front() : arcs(root, side).front();
}

void FoldedGraph::tidy(std::uint32_t node) {
    if (!is_node(node) || arcs(node, Down).size() != 1 || arcs(node, Up).size() != 1) return;
    const std::uint32_t below = arcs(node, Down)[0], above = arcs(node, Up)[0];
    for (const std::uint32_t arc : {below, above}) {
        detach(arc, Down);
        detach(arc, Up);
    }
    nodes_[node].alive = false;
    const std::uint32_t joined =
        add_arc({end(below, Down), end(above, Up), arcs_[above].below_top, arcs_[above].top});
    arcs_[below].next = arcs_[above].next = joined;
}

bool FoldedGraph::is_beyond(std::uint32_t vertex, std::uint32_t node, Side side) const {
    const std::uint32_t at = graph_.nodes[node].vertex;
    return side == Down ? is_below(field_, vertex, at) : is_below(field_, at, vertex);
}

const FoldedGraph::Cut* FoldedGraph::cut_that_took(std::uint32_t vertex, const Arc& arc) const {
    for (const Side side : {Down, Up}) {
        const auto& cuts = arc.cuts[side];
        if (cuts.empty() || !is_beyond(vertex, cuts.back().node, side)) continue;
        return &*std::ranges::partition_point(
            cuts, [&](const Cut& cut) { return !is_beyond(vertex, cut.node, side); });
    }
    return nullptr;
}

//! The arc that took another's place; chains of whole arcs are shortened on the way.
std::uint32_t FoldedGraph::skip_plain(std::uint32_t arc) {
    const auto is_plain = [&](const Arc& a) {
        return a.next != kNone && a.root == kNone && a.cuts[Down].empty() && a.cuts[Up].empty();
    };
    std::uint32_t next = arcs_[arc].next;
    while (is_plain(arcs_[next])) {
        const std::uint32_t further = arcs_[next].next;
        if (is_plain(arcs_[further])) arcs_[next].next = arcs_[further].next;
        next = further;
    }
    return arcs_[arc].next = next;
}

//! Where a vertex that lay on an arc lies now.
std::uint32_t FoldedGraph::arc_now(std::uint32_t arc, std::uint32_t vertex) {
    for (;;) {
        if (const Cut* cut = cut_that_took(vertex, arcs_[arc])) {
            arc = cut->arc;
            if (cut->root != kNone) vertex = graph_.nodes[cut->root].vertex;
        } else if (is_alive(arc)) {
            return arc;
        } else if (arcs_[arc].root != kNone) {
            vertex = graph_.nodes[arcs_[arc].root].vertex;
            arc = arcs_[arc].next;
        } else {
            arc = skip_plain(arc);
        }
    }
}

std::vector<std::uint32_t> FoldedGraph::arcs_in_order() const {
    std::vector<std::uint32_t> order;
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
        if (!is_node(n)) continue;
        const auto from = static_cast<std::ptrdiff_t>(order.size());
        order.insert(order.end(), arcs(n, Up).begin(), arcs(n, Up).end());
        std::ranges::sort(order.begin() + from, order.end(), {},
                          [&](std::uint32_t a) { return std::pair(end(a, Up), a); });
    }
    return order;
}

ReebGraph FoldedGraph::skeleton(std::vector<std::uint32_t>& old_nodes) const {
    ReebGraph skeleton;
    old_nodes.clear();
    std::vector<std::uint32_t> number(nodes_.size(), kNone);
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
        if (!is_node(n)) continue;
        number[n] = static_cast<std::uint32_t>(old_nodes.size());
        old_nodes.push_back(n);
        ReebNode node = graph_.nodes[n];
        node.down = static_cast<std::uint32_t>(arcs(n, Down).size());
        node.up = static_cast<std::uint32_t>(arcs(n, Up).size());
        if (node.down + node.up > 0)
            node.type = node.down == 0 ? CriticalType::Minimum
                        : node.up == 0 ? CriticalType::Maximum
                                       : CriticalType::Saddle;
        skeleton.nodes.push_back(node);
    }
    for (const std::uint32_t a : arcs_in_order())
        skeleton.arcs.push_back({number[end(a, Down)], number[end(a, Up)], arcs_[a].below_top, arcs_[a].top});
    skeleton.components = graph_.components;
    skeleton.hidden_loops = graph_.hidden_loops;
    return skeleton;
}

ReebGraph FoldedGraph::result(const TriMesh* mesh) {
    std::vector<std::uint32_t> kept;
    ReebGraph result = skeleton(kept);
    std::vector<std::uint32_t> number(arcs_.size(), kNone);
    const std::vector<std::uint32_t> order = arcs_in_order();
    for (std::uint32_t a = 0; a < order.size(); ++a) number[order[a]] = a;
    result.vertex_arc = graph_.vertex_arc;
    for (std::uint32_t v = 0; v < result.vertex_arc.size(); ++v)
        if (graph_.vertex_arc[v] != kNone) result.vertex_arc[v] = number[arc_now(graph_.vertex_arc[v], v)];
    if (mesh) fill_triangle_arcs(*mesh, number, result);
    return result;
}

void FoldedGraph::fill_triangle_arcs(const TriMesh& mesh, const std::vector<std::uint32_t>& number,
                                     ReebGraph& to) {
    to.triangle_arc = graph_.triangle_arc;
    for (std::uint32_t t = 0; t < to.triangle_arc.size(); ++t) {
        if (graph_.triangle_arc[t] == kNone) continue;
        const std::uint32_t middle = middle_vertex(mesh, mesh.face_handle(t), field_);
        to.triangle_arc[t] = number[arc_now(graph_.triangle_arc[t], middle)];
    }
}

}  // namespace stratareeb
