// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/cubic_knots.h"

#include <algorithm>

namespace stratareeb {
namespace {

constexpr std::size_t kBucketsASpan = 2;

}  // namespace

CubicKnots::CubicKnots(std::vector<double> breaks) : breaks_(std::move(breaks)) {
    knots_.assign(3, breaks_.front());
    knots_.insert(knots_.end(), breaks_.begin(), breaks_.end());
    knots_.insert(knots_.end(), 3, breaks_.back());
    for (std::size_t s = 0; s < spans(); ++s) pieces_.push_back(piece(s));
    last_.resize(kBucketsASpan * spans());
    buckets_a_unit_ = static_cast<double>(last_.size()) / (high() - low());
    for (std::size_t k = 0, s = 0; k < last_.size(); ++k) {
        while (s + 1 < spans() && bucket(breaks_[s + 1]) <= k) ++s;
        last_[k] = s;
    }
}

// By the recurrence of Cox and de Boor, from degree p - 1 to p, of polynomials.
CubicKnots::Piece CubicKnots::piece(std::size_t span) const {
    const double* u = knots_.data() + span + 3;
    const double width = u[1] - u[0];
    std::array<std::array<double, 4>, 4> N{};  // [function][power]
    N[0][0] = 1;
    for (std::size_t p = 1; p <= 3; ++p) {
        std::array<double, 4> saved{};
        for (std::size_t r = 0; r < p; ++r) {
            const double right = u[r + 1] - u[0], left = u[0] - *(u + r + 1 - p);  // at s = 0
            std::array<double, 4> next = saved;
            for (std::size_t k = 0; k <= p; ++k) {
                const double here = N[r][k] / (right + left),
                             before = k > 0 ? N[r][k - 1] / (right + left) : 0;
                next[k] += right * here - width * before;
                saved[k] = left * here + width * before;
            }
            N[r] = next;
        }
        N[p] = saved;
    }
    Piece result{.low = u[0], .per_width = 1 / width, .of_power = {}};
    for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t r = 0; r < 4; ++r) result.of_power[k][r] = N[r][k];
    return result;
}

// Never falls as t rises.
std::size_t CubicKnots::bucket(double t) const {
    const double at = (t - low()) * buckets_a_unit_;
    if (!(at > 0)) return 0;
    return at < static_cast<double>(last_.size()) ? static_cast<std::size_t>(at) : last_.size() - 1;
}

CubicKnots CubicKnots::uniform(double low, double high, std::size_t spans) {
    std::vector<double> breaks;
    for (std::size_t i = 0; i < spans; ++i)
        breaks.push_back(low + (high - low) * static_cast<double>(i) / static_cast<double>(spans));
    breaks.push_back(high);
    return CubicKnots(std::move(breaks));
}

std::size_t CubicKnots::span(double t) const {
    const std::size_t k = bucket(t);
    const auto first = breaks_.begin() + 1;
    const auto from = first + static_cast<std::ptrdiff_t>(k > 0 ? last_[k - 1] : 0),
               to = first + static_cast<std::ptrdiff_t>(last_[k]);
    return static_cast<std::size_t>(std::upper_bound(from, to, t) - first);
}

CubicKnots::Values CubicKnots::values(double t, int derivative) const {
    Values result{.first = span(t), .value = {}};
    const auto& [low, per_width, c] = pieces_[result.first];
    const double s = (t - low) * per_width;
    auto& N = result.value;
    for (std::size_t r = 0; r < 4; ++r)
        if (derivative == 0)
            N[r] = ((c[3][r] * s + c[2][r]) * s + c[1][r]) * s + c[0][r];
        else if (derivative == 1)
            N[r] = ((3 * c[3][r] * s + 2 * c[2][r]) * s + c[1][r]) * per_width;
        else
            N[r] = (6 * c[3][r] * s + 2 * c[2][r]) * per_width * per_width;
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
