// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/sheet_gaps.h"

#include <algorithm>
#include <cmath>

#include "subdivision/body_ends.h"

namespace stratareeb {
namespace {

constexpr int kSteps = 12;
constexpr int kHalvings = 4;     // of a step that is no better
constexpr double kClose = 1e-5;  // of the size: what sheets may be apart without harm
constexpr double kThrough = 10;  // times as bad as too far apart: too close

double square(const HorizonSheets& sheets, const SheetGaps& gaps, const Point2& p) {
    double sum = 0;
    for (const SheetGap& gap : gaps) {
        const double off = off_gap(sheets, gap, p);
        sum += std::pow(off < 0 ? kThrough * off : off, 2);
    }
    return sum;
}

// The equations of a damped Gauss-Newton step.
struct Normal {
    double xx, xy, yy, x, y;
};

Normal normal_at(const HorizonSheets& sheets, const SheetGaps& gaps, const Point2& p, double damping) {
    Normal n{damping, 0, damping, 0, 0};
    for (const SheetGap& gap : gaps) {
        const double off = off_gap(sheets, gap, p);
        const Point2 g = sheets.sheets[gap.above].gradient(p), h = sheets.sheets[gap.below].gradient(p);
        const Point2 d{g.x - h.x, g.y - h.y};
        n.xx += d.x * d.x, n.xy += d.x * d.y, n.yy += d.y * d.y;
        n.x -= off * d.x, n.y -= off * d.y;
    }
    return n;
}

// Steps from p while they bring it closer.
template <typename Step>
Point2 closest(const HorizonSheets& sheets, const SheetGaps& gaps, const Point2& p, double reach, double size,
               const Step& step) {
    const double damping = std::pow(kClose * size / reach, 2);
    Point2 here = p;
    double best = square(sheets, gaps, p);
    for (int i = 0; i < kSteps && best > 0; ++i) {
        Point2 by = step(normal_at(sheets, gaps, here, damping));
        const double much = std::max(1.0, std::hypot(by.x, by.y) / reach);
        by = {by.x / much, by.y / much};
        bool is_better = false;
        for (int half = 0; half < kHalvings && !is_better; ++half, by = {by.x / 2, by.y / 2}) {
            const Point2 there{here.x + by.x, here.y + by.y};
            if (!(std::hypot(there.x - p.x, there.y - p.y) <= reach)) continue;
            const double then = square(sheets, gaps, there);
            if (!(then < best)) continue;
            here = there, best = then, is_better = true;
        }
        if (!is_better) break;
    }
    return here;
}

double square_apart(const HorizonSheets& sheets, const SheetGaps& pairs, const Point2& p) {
    double sum = 0;
    for (const SheetGap& pair : pairs)
        sum += std::pow(sheets.sheets[pair.above].z(p) - sheets.sheets[pair.below].z(p), 2);
    return sum;
}

// A Gauss-Newton step from p in a direction of unit length.
double step_to_meeting(const HorizonSheets& sheets, const SheetGaps& pairs, const Point2& p,
                       const Point2& direction, double damping) {
    double A = damping, b = 0;
    for (const SheetGap& pair : pairs) {
        const double off = sheets.sheets[pair.above].z(p) - sheets.sheets[pair.below].z(p);
        const Point2 g = sheets.sheets[pair.above].gradient(p), h = sheets.sheets[pair.below].gradient(p);
        const double slope = (g.x - h.x) * direction.x + (g.y - h.y) * direction.y;
        b -= off * slope;
        A += slope * slope;
    }
    return b / A;
}

}  // namespace

std::vector<SheetGaps> sheet_gaps(const PlanCells& cells, const HorizonSheets& sheets) {
    std::vector<SheetGaps> result(cells.lines.size());
    const auto ends = body_ends(cells, sheets.of_cell);
    for (std::uint32_t b = 0; b < ends.size(); ++b)
        for (const BodyEnd& end : ends[b])
            result[cells.edges[end.edge].line].insert({end.above, b + 1, sheets.gaps[b]});
    return result;
}

bool has_gaps(const HorizonSheets& sheets) {
    return std::ranges::any_of(sheets.gaps, [](double gap) { return gap > 0; });
}

double off_gap(const HorizonSheets& sheets, const SheetGap& gap, const Point2& p) {
    return sheets.sheets[gap.above].z(p) - sheets.sheets[gap.below].z(p) - gap.gap;
}

Point2 closest_to_gaps(const HorizonSheets& sheets, const SheetGaps& gaps, const Point2& p,
                       const Point2& direction, double reach, double size) {
    return closest(sheets, gaps, p, reach, size, [&](const Normal& n) {
        // The damping stands in xx and yy: once in the direction's square.
        const double A = n.xx * direction.x * direction.x + 2 * n.xy * direction.x * direction.y +
                         n.yy * direction.y * direction.y;
        const double by = (n.x * direction.x + n.y * direction.y) / A;
        return Point2{by * direction.x, by * direction.y};
    });
}

Point2 closest_to_gaps(const HorizonSheets& sheets, const SheetGaps& gaps, const Point2& p, double reach,
                       double size) {
    return closest(sheets, gaps, p, reach, size, [](const Normal& n) {
        const double det = n.xx * n.yy - n.xy * n.xy;
        return Point2{(n.yy * n.x - n.xy * n.y) / det, (n.xx * n.y - n.xy * n.x) / det};
    });
}

Point2 closest_to_meeting(const HorizonSheets& sheets, const SheetGaps& pairs, const Point2& p,
                          const Point2& direction, double reach, double size) {
    const double damping = std::pow(kClose * size / reach, 2);
    double moved = 0, best = square_apart(sheets, pairs, p);
    for (int i = 0; i < kSteps && best > 0; ++i) {
        const Point2 at{p.x + moved * direction.x, p.y + moved * direction.y};
        double by = step_to_meeting(sheets, pairs, at, direction, damping), here = best;
        for (int half = 0; half < kHalvings && !(here < best); ++half, by /= 2)
            if (std::abs(moved + by) <= reach)
                here = square_apart(sheets, pairs, {at.x + by * direction.x, at.y + by * direction.y});
        if (!(here < best)) break;
        best = here;
        moved += 2 * by;  // halved once more after the step that was taken
    }
    return {p.x + moved * direction.x, p.y + moved * direction.y};
}

}  // namespace stratareeb
