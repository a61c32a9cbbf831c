// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/snapped_lines.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace stratareeb {
namespace {

constexpr std::uint32_t kNone = PlanCells::kNone;
constexpr int kSteps = 12;
constexpr double kReach = 0.25;  // of a line's edge: how far its vertices may move
constexpr double kFreeFrom = 4;  // vertices from an end: those before move less
constexpr double kClose = 1e-5;  // of the size: what sheets may be apart without harm

using Pair = std::pair<std::uint32_t, std::uint32_t>;  // sheets that are to be equal
using Pairs = std::set<Pair>;

double length(const Point2& v) {
    return std::hypot(v.x, v.y);
}

class Snapper {
 public:
    Snapper(const TriMesh& plan, const PlanCells& cells, const PlanCurves& curves,
            const HorizonSheets& sheets, double size)
        : plan_(plan), cells_(cells), curves_(curves), sheets_(sheets), size_(size) {}

    LineMoves snap() {
        gather_pairs();
        for (std::uint32_t l = 0; l < cells_.lines.size(); ++l)
            if (cells_.lines[l].side == kNone) snap_line(l);
        for (std::uint32_t l = 0; l < cells_.lines.size(); ++l)
            if (cells_.lines[l].side != kNone) snap_rim_ends(l);
        return std::move(moves_);
    }

 private:
    Point2 vertex(std::uint32_t v) const {
        const auto& p = plan_.point(TriMesh::VertexHandle(static_cast<int>(v)));
        return {p[0], p[1]};
    }

    void gather_pairs() {
        along_.resize(cells_.lines.size());
        for (const auto& edge : cells_.edges) {
            if (edge.line == kNone) continue;
            std::set<std::uint32_t> sheets;
            for (const auto c : edge.cells) sheets.insert(sheets_.of_cell[c]);
            for (const auto s : sheets)
                if (s != *sheets.begin()) along_[edge.line].insert({*sheets.begin(), s});
        }
        for (std::uint32_t l = 0; l < cells_.lines.size(); ++l) {
            const auto& line = cells_.lines[l];
            for (const auto v : {line.vertices.front(), line.vertices.back()}) {
                at_end_[v].insert(along_[l].begin(), along_[l].end());
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

    double square(const Pairs& pairs, const Point2& p) const {
        double sum = 0;
        for (const auto& [a, b] : pairs) sum += std::pow(sheets_.sheets[a].z(p) - sheets_.sheets[b].z(p), 2);
        return sum;
    }

    // A Gauss-Newton step from p in a direction of unit length, damped so that lines stay where going as far as they may would
    // not change much.
    double step(const Pairs& pairs, const Point2& p, const Point2& direction, double reach) const {
        double A = std::pow(kClose * size_ / reach, 2), b = 0;
        for (const auto& [above, below] : pairs) {
            const double off = sheets_.sheets[above].z(p) - sheets_.sheets[below].z(p);
            const Point2 g = sheets_.sheets[above].gradient(p), h = sheets_.sheets[below].gradient(p);
            const double slope = (g.x - h.x) * direction.x + (g.y - h.y) * direction.y;
            b -= off * slope;
            A += slope * slope;
        }
        return b / A;
    }

    // The place near p where sheets are closest, no further away than it may be.
    Point2 closest(const Pairs& pairs, const Point2& p, const Point2& direction, double reach) const {
        double moved = 0, best = square(pairs, p);
        for (int i = 0; i < kSteps && best > 0; ++i) {
            const Point2 at{p.x + moved * direction.x, p.y + moved * direction.y};
            double by = step(pairs, at, direction, reach), here = best;
            for (int half = 0; half < 4 && !(here < best); ++half, by /= 2)
                if (std::abs(moved + by) <= reach)
                    here = square(pairs, {at.x + by * direction.x, at.y + by * direction.y});
            if (!(here < best)) break;
            best = here;
            moved += 2 * by;  // halved once more after the step that was taken
        }
        return {p.x + moved * direction.x, p.y + moved * direction.y};
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
            const double reach = kReach * std::min(1.0, from_end / kFreeFrom) * n / 2;
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

    double reach_on_rim(std::uint32_t l, bool at_front) const {
        const auto& line = cells_.lines[l].vertices;
        return first_step(line, at_front ? line.front() : line.back());
    }

    const TriMesh& plan_;
    const PlanCells& cells_;
    const PlanCurves& curves_;
    const HorizonSheets& sheets_;
    double size_;
    LineMoves moves_;
    std::vector<Pairs> along_;               // [line]
    std::map<std::uint32_t, Pairs> at_end_;  // by vertex, of all lines that end there
    std::map<std::uint32_t, double> reach_;  // by vertex
};

}  // namespace

LineMoves snapped_lines(const TriMesh& plan, const PlanCells& cells, const PlanCurves& curves,
                        const HorizonSheets& sheets, double size) {
    return Snapper(plan, cells, curves, sheets, size).snap();
}

}  // namespace stratareeb
