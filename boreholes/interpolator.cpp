// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/interpolator.h"

#include <string>

#include "boreholes/errors.h"
#include "boreholes/linear_tin.h"
#include "boreholes/natural_neighbour.h"

namespace stratareeb {

InterpolatorKind interpolator_kind(std::string_view name) {
    if (name == "linear") return InterpolatorKind::Linear;
    if (name == "natural") return InterpolatorKind::NaturalNeighbour;
    throw InvalidInput("unknown interpolator '" + std::string(name) + "' (expected linear or natural)");
}

std::unique_ptr<Interpolator> make_interpolator(InterpolatorKind kind,
                                                std::shared_ptr<const HoleTriangulation> holes) {
    if (kind == InterpolatorKind::Linear) return std::make_unique<LinearTin>(std::move(holes));
    return std::make_unique<NaturalNeighbour>(std::move(holes));
}

}  // namespace stratareeb
