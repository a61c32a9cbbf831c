// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/join_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "boreholes/errors.h"
#include "mesh/block_border.h"
#include "mesh/fault_seams.h"
#include "mesh/match_seams.h"
#include "mesh/soup_topology.h"

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
    bool is_fault = true;
    std::vector<std::array<std::uint32_t, 2>> vertices;
};

//! Vertices of blocks that are one, by the least of them.
class OneVertex {
 public:
    using Key = std::pair<std::uint32_t, std::uint32_t>;

    Key root(Key v) const {
        for (auto it = parent_.find(v); it != parent_.end(); it = parent_.find(v)) v = it->second;
        return v;
    }
    void join(const Key& a, const Key& b) {
        const auto [low, high] = std::minmax({root(a), root(b)});
        if (low != high) parent_.emplace(high, low);
    }
    const std::map<Key, Key>& joined() const { return parent_; }

 private:
    std::map<Key, Key> parent_;
};

class BlockJoiner {
 public:
    BlockJoiner(std::vector<LayerModel> blocks, const std::vector<Footprint>& outline, const BlocksInOne& one)
        : blocks_(std::move(blocks)), one_(one), apart_(blocks_.size(), 0) {
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
        level_ways_on();
        for (const auto& [place, vertices] : places_) make_levels_equal(vertices);
        for (Seam& seam : seams_) insert_crossings(seam);
        join_ways_on();
        LayerModel model = joined(holes);
        if (joined_.joined().empty() || !part_again(model)) return model;
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
                    const bool is_fault = std::ranges::none_of(
                        one_.ways_on, [&](const WayOn& way) { return way.holds(p, q, one_.tolerance); });
                    seams_.push_back({other->second.first, b, is_fault, {}});
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
            if (i + 1 == ours.size() || j + 1 == theirs.size())
                throw GeometryError(
                    fmt::format("a pinch-out line meets a fault too close to a corner near x {:.10g}, y "
                                "{:.10g} (give another --spacing)",
                                to.first + blocks_[0].origin.x, to.second + blocks_[0].origin.y));
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

    bool has_same_layers(const BlockVertex& a, const BlockVertex& b) const {
        return blocks_[a.block].regions.zero_at[a.vertex] == blocks_[b.block].regions.zero_at[b.vertex];
    }

    //! Where no fault is, the two sides are at the mean of their elevations.
    void level_ways_on() {
        OneVertex one;
        for (const Seam& seam : seams_)
            for (const auto& [a, b] : seam.vertices)
                if (!seam.is_fault && has_same_layers({seam.first, a}, {seam.second, b}))
                    one.join({seam.first, a}, {seam.second, b});
        std::map<OneVertex::Key, std::vector<BlockVertex>> groups;
        for (const auto& [v, parent] : one.joined()) {
            auto& group = groups[one.root(v)];
            if (group.empty()) group.push_back({one.root(v).first, one.root(v).second});
            group.push_back({v.first, v.second});
        }
        for (const auto& [root, group] : groups)
            for (std::size_t k = 0; k < horizons(); ++k) {
                double sum = 0;
                for (const BlockVertex& v : group) sum += level(v, k);
                for (const BlockVertex& v : group) level(v, k) = sum / static_cast<double>(group.size());
            }
    }

    bool is_same(const BlockVertex& a, const BlockVertex& b) {
        bool same = has_same_layers(a, b);
        for (std::size_t k = 0; k < horizons() && same; ++k) same = level(a, k) == level(b, k);
        return same;
    }

    //! The two sides of a way on become one, but for pieces that would meet themselves across a corner, where faults cross: a
    //! solid could touch itself in a vertical edge there.
    void join_ways_on() {
        join_seams();
        const std::vector<std::uint32_t> piece = pieces();
        std::set<std::pair<OneVertex::Key, OneVertex::Key>> neighbours;
        for (const Seam& seam : seams_)
            for (const auto& [a, b] : seam.vertices)
                neighbours.insert(
                    std::minmax({joined_.root({seam.first, a}), joined_.root({seam.second, b})}));
        std::vector<char> apart(blocks_.size(), 0);
        for (const auto& [place, vertices] : places_)
            for (const BlockVertex& v : vertices)
                for (const BlockVertex& w : vertices) {
                    if (v.block >= w.block || piece[v.block] != piece[w.block]) continue;
                    const auto a = joined_.root({v.block, v.vertex}), b = joined_.root({w.block, w.vertex});
                    if (a != b && !neighbours.contains(std::minmax({a, b}))) apart[piece[v.block]] = 1;
                }
        for (const std::uint32_t b : blocks_touching_in_vertices()) apart[piece[b]] = 1;
        part(apart, piece);
    }

    //! Blocks at vertices of the joined plan around which the triangles form several fans.
    std::vector<std::uint32_t> blocks_touching_in_vertices() const {
        TriangleSoup soup;
        std::vector<std::uint32_t> block;  // by triangle
        std::map<OneVertex::Key, std::uint32_t> number;
        for (std::uint32_t b = 0; b < blocks_.size(); ++b)
            for (const auto f : blocks_[b].plan.surface.faces()) {
                auto& triangle = soup.triangles.emplace_back();
                std::size_t k = 0;
                for (const auto v : blocks_[b].plan.surface.fv_range(f)) {
                    const auto key = joined_.root({b, static_cast<std::uint32_t>(v.idx())});
                    triangle[k++] =
                        number.try_emplace(key, static_cast<std::uint32_t>(number.size())).first->second;
                }
                block.push_back(b);
            }
        soup.points.resize(number.size());
        std::vector<std::uint32_t> touching;
        for (const std::uint32_t corner : corners_in_further_fans(soup, soup_topology(soup)))
            touching.push_back(block[corner / 3]);
        return touching;
    }

    //! Pieces with a solid that touches itself are left apart along ways on.
    bool part_again(const LayerModel& model) {
        const std::vector<std::uint32_t> piece = pieces();
        std::vector<std::uint32_t> blocks_of(blocks_.size(), 0);
        for (const std::uint32_t p : piece) ++blocks_of[p];
        std::vector<char> apart(blocks_.size(), 0);
        bool any = false;
        std::size_t face = 0;
        for (std::uint32_t b = 0; b < blocks_.size(); face += blocks_[b++].plan.surface.n_faces()) {
            if (piece[b] != b || blocks_of[b] < 2) continue;
            for (std::size_t i = 0; i < model.units.size() && !apart[b]; ++i)
                apart[b] = touches_itself(model, i, model.seams.block[face]);
            any = any || apart[b];
        }
        if (any) part(apart, piece);
        return any;
    }

    void part(const std::vector<char>& apart, const std::vector<std::uint32_t>& piece) {
        for (std::size_t b = 0; b < piece.size(); ++b)
            if (apart[piece[b]]) apart_[b] = 1;
        joined_ = {};
        number_.clear();
        join_seams();
    }

    //! But for those of blocks that stay apart.
    void join_seams() {
        for (const Seam& seam : seams_)
            for (std::size_t i = 0; i + 1 < seam.vertices.size() && !seam.is_fault; ++i) {
                const auto [a, b] = seam.vertices[i];
                const auto [c, d] = seam.vertices[i + 1];
                if (apart_[seam.first] || !is_same({seam.first, a}, {seam.second, b}) ||
                    !is_same({seam.first, c}, {seam.second, d}))
                    continue;
                joined_.join({seam.first, a}, {seam.second, b});
                joined_.join({seam.first, c}, {seam.second, d});
            }
    }

    //! By block: the least block of its piece.
    std::vector<std::uint32_t> pieces() const {
        std::vector<std::uint32_t> piece(blocks_.size());
        std::iota(piece.begin(), piece.end(), 0u);
        const auto least = [&](std::uint32_t b) {
            while (piece[b] != b) b = piece[b];
            return b;
        };
        for (const auto& [v, parent] : joined_.joined()) {
            const auto [low, high] = std::minmax({least(v.first), least(parent.first)});
            piece[high] = low;
        }
        for (std::uint32_t b = 0; b < piece.size(); ++b) piece[b] = least(b);
        return piece;
    }

    void make_levels_equal(const std::vector<BlockVertex>& vertices) {
        std::vector<LevelColumn> columns;
        for (const BlockVertex& v : vertices) {
            auto& column = columns.emplace_back();
            for (std::size_t k = 0; k < horizons(); ++k) column.push_back(&level(v, k));
        }
        equal_levels(columns, kSameLevel * extent_);
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
            make_levels_equal({{seam.first, v}, {seam.second, w}});
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
        for (std::uint32_t b = 0; b < blocks_.size(); ++b) append(model, b, holes[b]);
        model.seams = seams_of_pieces(model.plan.surface, model.horizons);
        return model;
    }

    void append(LayerModel& model, std::uint32_t b, const std::vector<std::uint32_t>& holes) {
        const LayerModel& block = blocks_[b];
        TriMesh& mesh = model.plan.surface;
        auto& number = number_.emplace_back();
        for (const auto v : block.plan.surface.vertices()) {
            const auto i = static_cast<std::uint32_t>(v.idx());
            const auto [of_block, of_vertex] = joined_.root({b, i});
            if (of_block != b || of_vertex != i) {
                number.push_back(number_[of_block][of_vertex]);
                continue;
            }
            number.push_back(static_cast<std::uint32_t>(mesh.n_vertices()));
            mesh.add_vertex(block.plan.surface.point(v));
            for (std::size_t k = 0; k < horizons(); ++k) model.horizons[k].push_back(block.horizons[k][i]);
            model.regions.zero_at.push_back(block.regions.zero_at[i]);
        }
        for (const auto f : block.plan.surface.faces()) {
            auto corner = block.plan.surface.cfv_ccwbegin(f);
            const auto next = [&] { return handle(number[static_cast<std::size_t>((corner++)->idx())]); };
            const auto u = next(), v = next(), w = next();
            if (!mesh.add_face(u, v, w).is_valid())
                throw GeometryError(fmt::format("blocks can't be joined near x {:.10g}, y {:.10g}",
                                                mesh.point(u)[0] + model.origin.x,
                                                mesh.point(u)[1] + model.origin.y));
            model.regions.in_face.push_back(block.regions.in_face[static_cast<std::size_t>(f.idx())]);
        }
        model.regions.opened += block.regions.opened;
        for (const std::string& note : block.notes)
            model.notes.push_back(fmt::format("block {}: {}", b + 1, note));
        place_holes(model, block, number, holes);
    }

    static void place_holes(LayerModel& model, const LayerModel& block,
                            const std::vector<std::uint32_t>& number,
                            const std::vector<std::uint32_t>& holes) {
        std::size_t count = model.plan.hole_vertex.size();
        for (const std::uint32_t h : holes) count = std::max<std::size_t>(count, h + 1);
        model.plan.hole_vertex.resize(count, PlanMesh::kNoVertex);
        model.columns.sites.resize(count);
        model.columns.ground.resize(count);
        for (auto& layer : model.columns.thickness) layer.resize(count);
        for (std::size_t i = 0; i < holes.size(); ++i) {
            const auto v = block.plan.hole_vertex[i];
            if (v != PlanMesh::kNoVertex) model.plan.hole_vertex[holes[i]] = number[v];
            model.columns.sites[holes[i]] = block.columns.sites[i];
            model.columns.ground[holes[i]] = block.columns.ground[i];
            for (std::size_t k = 0; k < model.columns.thickness.size(); ++k)
                model.columns.thickness[k][holes[i]] = block.columns.thickness[k][i];
        }
    }

    std::vector<LayerModel> blocks_;
    const BlocksInOne& one_;
    double extent_ = 0;
    std::vector<BlockBorder> borders_;
    std::vector<Seam> seams_;
    std::vector<std::array<std::vector<std::uint32_t>, 2>>
        pending_;  // by seam: vertices of both sides before they match
    std::map<Place, std::vector<BlockVertex>> places_;
    OneVertex joined_;
    std::vector<char> apart_;                         // by block: not to be joined with others
    std::vector<std::vector<std::uint32_t>> number_;  // by block and vertex: the one of the whole model
};

}  // namespace

LayerModel join_blocks(std::vector<LayerModel> blocks, const std::vector<Footprint>& outline,
                       const std::vector<std::vector<std::uint32_t>>& holes, const BlocksInOne& one) {
    return BlockJoiner(std::move(blocks), outline, one).run(holes);
}

}  // namespace stratareeb
