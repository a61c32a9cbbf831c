// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/gauss_rule.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace stratareeb {
namespace {

constexpr std::size_t kMostPoints = 61;

// Roots of the n-th polynomial of Legendre, by Newton's method.
GaussRule roots_of_legendre(std::size_t n) {
    GaussRule rule;
    for (std::size_t k = 0; k < n; ++k) {
        double x =
            std::cos(std::numbers::pi * (static_cast<double>(k) + 0.75) / (static_cast<double>(n) + 0.5));
        double slope = 1;
        for (int step = 0; step < 100; ++step) {
            double before = 1, here = x;
            for (std::size_t i = 2; i <= n; ++i) {
                const auto m = static_cast<double>(i);
                before = std::exchange(here, ((2 * m - 1) * x * here - (m - 1) * before) / m);
            }
            slope = static_cast<double>(n) * (x * here - before) / (x * x - 1);
            const double by = here / slope;
            x -= by;
            if (std::abs(by) < 1e-15) break;
        }
        rule.places.push_back((1 - x) / 2);
        rule.weights.push_back(1 / ((1 - x * x) * slope * slope));
    }
    return rule;
}

}  // namespace

const GaussRule& gauss_rule(std::size_t points) {
    static const std::vector<GaussRule> rules = [] {
        std::vector<GaussRule> all(1);
        for (std::size_t k = 1; k <= kMostPoints; ++k) all.push_back(roots_of_legendre(k));
        return all;
    }();
    return rules.at(points);
}

}  // namespace stratareeb
