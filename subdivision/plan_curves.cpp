// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/plan_curves.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace stratareeb {
namespace {

constexpr double kSameBreak = 1e-9;  // of a line's length

class Curves {
 public:
    Curves(const TriMesh& plan, const PlanCells& cells, double tolerance, const LineMoves& moves)
        : plan_(plan), cells_(cells), tolerance_(tolerance), moves_(moves), moved_(moves.inner) {}

    PlanCurves build() {
        PlanCurves curves;
        for (std::uint32_t s = 0; s < cells_.sides.size(); ++s) curves.sides.push_back(side_curve(s));
        for (const auto& line : cells_.lines)
            if (line.side != PlanCells::kNone) place_ends(line, curves.sides[line.side]);
        for (std::uint32_t l = 0; l < cells_.lines.size(); ++l) {
            const auto& line = cells_.lines[l];
            curves.lines.push_back(line.side == PlanCells::kNone ? inner_line(line, tolerance_of(l))
                                                                 : rim_line(line, curves.sides[line.side]));
        }
        return curves;
    }

 private:
    Point2 vertex(std::uint32_t v) const {
        const auto& p = plan_.point(TriMesh::VertexHandle(static_cast<int>(v)));
        return {p[0], p[1]};
    }

    Point2 place(std::uint32_t v) const {
        const auto it = moved_.find(v);
        return it == moved_.end() ? vertex(v) : it->second;
    }

    std::vector<double> lengths(const std::vector<Point2>& points) const {
        std::vector<double> result{0};
        for (std::size_t i = 1; i < points.size(); ++i)
            result.push_back(result.back() +
                             std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y));
        return result;
    }

    double tolerance_of(std::uint32_t line) const {
        const auto it = moves_.closer.find(line);
        return it == moves_.closer.end() ? tolerance_ : tolerance_ * std::pow(0.1, it->second);
    }

    static SplineCurve fitted(const std::vector<Point2>& points, const std::vector<double>& parameters,
                              double tolerance) {
        std::vector<std::vector<double>> samples(2);
        for (const Point2& p : points) samples[0].push_back(p.x), samples[1].push_back(p.y);
        return fit_spline(parameters, samples, {.tolerance = tolerance, .most_spans = 2 * points.size()});
    }

    SideCurve side_curve(std::uint32_t number) {
        const RimSide& side = cells_.sides[number];
        SideCurve result{.straight = side.straight,
                         .from = vertex(side.vertices.front()),
                         .to = vertex(side.vertices.back())};
        std::vector<Point2> points;
        for (const auto v : side.vertices) points.push_back(vertex(v));
        const auto s = lengths(points);
        for (std::size_t i = 0; i < s.size(); ++i) along_[{number, side.vertices[i]}] = s[i];
        for (const auto& [key, length] : moves_.on_side)
            if (key.first == number) along_[key] = length;
        if (!side.straight) result.curve = fitted(points, s, tolerance_);
        return result;
    }

    void place_ends(const PlanCells::Line& line, const SideCurve& side) {
        for (const auto v : {line.vertices.front(), line.vertices.back()}) {
            const auto& all = cells_.sides[line.side].vertices;
            const double s = along_.at({line.side, v});
            if (v != all.front() && v != all.back())
                moved_[v] = point_on(side, s / along_.at({line.side, all.back()}), s);
        }
    }

    static Point2 point_on(const SideCurve& side, double share, double s) {
        if (!side.straight) return {side.curve.at(0, s), side.curve.at(1, s)};
        return {side.from.x + (side.to.x - side.from.x) * share,
                side.from.y + (side.to.y - side.from.y) * share};
    }

    static SplineCurve straight(const Point2& a, const Point2& b, double length) {
        const CubicKnots knots({0, length});
        SplineCurve curve{knots, {{}, {}}};
        for (const double t : knots.greville()) {
            curve.coefficients[0].push_back(a.x + (b.x - a.x) * (t / length));
            curve.coefficients[1].push_back(a.y + (b.y - a.y) * (t / length));
        }
        return curve;
    }

    LineCurve rim_line(const PlanCells::Line& line, const SideCurve& side) const {
        LineCurve result;
        result.side_start = along_.at({line.side, line.vertices.front()});
        for (const auto v : line.vertices)
            result.parameters.push_back(along_.at({line.side, v}) - result.side_start);
        const double length = result.parameters.back();
        if (side.straight) {
            result.curve = straight(place(line.vertices.front()), place(line.vertices.back()), length);
            return result;
        }
        std::vector<double> breaks{0};
        for (const double b : side.curve.knots.breaks()) {
            const double t = b - result.side_start;
            if (t > kSameBreak * length && t < (1 - kSameBreak) * length) breaks.push_back(t);
        }
        breaks.push_back(length);
        const CubicKnots knots(breaks);
        result.curve.knots = knots;
        for (const std::size_t c : {0, 1})
            result.curve.coefficients.push_back(interpolate_spline(
                knots, [&, c](double t) { return side.curve.at(c, t + result.side_start); }));
        return result;
    }

    LineCurve inner_line(const PlanCells::Line& line, double tolerance) const {
        std::vector<Point2> points;
        for (const auto v : line.vertices) points.push_back(place(v));
        LineCurve result;
        result.parameters = lengths(points);
        result.curve = points.size() == 2 ? straight(points[0], points[1], result.parameters.back())
                                          : fitted(points, result.parameters, tolerance);
        return result;
    }

    const TriMesh& plan_;
    const PlanCells& cells_;
    double tolerance_;
    const LineMoves& moves_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> along_;  // [side, vertex]: the length up to it
    std::map<std::uint32_t, Point2> moved_;  // ends of lines that a side's curve puts elsewhere
};

}  // namespace

PlanCurves build_plan_curves(const TriMesh& plan, const PlanCells& cells, double tolerance,
                             const LineMoves& moves) {
    return Curves(plan, cells, tolerance, moves).build();
}

}  // namespace stratareeb
