// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/vertex_descent.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "reeb/vertex_link.h"

namespace stratareeb {

namespace {

using Halfedge = TriMesh::HalfedgeHandle;

constexpr std::size_t kBlock = std::size_t{1} << 14;  // vertices that one thread looks at together

class Scan {
 public:
    Scan(const TriMesh& mesh, const VertexOrder& order) : mesh_(mesh), rank_(order.rank) {
        descent_.below.resize(rank_.size());
    }

    VertexDescent run() {
        const std::size_t n = rank_.size();
        blocks_.resize((n + kBlock - 1) / kBlock);
        tbb::parallel_for(std::size_t{0}, blocks_.size(),
                          [&](std::size_t b) { scan_block(b, std::min(n, (b + 1) * kBlock)); });
        for (const Block& block : blocks_) join(block);
        return std::move(descent_);
    }

 private:
    //! What a block of vertices has found that is critical; fans are counted from the block's own first.
    struct Block {
        std::vector<CriticalLink> critical;
        std::vector<std::uint32_t> fan_below;
        bool has_boundary = false;
    };

    std::uint32_t rank_at_end(Halfedge h) const {
        return rank_[static_cast<std::size_t>(mesh_.to_vertex_handle(h).idx())];
    }

    void scan_block(std::size_t b, std::size_t end) {
        Block& block = blocks_[b];
        VertexLink link;
        for (std::size_t v = b * kBlock; v < end; ++v)
            if (!scan_regular(v, block)) add_critical(static_cast<std::uint32_t>(v), link, block);
    }

    //! Contours pass a vertex whose link changes between below and above twice, or once on the boundary.
    bool scan_regular(std::size_t v, Block& block) {
        const Halfedge first = mesh_.halfedge_handle(TriMesh::VertexHandle(static_cast<int>(v)));
        if (!first.is_valid()) return false;
        const std::uint32_t rank = rank_[v];
        const bool is_path = mesh_.is_boundary(first);
        block.has_boundary |= is_path;
        std::uint32_t highest_below = 0;
        int changes = 0;
        const bool first_above = rank_at_end(first) > rank;
        bool before = first_above;
        for (Halfedge h = first;;) {
            const std::uint32_t r = rank_at_end(h);
            const bool above = r > rank;
            changes += above != before;
            before = above;
            if (!above) highest_below = std::max(highest_below, r);
            h = mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(h));
            if (h == first) break;
        }
        if (!is_path) changes += before != first_above;
        if (changes != (is_path ? 1 : 2)) return false;
        descent_.below[rank] = highest_below;
        return true;
    }

    void add_critical(std::uint32_t v, VertexLink& link, Block& block) const {
        read_link(mesh_, rank_, v, link);
        CriticalLink critical{.vertex = v,
                              .first_fan = static_cast<std::uint32_t>(block.fan_below.size()),
                              .fans = static_cast<std::uint32_t>(link.lower_fans.size()),
                              .strands = static_cast<std::uint32_t>(link.strands.size())};
        if (link.is_path) {
            critical.ends_above = static_cast<std::uint8_t>((rank_at_end(link.spokes.front()) > rank_[v]) +
                                                            (rank_at_end(link.spokes.back()) > rank_[v]));
            critical.ends_below = static_cast<std::uint8_t>(2 - critical.ends_above);
        }
        block.critical.push_back(critical);
        for (const LowerFan& fan : link.lower_fans) {
            std::uint32_t highest = 0;
            for (const Halfedge h : link.edges_of(fan)) highest = std::max(highest, rank_at_end(h));
            block.fan_below.push_back(highest);
        }
    }

    void join(const Block& block) {
        const auto first_fan = static_cast<std::uint32_t>(descent_.fan_below.size());
        descent_.fan_below.insert(descent_.fan_below.end(), block.fan_below.begin(), block.fan_below.end());
        descent_.has_boundary |= block.has_boundary;
        for (CriticalLink link : block.critical) {
            link.first_fan += first_fan;
            descent_.below[rank_[link.vertex]] =
                VertexDescent::kCritical | static_cast<std::uint32_t>(descent_.critical.size());
            descent_.critical.push_back(link);
        }
    }

    const TriMesh& mesh_;
    const std::vector<std::uint32_t>& rank_;
    VertexDescent descent_;
    std::vector<Block> blocks_;
};

}  // namespace

VertexDescent vertex_descent(const TriMesh& mesh, const VertexOrder& order) {
    return Scan(mesh, order).run();
}

}  // namespace stratareeb
