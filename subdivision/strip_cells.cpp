// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/strip_cells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "boreholes/errors.h"
#include "mesh/point_in_ring.h"
#include "subdivision/strip_lines.h"

namespace stratareeb {
namespace {

constexpr std::uint32_t kNone = PlanCells::kNone;
constexpr int kSamplesASpan = 8;
constexpr double kSameBreak = 1e-6;  // of a curve's length

// A place where an edge crosses the line x = line.
struct Crossing {
    double t, line;
    std::uint32_t corner = kNone;
};

double find_root(const SplineCurve& curve, double a, double b, double x) {
    const bool rises = curve.at(0, b) > x;
    for (int i = 0; i < 60; ++i) {
        const double middle = (a + b) / 2;
        ((curve.at(0, middle) > x) == rises ? b : a) = middle;
    }
    return (a + b) / 2;
}

// The part of a curve between two parameters, exactly.
SplineCurve part_of(const SplineCurve& curve, double from, double to) {
    const double least = kSameBreak * (curve.knots.high() - curve.knots.low());
    std::vector<double> breaks{from};
    for (const double b : curve.knots.breaks())
        if (b > from + least && b < to - least) breaks.push_back(b);
    breaks.push_back(to);
    SplineCurve part{CubicKnots(breaks), {}};
    for (std::size_t c = 0; c < 3; ++c)
        part.coefficients.push_back(interpolate_spline(part.knots, [&](double t) { return curve.at(c, t); }));
    return part;
}

class Cutter {
 public:
    Cutter(SmoothBrep& brep, const std::vector<double>& lines)
        : brep_(brep), cells_(brep.cells), lines_(lines) {}

    void cut() {
        split_edges();
        for (const double x : lines_)
            if (!std::isnan(x) && std::ranges::find(brep_.cuts, x) == brep_.cuts.end())
                brep_.cuts.push_back(x);
        for (auto& cell : cells_.cells)
            for (auto& loop : cell.loops) loop = expanded(loop);
        for (auto& body : cells_.bodies)
            for (auto& wall : body.walls) wall.loop = expanded(wall.loop);
        for (std::uint32_t c = 0; c < lines_.size(); ++c)
            if (!std::isnan(lines_[c])) split_cell(c, lines_[c]);
        note_what_meets();
    }

 private:
    void note_what_meets() {
        for (auto& edge : cells_.edges)
            if (edge.line != kNone) edge.cells.clear();
        for (std::uint32_t c = 0; c < cells_.cells.size(); ++c)
            for (const auto& loop : cells_.cells[c].loops)
                for (const auto& use : loop) {
                    auto& meeting = cells_.edges[use.edge].cells;
                    if (std::ranges::find(meeting, c) == meeting.end()) meeting.push_back(c);
                }
    }

    void split_edges() {
        const std::size_t count = cells_.edges.size();
        parts_.resize(count);
        crossings_.resize(count);
        for (std::uint32_t e = 0; e < count; ++e) {
            if (cells_.edges[e].line == kNone) {
                parts_[e] = {e};
                continue;
            }
            find_crossings(e);
            split_edge(e);
        }
    }

    void find_crossings(std::uint32_t e) {
        std::vector<double> lines;
        for (const auto c : cells_.edges[e].cells)
            if (!std::isnan(lines_[c])) lines.push_back(lines_[c]);
        std::ranges::sort(lines);
        lines.erase(std::ranges::unique(lines).begin(), lines.end());
        const auto& curve = brep_.edges[e].curve;
        const auto& breaks = curve.knots.breaks();
        for (const double x : lines)
            for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
                for (int k = 0; k < kSamplesASpan; ++k) {
                    const double a = std::lerp(breaks[s], breaks[s + 1], k / double(kSamplesASpan)),
                                 b = std::lerp(breaks[s], breaks[s + 1], (k + 1) / double(kSamplesASpan));
                    if ((curve.at(0, a) > x) != (curve.at(0, b) > x))
                        crossings_[e].push_back({find_root(curve, a, b, x), x});
                }
        std::ranges::sort(crossings_[e], {}, &Crossing::t);
    }

    // The first part keeps the edge's number.
    void split_edge(std::uint32_t e) {
        parts_[e] = {e};
        if (crossings_[e].empty()) return;
        const SplineCurve whole = brep_.edges[e].curve;
        const std::uint32_t end = cells_.edges[e].to;
        double from = whole.knots.low();
        for (auto& crossing : crossings_[e]) {
            crossing.corner =
                add_corner({whole.at(0, crossing.t), whole.at(1, crossing.t), whole.at(2, crossing.t)},
                           cells_.edges[e].horizon);
            line_of_[crossing.corner] = crossing.line;
            end_part(parts_[e].back(), whole, from, crossing.t, crossing.corner);
            PlanCells::Edge next = cells_.edges[e];
            next.from = crossing.corner;
            parts_[e].push_back(add_edge(next, brep_.edges[e]));
            from = crossing.t;
        }
        end_part(parts_[e].back(), whole, from, whole.knots.high(), end);
    }

    void end_part(std::uint32_t part, const SplineCurve& whole, double from, double to,
                  std::uint32_t corner) {
        cells_.edges[part].to = corner;
        auto& curve = brep_.edges[part].curve;
        curve = part_of(whole, from, to);
        const Point3 &a = brep_.corners[cells_.edges[part].from], &b = brep_.corners[corner];
        auto& c = curve.coefficients;
        c[0].front() = a.x, c[1].front() = a.y, c[2].front() = a.z;
        c[0].back() = b.x, c[1].back() = b.y, c[2].back() = b.z;
    }

    std::uint32_t add_corner(const Point3& at, std::uint32_t horizon) {
        cells_.corners.push_back({kNone, horizon});
        brep_.corners.push_back(at);
        return static_cast<std::uint32_t>(brep_.corners.size() - 1);
    }

    std::uint32_t add_edge(const PlanCells::Edge& edge, const SmoothBrep::Edge& geometry) {
        cells_.edges.push_back(edge);
        brep_.edges.push_back(geometry);
        return static_cast<std::uint32_t>(cells_.edges.size() - 1);
    }

    PlanCells::Loop expanded(const PlanCells::Loop& loop) const {
        PlanCells::Loop result;
        for (const auto& use : loop) {
            const auto& parts = parts_[use.edge];
            for (std::size_t i = 0; i < parts.size(); ++i)
                result.push_back({use.forward ? parts[i] : parts[parts.size() - 1 - i], use.forward});
        }
        return result;
    }

    std::uint32_t start_of(const PlanCells::EdgeUse& use) const {
        return use.forward ? cells_.edges[use.edge].from : cells_.edges[use.edge].to;
    }
    std::uint32_t end_of(const PlanCells::EdgeUse& use) const {
        return use.forward ? cells_.edges[use.edge].to : cells_.edges[use.edge].from;
    }

    struct Part {
        PlanCells::EdgeUse use;
        bool beyond;           // the line
        std::size_t next = 0;  // along the boundary; of ends on a line: found by the corner
        bool is_walked = false;
    };

    bool is_beyond(const PlanCells::EdgeUse& use, double line) const {
        const auto& curve = brep_.edges[use.edge].curve;
        return curve.at(0, (curve.knots.low() + curve.knots.high()) / 2) > line;
    }

    void split_cell(std::uint32_t c, double line) {
        std::set<std::uint32_t> on_line;  // corners of this cell's outline
        for (const auto& loop : cells_.cells[c].loops)
            for (const auto& use : loop)
                if (is_crossing(end_of(use), line)) on_line.insert(end_of(use));
        if (on_line.empty()) return;
        std::vector<Part> parts;
        for (const auto& loop : cells_.cells[c].loops) {
            const std::size_t first = parts.size();
            for (std::size_t i = 0; i < loop.size(); ++i)
                parts.push_back({loop[i], is_beyond(loop[i], line), first + (i + 1) % loop.size()});
        }
        add_cuts(c, on_line, line, parts);
        join(c, parts, on_line);
    }

    bool is_crossing(std::uint32_t corner, double line) const {
        const auto it = line_of_.find(corner);
        return it != line_of_.end() && it->second == line;
    }

    void add_cuts(std::uint32_t c, const std::set<std::uint32_t>& on_line, double line,
                  std::vector<Part>& parts) {
        std::vector<std::uint32_t> corners(on_line.begin(), on_line.end());
        std::ranges::sort(corners, {}, [&](std::uint32_t i) { return brep_.corners[i].y; });
        for (std::size_t i = 0; i + 1 < corners.size(); i += 2) {
            const std::uint32_t e = add_cut(c, line, corners[i], corners[i + 1]);
            parts.push_back({{e, true}, false});
            parts.push_back({{e, false}, true});
        }
    }

    // From the lower y to the higher.
    std::uint32_t add_cut(std::uint32_t c, double x, std::uint32_t from, std::uint32_t to) {
        const HeightPatch& sheet = brep_.sheet(c);
        const Point3 &a = brep_.corners[from], &b = brep_.corners[to];
        std::vector<double> breaks{a.y};
        const double least = kSameBreak * (sheet.y.high() - sheet.y.low());
        for (const double y : sheet.y.breaks())
            if (y > a.y + least && y < b.y - least) breaks.push_back(y);
        breaks.push_back(b.y);
        SmoothBrep::Edge geometry;
        auto& curve = geometry.curve = {CubicKnots(breaks), {}};
        curve.coefficients = {std::vector<double>(curve.knots.functions(), x), curve.knots.greville(),
                              interpolate_spline(curve.knots, [&](double y) {
                                  return sheet.z({x, y});
                              })};
        curve.coefficients[2].front() = a.z;
        curve.coefficients[2].back() = b.z;
        cells_.lines.push_back({});
        return add_edge({.line = static_cast<std::uint32_t>(cells_.lines.size() - 1),
                         .horizon = cells_.cells[c].horizon,
                         .from = from,
                         .to = to,
                         .cells = {c}},
                        geometry);
    }

    using StripCorner = std::pair<bool, std::uint32_t>;

    static std::size_t next_from(const std::map<StripCorner, std::size_t>& from_line,
                                 const StripCorner& here) {
        const auto it = from_line.find(here);
        if (it == from_line.end())
            throw GeometryError("a smooth face can't be cut into strips: its edge touches a line of the cut");
        return it->second;
    }

    void join(std::uint32_t c, std::vector<Part>& parts, const std::set<std::uint32_t>& on_line) {
        std::map<StripCorner, std::size_t> from_line;
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (on_line.contains(start_of(parts[i].use)))
                from_line[{parts[i].beyond, start_of(parts[i].use)}] = i;
        std::vector<std::pair<bool, PlanCells::Loop>> loops;  // whether it lies beyond the line
        for (std::size_t first = 0; first < parts.size(); ++first) {
            if (parts[first].is_walked) continue;
            loops.push_back({parts[first].beyond, {}});
            std::size_t i = first;
            while (!parts[i].is_walked) {
                parts[i].is_walked = true;
                loops.back().second.push_back(parts[i].use);
                const std::uint32_t corner = end_of(parts[i].use);
                i = on_line.contains(corner) ? next_from(from_line, {parts[i].beyond, corner})
                                             : parts[i].next;
            }
        }
        share_out(c, loops);
    }

    using Ring = std::vector<Point2>;

    Ring ring_of(const PlanCells::Loop& loop) const {
        Ring ring;
        for (const auto& use : loop) {
            const auto& curve = brep_.edges[use.edge].curve;
            const auto& breaks = curve.knots.breaks();
            const std::size_t n = 2 * (breaks.size() - 1);
            for (std::size_t i = 0; i < n; ++i) {
                const std::size_t k = use.forward ? i : n - i;
                const double t =
                    k == n ? breaks.back() : std::lerp(breaks[k / 2], breaks[k / 2 + 1], k % 2 / 2.0);
                ring.push_back({curve.at(0, t), curve.at(1, t)});
            }
        }
        return ring;
    }

    static double area_of(const Ring& ring) {
        double sum = 0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            sum += (a.x - ring[0].x) * (b.y - ring[0].y) - (b.x - ring[0].x) * (a.y - ring[0].y);
        }
        return sum / 2;
    }

    // A cell for each outer loop, with the holes inside it.
    void share_out(std::uint32_t c, const std::vector<std::pair<bool, PlanCells::Loop>>& loops) {
        std::vector<Ring> rings;
        for (const auto& [beyond, loop] : loops) rings.push_back(ring_of(loop));
        std::map<std::size_t, std::uint32_t> cell_of;  // by outer loop
        for (std::size_t i = 0; i < loops.size(); ++i)
            if (area_of(rings[i]) > 0) cell_of[i] = cell_of.empty() ? first_part(c) : further_part(c);
        for (std::size_t i = 0; i < loops.size(); ++i) {
            std::uint32_t owner = kNone;
            for (const auto& [outer, cell] : cell_of)
                if (outer == i || (!cell_of.contains(i) && loops[outer].first == loops[i].first &&
                                   is_inside_ring(rings[outer], rings[i][0])))
                    owner = cell;
            if (owner != kNone) cells_.cells[owner].loops.push_back(loops[i].second);
        }
    }

    std::uint32_t first_part(std::uint32_t c) {
        cells_.cells[c].loops.clear();
        return c;
    }

    std::uint32_t further_part(std::uint32_t c) {
        const auto id = static_cast<std::uint32_t>(cells_.cells.size());
        PlanCells::Cell part = cells_.cells[c];
        part.loops.clear();
        part.faces.clear();
        if (part.body_above != kNone) cells_.bodies[part.body_above].base.push_back(id);
        if (part.body_below != kNone) cells_.bodies[part.body_below].top.push_back(id);
        cells_.cells.push_back(std::move(part));
        brep_.horizons.of_cell.push_back(brep_.horizons.of_cell[c]);
        return id;
    }

    SmoothBrep& brep_;
    PlanCells& cells_;
    const std::vector<double>& lines_;               // [cell] NAN = not to be cut
    std::vector<std::vector<Crossing>> crossings_;   // [edge]
    std::vector<std::vector<std::uint32_t>> parts_;  // [edge] in its direction
    std::map<std::uint32_t, double> line_of_;        // of corners on lines
};

}  // namespace

std::size_t halve_cells(SmoothBrep& brep, const std::vector<char>& which) {
    const std::vector<double> lines = halving_lines(brep, which);
    const auto cut = std::ranges::count_if(lines, [](double x) { return !std::isnan(x); });
    if (cut == 0) return 0;
    SmoothBrep whole = brep;
    try {
        Cutter(brep, lines).cut();
    } catch (const GeometryError&) {
        brep = std::move(whole);
        return 0;
    }
    measure_edges(brep);
    return static_cast<std::size_t>(cut);
}

}  // namespace stratareeb
