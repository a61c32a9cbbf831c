// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/cubic_knots.h"

#include <algorithm>

namespace stratareeb {

CubicKnots::CubicKnots(std::vector<double> breaks) : breaks_(std::move(breaks)) {
    knots_.assign(3, breaks_.front());
    knots_.insert(knots_.end(), breaks_.begin(), breaks_.end());
    knots_.insert(knots_.end(), 3, breaks_.back());
}

CubicKnots CubicKnots::uniform(double low, double high, std::size_t spans) {
    std::vector<double> breaks;
    for (std::size_t i = 0; i < spans; ++i)
        breaks.push_back(low + (high - low) * static_cast<double>(i) / static_cast<double>(spans));
    breaks.push_back(high);
    return CubicKnots(std::move(breaks));
}

std::size_t CubicKnots::span(double t) const {
    const auto it = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, t);
    return static_cast<std::size_t>(it - breaks_.begin()) - 1;
}

CubicKnots::Values CubicKnots::values(double t, int derivative) const {
    const std::size_t i = span(t);
    const double* u = knots_.data() + i + 3;  // u[0] <= t < u[1]
    Values result{.first = i, .value = {1, 0, 0, 0}};
    auto& N = result.value;
    const int raised = 3 - derivative;
    for (int p = 1; p <= raised; ++p) {  // Cox and de Boor: from degree p - 1 to p
        double saved = 0;
        for (int r = 0; r < p; ++r) {
            const double right = u[r + 1] - t, left = t - u[r + 1 - p];
            const double share = N[r] / (right + left);
            N[r] = saved + right * share;
            saved = left * share;
        }
        N[p] = saved;
    }
    for (int p = raised + 1; p <= 3; ++p) {  // N'_p,k = p (N_p-1,k / width - N_p-1,k+1 / next width)
        double saved = 0;
        for (int r = 0; r < p; ++r) {
            const double share = p * N[r] / (u[r + 1] - u[r + 1 - p]);
            N[r] = saved - share;
            saved = share;
        }
        N[p] = saved;
    }
    return result;
}

double CubicKnots::evaluate(const std::vector<double>& coefficients, double t, int derivative) const {
    const Values v = values(t, derivative);
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k) sum += v.value[k] * coefficients[v.first + k];
    return sum;
}

std::vector<double> CubicKnots::greville() const {
    std::vector<double> result;
    for (std::size_t i = 0; i < functions(); ++i)
        result.push_back((knots_[i + 1] + knots_[i + 2] + knots_[i + 3]) / 3);
    // The ends exactly: a third of three times a number may be another one.
    result.front() = low();
    result.back() = high();
    return result;
}

CubicKnots CubicKnots::part(double low, double high) const {
    const auto first = breaks_.begin();
    return CubicKnots({first + static_cast<std::ptrdiff_t>(span(low)),
                       first + static_cast<std::ptrdiff_t>(span(high)) + 2});
}

CubicKnots CubicKnots::refined(const std::vector<char>& halve) const {
    std::vector<double> breaks;
    for (std::size_t i = 0; i < spans(); ++i) {
        breaks.push_back(breaks_[i]);
        if (halve[i]) breaks.push_back((breaks_[i] + breaks_[i + 1]) / 2);
    }
    breaks.push_back(high());
    return CubicKnots(std::move(breaks));
}

}  // namespace stratareeb
