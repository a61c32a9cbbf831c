// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/layer_volumes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "boreholes/errors.h"
#include "mesh/compensated_sum.h"

namespace stratareeb {

std::vector<double> layer_volumes(const LayerModel& model) {
    std::vector<CompensatedSum> sums(model.units.size());
    const auto& mesh = model.plan.surface;
    for (const auto face : mesh.faces()) {
        const double area = mesh.calc_face_area(face);
        for (std::size_t i = 0; i < sums.size(); ++i) {
            double thickness = 0;
            for (const auto v : mesh.fv_range(face))
                thickness += model.thickness(i, static_cast<std::size_t>(v.idx()));
            sums[i].add(area * thickness / 3);
        }
    }
    std::vector<double> volumes;
    for (const CompensatedSum& sum : sums) volumes.push_back(sum.value());
    return volumes;
}

ComparedModel compare_volumes(const std::string& name, const Survey& survey, const TrueVolumes& truth,
                              LayerModelOptions options) {
    ComparedModel result{
        .name = name, .holes = survey.holes.size(), .volumes = std::vector(truth.codes.size(), 0.0)};
    options.footprint = truth.footprint;
    const LayerModel model = build_layer_model(survey, options);
    const std::vector<double> volumes = layer_volumes(model);
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        const auto found = std::ranges::find(truth.codes, model.units[i].code);
        if (found == truth.codes.end())
            throw InvalidInput(fmt::format("{}: the truth has no layer '{}'; it has {}", name,
                                           model.units[i].code, fmt::join(truth.codes, ", ")));
        result.volumes[static_cast<std::size_t>(found - truth.codes.begin())] = volumes[i];
    }
    result.envelope = envelope_volume(model);
    return result;
}

}  // namespace stratareeb
