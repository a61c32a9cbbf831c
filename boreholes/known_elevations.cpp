// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/known_elevations.h"

#include <algorithm>
#include <memory>

namespace stratareeb {

std::vector<std::vector<std::optional<double>>> known_elevations(const Survey& survey,
                                                                 std::span<const double> ground) {
    std::vector<std::vector<std::optional<double>>> known;
    for (std::size_t h = 0; h < survey.holes.size(); ++h) {
        const Borehole& hole = survey.holes[h];
        auto& z = known.emplace_back(survey.units.size() + 1);
        for (std::size_t k = 0; k < z.size(); ++k) {
            if (k < hole.horizons.size()) z[k] = hole.horizons[k];
            if (survey.contact_points || z[k]) continue;
            if (k == 0)
                z[k] = ground[h];
            else if (z[k - 1] && hole.layers[k - 1].knowledge == Knowledge::Measured)
                z[k] = *z[k - 1] - hole.layers[k - 1].thickness;
        }
    }
    return known;
}

std::vector<double> completed_elevations(std::span<const Point2> sites,
                                         std::span<const std::optional<double>> known, InterpolatorKind kind,
                                         std::span<const std::optional<double>> lowest) {
    std::vector<Point2> at, missing_at;
    std::vector<double> value, result(sites.size());
    std::vector<std::size_t> missing;
    for (std::size_t h = 0; h < sites.size(); ++h) {
        if (known[h]) {
            result[h] = *known[h];
            at.push_back(sites[h]);
            value.push_back(*known[h]);
        } else {
            missing.push_back(h);
            missing_at.push_back(sites[h]);
        }
    }
    if (missing.empty()) return result;
    std::vector<char> at_least(at.size(), 0);
    for (const std::size_t h : missing)
        if (!lowest.empty() && lowest[h] && takes_bounds(kind)) {
            at.push_back(sites[h]), value.push_back(*lowest[h]);
            at_least.push_back(1);
        }
    const auto interpolator = make_interpolator(kind, std::make_shared<HoleTriangulation>(at));
    const auto predicted =
        interpolator->predict(missing_at, std::vector<SiteField>{{value, {}, at_least}})[0];
    for (std::size_t m = 0; m < missing.size(); ++m) {
        const std::size_t h = missing[m];
        result[h] = lowest.empty() || !lowest[h] ? predicted[m] : std::max(predicted[m], *lowest[h]);
    }
    return result;
}

}  // namespace stratareeb
