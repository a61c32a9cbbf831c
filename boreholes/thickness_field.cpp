// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/thickness_field.h"

#include <algorithm>

namespace stratareeb {

ThicknessField::ThicknessField(std::shared_ptr<const HoleTriangulation> holes,
                               std::vector<std::vector<double>> thickness, PinchOutRule rule,
                               std::unique_ptr<Interpolator> interpolator,
                               const std::vector<std::vector<char>>& known)
    : holes_(std::move(holes)),
      thickness_(std::move(thickness)),
      known_(known),
      rule_(rule),
      interpolator_(std::move(interpolator)) {
    for (const auto& layer : thickness_) {
        if (known.empty()) known_.emplace_back(layer.size(), static_cast<char>(1));
        auto& present = present_.emplace_back(layer.size());
        std::ranges::transform(layer, present.begin(), [](double t) { return static_cast<char>(t > 0); });
        auto& say = has_say_.emplace_back(present);
        if (!known.empty())
            std::ranges::transform(present, known[has_say_.size() - 1], say.begin(),
                                   [](char there, char sure) { return static_cast<char>(there && sure); });
    }
}

// All corners alike give exactly 0 or 1, so that amid equal holes no rounding draws a line.
double ThicknessField::share(std::size_t layer, const PlanLocation& location) const {
    double have = 0, lack = 0;
    for (int k = 0; k < 3; ++k) (has(layer, location.site[k]) ? have : lack) += location.weight[k];
    return lack == 0 ? 1.0 : have;
}

double ThicknessField::taper(std::size_t layer, const PlanLocation& location) const {
    const double inside = share(layer, location);
    return inside < 1 ? std::max(0.0, (inside - rule_.fraction) / (1 - rule_.fraction)) : 1.0;
}

bool ThicknessField::is_present(std::size_t layer, const PlanLocation& location) const {
    return share(layer, location) > rule_.fraction;
}

// Where none of the interpolator's sites around a place has the layer, though it is there: the mean of the
// corners that do.
double ThicknessField::mean_of_present(std::size_t layer, const PlanLocation& location) const {
    double sum = 0, weight = 0;
    for (int k = 0; k < 3; ++k) {
        if (!has(layer, location.site[k])) continue;
        sum += location.weight[k] * thickness_[layer][location.site[k]];
        weight += location.weight[k];
    }
    return weight > 0 ? sum / weight : 0.0;
}

std::vector<std::vector<double>> ThicknessField::predict(std::span<const Point2> where) const {
    std::vector<SiteField> fields;
    for (std::size_t i = 0; i < layers(); ++i) fields.push_back({thickness_[i], has_say_[i]});
    const std::vector<PlanLocation> locations = holes_->locate(where);
    std::vector<std::vector<double>> tapers(layers(), std::vector<double>(where.size()));
    for (std::size_t i = 0; i < layers(); ++i)
        for (std::size_t p = 0; p < where.size(); ++p) tapers[i][p] = taper(i, locations[p]);
    auto result = interpolator_->predict_layers(where, {fields, known_, tapers});
    for (std::size_t i = 0; i < layers(); ++i)
        for (std::size_t p = 0; p < where.size(); ++p) {
            const double share = tapers[i][p];
            if (share > 0 && result[i][p] == 0) result[i][p] = mean_of_present(i, locations[p]);
            if (share < 1) result[i][p] *= share;
        }
    return result;
}

}  // namespace stratareeb
