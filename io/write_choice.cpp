// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_choice.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace stratareeb {

nlohmann::ordered_json choice_json(const InterpolatorChoice& choice) {
    nlohmann::ordered_json json{{"interpolator", name_of(choice.kind)}, {"reason", choice.reason}};
    json["candidates"] = nlohmann::ordered_json::array();
    for (const InterpolatorScore& score : choice.scores)
        json["candidates"].push_back({{"interpolator", name_of(score.kind)}, {"ratio", score.ratio}});
    json["quantities"] = nlohmann::ordered_json::array();
    for (std::size_t q = 0; q < choice.quantities.size(); ++q) {
        nlohmann::ordered_json rmse;
        for (const InterpolatorScore& score : choice.scores)
            rmse[std::string(name_of(score.kind))] = score.rmse[q];
        json["quantities"].push_back(
            {{"name", choice.quantities[q]}, {"held_out", choice.held_out[q]}, {"rmse", rmse}});
    }
    return json;
}

OutputTable choice_table(const InterpolatorChoice& choice) {
    OutputTable table{{"quantity", "held_out"}, {}};
    std::vector<OutputCell> ratios{std::string("ratio to the first, all quantities"), std::monostate()};
    for (const InterpolatorScore& score : choice.scores) {
        table.columns.emplace_back(name_of(score.kind));
        ratios.emplace_back(score.ratio);
    }
    for (std::size_t q = 0; q < choice.quantities.size(); ++q) {
        std::vector<OutputCell> row{choice.quantities[q], static_cast<double>(choice.held_out[q])};
        for (const InterpolatorScore& score : choice.scores) row.emplace_back(score.rmse[q]);
        table.rows.push_back(std::move(row));
    }
    if (!choice.quantities.empty()) table.rows.push_back(std::move(ratios));
    return table;
}

std::string choice_text(const InterpolatorChoice& choice) {
    std::string text = fmt::format("{:<33} {:>6}", "RMSE of held-out holes", "holes");
    for (const InterpolatorScore& score : choice.scores) text += fmt::format(" {:>17}", name_of(score.kind));
    for (std::size_t q = 0; q < choice.quantities.size(); ++q) {
        text += fmt::format("\n{:<33} {:>6}", choice.quantities[q], choice.held_out[q]);
        for (const InterpolatorScore& score : choice.scores) text += fmt::format(" {:>17.4g}", score.rmse[q]);
    }
    text += fmt::format("\n{:<33} {:>6}", "ratio, geometric mean", "");
    for (const InterpolatorScore& score : choice.scores) text += fmt::format(" {:>17.3f}", score.ratio);
    return text + "\nauto: " + choice.reason + "\n";
}

}  // namespace stratareeb
