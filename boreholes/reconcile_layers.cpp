// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/reconcile_layers.h"

#include <algorithm>

namespace stratareeb {

namespace {

constexpr double kLeastError =
    1e-6;  // of the largest error; weights go with its square, and 0 would be an infinite one

std::vector<double> inverse_squares(std::span<const RatedPrediction> predictions, double least) {
    std::vector<double> result;
    for (const RatedPrediction& p : predictions) {
        const double error = std::max(p.error, least);
        result.push_back(1 / (error * error));
    }
    return result;
}

//! Cholesky's factor of the tridiagonal matrix of the sums E_i of corrections.
class Corrections {
 public:
    Corrections(const std::vector<double>& thickness_weight, const std::vector<double>& depth_weight)
        : depth_weight_(depth_weight) {
        const std::size_t n = thickness_weight.size();
        pivot_.resize(n), below_.resize(n, 0.0);
        for (std::size_t i = 0; i < n; ++i) {
            pivot_[i] = thickness_weight[i] + (i > 0 ? depth_weight[i] : 0) +
                        (i + 1 < n ? thickness_weight[i + 1] : 0);
            if (i == 0) continue;
            below_[i] = -thickness_weight[i] / pivot_[i - 1];
            pivot_[i] += below_[i] * thickness_weight[i];
        }
    }

    //! In: what each depth exceeds the sum of thicknesses by. Out: what to add to each sum.
    void solve(std::vector<double>& excess) const {
        const std::size_t n = pivot_.size();
        for (std::size_t i = 1; i < n; ++i)
            excess[i] = depth_weight_[i] * excess[i] - below_[i] * excess[i - 1];
        for (std::size_t i = n; i-- > 0;) {
            excess[i] /= pivot_[i];
            if (i + 1 < n) excess[i] -= below_[i + 1] * excess[i + 1];
        }
    }

 private:
    std::vector<double> depth_weight_, pivot_, below_;
};

}  // namespace

std::vector<std::vector<double>> reconcile_layers(std::span<const RatedPrediction> thickness,
                                                  std::span<const RatedPrediction> depth) {
    std::vector<std::vector<double>> result;
    double largest = 0;
    for (std::size_t i = 0; i < thickness.size(); ++i) {
        result.push_back(thickness[i].value);
        largest = std::max({largest, thickness[i].error, i > 0 ? depth[i].error : 0});
    }
    if (result.size() < 2 || !(largest > 0)) return result;
    const double least = kLeastError * largest;
    const Corrections corrections(inverse_squares(thickness, least), inverse_squares(depth, least));
    std::vector<double> excess(result.size());
    for (std::size_t p = 0; p < result[0].size(); ++p) {
        double sum = 0;
        for (std::size_t i = 0; i < result.size(); ++i) {
            sum += result[i][p];
            excess[i] = i > 0 ? depth[i].value[p] - sum : 0;
        }
        corrections.solve(excess);
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i][p] += excess[i] - (i > 0 ? excess[i - 1] : 0);
    }
    return result;
}

}  // namespace stratareeb
