// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/analytic_truth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stratareeb {
namespace {

using std::numbers::pi;

double sum(const std::vector<Wave>& waves, double x, double y) {
    double total = 0;
    for (const Wave& wave : waves)
        total += wave.amplitude * std::sin(wave.kx * x + wave.px) * std::sin(wave.ky * y + wave.py);
    return total;
}

//! Integral of sin(k t + p) for t from 0 to length, k > 0.
double integral_of_sine(double k, double p, double length) {
    return (std::cos(p) - std::cos(k * length + p)) / k;
}

double integral(const std::vector<Wave>& waves, double extent) {
    double total = 0;
    for (const Wave& wave : waves)
        total += wave.amplitude * integral_of_sine(wave.kx, wave.px, extent) *
                 integral_of_sine(wave.ky, wave.py, extent);
    return total;
}

double rise(double at, double from, double to) {
    return std::clamp((at - from) / (to - from), 0.0, 1.0);
}

}  // namespace

double AnalyticTruth::ground(Point2 at) const {
    const double x = at.x - corner.x, y = at.y - corner.y, half = extent / 2;
    const double r = std::hypot(x - half, y - half) / half;
    return level + slope_x * x + slope_y * y + dome_height * (1 - r * r) + sum(ground_waves, x, y);
}

double AnalyticTruth::thickness(std::size_t layer, Point2 at) const {
    const TrueThickness& field = layers.at(layer);
    const double x = at.x - corner.x, y = at.y - corner.y;
    const double r = std::hypot(x - field.center.x, y - field.center.y);
    switch (field.shape) {
        case TrueThickness::Shape::Even:
            return field.thickness * (1 + sum(field.waves, x, y));
        case TrueThickness::Shape::Ramp:
            return field.thickness * rise(field.mirrored ? extent - x : x, field.inner, field.outer);
        case TrueThickness::Shape::Cone:
            return field.thickness * std::max(0.0, 1 - r / field.outer);
        case TrueThickness::Shape::Window:
            return field.thickness * rise(r, field.inner, field.outer);
    }
    return 0;
}

double AnalyticTruth::volume(std::size_t layer) const {
    const TrueThickness& field = layers.at(layer);
    const double area = extent * extent, a = field.inner, b = field.outer;
    switch (field.shape) {
        case TrueThickness::Shape::Even:
            return field.thickness * (area + integral(field.waves, extent));
        case TrueThickness::Shape::Ramp:
            return field.thickness * extent * (extent - (a + b) / 2);
        case TrueThickness::Shape::Cone:
            return field.thickness * pi * b * b / 3;
        case TrueThickness::Shape::Window:  // the opening is a frustum of a cone
            return field.thickness * (area - pi * (a * a + a * b + b * b) / 3);
    }
    return 0;
}

}  // namespace stratareeb
