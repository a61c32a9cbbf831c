// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/plan_cells.h"

#include <algorithm>
#include <map>
#include <ranges>

#include "subdivision/plan_levels.h"

namespace stratareeb {
namespace {

constexpr std::uint32_t kNone = PlanCells::kNone;

class Builder {
 public:
    Builder(const LayerModel& model, const PlanCellsOptions& options)
        : model_(model), plan_(model.plan.surface), options_(options), levels_(model) {
        cells_.sides = rim_sides(plan_, options.rim);
    }

    PlanCells build() {
        add_bodies();
        add_cells();
        mark_nodes();
        add_lines();
        walked_for_.assign(plan_.n_halfedges(), kNone);
        for (std::uint32_t c = 0; c < cells_.cells.size(); ++c) add_loops(c);
        add_walls();
        return std::move(cells_);
    }

 private:
    using Half = TriMesh::HalfedgeHandle;

    static std::size_t index(OpenMesh::BaseHandle h) { return static_cast<std::size_t>(h.idx()); }
    std::uint32_t from(Half h) const { return static_cast<std::uint32_t>(plan_.from_vertex_handle(h).idx()); }
    std::uint32_t to(Half h) const { return static_cast<std::uint32_t>(plan_.to_vertex_handle(h).idx()); }
    Half opposite(Half h) const { return plan_.opposite_halfedge_handle(h); }

    void add_bodies() {
        body_of_.resize(levels_.layers());
        for (std::uint32_t layer = 0; layer < levels_.layers(); ++layer) {
            body_of_[layer] = levels_.layer_parts(layer);
            const auto first = static_cast<std::uint32_t>(cells_.bodies.size());
            for (std::uint32_t f = 0; f < plan_.n_faces(); ++f) {
                auto& body = body_of_[layer][f];
                if (body == kNone) continue;
                body += first;
                if (body == cells_.bodies.size()) cells_.bodies.push_back({.layer = layer});
                cells_.bodies[body].faces.push_back(f);
            }
        }
    }

    void add_cells() {
        cell_of_ = levels_.interface_parts();
        for (std::uint32_t f = 0; f < plan_.n_faces(); ++f)
            for (const auto& i : levels_.interfaces(f)) {
                const std::uint32_t c = cell_of_[i.id];
                if (c == cells_.cells.size()) add_cell(f, i, c);
                cells_.cells[c].faces.push_back(f);
            }
    }

    void add_cell(std::uint32_t f, const PlanLevels::Interface& i, std::uint32_t c) {
        auto& cell = cells_.cells.emplace_back();
        cell.horizon = i.horizon;
        if (i.above != kNone) cells_.bodies[cell.body_above = body_of_[i.above][f]].base.push_back(c);
        if (i.below != kNone) cells_.bodies[cell.body_below = body_of_[i.below][f]].top.push_back(c);
    }

    // What meets along a half-edge, level by level: cells on its left and on its right.
    struct Meeting {
        std::uint32_t horizon;
        std::vector<std::uint32_t> left, right;
        bool same_cells(const Meeting& m) const { return left == m.left && right == m.right; }
    };

    std::vector<Meeting> meetings(Half h) const {
        if (levels_.all_go_on_across(plan_.edge_handle(h))) return {};
        std::map<std::uint32_t, Meeting> found;
        for (const bool on_left : {true, false}) {
            const Half side = on_left ? h : opposite(h);
            if (plan_.is_boundary(side)) continue;
            for (const auto& i : levels_.interfaces(plan_.face_handle(side).idx())) {
                const std::uint32_t horizon = levels_.on_edge(plan_.edge_handle(h), i.horizon);
                auto& meeting = found.try_emplace(horizon, Meeting{horizon, {}, {}}).first->second;
                (on_left ? meeting.left : meeting.right).push_back(cell_of_[i.id]);
            }
        }
        std::vector<Meeting> result;
        for (auto& [horizon, m] : found)
            if (m.left.size() != 1 || m.right.size() != 1 || m.left != m.right)
                result.push_back(std::move(m));
        return result;
    }

    static bool same(const std::vector<Meeting>& a, const std::vector<Meeting>& b) {
        return std::ranges::equal(a, b, [](const auto& m, const auto& n) { return m.same_cells(n); });
    }

    void mark_nodes() {
        on_line_.assign(plan_.n_edges(), 0);
        for (const auto e : plan_.edges())
            on_line_[index(e)] = !meetings(plan_.halfedge_handle(e, 0)).empty();
        is_node_.assign(plan_.n_vertices(), 0);
        for (const RimSide& side : cells_.sides)
            is_node_[side.vertices.front()] = is_node_[side.vertices.back()] = 1;
        for (const auto v : plan_.vertices())
            if (!is_node_[index(v)]) is_node_[index(v)] = is_end_of_lines(v);
    }

    bool is_end_of_lines(TriMesh::VertexHandle v) const {
        std::vector<Half> out;
        for (const auto h : plan_.voh_range(v))
            if (on_line_[index(plan_.edge_handle(h))]) out.push_back(h);
        if (out.empty()) return false;
        if (out.size() != 2 || !same(meetings(opposite(out[0])), meetings(out[1]))) return true;
        if (plan_.is_boundary(plan_.edge_handle(out[0])))
            return levels_.pinches_at(v, plan_.edge_handle(out[0]));
        return turning_deg(plan_, to(out[0]), static_cast<std::uint32_t>(v.idx()), to(out[1])) >
               options_.corner_deg;
    }

    void add_lines() {
        line_at_.assign(plan_.n_halfedges(), {kNone, 0});
        for (std::uint32_t s = 0; s < cells_.sides.size(); ++s) add_lines_of_side(s);
        for (const auto v : plan_.vertices())
            if (is_node_[index(v)]) add_lines_from(v);
        for (const auto e : plan_.edges()) {  // closed lines that meet no other are cut in two
            if (!on_line_[index(e)] || has_line(e)) continue;
            const Half start = plan_.halfedge_handle(e, 0);
            std::vector<Half> ring;
            Half h = start;
            do ring.push_back(h), h = next_on_line(h);
            while (h != start);
            is_node_[from(start)] = is_node_[from(ring[ring.size() / 2])] = 1;
            add_lines_from(plan_.from_vertex_handle(start));
            add_lines_from(plan_.from_vertex_handle(ring[ring.size() / 2]));
        }
        edges_at_.resize(cells_.lines.size());
        for (std::uint32_t l = 0; l < cells_.lines.size(); ++l) add_edges(l);
    }

    bool has_line(TriMesh::EdgeHandle e) const {
        return line_at_[index(plan_.halfedge_handle(e, 0))].line != kNone;
    }

    void add_lines_of_side(std::uint32_t s) {
        const auto& vertices = cells_.sides[s].vertices;
        std::vector<Half> run;
        for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
            const Half h =
                plan_.find_halfedge(plan_.vertex_handle(vertices[i]), plan_.vertex_handle(vertices[i + 1]));
            if (on_line_[index(plan_.edge_handle(h))]) run.push_back(h);
            if (is_node_[vertices[i + 1]] && !run.empty()) add_line(run, s), run.clear();
        }
    }

    void add_lines_from(TriMesh::VertexHandle v) {
        for (const auto out : plan_.voh_range(v)) {
            if (!on_line_[index(plan_.edge_handle(out))] || has_line(plan_.edge_handle(out))) continue;
            std::vector<Half> run{out};
            while (!is_node_[to(run.back())]) run.push_back(next_on_line(run.back()));
            if (to(run.back()) != from(run.front())) {
                add_line(run, kNone);
                continue;
            }
            const auto middle = run.begin() + static_cast<std::ptrdiff_t>(run.size() / 2);
            is_node_[from(*middle)] = 1;
            add_line({run.begin(), middle}, kNone);
            add_line({middle, run.end()}, kNone);
        }
    }

    Half next_on_line(Half h) const {
        for (const auto out : plan_.voh_range(plan_.to_vertex_handle(h)))
            if (out != opposite(h) && on_line_[index(plan_.edge_handle(out))]) return out;
        return Half();
    }

    void add_line(const std::vector<Half>& run, std::uint32_t side) {
        const auto id = static_cast<std::uint32_t>(cells_.lines.size());
        auto& line = cells_.lines.emplace_back();
        line.side = side;
        line.vertices.push_back(from(run.front()));
        for (std::size_t i = 0; i < run.size(); ++i) {
            line.vertices.push_back(to(run[i]));
            line_at_[index(run[i])] = {id, i == 0};
            line_at_[index(opposite(run[i]))] = {id, i + 1 == run.size()};
        }
        first_half_.push_back(run.front());
    }

    void add_edges(std::uint32_t l) {
        for (const Meeting& m : meetings(first_half_[l])) {
            edges_at_[l][m.horizon] = static_cast<std::uint32_t>(cells_.edges.size());
            auto& edge = cells_.edges.emplace_back();
            edge.line = l;
            edge.horizon = m.horizon;
            edge.from = corner(cells_.lines[l].vertices.front(), m.horizon);
            edge.to = corner(cells_.lines[l].vertices.back(), m.horizon);
            edge.cells = m.left;
            edge.cells.insert(edge.cells.end(), m.right.begin(), m.right.end());
            std::ranges::sort(edge.cells);
        }
    }

    std::uint32_t corner(std::uint32_t vertex, std::uint32_t horizon) {
        const std::uint32_t highest = levels_.at_vertex(vertex, horizon);
        const auto [it, fresh] =
            corner_ids_.try_emplace({vertex, highest}, static_cast<std::uint32_t>(cells_.corners.size()));
        if (fresh) cells_.corners.push_back({vertex, highest});
        return it->second;
    }

    // The edge under a half-edge of a cell's triangle; kNone where the cell goes on beyond.
    std::uint32_t edge_under(Half h, std::uint32_t horizon) const {
        const std::uint32_t line = line_at_[index(h)].line;
        if (line == kNone) return kNone;
        const auto it = edges_at_[line].find(levels_.on_edge(plan_.edge_handle(h), horizon));
        return it == edges_at_[line].end() ? kNone : it->second;
    }

    void add_loops(std::uint32_t c) {
        auto& cell = cells_.cells[c];
        for (const std::uint32_t f : cell.faces)
            for (const auto start : plan_.fh_range(plan_.face_handle(f))) {
                if (edge_under(start, horizon_in(f, c)) == kNone) continue;
                if (walked_for_[index(start)] != c) cell.loops.push_back(loop_from(start, c));
            }
    }

    PlanCells::Loop loop_from(Half start, std::uint32_t c) {
        PlanCells::Loop loop;
        Half h = start;
        do {
            walked_for_[index(h)] = c;
            const std::uint32_t edge = edge_under(h, horizon_in(index(plan_.face_handle(h)), c));
            if (line_at_[index(h)].is_first)
                loop.push_back({edge, from(h) == cells_.lines[cells_.edges[edge].line].vertices.front() &&
                                          to(h) == cells_.lines[cells_.edges[edge].line].vertices[1]});
            h = plan_.next_halfedge_handle(h);
            while (edge_under(h, horizon_in(index(plan_.face_handle(h)), c)) == kNone)
                h = plan_.next_halfedge_handle(opposite(h));
        } while (h != start);
        return loop;
    }

    std::uint32_t horizon_in(std::size_t f, std::uint32_t c) const {
        for (const auto& i : levels_.interfaces(f))
            if (cell_of_[i.id] == c) return i.horizon;
        return kNone;
    }

    void add_walls() {
        std::vector<std::vector<std::uint32_t>> lines_of(cells_.sides.size());
        for (std::uint32_t l = 0; l < cells_.lines.size(); ++l)
            if (cells_.lines[l].side != kNone) lines_of[cells_.lines[l].side].push_back(l);
        for (std::uint32_t s = 0; s < cells_.sides.size(); ++s)
            for (std::uint32_t layer = 0; layer < levels_.layers(); ++layer)
                add_walls_of_layer(s, lines_of[s], layer);
    }

    void add_walls_of_layer(std::uint32_t s, const std::vector<std::uint32_t>& lines, std::uint32_t layer) {
        std::vector<std::uint32_t> run;
        const auto finish = [&] {
            if (!run.empty()) add_wall(s, run, layer);
            run.clear();
        };
        for (const std::uint32_t l : lines) {
            const auto& vertices = cells_.lines[l].vertices;
            const bool goes_on = !run.empty() &&
                                 cells_.lines[run.back()].vertices.back() == vertices.front() &&
                                 !levels_.is_zero(vertices.front(), layer);
            if (!goes_on) finish();
            if (levels_.is_open(plan_.edge_handle(first_half_[l]), layer))
                run.push_back(l);
            else
                finish();
        }
        finish();
    }

    void add_wall(std::uint32_t s, const std::vector<std::uint32_t>& run, std::uint32_t layer) {
        PlanCells::Wall wall{.side = s, .loop = {}};
        const auto edge = [&](std::uint32_t l, std::uint32_t horizon) {
            return edges_at_[l].at(levels_.on_edge(plan_.edge_handle(first_half_[l]), horizon));
        };
        for (const auto l : run) wall.loop.push_back({edge(l, layer + 1), true});
        add_upright(wall.loop, cells_.lines[run.back()].vertices.back(), layer, true);
        for (const auto l : std::views::reverse(run)) wall.loop.push_back({edge(l, layer), false});
        add_upright(wall.loop, cells_.lines[run.front()].vertices.front(), layer, false);
        const auto f = index(plan_.face_handle(first_half_[run.front()]));
        cells_.bodies[body_of_[layer][f]].walls.push_back(std::move(wall));
    }

    void add_upright(PlanCells::Loop& loop, std::uint32_t vertex, std::uint32_t layer, bool up) {
        if (levels_.is_zero(vertex, layer)) return;
        const auto [it, fresh] =
            uprights_.try_emplace({vertex, layer}, static_cast<std::uint32_t>(cells_.edges.size()));
        if (fresh) {
            auto& edge = cells_.edges.emplace_back();
            edge.from = corner(vertex, layer + 1);
            edge.to = corner(vertex, layer);
        }
        loop.push_back({it->second, up});
    }

    struct OnLine {
        std::uint32_t line;
        bool is_first;  // of the line's half-edges, walked in this direction
    };

    const LayerModel& model_;
    const TriMesh& plan_;
    const PlanCellsOptions& options_;
    PlanLevels levels_;
    PlanCells cells_;
    std::vector<std::vector<std::uint32_t>> body_of_;  // [layer][triangle]
    std::vector<std::uint32_t> cell_of_;               // [interface]
    std::vector<char> on_line_, is_node_;              // [plan edge], [plan vertex]
    std::vector<OnLine> line_at_;                      // [half-edge]
    std::vector<std::uint32_t> walked_for_;            // [half-edge]: the cell whose loop last took it
    std::vector<Half> first_half_;                     // [line]
    std::vector<std::map<std::uint32_t, std::uint32_t>> edges_at_;  // [line]: horizon -> edge
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> corner_ids_, uprights_;
};

}  // namespace

PlanCells build_plan_cells(const LayerModel& model, const PlanCellsOptions& options) {
    return Builder(model, options).build();
}

}  // namespace stratareeb
