// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/homotopy.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "boreholes/errors.h"
#include "reeb/joint_parameters.h"
#include "reeb/point_math.h"

namespace stratareeb {
namespace {

constexpr std::size_t kDistanceSamples = 256;  // of a contour, for the mean distance to the next

std::vector<double> places_of(const std::vector<double>& heights, const HeightScale& scale) {
    std::vector<double> places;
    for (const double height : heights) places.push_back(scale.place(height));
    return places;
}

}  // namespace

ContourHomotopy::ContourHomotopy(std::vector<SampledContour> contours, const std::vector<double>& heights,
                                 const HomotopyOptions& options)
    : ContourHomotopy(std::move(contours), heights, heights, options) {}

ContourHomotopy::ContourHomotopy(std::vector<SampledContour> contours, const std::vector<double>& heights,
                                 const HomotopyOptions& options, const HeightScale& scale)
    : ContourHomotopy(std::move(contours), places_of(heights, scale), heights, options) {
    scale_ = scale;
}

ContourHomotopy::ContourHomotopy(std::vector<SampledContour> contours, std::vector<double> places,
                                 std::vector<double> levels, const HomotopyOptions& options)
    : contours_(std::move(contours)), levels_(std::move(levels)), weights_(std::move(places), options) {
    if (contours_.size() != levels_.size() || weights_.places().size() != levels_.size()) {
        throw InvalidInput(
            fmt::format("homotopy: {} contours with {} places and {} heights (expected one each)",
                        contours_.size(), weights_.places().size(), levels_.size()));
    }
    for (const auto& contour : contours_) {
        check_contour(contour);
        means_.push_back({mean_point(contour)});
    }
}

double ContourHomotopy::level(std::size_t interval, double t) const {
    const double low = levels_[interval], high = levels_[interval + 1];
    if (t <= 0 || t >= 1) return t <= 0 ? low : high;
    if (!scale_) return low + t * (high - low);
    const double below = places()[interval], above = places()[interval + 1];
    return std::clamp(scale_->height(below + t * (above - below)), low, high);
}

//! Sums of corresponding points, as differences from those of the lower contour: far from the origin nothing is lost.
//! `given[i]`: the points of contour i, for each i that has a weight.
std::vector<Point3> ContourHomotopy::mixed(std::size_t interval, double t,
                                           std::span<const ContourWeight> weights,
                                           std::span<const std::vector<Point3>> given) const {
    if (weights.size() == 1) return given[weights[0].contour];
    const auto& base = given[interval];
    auto sums = base;
    for (Point3& p : sums) p.z = level(interval, t);
    for (const auto& [i, weight] : weights) {
        const auto& points = given[i];
        const double height = levels_[i];
        for (std::size_t k = 0; k < sums.size(); ++k) {
            sums[k].x += weight * (points[k].x - base[k].x);
            sums[k].y += weight * (points[k].y - base[k].y);
            sums[k].z += weight * (points[k].z - height);
        }
    }
    return sums;
}

Point3 ContourHomotopy::at(double s, std::size_t interval, double t) const {
    return contour_at(std::span(&s, 1), interval, t).front();
}

Point3 ContourHomotopy::mean(std::size_t interval, double t) const {
    return mixed(interval, t, weights_.at(interval, t), means_).front();
}

std::vector<Point3> ContourHomotopy::contour_at(std::span<const double> s, std::size_t interval,
                                                double t) const {
    return std::move(contours_at(s, interval, std::span(&t, 1)).front().points);
}

//! Every contour in play is brought to the parameters once for all t.
std::vector<SampledContour> ContourHomotopy::contours_at(std::span<const double> s, std::size_t interval,
                                                         std::span<const double> t) const {
    std::vector<std::vector<Point3>> given(contours_.size());
    std::vector<SampledContour> result;
    for (const double share : t) {
        const auto weights = weights_.at(interval, share);
        for (const auto& part : weights) {
            if (given[part.contour].empty()) given[part.contour] = points_at(contours_[part.contour], s);
        }
        result.push_back({mixed(interval, share, weights, given), {s.begin(), s.end()}});
    }
    return result;
}

std::vector<double> ContourHomotopy::parameters_near(std::size_t interval, double t) const {
    const SampledContour &low = contours_[interval], &high = contours_[interval + 1];
    if (t <= 0) return low.parameters;
    if (t >= 1) return high.parameters;
    if (low.points.size() == 1) return high.parameters;
    if (high.points.size() == 1) return low.parameters;
    return t < 0.5 ? joint_parameters(low, high) : joint_parameters(high, low);
}

SampledContour ContourHomotopy::contour(std::size_t interval, double t) const {
    return std::move(contours_at(parameters_near(interval, t), interval, std::span(&t, 1)).front());
}

std::vector<SampledContour> ContourHomotopy::contours_between(std::size_t interval, std::size_t steps) const {
    std::vector<double> low, high;  // shares of the interval
    for (std::size_t i = 1; i < steps; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(steps);
        (t < 0.5 ? low : high).push_back(t);
    }
    std::vector<SampledContour> result;
    for (const auto& shares : {low, high}) {
        if (shares.empty()) continue;
        auto rows = contours_at(parameters_near(interval, shares.front()), interval, shares);
        result.insert(result.end(), std::make_move_iterator(rows.begin()),
                      std::make_move_iterator(rows.end()));
    }
    return result;
}

HomotopyPlace homotopy_place(std::span<const double> places, double place) {
    if (places.size() < 2 || !(place >= places.front() && place <= places.back())) {
        throw InvalidInput(fmt::format("homotopy: nothing at {} (the contours run from {} to {})", place,
                                       places.empty() ? 0 : places.front(),
                                       places.empty() ? 0 : places.back()));
    }
    const auto above = std::upper_bound(places.begin() + 1, places.end() - 1, place);
    const auto i = static_cast<std::size_t>(above - places.begin()) - 1;
    return {i, (place - places[i]) / (places[i + 1] - places[i])};
}

ContourHomotopy horizontal_homotopy(std::vector<SampledContour> contours, const HomotopyOptions& options) {
    for (const auto& contour : contours) check_contour(contour);
    std::vector<double> places, levels;
    for (std::size_t i = 0; i < contours.size(); ++i) {
        const double z = contours[0].points[0].z;
        for (const Point3& p : contours[i].points) {
            if (p.z == z) continue;
            throw InvalidInput(
                fmt::format("homotopy: contour {} has a point at z = {}, the first contour is at {} "
                            "(expected all at one height)",
                            i, p.z, z));
        }
        levels.push_back(z);
        places.push_back(i == 0 ? 0
                                : places.back() + mean_distance(contours[i - 1], contours[i],
                                                                even_parameters(kDistanceSamples)));
    }
    return {std::move(contours), std::move(places), std::move(levels), options};
}

}  // namespace stratareeb
