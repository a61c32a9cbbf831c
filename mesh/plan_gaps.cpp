// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/plan_gaps.h"

#include <cmath>
#include <numeric>

#include "boreholes/nearest_sites.h"

namespace stratareeb {

std::vector<double> plan_gaps(const LayerModel& model, std::span<const Point2> sites,
                              std::span<const double> areas) {
    constexpr double kParts = 1000;
    const double part = std::accumulate(areas.begin(), areas.end(), 0.0) / kParts;
    if (!(part > 0)) return {};
    const NearestSites nearest(sites);
    std::vector<double> gaps;
    std::vector<NearSite> found;
    double sum = part / 2;
    for (const auto f : model.plan.surface.faces()) {
        sum += areas[static_cast<std::size_t>(f.idx())];
        if (!(sum >= part)) continue;
        const auto middle = model.plan.surface.calc_face_centroid(f);
        nearest.nearest({middle[0] + model.origin.x, middle[1] + model.origin.y}, 1, found);
        for (; sum >= part; sum -= part) gaps.push_back(std::sqrt(found[0].squared_distance));
    }
    return gaps;
}

}  // namespace stratareeb
