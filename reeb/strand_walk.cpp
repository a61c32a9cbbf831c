// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/strand_walk.h"

#include <algorithm>
#include <numeric>

namespace stratareeb {

namespace {

using Halfedge = TriMesh::HalfedgeHandle;

}  // namespace

std::size_t StrandWalk::one_group(const VertexLink& link) {
    group_.assign(link.strands.size(), 0);
    walkers_.clear();
    unfinished_ = 0;
    return 1;
}

std::size_t StrandWalk::root(std::size_t strand) const {
    while (parent_[strand] != strand) strand = parent_[strand];
    return strand;
}

//! Are all groups but one finished?
bool StrandWalk::one_is_open() const {
    constexpr std::size_t kNone = ~std::size_t{0};
    std::size_t open = kNone;
    for (const Walker& walker : walkers_) {
        if (walker.done) continue;
        const std::size_t group = root(walker.strand);
        if (open != kNone && open != group) return false;
        open = group;
    }
    return true;
}

void StrandWalk::step(Walker& walker) {
    if (mesh_.is_boundary(walker.at)) {
        walker.done = true;
        return;
    }
    // Out of the triangle by the other crossed edge.
    const auto is_above = [&](TriMesh::VertexHandle v) {
        return rank_[static_cast<std::size_t>(v.idx())] > rank_at_;
    };
    Halfedge out = mesh_.next_halfedge_handle(walker.at);
    if (is_above(mesh_.from_vertex_handle(out)) == is_above(mesh_.to_vertex_handle(out)))
        out = mesh_.next_halfedge_handle(out);
    const auto edge = static_cast<std::uint32_t>(mesh_.edge_handle(out).idx());
    if (const std::uint32_t end = end_at_[edge]; end > 0) {  // back at the vertex, at the end of a strand
        Walker& other = walkers_[end - 1];
        walker.done = other.done = true;
        parent_[root(walker.strand)] = root(other.strand);
        return;
    }
    walker.edges.push_back(edge);
    walker.at = mesh_.opposite_halfedge_handle(out);
}

std::size_t StrandWalk::group_strands(const VertexLink& link) {
    walkers_.clear();
    parent_.resize(link.strands.size());
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (std::size_t s = 0; s < link.strands.size(); ++s)
        for (const Halfedge exit : {link.strands[s].first_exit, link.strands[s].last_exit})
            if (exit.is_valid()) {
                const auto edge = static_cast<std::uint32_t>(mesh_.edge_handle(exit).idx());
                walkers_.push_back({exit, s, false, {edge}});
                end_at_[edge] = static_cast<std::uint32_t>(walkers_.size());
            }
    rank_at_ = rank_[static_cast<std::size_t>(link.vertex)];
    while (!one_is_open())
        for (Walker& walker : walkers_)
            if (!walker.done) step(walker);
    for (const Walker& walker : walkers_) end_at_[walker.edges.front()] = 0;

    // Number groups in the order of their first strands.
    group_.assign(link.strands.size(), 0);
    std::vector<std::size_t> roots;
    for (std::size_t s = 0; s < link.strands.size(); ++s) {
        const auto it = std::ranges::find(roots, root(s));
        group_[s] = static_cast<std::uint32_t>(it - roots.begin());
        if (it == roots.end()) roots.push_back(root(s));
    }
    unfinished_ = 0;  // if all are finished, any may keep its name
    for (const Walker& walker : walkers_)
        if (!walker.done) unfinished_ = group_[walker.strand];
    return roots.size();
}

std::vector<std::uint32_t> StrandWalk::edges_of(std::uint32_t group) const {
    std::vector<std::uint32_t> edges;
    for (const Walker& walker : walkers_)
        if (group_[walker.strand] == group)
            edges.insert(edges.end(), walker.edges.begin(), walker.edges.end());
    return edges;
}

}  // namespace stratareeb
