// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/strand_walk.h"

#include <algorithm>
#include <numeric>

namespace stratareeb {

std::size_t StrandWalk::root(std::size_t strand) const {
    while (parent_[strand] != strand) strand = parent_[strand];
    return strand;
}

//! Are all groups but one finished?
bool StrandWalk::one_is_open() const {
    constexpr std::size_t kNone = ~std::size_t{0};
    std::size_t open = kNone;
    for (const Walker& walker : walkers()) {
        if (walker.done) continue;
        const std::size_t group = root(walker.strand);
        if (open != kNone && open != group) return false;
        open = group;
    }
    return true;
}

void StrandWalk::start(Halfedge exit, std::size_t strand) {
    if (walker_count_ == walkers_.size()) walkers_.emplace_back();
    Walker& walker = walkers_[walker_count_++];
    walker.at = exit;
    walker.strand = strand;
    walker.done = false;
    walker.crossed.assign(1, exit);
}

StrandWalk::Walker* StrandWalk::that_starts_at(Halfedge h) {
    for (Walker& walker : walkers())
        if (walker.crossed.front().idx() >> 1 == h.idx() >> 1) return &walker;
    return nullptr;
}

void StrandWalk::step(Walker& walker) {
    if (mesh_.is_boundary(walker.at)) {
        walker.done = true;
        return;
    }
    // Out of the triangle by the other crossed edge.
    const auto is_above = [&](Halfedge h) {
        return rank_[static_cast<std::size_t>(mesh_.to_vertex_handle(h).idx())] > rank_at_;
    };
    Halfedge out = mesh_.next_halfedge_handle(walker.at);
    if (is_above(walker.at) == is_above(out)) out = mesh_.next_halfedge_handle(out);
    if (Walker* other = that_starts_at(out)) {  // back at the vertex, at the end of a strand
        walker.done = other->done = true;
        parent_[root(walker.strand)] = root(other->strand);
        return;
    }
    walker.at = mesh_.opposite_halfedge_handle(out);
    walker.crossed.push_back(walker.at);
}

std::size_t StrandWalk::group_strands(const VertexLink& link) {
    walker_count_ = 0;
    parent_.resize(link.strands.size());
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (std::size_t s = 0; s < link.strands.size(); ++s)
        for (const Halfedge exit : {link.strands[s].first_exit, link.strands[s].last_exit})
            if (exit.is_valid()) start(exit, s);
    rank_at_ = rank_[static_cast<std::size_t>(link.vertex)];
    while (!one_is_open())
        for (Walker& walker : walkers())
            if (!walker.done) step(walker);

    // Number groups in the order of their first strands.
    group_.assign(link.strands.size(), 0);
    std::uint32_t groups = 0;
    for (std::size_t s = 0; s < link.strands.size(); ++s) {
        std::size_t first = 0;  // strand of the group
        while (root(first) != root(s)) ++first;
        group_[s] = first == s ? groups++ : group_[first];
    }
    ends_.assign(groups, 0);
    for (std::size_t s = 0; s < link.strands.size(); ++s)
        for (const Halfedge exit : {link.strands[s].first_exit, link.strands[s].last_exit})
            ends_[group_[s]] += !exit.is_valid();
    for (const Walker& walker : walkers()) ends_[group_[walker.strand]] += mesh_.is_boundary(walker.at);
    unfinished_ = 0;  // if all are finished, any may keep its name
    for (const Walker& walker : walkers())
        if (!walker.done) unfinished_ = group_[walker.strand];
    return groups;
}

}  // namespace stratareeb
