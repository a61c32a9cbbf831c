// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/face_spans.h"

#include <algorithm>
#include <cmath>

namespace stratareeb {

FaceSpans face_spans(const SmoothBrep& brep, std::uint32_t cell) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (const auto& loop : brep.cells.cells[cell].loops)
        for (const auto& use : loop)
            for (std::size_t k = 0; k < 2; ++k) {
                const auto [l, h] = std::ranges::minmax(brep.edges[use.edge].curve.coefficients[k]);
                low[k] = std::min(low[k], l), high[k] = std::max(high[k], h);
            }
    const HeightPatch& sheet = brep.sheet(cell);
    return {sheet.x.span(low[0]), sheet.x.span(high[0]) + 1, sheet.y.span(low[1]), sheet.y.span(high[1]) + 1};
}

}  // namespace stratareeb
