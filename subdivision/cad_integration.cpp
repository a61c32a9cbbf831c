// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/cad_integration.h"

#include <algorithm>
#include <cmath>

#include "subdivision/cell_integrals.h"
#include "subdivision/gauss_rule.h"

namespace stratareeb {
namespace {

constexpr std::size_t kMostPoints = 61, kPointsASpan = 8;  // across a face
constexpr std::size_t kFewSpans = 6;                       // of an edge, that the most points are enough for
constexpr int kSamplesASpan = 15;

// What a cone gets along a line of equal y from x1 to p, by a rule.
ConeIntegral cone_along_x(const HeightPatch& sheet, const Point3& from, double x1, const Point2& p,
                          const GaussRule& rule) {
    const std::size_t ny = sheet.y.functions();
    const auto vy = sheet.y.values(p.y), dy = sheet.y.values(p.y, 1);
    ConeIntegral sum;
    for (std::size_t k = 0; k < rule.places.size(); ++k) {
        const double x = std::lerp(x1, p.x, rule.places[k]);
        const auto vx = sheet.x.values(x), dx = sheet.x.values(x, 1);
        double z = 0, along_x = 0, along_y = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const double* row = sheet.coefficients.data() + (vx.first + i) * ny + vy.first;
            double value = 0, slope = 0;
            for (std::size_t j = 0; j < 4; ++j) value += vy.value[j] * row[j], slope += dy.value[j] * row[j];
            z += vx.value[i] * value, along_x += dx.value[i] * value, along_y += vx.value[i] * slope;
        }
        sum.add(
            {(z - from.z - (x - from.x) * along_x - (p.y - from.y) * along_y) / 3, {-along_x, -along_y, 1}},
            rule.weights[k] * (p.x - x1));
    }
    return sum;
}

//! What a program finds along an edge, and what there is.
struct EdgeSums {
    ConeIntegral found, whole;
};

template <typename F>  // integrand(t, rule)
EdgeSums along_edge(const SmoothBrep::Edge& edge, std::size_t across, const F& integrand) {
    const auto& breaks = edge.curve.knots.breaks();
    const auto ends = cad_edge_ends(edge);
    EdgeSums sums;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        const std::size_t spans = ends[k + 1] - ends[k];
        const GaussRule& rule = gauss_rule(std::min(kMostPoints, kPointsASpan * std::max(across, spans)));
        const auto between = [&](std::size_t first, std::size_t last, const GaussRule& places) {
            ConeIntegral sum;
            for (std::size_t i = 0; i < places.places.size(); ++i)
                sum.add(integrand(std::lerp(breaks[first], breaks[last], places.places[i]), rule),
                        places.weights[i] * (breaks[last] - breaks[first]));
            return sum;
        };
        const ConeIntegral found = between(ends[k], ends[k + 1], rule);
        sums.found.add(found);
        if (spans <= kFewSpans) {
            sums.whole.add(found);
            continue;
        }
        for (std::size_t s = ends[k]; s < ends[k + 1]; ++s) sums.whole.add(between(s, s + 1, gauss_rule(5)));
    }
    return sums;
}

//! Twice the area that a line from a point sweeps over in plan as its end runs along a side of the footprint.
class SweptAlong {
 public:
    SweptAlong(const SideCurve& side, const Point3& from) : side_(side), from_(from) {
        if (side.straight) return;
        before_.push_back(0);
        const auto& breaks = side.curve.knots.breaks();
        for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
            before_.push_back(before_.back() + within_span(breaks[s], breaks[s + 1]));
    }

    //! \param p on the side, at s along it
    double operator()(const Point2& p, double s) const {
        if (side_.straight) return cross(side_.from, run(p));
        const std::size_t span = side_.curve.knots.span(s);
        return before_[span] + within_span(side_.curve.knots.breaks()[span], s);
    }

    // From the side's beginning.
    Point2 run(const Point2& p) const {
        const Point2 start = side_.straight ? side_.from
                                            : Point2{side_.curve.at(0, side_.curve.knots.low()),
                                                     side_.curve.at(1, side_.curve.knots.low())};
        return {p.x - start.x, p.y - start.y};
    }

 private:
    double cross(const Point2& p, const Point2& by) const {
        return (p.x - from_.x) * by.y - (p.y - from_.y) * by.x;
    }

    double within_span(double a, double b) const {
        const GaussRule& rule = gauss_rule(3);  // exact for fifth powers
        double sum = 0;
        for (std::size_t i = 0; i < rule.places.size(); ++i) {
            const double s = std::lerp(a, b, rule.places[i]);
            const auto& c = side_.curve;
            sum += rule.weights[i] * cross({c.at(0, s), c.at(1, s)}, {c.at(0, s, 1), c.at(1, s, 1)});
        }
        return sum * (b - a);
    }

    const SideCurve& side_;
    const Point3& from_;
    std::vector<double> before_;  // [break of the side]
};

// What edges reach of x and y.
struct PlanReach {
    double low_x = INFINITY, low_y = INFINITY, high_y = -INFINITY;
};

PlanReach reach_of(const SmoothBrep& brep, std::uint32_t cell) {
    PlanReach reach;
    for (const auto& loop : brep.cells.cells[cell].loops)
        for (const auto& use : loop) {
            const SplineCurve& curve = brep.edges[use.edge].curve;
            const auto& breaks = curve.knots.breaks();
            for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
                for (int k = 0; k <= kSamplesASpan; ++k) {
                    const double t = std::lerp(breaks[s], breaks[s + 1], k / double(kSamplesASpan));
                    reach.low_x = std::min(reach.low_x, curve.at(0, t));
                    reach.low_y = std::min(reach.low_y, curve.at(1, t));
                    reach.high_y = std::max(reach.high_y, curve.at(1, t));
                }
        }
    return reach;
}

}  // namespace

ConeIntegral IntegrationError::all() const {
    ConeIntegral sum = across;
    for (const auto& edge : along) sum.add(edge);
    return sum;
}

IntegrationError integration_error(const SmoothBrep& brep, std::uint32_t cell, const Point3& from) {
    const HeightPatch& sheet = brep.sheet(cell);
    const PlanReach reach = reach_of(brep, cell);
    const std::size_t across = sheet.y.span(reach.high_y) - sheet.y.span(reach.low_y) + 1;
    IntegrationError error;
    ConeIntegral found;
    for (const auto& loop : brep.cells.cells[cell].loops)
        for (const auto& use : loop) {
            const SplineCurve& curve = brep.edges[use.edge].curve;
            const auto sums = along_edge(brep.edges[use.edge], across, [&](double t, const GaussRule& rule) {
                return ConeIntegral().add(
                    cone_along_x(sheet, from, reach.low_x, {curve.at(0, t), curve.at(1, t)}, rule),
                    curve.at(1, t, 1));
            });
            const int sign = use.forward ? 1 : -1;
            found.add(sums.found, sign);
            error.along.push_back(ConeIntegral().add(sums.found, sign).add(sums.whole, -sign));
        }
    error.across = found.add(integrate_cell(brep, cell, from).from_point, -1).add(error.all(), -1);
    return error;
}

std::vector<ConeIntegral> wall_integration_error(const SmoothBrep& brep, const PlanCells::Wall& wall,
                                                 const Point3& from) {
    const SideCurve& side = brep.sides[wall.side];
    const SweptAlong swept(side, from);
    std::vector<ConeIntegral> error;
    for (const auto& use : wall.loop) {
        const auto& edge = brep.edges[use.edge];
        error.emplace_back();
        if (brep.cells.edges[use.edge].line == PlanCells::kNone) continue;
        const auto sums = along_edge(edge, 1, [&](double t, const GaussRule&) {
            const Point2 p{edge.curve.at(0, t), edge.curve.at(1, t)};
            const Point2 run = swept.run(p);
            return ConeIntegral().add({swept(p, t + edge.side_start) / 3, {run.y, -run.x, 0}},
                                      edge.curve.at(2, t, 1));
        });
        const int sign = use.forward ? 1 : -1;
        error.back().add(sums.found, sign).add(sums.whole, -sign);
    }
    return error;
}

}  // namespace stratareeb
