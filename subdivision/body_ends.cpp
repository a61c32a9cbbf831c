// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/body_ends.h"

#include <algorithm>

namespace stratareeb {

std::vector<std::vector<BodyEnd>> body_ends(const PlanCells& cells,
                                            const std::vector<std::uint32_t>& of_cell) {
    std::vector<std::vector<BodyEnd>> ends(cells.bodies.size());
    for (std::uint32_t e = 0; e < cells.edges.size(); ++e) {
        if (cells.edges[e].line == PlanCells::kNone) continue;
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

}  // namespace stratareeb
