// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/body_ends.h"

#include <algorithm>
#include <cmath>

namespace stratareeb {
namespace {

constexpr std::uint32_t kNone = PlanCells::kNone;
constexpr double kStep = 0.1;         // of a curve's spans and of those of the base under it, along the curve
constexpr int kMostSweeps = 100;      // each place that is lowered lifts none
constexpr double kLeastGap = 0.5;     // of the gap
constexpr double kLeastShare = 0.05;  // of the model's thickness at a place

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

// Vertices where a body has thickness and centres of its triangles: the place, the sheet above, the model's thickness.
template <typename Visit>
void each_sample(const LayerModel& model, const PlanCells& cells, const HorizonSheets& sheets,
                 std::uint32_t b, const Visit& visit) {
    const TriMesh& plan = model.plan.surface;
    const auto& body = cells.bodies[b];
    for (const auto c : body.top)
        for (const auto f : cells.cells[c].faces) {
            Point2 centre{0, 0};
            double mean = 0;
            for (const auto v : plan.fv_range(plan.face_handle(f))) {
                const Point2 p{plan.point(v)[0], plan.point(v)[1]};
                const auto i = static_cast<std::size_t>(v.idx());
                const double thickness = model.thickness(body.layer, i);
                centre = {centre.x + p.x / 3, centre.y + p.y / 3};
                mean += thickness / 3;
                if (!model.regions.zero_at[i][body.layer]) visit(p, sheets.of_cell[c], thickness);
            }
            visit(centre, sheets.of_cell[c], mean);
        }
}

// A base whose top was lowered goes along.
bool lower_inside(HorizonSheets& sheets, const LayerModel& model, const PlanCells& cells, std::uint32_t b) {
    bool any = false;
    each_sample(model, cells, sheets, b, [&](const Point2& p, std::uint32_t above, double thickness) {
        const double open = sheets.sheets[above].z(p) - sheets.sheets[b + 1].z(p);
        if (open >= kLeastShare * thickness) return;
        lower_at(sheets.sheets[b + 1], p, 2 * kLeastShare * thickness - open);
        any = true;
    });
    return any;
}

double least_thickness(const HorizonSheets& sheets, const LayerModel& model, const PlanCells& cells,
                       std::uint32_t b) {
    double least = INFINITY;
    each_sample(model, cells, sheets, b, [&](const Point2& p, std::uint32_t above, double) {
        least = std::min(least, sheets.sheets[above].z(p) - sheets.sheets[b + 1].z(p));
    });
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
        const auto layer = [&](std::uint32_t sheet) { return cells.bodies[sheet - 1].layer; };
        for (std::size_t i = 1; i < sheets.size(); ++i) {
            std::size_t above = i - 1;
            while (above > 0 && layer(sheets[above]) == layer(sheets[i])) --above;
            ends[sheets[i] - 1].push_back({e, sheets[above]});
        }
    }
    return ends;
}

void open_body_ends(HorizonSheets& sheets, const LayerModel& model, const PlanCells& cells,
                    const PlanCurves& curves) {
    const auto ends = body_ends(cells, sheets.of_cell);
    for (std::uint32_t b = 0; b < ends.size(); ++b) {  // from the top: those above are lowered first
        bool any = true;
        for (int sweep = 0; sweep < kMostSweeps && any; ++sweep) {
            any = lower_inside(sheets, model, cells, b);
            for (const BodyEnd& end : ends[b])
                any |= lower_along(sheets, b + 1, end, curves.lines[cells.edges[end.edge].line].curve,
                                   sheets.gaps[b]);
        }
        sheets.least_thickness[b] = least_thickness(sheets, model, cells, b);
    }
}

}  // namespace stratareeb
