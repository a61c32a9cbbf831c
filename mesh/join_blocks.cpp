// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/join_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "boreholes/errors.h"
#include "mesh/block_border.h"

namespace stratareeb {

namespace {

constexpr double kSamePlace = 1e-9;   // of the extent: vertices of two sides as close as that are one place
constexpr double kSameLevel = 1e-11;  // of the extent: elevations of two sides as close as that are equal
constexpr double kNearEnd = 1e-9;     // of an edge: crossings as close to its end as that may be rounding
constexpr int kMaxRounds = 50;        // of such crossings one after the other

TriMesh::VertexHandle handle(std::uint32_t v) {
    return TriMesh::VertexHandle(static_cast<int>(v));
}

using Place = std::pair<double, double>;

//! A vertex of one block.
struct BlockVertex {
    std::uint32_t block, vertex;
};

//! A border that two blocks share: vertices of both at the same places, in the direction in which the first has its inside
//! to the left.
struct Seam {
    std::uint32_t first = 0, second = 0;
    std::vector<std::array<std::uint32_t, 2>> vertices;
};

class BlockJoiner {
 public:
    BlockJoiner(std::vector<LayerModel> blocks, const std::vector<Footprint>& outline)
        : blocks_(std::move(blocks)) {
        double low = 0, high = 0;
        for (const auto& footprint : outline)
            for (const auto& ring : footprint)
                for (const Point2& p : ring)
                    low = std::min({low, p.x, p.y}), high = std::max({high, p.x, p.y});
        for (const LayerModel& block : blocks_)
            for (const double z : block.horizons.front()) high = std::max(high, std::abs(z));
        extent_ = high - low;
        find_seams(outline);
    }

    LayerModel run(const std::vector<std::vector<std::uint32_t>>& holes) {
        for (Seam& seam : seams_) match_vertices(seam);
        for (const Seam& seam : seams_)
            for (const auto& [a, b] : seam.vertices) {
                note_place({seam.first, a});
                note_place({seam.second, b});
            }
        for (const auto& [place, vertices] : places_) equal_levels(vertices);
        for (Seam& seam : seams_) insert_crossings(seam);
        return joined(holes);
    }

 private:
    Place place_of(const BlockVertex& v) const {
        const auto& p = blocks_[v.block].plan.surface.point(handle(v.vertex));
        return {p[0], p[1]};
    }

    void find_seams(const std::vector<Footprint>& outline) {
        std::map<std::pair<Place, Place>, std::pair<std::uint32_t, const std::vector<std::uint32_t>*>> sides;
        for (std::uint32_t b = 0; b < blocks_.size(); ++b)
            borders_.emplace_back(blocks_[b], outline[b], kSamePlace * extent_);
        for (std::uint32_t b = 0; b < blocks_.size(); ++b)
            for (std::size_t r = 0; r < outline[b].size(); ++r)
                for (std::size_t k = 0; k < outline[b][r].size(); ++k) {
                    const Point2 &p = outline[b][r][k], &q = outline[b][r][(k + 1) % outline[b][r].size()];
                    const Place from{p.x, p.y}, to{q.x, q.y};
                    const auto other = sides.find({to, from});
                    if (other == sides.end()) {
                        sides.emplace(std::pair(from, to), std::pair(b, &borders_[b].side(r, k)));
                        continue;
                    }
                    pending_.push_back({*other->second.second, borders_[b].side(r, k)});
                    seams_.push_back({other->second.first, b, {}});
                }
    }

    double share_along(const BlockVertex& v, const Place& from, const Place& to) const {
        const Place p = place_of(v);
        const double dx = to.first - from.first, dy = to.second - from.second;
        return ((p.first - from.first) * dx + (p.second - from.second) * dy) / (dx * dx + dy * dy);
    }

    //! Where one side has a vertex and the other none, the other gets one.
    void match_vertices(Seam& seam) {
        auto [ours, theirs] = pending_[static_cast<std::size_t>(&seam - seams_.data())];
        std::ranges::reverse(theirs);
        const Place from = place_of({seam.first, ours.front()}), to = place_of({seam.first, ours.back()});
        const double same = kSamePlace * extent_ / std::hypot(to.first - from.first, to.second - from.second);
        std::size_t i = 0, j = 0;
        seam.vertices.push_back({ours[0], theirs[0]});
        while (i + 1 < ours.size() || j + 1 < theirs.size()) {
            const bool end_i = i + 2 >= ours.size(), end_j = j + 2 >= theirs.size();
            const double a = end_i ? 1 : share_along({seam.first, ours[i + 1]}, from, to);
            const double b = end_j ? 1 : share_along({seam.second, theirs[j + 1]}, from, to);
            if ((end_i && end_j) || std::abs(a - b) <= same) {
                ++i, ++j;
                const auto p = place_of({seam.first, ours[i]});
                blocks_[seam.second].plan.surface.set_point(handle(theirs[j]), {p.first, p.second, 0});
            } else if (a < b) {
                ++i;
                const auto p = place_of({seam.first, ours[i]});
                const double here = share_along({seam.second, theirs[j]}, from, to);
                // Their inside lies to the left of the way back.
                const auto v = BlockBorder::split_edge(blocks_[seam.second], theirs[j + 1], theirs[j],
                                                       {p.first, p.second}, 1 - (a - here) / (b - here));
                theirs.insert(theirs.begin() + static_cast<std::ptrdiff_t>(++j), v);
            } else {
                ++j;
                const auto p = place_of({seam.second, theirs[j]});
                const double here = share_along({seam.first, ours[i]}, from, to);
                const auto v = BlockBorder::split_edge(blocks_[seam.first], ours[i], ours[i + 1],
                                                       {p.first, p.second}, (b - here) / (a - here));
                ours.insert(ours.begin() + static_cast<std::ptrdiff_t>(++i), v);
            }
            seam.vertices.push_back({ours[i], theirs[j]});
        }
    }

    void note_place(const BlockVertex& v) {
        auto& here = places_[place_of(v)];
        for (const BlockVertex& other : here)
            if (other.block == v.block && other.vertex == v.vertex) return;
        here.push_back(v);
    }

    double& level(const BlockVertex& v, std::size_t k) { return blocks_[v.block].horizons[k][v.vertex]; }
    std::size_t horizons() const { return blocks_[0].horizons.size(); }

    //! Elevations of several blocks at one place that differ by rounding alone become the same number; horizons of one block
    //! that are apart stay apart.
    void equal_levels(const std::vector<BlockVertex>& vertices) {
        std::vector<double> known;
        for (const BlockVertex& v : vertices) {
            std::optional<double> before, replaced;  // the last level of this block, and what became of it
            for (std::size_t k = 0; k < horizons(); ++k) {
                const double z = level(v, k);
                if (before && z == *before) {
                    level(v, k) = *replaced;
                    continue;
                }
                double best = z, off = kSameLevel * extent_;
                for (const double other : known)
                    if (std::abs(other - z) <= off && (!replaced || other < *replaced))
                        best = other, off = std::abs(other - z);
                before = z;
                if (!replaced || best < *replaced) level(v, k) = best;
                replaced = level(v, k);
            }
            for (std::size_t k = 0; k < horizons(); ++k) known.push_back(level(v, k));
        }
    }

    //! Where between two neighbouring places a horizon of one side crosses one of the other, nearest to the first.
    std::optional<double> first_crossing(const Seam& seam, std::size_t at) {
        const auto [a, b] = seam.vertices[at];
        const auto [c, d] = seam.vertices[at + 1];
        std::optional<double> first;
        for (std::size_t i = 0; i < horizons(); ++i)
            for (std::size_t j = 0; j < horizons(); ++j) {
                const double from = level({seam.first, a}, i) - level({seam.second, b}, j),
                             to = level({seam.first, c}, i) - level({seam.second, d}, j);
                if (!((from < 0 && to > 0) || (from > 0 && to < 0))) continue;
                const double share = from / (from - to);
                if (!first || share < *first) first = share;
            }
        return first;
    }

    void insert_crossings(Seam& seam) {
        int in_a_row = 0;
        for (std::size_t at = 0; at + 1 < seam.vertices.size();) {
            const auto share = first_crossing(seam, at);
            if (!share) {
                ++at;
                continue;
            }
            const auto [a, b] = seam.vertices[at];
            const auto [c, d] = seam.vertices[at + 1];
            const Place from = place_of({seam.first, a}), to = place_of({seam.first, c});
            const Point2 p{from.first + *share * (to.first - from.first),
                           from.second + *share * (to.second - from.second)};
            in_a_row = *share <= 2 * kNearEnd ? in_a_row + 1 : 0;
            if (in_a_row > kMaxRounds)
                throw GeometryError(fmt::format(
                    "horizons of two sides of a fault can't be told apart near x {:.10g}, y {:.10g}",
                    p.x + blocks_[0].origin.x, p.y + blocks_[0].origin.y));
            const auto v = BlockBorder::split_edge(blocks_[seam.first], a, c, p, *share);
            const auto w = BlockBorder::split_edge(blocks_[seam.second], d, b, p, 1 - *share);
            equal_levels({{seam.first, v}, {seam.second, w}});
            seam.vertices.insert(seam.vertices.begin() + static_cast<std::ptrdiff_t>(at + 1), {v, w});
            note_place({seam.first, v});
            note_place({seam.second, w});
            ++at;
        }
    }

    LayerModel joined(const std::vector<std::vector<std::uint32_t>>& holes) {
        LayerModel model;
        model.units = blocks_[0].units;
        model.origin = blocks_[0].origin;
        model.length_unit = blocks_[0].length_unit;
        model.spacing = blocks_[0].spacing;
        model.horizons.resize(horizons());
        model.columns.thickness.resize(model.units.size());
        std::vector<std::uint32_t> first;
        for (std::uint32_t b = 0; b < blocks_.size(); ++b) {
            first.push_back(static_cast<std::uint32_t>(model.plan.surface.n_vertices()));
            append(model, b, first[b], holes[b]);
        }
        model.seams.blocks = blocks_.size();
        model.seams.levels.resize(model.plan.surface.n_vertices());
        for (const auto& [place, vertices] : places_) {
            std::vector<double> levels;
            for (const BlockVertex& v : vertices)
                for (std::size_t k = 0; k < horizons(); ++k) levels.push_back(level(v, k));
            std::ranges::sort(levels);
            levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
            for (const BlockVertex& v : vertices) model.seams.levels[first[v.block] + v.vertex] = levels;
        }
        for (const Seam& seam : seams_)
            for (std::size_t i = 0; i + 1 < seam.vertices.size(); ++i) {
                const std::uint32_t a = first[seam.first] + seam.vertices[i][0],
                                    b = first[seam.second] + seam.vertices[i][1],
                                    c = first[seam.first] + seam.vertices[i + 1][0],
                                    d = first[seam.second] + seam.vertices[i + 1][1];
                model.seams.across[{a, c}] = {b, d};
                model.seams.across[{d, b}] = {c, a};
            }
        return model;
    }

    void append(LayerModel& model, std::uint32_t b, std::uint32_t first,
                const std::vector<std::uint32_t>& holes) {
        const LayerModel& block = blocks_[b];
        TriMesh& mesh = model.plan.surface;
        const auto shifted = [&](TriMesh::VertexHandle v) {
            return handle(first + static_cast<std::uint32_t>(v.idx()));
        };
        for (const auto v : block.plan.surface.vertices()) mesh.add_vertex(block.plan.surface.point(v));
        for (const auto f : block.plan.surface.faces()) {
            auto corner = block.plan.surface.cfv_ccwbegin(f);
            const auto u = shifted(*corner), v = shifted(*++corner), w = shifted(*++corner);
            mesh.add_face(u, v, w);
            model.seams.block.push_back(b);
        }
        for (std::size_t k = 0; k < horizons(); ++k)
            model.horizons[k].insert(model.horizons[k].end(), block.horizons[k].begin(),
                                     block.horizons[k].end());
        auto& regions = model.regions;
        regions.in_face.insert(regions.in_face.end(), block.regions.in_face.begin(),
                               block.regions.in_face.end());
        regions.zero_at.insert(regions.zero_at.end(), block.regions.zero_at.begin(),
                               block.regions.zero_at.end());
        regions.opened += block.regions.opened;
        for (const std::string& note : block.notes)
            model.notes.push_back(fmt::format("block {}: {}", b + 1, note));
        place_holes(model, block, first, holes);
    }

    static void place_holes(LayerModel& model, const LayerModel& block, std::uint32_t first,
                            const std::vector<std::uint32_t>& holes) {
        std::size_t count = model.plan.hole_vertex.size();
        for (const std::uint32_t h : holes) count = std::max<std::size_t>(count, h + 1);
        model.plan.hole_vertex.resize(count, PlanMesh::kNoVertex);
        model.columns.sites.resize(count);
        model.columns.ground.resize(count);
        for (auto& layer : model.columns.thickness) layer.resize(count);
        for (std::size_t i = 0; i < holes.size(); ++i) {
            const auto v = block.plan.hole_vertex[i];
            if (v != PlanMesh::kNoVertex) model.plan.hole_vertex[holes[i]] = first + v;
            model.columns.sites[holes[i]] = block.columns.sites[i];
            model.columns.ground[holes[i]] = block.columns.ground[i];
            for (std::size_t k = 0; k < model.columns.thickness.size(); ++k)
                model.columns.thickness[k][holes[i]] = block.columns.thickness[k][i];
        }
    }

    std::vector<LayerModel> blocks_;
    double extent_ = 0;
    std::vector<BlockBorder> borders_;
    std::vector<Seam> seams_;
    std::vector<std::array<std::vector<std::uint32_t>, 2>>
        pending_;  // by seam: vertices of both sides before they match
    std::map<Place, std::vector<BlockVertex>> places_;
};

}  // namespace

LayerModel join_blocks(std::vector<LayerModel> blocks, const std::vector<Footprint>& outline,
                       const std::vector<std::vector<std::uint32_t>>& holes) {
    return BlockJoiner(std::move(blocks), outline).run(holes);
}

}  // namespace stratareeb
