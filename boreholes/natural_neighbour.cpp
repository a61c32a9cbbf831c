// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/natural_neighbour.h"

#include <algorithm>
#include <cmath>

namespace stratareeb {

namespace {

// A gradient is taken only from neighbours that spread in two directions; flatter sets (in terms of the
// normal matrix's determinant against its trace) say nothing across their line.
constexpr double kFlatSpread = 1e-6;

}  // namespace

NaturalNeighbour::NaturalNeighbour(std::shared_ptr<const HoleTriangulation> holes)
    : holes_(std::move(holes)), neighbours_(holes_->neighbours()) {}

std::vector<Point2> NaturalNeighbour::gradients(const SiteField& field) const {
    const auto& sites = holes_->sites();
    std::vector<Point2> gradient(sites.size());
    for (std::uint32_t i = 0; i < sites.size(); ++i) {
        if (!field.is_measured(i)) continue;
        double xx = 0, xy = 0, yy = 0, xv = 0, yv = 0;
        for (const std::uint32_t j : neighbours_[i]) {
            if (!field.is_measured(j)) continue;
            const double dx = sites[j].x - sites[i].x, dy = sites[j].y - sites[i].y;
            const double dv = field.value[j] - field.value[i];
            const double w = 1 / (dx * dx + dy * dy);
            xx += w * dx * dx, xy += w * dx * dy, yy += w * dy * dy;
            xv += w * dx * dv, yv += w * dy * dv;
        }
        const double determinant = xx * yy - xy * xy, trace = xx + yy;
        if (determinant <= kFlatSpread * trace * trace) continue;
        gradient[i] = {(yy * xv - xy * yv) / determinant, (xx * yv - xy * xv) / determinant};
    }
    return gradient;
}

// Notation of Sibson 1981: z0 the C0 interpolant, xi the blend of the sites' tangent planes.
double NaturalNeighbour::blend(const NaturalPlace& place, const SiteField& field,
                               const std::vector<Point2>& gradient) const {
    const auto& sites = holes_->sites();
    double share = 0, z0 = 0, xi = 0, over_r = 0, times_r = 0, times_r2 = 0, rise = 0;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& [site, weight] : place.weights) {
        if (!field.is_measured(site)) continue;
        const double dx = place.at.x - sites[site].x, dy = place.at.y - sites[site].y, r = std::hypot(dx, dy);
        const double value = field.value[site];
        const Point2& slope = gradient[site];
        share += weight;
        rise += weight * (slope.x * place.beyond.x + slope.y * place.beyond.y);
        low = std::min(low, value), high = std::max(high, value);
        if (r == 0) return value + slope.x * place.beyond.x + slope.y * place.beyond.y;
        z0 += weight * value;
        xi += weight / r * (value + slope.x * dx + slope.y * dy);
        over_r += weight / r;
        times_r += weight * r;
        times_r2 += weight * r * r;
    }
    if (share == 0) return 0;
    if (low == high) return low + rise / share;
    z0 /= share;
    xi /= over_r;
    const double alpha = times_r / over_r, beta = times_r2 / share;
    const double slack = (high - low) / 2;
    const double lowest = low > 0 ? std::max(low - slack, low / 2) : low - slack;
    const double value =
        std::clamp((alpha * z0 + beta * xi) / (alpha + beta), lowest, high + slack) + rise / share;
    return low > 0 ? std::max(value, low / 2) : value;
}

std::vector<std::vector<double>> NaturalNeighbour::predict(std::span<const Point2> where,
                                                           std::span<const SiteField> fields) const {
    std::vector<std::vector<Point2>> gradient;
    for (const SiteField& field : fields) gradient.push_back(gradients(field));
    std::vector<std::vector<double>> result(fields.size(), std::vector<double>(where.size()));
    holes_->for_each_natural_place(where, [&](std::size_t i, const NaturalPlace& place) {
        for (std::size_t f = 0; f < fields.size(); ++f) result[f][i] = blend(place, fields[f], gradient[f]);
    });
    return result;
}

}  // namespace stratareeb
