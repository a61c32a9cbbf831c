// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_step.h"

#include <Standard_Failure.hxx>

#include <fmt/format.h>

#include "boreholes/errors.h"
#include "io/faceted_bodies.h"
#include "io/smooth_bodies.h"
#include "io/step_document.h"

namespace stratareeb {
namespace {

StepReport report_of(const std::vector<CadBody>& bodies) {
    StepReport report{.solids = bodies.size()};
    for (const auto& body : bodies) report.faces += count_faces(*body.solid);
    return report;
}

// OpenCASCADE's failures become ours, with the file's name.
template <typename Work>
auto translated(const std::filesystem::path& path, const Work& work) {
    try {
        return work();
    } catch (const Standard_Failure& e) {
        throw GeometryError(fmt::format("{}: OpenCASCADE: {}", path.string(), e.GetMessageString()));
    }
}

}  // namespace

StepReport write_step(const std::filesystem::path& path, std::span<const LayerSolid> solids,
                      const StepOptions& options) {
    return translated(path, [&] {
        std::vector<CadBody> bodies;
        for (const auto& layer : solids)
            for (auto& body : faceted_bodies(layer)) bodies.push_back(std::move(body));
        write_step_document(path, bodies, {.length_unit = options.length_unit, .origin = options.origin});
        return report_of(bodies);
    });
}

StepReport write_smooth_step(const std::filesystem::path& path, const LayerModel& model,
                             const SmoothBodiesOptions& options) {
    return translated(path, [&] {
        auto smooth = smooth_bodies(model, options);
        write_step_document(
            path, smooth.bodies,
            {.length_unit = model.length_unit, .origin = model.origin, .has_parameter_curves = true});
        StepReport report = report_of(smooth.bodies);
        report.bodies = std::move(smooth.reports);
        report.notes = std::move(smooth.notes);
        return report;
    });
}

}  // namespace stratareeb
