// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/placed_errors.h"

namespace stratareeb {

KnowingHoles knowing_holes(const Survey& survey, const std::vector<Draw>& draws,
                           const std::function<bool(const Borehole&)>& knows) {
    std::vector<std::size_t> draw_of(survey.holes.size());
    for (std::size_t h = 0; h < draw_of.size(); ++h) draw_of[h] = draws.size() + h;  // in none
    for (std::size_t d = 0; d < draws.size(); ++d)
        for (const std::size_t h : draws[d]) draw_of[h] = d;
    KnowingHoles result{{}, {}, std::vector<std::size_t>(survey.holes.size(), 0)};
    for (std::size_t h = 0; h < survey.holes.size(); ++h) {
        if (!knows(survey.holes[h])) continue;
        result.number_of_hole[h] = result.at.size();
        result.at.push_back(survey.holes[h].at);
        result.draw.push_back(draw_of[h]);
    }
    return result;
}

bool knows_thickness(const Borehole& hole, std::size_t layer) {
    return layer < hole.layers.size() && hole.layers[layer].knowledge == Knowledge::Measured;
}

bool knows_horizon(const Borehole& hole, std::size_t k) {
    return k < hole.horizons.size() && hole.horizons[k].has_value();
}

std::vector<PlacedError> placed_errors(const Survey& survey, const std::vector<Residual>& residuals,
                                       const KnowingHoles& know) {
    std::vector<std::size_t> asked;
    for (const Residual& residual : residuals) asked.push_back(know.number_of_hole[residual.hole]);
    const std::vector<double> gaps = gaps_to_other_draws(know.at, know.draw, asked);
    std::vector<PlacedError> errors;
    for (std::size_t i = 0; i < residuals.size(); ++i)
        errors.push_back(
            {survey.holes[residuals[i].hole].at, residuals[i].draw, residuals[i].error(), gaps[i]});
    return errors;
}

}  // namespace stratareeb
