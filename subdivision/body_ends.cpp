// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/body_ends.h"

#include <algorithm>
#include <cmath>

namespace stratareeb {
namespace {

constexpr std::uint32_t kNone = PlanCells::kNone;
constexpr double kStep = 0.1;      // of a curve's spans and of those of the base under it, along the curve
constexpr int kMostSweeps = 100;   // each place that is lowered lifts none
constexpr double kLeastGap = 0.5;  // of the gap

double width_at(const CubicKnots& knots, double at) {
    const std::size_t s = knots.span(at);
    return knots.breaks()[s + 1] - knots.breaks()[s];
}

double span_at(const HeightPatch& patch, const Point2& p) {
    return std::min(width_at(patch.x, p.x), width_at(patch.y, p.y));
}

bool lower_along(HorizonSheets& sheets, std::uint32_t base, const BodyEnd& end, const SplineCurve& curve,
                 double gap) {
    bool any = false;
    const double last = curve.knots.high();
    for (double t = curve.knots.low();;) {
        const Point2 p{curve.at(0, t), curve.at(1, t)};
        const double open = sheets.sheets[end.above].z(p) - sheets.sheets[base].z(p);
        if (open < kLeastGap * gap) {
            lower_at(sheets.sheets[base], p, gap - open);
            any = true;
        }
        if (t == last) return any;
        t = std::min(last, t + kStep * std::min(span_at(sheets.sheets[base], p), width_at(curve.knots, t)));
    }
}

double least_thickness(const HorizonSheets& sheets, const LayerModel& model, const PlanCells& cells,
                       std::uint32_t b) {
    const TriMesh& plan = model.plan.surface;
    const auto& body = cells.bodies[b];
    double least = INFINITY;
    for (const auto c : body.top)
        for (const auto f : cells.cells[c].faces) {
            Point2 centre{0, 0};
            const auto thickness_at = [&](const Point2& p) {
                return sheets.sheets[sheets.of_cell[c]].z(p) - sheets.sheets[b + 1].z(p);
            };
            for (const auto v : plan.fv_range(plan.face_handle(f))) {
                const Point2 p{plan.point(v)[0], plan.point(v)[1]};
                centre = {centre.x + p.x / 3, centre.y + p.y / 3};
                if (!model.regions.zero_at[static_cast<std::size_t>(v.idx())][body.layer])
                    least = std::min(least, thickness_at(p));
            }
            least = std::min(least, thickness_at(centre));
        }
    return least;
}

}  // namespace

std::vector<std::vector<BodyEnd>> body_ends(const PlanCells& cells,
                                            const std::vector<std::uint32_t>& of_cell) {
    std::vector<std::vector<BodyEnd>> ends(cells.bodies.size());
    for (std::uint32_t e = 0; e < cells.edges.size(); ++e) {
        if (cells.edges[e].line == kNone) continue;
        std::vector<std::uint32_t> sheets;
        for (const auto c : cells.edges[e].cells) sheets.push_back(of_cell[c]);
        std::ranges::sort(sheets);
        sheets.erase(std::ranges::unique(sheets).begin(), sheets.end());
        for (std::size_t i = 1; i < sheets.size(); ++i)
            ends[sheets[i] - 1].push_back({e, sheets[0], static_cast<double>(i)});
    }
    return ends;
}

void open_body_ends(HorizonSheets& sheets, const LayerModel& model, const PlanCells& cells,
                    const PlanCurves& curves, double gap) {
    const auto ends = body_ends(cells, sheets.of_cell);
    for (std::uint32_t b = 0; b < ends.size(); ++b) {  // from the top: those above are lowered first
        bool any = !ends[b].empty();
        for (int sweep = 0; sweep < kMostSweeps && any; ++sweep) {
            any = false;
            for (const BodyEnd& end : ends[b])
                any |= lower_along(sheets, b + 1, end, curves.lines[cells.edges[end.edge].line].curve,
                                   end.rank * gap);
        }
        sheets.least_thickness[b] =
            std::min(sheets.least_thickness[b], least_thickness(sheets, model, cells, b));
    }
}

}  // namespace stratareeb
