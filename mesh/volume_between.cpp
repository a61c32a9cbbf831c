// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/volume_between.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boreholes/errors.h"
#include "mesh/clamped_mean.h"
#include "mesh/compensated_sum.h"
#include "mesh/plan_pieces.h"

namespace stratareeb {

namespace {

void check_range(const std::optional<std::array<double, 2>>& range, const char* what) {
    if (range && !((*range)[0] < (*range)[1] && std::isfinite((*range)[0]) && std::isfinite((*range)[1])))
        throw InvalidInput(fmt::format("{} from {} to {}: give two numbers, the smaller first", what,
                                       (*range)[0], (*range)[1]));
}

using Values = std::array<double, 3>;

//! Mean over a piece of the layer's thickness in the window; elevations relative to the model's origin.
double mean_thickness(const VolumeWindow& window, double origin_z, const Values& ground, const Values& top,
                      const Values& base) {
    if (window.elevations)
        return mean_thickness_between(base, top, (*window.elevations)[0] - origin_z,
                                      (*window.elevations)[1] - origin_z);
    if (window.depths) {
        Values upper{}, lower{};
        for (std::size_t i = 0; i < 3; ++i) {
            upper[i] = ground[i] - top[i];
            lower[i] = ground[i] - base[i];
        }
        return mean_thickness_between(upper, lower, (*window.depths)[0], (*window.depths)[1]);
    }
    return ((top[0] - base[0]) + (top[1] - base[1]) + (top[2] - base[2])) / 3;
}

}  // namespace

double VolumeWindow::thickness(double ground, double top, double base) const {
    if (elevations) return std::max(0.0, std::min(top, (*elevations)[1]) - std::max(base, (*elevations)[0]));
    if (depths)
        return std::max(0.0, std::min(ground - base, (*depths)[1]) - std::max(ground - top, (*depths)[0]));
    return top - base;
}

double WindowVolumes::area() const {
    CompensatedSum sum;
    for (const double a : plan_area) sum.add(a);
    return sum.value();
}

WindowVolumes volumes_between(const LayerModel& model, const VolumeWindow& window) {
    check_range(window.elevations, "elevations");
    check_range(window.depths, "depths");
    if (window.elevations && window.depths)
        throw InvalidInput("elevations and depths together: give one of them");
    WindowVolumes result{.layers = {}, .plan_area = std::vector<double>(model.plan.surface.n_faces(), 0.0)};
    std::vector<CompensatedSum> sums(model.units.size());
    std::vector<Values> horizons(model.horizons.size());
    auto current = ~0u;
    for_each_piece(model, window.areas, [&](const PlanPiece& piece) {
        if (piece.face != current) {
            current = piece.face;
            std::size_t i = 0;
            for (const auto v :
                 model.plan.surface.fv_range(TriMesh::FaceHandle(static_cast<int>(piece.face)))) {
                for (std::size_t k = 0; k < horizons.size(); ++k)
                    horizons[k][i] = model.horizons[k][static_cast<std::size_t>(v.idx())];
                ++i;
            }
        }
        result.plan_area[piece.face] += piece.area;
        const Values ground = piece.values(horizons[0]);
        Values top = ground;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const Values base = piece.values(horizons[i + 1]);
            if (model.regions.in_face[piece.face][i])
                sums[i].add(piece.area * mean_thickness(window, model.origin.z, ground, top, base));
            top = base;
        }
    });
    for (const CompensatedSum& sum : sums) result.layers.push_back(sum.value());
    return result;
}

}  // namespace stratareeb
