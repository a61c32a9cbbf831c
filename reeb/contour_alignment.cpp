// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/contour_alignment.h"

#include <cmath>

#include "reeb/point_math.h"

namespace stratareeb {

namespace {

constexpr std::size_t kPlaces = 128;  // shifts that are tried, and places compared for each

std::vector<Point3> centred_places(const SampledContour& contour) {
    std::vector<Point3> places = points_at(contour, even_parameters(kPlaces));
    const Point3 center = mean_point(contour);
    for (Point3& p : places) p = p - center;
    return places;
}

//! The sum over places of f(i) . g(i + shift): the greater, the closer they are.
double likeness(const std::vector<Point3>& f, const std::vector<Point3>& g, std::size_t shift) {
    double sum = 0;
    for (std::size_t i = 0; i < kPlaces; ++i) sum += dot_product(f[i], g[(i + shift) % kPlaces]);
    return sum;
}

}  // namespace

double aligned_origin(const SampledContour& first, const SampledContour& second) {
    const std::vector<Point3> f = centred_places(first), g = centred_places(second);
    std::vector<double> likenesses;
    std::size_t best = 0;
    for (std::size_t shift = 0; shift < kPlaces; ++shift) {
        likenesses.push_back(likeness(f, g, shift));
        if (likenesses[shift] > likenesses[best]) best = shift;
    }
    // Between the shifts tried: the top of the parabola through the best and its neighbours.
    const double before = likenesses[(best + kPlaces - 1) % kPlaces],
                 after = likenesses[(best + 1) % kPlaces];
    const double bend = before - 2 * likenesses[best] + after;
    const double beside = bend < 0 ? 0.5 * (before - after) / bend : 0;
    return (static_cast<double>(best) + beside) / static_cast<double>(kPlaces);
}

std::vector<SampledContour> aligned_contours(std::vector<SampledContour> contours) {
    for (std::size_t i = 1; i < contours.size(); ++i)
        contours[i] = with_origin(contours[i], aligned_origin(contours[i - 1], contours[i]));
    return contours;
}

}  // namespace stratareeb
