// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/reconcile_layers.h"

#include <algorithm>
#include <cmath>

namespace stratareeb {

namespace {

constexpr double kMostError = 1e9;  // of the smallest error above 0: as good as useless

//! What errors count as at most, so that their squares can be added: a fit may have broken down at a left-out site.
double most_error(std::span<const RatedPrediction> thickness, std::span<const RatedPrediction> depth) {
    double least = HUGE_VAL;
    for (const auto& predictions : {thickness, depth})
        for (const RatedPrediction& p : predictions)
            if (p.error > 0) least = std::min(least, p.error);
    return std::isfinite(least) ? kMostError * least : 1;
}

double variance_at(const RatedPrediction& prediction, double most, std::size_t place) {
    const double whole = prediction.error <= most ? prediction.error : most;  // most if it is no number
    const double error = whole * (prediction.share.empty() ? 1.0 : prediction.share[place]);
    return error * error;
}

//! What to add to the sums of layers in one column, from what the depths exceed them by.
class Corrections {
 public:
    explicit Corrections(std::size_t layers)
        : step_(layers), excess_(layers), depth_(layers), sum_(layers), variance_(layers) {}

    //! The variances of a layer, and of the depth of its base, which exceeds the sum of thicknesses by so much.
    void set(std::size_t layer, double step, double excess, double depth) {
        step_[layer] = step, excess_[layer] = excess, depth_[layer] = depth;
    }

    const std::vector<double>& solve() {
        walk_down();
        walk_up();
        return sum_;
    }

 private:
    void walk_down() {
        double sum = 0, variance = step_[0];
        for (std::size_t i = 0; i < step_.size(); ++i) {
            if (i > 0) {
                variance += step_[i];
                const double both = variance + depth_[i];
                const double gain = both > 0 ? variance / both : 0;
                sum += gain * (excess_[i] - sum);
                variance *= 1 - gain;
            }
            sum_[i] = sum, variance_[i] = variance;
        }
    }

    void walk_up() {
        for (std::size_t i = sum_.size() - 1; i-- > 0;) {
            const double ahead = variance_[i] + step_[i + 1];
            if (ahead > 0) sum_[i] += variance_[i] / ahead * (sum_[i + 1] - sum_[i]);
        }
    }

    std::vector<double> step_, excess_, depth_, sum_, variance_;
};

}  // namespace

std::vector<std::vector<double>> reconcile_layers(std::span<const RatedPrediction> thickness,
                                                  std::span<const RatedPrediction> depth) {
    std::vector<std::vector<double>> result;
    for (const RatedPrediction& layer : thickness) result.push_back(layer.value);
    if (result.size() < 2) return result;
    const double most = most_error(thickness, depth);
    Corrections corrections(result.size());
    for (std::size_t p = 0; p < result[0].size(); ++p) {
        double sum = 0;
        for (std::size_t i = 0; i < result.size(); ++i) {
            sum += result[i][p];
            const double excess = i > 0 ? depth[i].value[p] - sum : 0;
            corrections.set(i, variance_at(thickness[i], most, p), excess,
                            i > 0 ? variance_at(depth[i], most, p) : 0);
        }
        const std::vector<double>& moved = corrections.solve();
        for (std::size_t i = 0; i < result.size(); ++i) result[i][p] += moved[i] - (i > 0 ? moved[i - 1] : 0);
    }
    return result;
}

}  // namespace stratareeb
