// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model_prediction.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include "boreholes/choose_interpolator.h"
#include "io/read_raster.h"

namespace stratareeb {

namespace {

std::string option(const std::map<std::string, std::string>& options, const std::string& name) {
    const auto found = options.find(name);
    return found == options.end() ? "" : found->second;
}

}  // namespace

CompletionOptions model_prediction(const Survey& survey, const std::map<std::string, std::string>& options) {
    CompletionOptions prediction;
    if (const std::string rule = option(options, "pinch_out"); !rule.empty())
        prediction.pinch_out = pinch_out_rule(rule);
    const std::string name = option(options, "interpolator");
    const auto kinds = interpolator_kinds();
    if (name == "auto")
        prediction.interpolator = choose_interpolator(survey, {.pinch_out = prediction.pinch_out}).kind;
    else if (std::ranges::any_of(kinds, [&](InterpolatorKind kind) { return name_of(kind) == name; }))
        prediction.interpolator = interpolator_kind(name);
    if (const std::string ground = option(options, "ground");
        !ground.empty() && std::filesystem::exists(ground)) {
        const auto raster = std::make_shared<Raster>(read_raster(ground));
        prediction.terrain = [raster](const Point2& p) { return raster->sample(p.x, p.y); };
    }
    return prediction;
}

}  // namespace stratareeb
