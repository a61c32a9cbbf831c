// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/snapped_lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "subdivision/sheet_gaps.h"

namespace stratareeb {
namespace {

constexpr std::uint32_t kNone = PlanCells::kNone;
constexpr double kReach = 0.25;                    // of a line's edge: how far its vertices may move
constexpr double kFreeFrom = 4, kGapFreeFrom = 2;  // vertices from an end: those before move less
constexpr std::size_t kMostLines = 3;  // that end at a junction that moves: more might change places

double length(const Point2& v) {
    return std::hypot(v.x, v.y);
}

class Snapper {
 public:
    Snapper(const TriMesh& plan, const PlanCells& cells, const PlanCurves& curves,
            const HorizonSheets& sheets, double size)
        : plan_(plan),
          cells_(cells),
          curves_(curves),
          sheets_(sheets),
          size_(size),
          has_gaps_(has_gaps(sheets)) {}

    LineMoves snap() {
        gather_gaps();
        for (std::uint32_t l = 0; l < cells_.lines.size(); ++l)
            if (cells_.lines[l].side == kNone) snap_line(l);
        for (std::uint32_t l = 0; l < cells_.lines.size(); ++l)
            if (cells_.lines[l].side != kNone) snap_rim_ends(l);
        if (has_gaps_) snap_junctions();
        return std::move(moves_);
    }

 private:
    Point2 vertex(std::uint32_t v) const {
        const auto& p = plan_.point(TriMesh::VertexHandle(static_cast<int>(v)));
        return {p[0], p[1]};
    }

    void gather_gaps() {
        along_ = sheet_gaps(cells_, sheets_);
        for (std::uint32_t l = 0; l < cells_.lines.size(); ++l) {
            const auto& line = cells_.lines[l];
            for (const auto v : {line.vertices.front(), line.vertices.back()}) {
                at_end_[v].insert(along_[l].begin(), along_[l].end());
                ++ends_[v];
                const double next = first_step(line.vertices, v);
                const auto [it, fresh] = reach_.try_emplace(v, next);
                if (!fresh) it->second = std::min(it->second, next);
            }
        }
    }

    double first_step(const std::vector<std::uint32_t>& line, std::uint32_t end) const {
        const std::uint32_t next = end == line.front() ? line[1] : line[line.size() - 2];
        const Point2 a = vertex(end), b = vertex(next);
        return std::hypot(b.x - a.x, b.y - a.y);
    }

    Point2 closest(const SheetGaps& gaps, const Point2& p, const Point2& direction, double reach) const {
        return has_gaps_ ? closest_to_gaps(sheets_, gaps, p, direction, reach, size_)
                         : closest_to_meeting(sheets_, gaps, p, direction, reach, size_);
    }

    void snap_line(std::uint32_t l) {
        const auto& line = cells_.lines[l].vertices;
        if (along_[l].empty()) return;
        for (std::size_t i = 1; i + 1 < line.size(); ++i) {
            const Point2 before = vertex(line[i - 1]), here = vertex(line[i]), after = vertex(line[i + 1]);
            const Point2 way{after.x - before.x, after.y - before.y};
            const double n = length(way);
            if (!(n > 0)) continue;
            const double from_end = static_cast<double>(std::min(i, line.size() - 1 - i));
            const double reach =
                kReach * std::min(1.0, from_end / (has_gaps_ ? kGapFreeFrom : kFreeFrom)) * n / 2;
            moves_.inner[line[i]] = closest(along_[l], here, {-way.y / n, way.x / n}, reach);
        }
    }

    // Ends of lines within a side; its own ends stay.
    void snap_rim_ends(std::uint32_t l) {
        const auto& line = cells_.lines[l];
        const auto& side = cells_.sides[line.side].vertices;
        for (const bool at_front : {true, false}) {
            const std::uint32_t v = at_front ? line.vertices.front() : line.vertices.back();
            if (v == side.front() || v == side.back() || at_end_.at(v).empty()) continue;
            const auto& curve = curves_.lines[l];
            const double t = at_front ? 0 : curve.parameters.back();
            const Point2 p{curve.curve.at(0, t), curve.curve.at(1, t)};
            Point2 way{curve.curve.at(0, t, 1), curve.curve.at(1, t, 1)};
            const double n = length(way);
            way = {way.x / n, way.y / n};
            const double reach = kReach * reach_on_rim(l, at_front);
            const Point2 q = closest(at_end_.at(v), p, way, reach);
            moves_.on_side[{line.side, v}] =
                curve.side_start + t + ((q.x - p.x) * way.x + (q.y - p.y) * way.y) / n;
        }
    }

    // Ends of lines inside, in the plan.
    void snap_junctions() {
        std::set<std::uint32_t> on_rim;
        for (const auto& side : cells_.sides) on_rim.insert(side.vertices.begin(), side.vertices.end());
        for (const auto& [v, gaps] : at_end_)
            if (!gaps.empty() && !on_rim.contains(v) && ends_.at(v) <= kMostLines)
                moves_.inner[v] = closest_to_gaps(sheets_, gaps, vertex(v), kReach * reach_.at(v), size_);
    }

    double reach_on_rim(std::uint32_t l, bool at_front) const {
        const auto& line = cells_.lines[l].vertices;
        return first_step(line, at_front ? line.front() : line.back());
    }

    const TriMesh& plan_;
    const PlanCells& cells_;
    const PlanCurves& curves_;
    const HorizonSheets& sheets_;
    double size_;
    bool has_gaps_;
    LineMoves moves_;
    std::vector<SheetGaps> along_;               // [line]
    std::map<std::uint32_t, SheetGaps> at_end_;  // by vertex, of all lines that end there
    std::map<std::uint32_t, std::size_t> ends_;  // of lines, by vertex
    std::map<std::uint32_t, double> reach_;      // by vertex
};

}  // namespace

LineMoves snapped_lines(const TriMesh& plan, const PlanCells& cells, const PlanCurves& curves,
                        const HorizonSheets& sheets, double size) {
    return Snapper(plan, cells, curves, sheets, size).snap();
}

}  // namespace stratareeb
