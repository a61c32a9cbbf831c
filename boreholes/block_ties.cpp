// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/block_ties.h"

#include <algorithm>
#include <map>
#include <string>

#include "boreholes/block_survey.h"
#include "boreholes/predict_columns.h"

namespace stratareeb {

namespace {

Borehole column_at(const Survey& survey, const PredictedColumns& columns, std::size_t place,
                   const Point2& at) {
    Borehole hole{.id = "tie", .at = at, .layers = {}, .horizons = {columns.ground[place]}, .row = 0};
    for (std::size_t i = 0; i < survey.units.size(); ++i) {
        const double thickness = columns.thickness[i][place];
        hole.layers.push_back(survey.contact_points ? LayerFact{}
                                                    : LayerFact{Knowledge::Measured, thickness});
        hole.horizons.push_back(*hole.horizons.back() - thickness);
    }
    return hole;
}

}  // namespace

std::vector<std::vector<Borehole>> tie_columns(const Survey& survey, std::span<const std::uint32_t> block_of,
                                               std::span<const BlockTie> ties,
                                               const CompletionOptions& options, bool bare) {
    std::uint32_t last = 0;
    for (const std::uint32_t block : block_of) last = std::max(last, block);
    std::map<std::vector<std::uint32_t>, std::vector<const BlockTie*>> with;
    for (const BlockTie& tie : ties) {
        with[tie.from].push_back(&tie);
        for (const std::uint32_t block : tie.to) last = std::max(last, block);
    }
    std::vector<std::vector<Borehole>> result(last + 1);
    for (const auto& [blocks, members] : with) {
        std::vector<std::uint32_t> holes;
        for (std::uint32_t h = 0; h < block_of.size(); ++h)
            if (std::ranges::binary_search(blocks, block_of[h])) holes.push_back(h);
        if (holes.empty()) continue;
        std::vector<std::string> notes;
        const ColumnPredictor predictor(survey_of_block(survey, holes, notes), options, bare);
        std::vector<Point2> where;
        for (const BlockTie* tie : members) where.push_back(tie->at);
        const PredictedColumns columns = predictor.at(where);
        for (std::size_t i = 0; i < members.size(); ++i) {
            const Borehole column = column_at(survey, columns, i, where[i]);
            for (const std::uint32_t block : members[i]->to) result[block].push_back(column);
        }
    }
    return result;
}

}  // namespace stratareeb
