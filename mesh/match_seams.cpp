// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/match_seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "mesh/block_border.h"

namespace stratareeb {

namespace {

constexpr double kSameShare = 1e-9;   // of an edge: cuts of two sides as close as that are one
constexpr double kSameLevel = 1e-11;  // of the extent: elevations as close as that are equal

TriMesh::VertexHandle handle(std::uint32_t v) {
    return TriMesh::VertexHandle(static_cast<int>(v));
}

class SeamMatching {
 public:
    explicit SeamMatching(LayerModel& model) : model_(model) {
        TriMesh::Point low(0), high(0);
        for (const auto v : mesh().vertices()) low.minimize(mesh().point(v)), high.maximize(mesh().point(v));
        for (const double z : model.horizons.front()) high[2] = std::max(high[2], std::abs(z));
        tolerance_ = kSameLevel * (high - low).max();
    }

    void run() {
        const auto across = model_.seams.across;
        for (const auto& [edge, other] : across)
            if (edge.first < other[1]) match(edge.first, edge.second, other[0], other[1]);
        model_.seams = seams_of_pieces(mesh(), model_.horizons);
    }

 private:
    TriMesh& mesh() { return model_.plan.surface; }

    //! Boundary vertices from one to another, the inside to the left.
    std::vector<std::uint32_t> border(std::uint32_t from, std::uint32_t to) {
        std::vector<std::uint32_t> chain{from};
        while (chain.back() != to)
            for (const auto h : mesh().voh_range(handle(chain.back())))
                if (!mesh().is_boundary(h) && mesh().is_boundary(mesh().opposite_halfedge_handle(h))) {
                    chain.push_back(static_cast<std::uint32_t>(mesh().to_vertex_handle(h).idx()));
                    break;
                }
        return chain;
    }

    double share(std::uint32_t v, std::uint32_t from, std::uint32_t to) {
        const auto &p = mesh().point(handle(from)), &q = mesh().point(handle(to));
        return (mesh().point(handle(v)) - p).norm() / (q - p).norm();
    }

    //! Along an edge from a to c; its other side runs from d to b, b being at a's place.
    void match(std::uint32_t a, std::uint32_t c, std::uint32_t b, std::uint32_t d) {
        std::vector<std::uint32_t> ours = border(a, c), theirs = border(d, b);
        std::ranges::reverse(theirs);
        for (std::size_t i = 1; i + 1 < ours.size() || i + 1 < theirs.size(); ++i) {
            const double here = i + 1 < ours.size() ? share(ours[i], a, c) : 1,
                         there = i + 1 < theirs.size() ? share(theirs[i], b, d) : 1;
            if (here < there - kSameShare)
                theirs.insert(theirs.begin() + static_cast<std::ptrdiff_t>(i),
                              split(theirs[i], theirs[i - 1], ours[i]));
            else if (there < here - kSameShare)
                ours.insert(ours.begin() + static_cast<std::ptrdiff_t>(i),
                            split(ours[i - 1], ours[i], theirs[i]));
            else
                mesh().set_point(handle(theirs[i]), mesh().point(handle(ours[i])));
            equal_levels({column(ours[i]), column(theirs[i])}, tolerance_);
        }
    }

    //! A vertex on the boundary edge from u to w at the place of one across.
    std::uint32_t split(std::uint32_t u, std::uint32_t w, std::uint32_t across) {
        const auto p = mesh().point(handle(across));
        return BlockBorder::split_edge(model_, u, w, {p[0], p[1]}, share(across, u, w));
    }

    LevelColumn column(std::uint32_t v) {
        LevelColumn column;
        for (auto& horizon : model_.horizons) column.push_back(&horizon[v]);
        return column;
    }

    LayerModel& model_;
    double tolerance_ = 0;
};

}  // namespace

void equal_levels(const std::vector<LevelColumn>& columns, double tolerance) {
    std::vector<double> known;
    for (const LevelColumn& column : columns) {
        std::optional<double> before, replaced;  // the last level of this block, and what became of it
        for (double* const level : column) {
            const double z = *level;
            if (before && z == *before) {
                *level = *replaced;
                continue;
            }
            double best = z, off = tolerance;
            for (const double other : known)
                if (std::abs(other - z) <= off && (!replaced || other < *replaced))
                    best = other, off = std::abs(other - z);
            before = z;
            if (!replaced || best < *replaced) *level = best;
            replaced = *level;
        }
        for (const double* const level : column) known.push_back(*level);
    }
}

void match_seams(LayerModel& model) {
    SeamMatching(model).run();
}

}  // namespace stratareeb
