// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/cell_integrals.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/compensated_sum.h"
#include "subdivision/gauss_rule.h"

namespace stratareeb {
namespace {

constexpr int kPartsASpan = 3;  // of an edge, which has a few spans of its sheet in each

// Of a sheet along x, from its lower end.
class AlongX {
 public:
    explicit AlongX(const HeightPatch& sheet) : sheet_(sheet), ny_(sheet.y.functions()) {
        const auto& breaks = sheet.x.breaks();
        before_.assign(breaks.size() * ny_, 0);
        for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
            for (std::size_t j = 0; j < ny_; ++j)
                before_[(s + 1) * ny_ + j] = before_[s * ny_ + j] + row(j, breaks[s], breaks[s + 1]);
    }

    double operator()(const Point2& p) const {
        const std::size_t s = sheet_.x.span(p.x);
        const auto vy = sheet_.y.values(p.y);
        double sum = 0;
        for (std::size_t j = 0; j < 4; ++j)
            sum += vy.value[j] *
                   (before_[s * ny_ + vy.first + j] + row(vy.first + j, sheet_.x.breaks()[s], p.x));
        return sum;
    }

 private:
    // Of the functions of x that go with the j-th of y, within a span.
    double row(std::size_t j, double from, double to) const {
        double sum = 0;
        for (const double t : gauss_rule(2).places) {  // of equal weights, exact for cubics
            const auto vx = sheet_.x.values(std::lerp(from, to, t));
            for (std::size_t i = 0; i < 4; ++i)
                sum += vx.value[i] * sheet_.coefficients[(vx.first + i) * ny_ + j];
        }
        return sum * (to - from) / 2;
    }

    const HeightPatch& sheet_;
    std::size_t ny_;
    std::vector<double> before_;  // [break of x][function of y]
};

template <typename Visit>  // visit(point, dx, dy), weighted: edges in the direction of their loops
void along_edges(const SmoothBrep& brep, std::uint32_t cell, const Visit& visit) {
    const GaussRule& five = gauss_rule(5);
    for (const auto& loop : brep.cells.cells[cell].loops)
        for (const auto& use : loop) {
            const SplineCurve& curve = brep.edges[use.edge].curve;
            const auto& breaks = curve.knots.breaks();
            for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
                for (int k = 0; k < kPartsASpan; ++k) {
                    const double a = std::lerp(breaks[s], breaks[s + 1], k / double(kPartsASpan)),
                                 b = std::lerp(breaks[s], breaks[s + 1], (k + 1) / double(kPartsASpan));
                    for (std::size_t i = 0; i < five.places.size(); ++i) {
                        const double t = std::lerp(a, b, five.places[i]),
                                     w = five.weights[i] * (use.forward ? b - a : a - b);
                        visit(Point2{curve.at(0, t), curve.at(1, t)}, w * curve.at(0, t, 1),
                              w * curve.at(1, t, 1));
                    }
                }
        }
}

}  // namespace

CellIntegrals integrate_cell(const SmoothBrep& brep, std::uint32_t cell, const Point3& from) {
    const HeightPatch& sheet = brep.sheet(cell);
    const AlongX along_x(sheet);
    CompensatedSum area, volume, moment, along_x_axis, along_y_axis;
    along_edges(brep, cell, [&](const Point2& p, double dx, double dy) {
        area.add((p.x - from.x) * dy);
        volume.add(along_x(p) * dy);
        const double z = sheet.z(p);
        moment.add(z * ((p.x - from.x) * dy - (p.y - from.y) * dx));
        along_x_axis.add(z * dx);
        along_y_axis.add(z * dy);
    });
    return {area.value(),
            volume.value(),
            {volume.value() - (from.z * area.value() + moment.value()) / 3,
             {-along_y_axis.value(), along_x_axis.value(), area.value()}}};
}

double body_volume(const SmoothBrep& brep, const PlanCells::Body& body) {
    CompensatedSum volume;
    for (const auto c : body.top) volume.add(integrate_cell(brep, c).volume);
    for (const auto c : body.base) volume.add(-integrate_cell(brep, c).volume);
    return volume.value();
}

}  // namespace stratareeb
