// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/height_patch.h"

#include <algorithm>
#include <cmath>

#include "subdivision/spline_equations.h"

namespace stratareeb {
namespace {

constexpr double kFairWave = 0.05;  // of a span: bending weighs as much as samples on such waves only
constexpr double kFarWave = 0.3;    // the same where the patch is not needed
constexpr double kMostBorderWeight =
    3000;  // of a border sample that the patch misses, in mean weights of one inside
constexpr double kMostHeavier = 10;  // a round
constexpr int kBorderRounds = 2;
constexpr double kMostUrgent = 1e4;  // of the weight of a sample with the loosest tolerance
// Spans are halved where samples are off by more than this share of the worst: what is steep at a few places gets its rows
// and columns there and not everywhere.
constexpr double kWorthHalving[] = {0.3, 0.6, 0.9, 0.99};
constexpr int kMostSweeps = 20;

PlanBox around(const HeightSamples& samples) {
    PlanBox box = kEmptyPlanBox;
    for (const auto* part : {&samples.inside, &samples.border})
        for (const auto& s : *part) box.include(s.at);
    return box;
}

class HeightFitter {
 public:
    HeightFitter(const HeightSamples& samples, const HeightFitOptions& options)
        : samples_(samples), options_(options) {
        const auto &inside = samples.inside, &border = samples.border;
        border_weights_.assign(border.size(), options.border_weight);
        for (const auto& s : inside) total_ += s.weight, loosest_ = std::max(loosest_, s.tolerance);
        for (const auto* part : {&inside, &border})
            for (const auto& s : *part) mean_ += s.z / static_cast<double>(inside.size() + border.size());
    }

    HeightFit fit() {
        const PlanBox r = around(samples_);
        HeightFit result{{options_.x.part(r.low.x, r.high.x), options_.y.part(r.low.y, r.high.y), {}}};
        while (true) {
            SplineEquations equations(result.patch.x, result.patch.y);
            set_up(equations, result.patch);
            take(result, equations.solve());
            const double worst = worst_to_refine(result.patch);
            if (!(worst > 1 && refine(result.patch, worst))) {
                meet_border(equations, result);
                if (options_.limits) hold_below(equations, result);
                return result;
            }
        }
    }

    HeightFit refit(HeightFit fit) {
        border_weights_ = fit.border_weights;
        SplineEquations equations(fit.patch.x, fit.patch.y);
        set_up(equations, fit.patch);
        if (options_.limits)
            hold_below(equations, fit);
        else
            take(fit, equations.solve());
        return fit;
    }

 private:
    // Border samples that are off weigh more, so that others don't bend what is between them.
    void meet_border(SplineEquations& equations, HeightFit& fit) {
        for (int round = 0; round < kBorderRounds; ++round) {
            bool any = false;
            for (std::size_t i = 0; i < border_weights_.size(); ++i) {
                const double heavier =
                    std::clamp(off_border_[i] / samples_.border[i].tolerance, 1.0, kMostHeavier);
                const double weight = std::min(kMostBorderWeight, heavier * border_weights_[i]);
                any |= weight > border_weights_[i];
                border_weights_[i] = weight;
            }
            if (!any) break;
            set_up(equations, fit.patch);
            take(fit, equations.solve());
        }
        fit.border_weights = border_weights_;
    }

    void set_up(SplineEquations& equations, const HeightPatch& patch) const {
        const double width = patch.x.high() - patch.x.low(), height = patch.y.high() - patch.y.low();
        const double area = width * height;
        const double span = std::sqrt(area / static_cast<double>(patch.x.spans() * patch.y.spans()));
        equations.begin_with_bending(std::pow(kFairWave * span, 4) / area);
        straighten_elsewhere(equations, patch, std::pow(kFarWave, 4) / area);
        // About the mean height, so that what is left to rounding is small.
        for (const auto& s : samples_.inside)
            equations.add(s.at, s.z - mean_, s.weight / total_ * urgency(s));
        const double each = 1 / static_cast<double>(std::max<std::size_t>(samples_.inside.size(), 1));
        for (std::size_t i = 0; i < samples_.border.size(); ++i) {
            const auto& s = samples_.border[i];
            equations.add(s.at, s.z - mean_, each * border_weights_[i] * s.weight);
        }
    }

    // Functions that hardly reach the place the patch is for would take any value to come a little closer there.
    void straighten_elsewhere(SplineEquations& equations, const HeightPatch& patch, double factor) const {
        if (samples_.covered.empty()) return;
        const std::size_t ny = patch.y.spans();
        std::vector<char> covered(patch.x.spans() * ny, 0);
        for (const PlanBox& box : samples_.covered)
            for (std::size_t i = patch.x.span(box.low.x); i <= patch.x.span(box.high.x); ++i)
                for (std::size_t j = patch.y.span(box.low.y); j <= patch.y.span(box.high.y); ++j)
                    covered[i * ny + j] = 1;
        for (std::size_t k = 0; k < covered.size(); ++k)
            if (!covered[k]) equations.add_bending_of_span(k / ny, k % ny, factor);
    }

    void take(HeightFit& fit, std::vector<double> coefficients) {
        fit.patch.coefficients = std::move(coefficients);
        for (double& c : fit.patch.coefficients) c += mean_;
        measure(fit);
    }

    // What has to be closer weighs more.
    double urgency(const HeightSample& s) const {
        return std::min(kMostUrgent, std::pow(loosest_ / s.tolerance, 2));
    }

    // Least squares among coefficients below their limits; samples that are above theirs all the same are pressed down one
    // by one.
    void hold_below(SplineEquations& equations, HeightFit& fit) {
        std::vector<double> limits = options_.limits(fit.patch.x, fit.patch.y);
        if (fit.held.empty())
            for (std::size_t i = 0; i < limits.size(); ++i)
                fit.held.push_back(fit.patch.coefficients[i] > limits[i]);
        for (double& z : limits) z -= mean_;
        take(fit, equations.solve_below(limits, fit.held));
        press_down(fit.patch);
        measure(fit);
    }

    // Border samples to their heights, and samples above their limits down to these, one by one by the least change of
    // coefficients, again and again (S. Kaczmarz, 1937); in the end only down: what was below stays so.
    void press_down(HeightPatch& patch) const {
        for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
            for (const auto& s : samples_.border) lower_at(patch, s.at, patch.z(s.at) - s.z);
            press_all(patch);
        }
        for (int sweep = 0; sweep < kMostSweeps && press_all(patch); ++sweep) {
        }
    }

    bool press_all(HeightPatch& patch) const {
        bool any = false;
        for (const auto* part : {&samples_.border, &samples_.inside})
            for (const auto& s : *part) {
                const double above = patch.z(s.at) - s.highest;
                if (!(above > 0)) continue;
                lower_at(patch, s.at, above);
                any = true;
            }
        return any;
    }

    void measure(HeightFit& fit) {
        off_inside_ = distances(fit.patch, samples_.inside);
        off_border_ = distances(fit.patch, samples_.border);
        fit.off_inside = off_inside_.empty() ? 0 : std::ranges::max(off_inside_);
        fit.off_border = off_border_.empty() ? 0 : std::ranges::max(off_border_);
    }

    static std::vector<double> distances(const HeightPatch& patch, const std::vector<HeightSample>& samples) {
        std::vector<double> result;
        for (const auto& s : samples) result.push_back(std::abs(patch.z(s.at) - s.z));
        return result;
    }

    // The largest distance, in tolerances, where spans may still be halved: what is as fine as it may be must not keep others
    // from it.
    double worst_to_refine(const HeightPatch& patch) const {
        const auto may_halve = [&](const CubicKnots& knots, double t) {
            const std::size_t s = knots.span(t);
            return knots.breaks()[s + 1] - knots.breaks()[s] >= options_.finest;
        };
        double worst = 0;
        const auto look = [&](const std::vector<HeightSample>& samples, const std::vector<double>& off) {
            for (std::size_t i = 0; i < samples.size(); ++i)
                if (may_halve(patch.x, samples[i].at.x) || may_halve(patch.y, samples[i].at.y))
                    worst = std::max(worst, off[i] / samples[i].tolerance);
        };
        look(samples_.inside, off_inside_);
        look(samples_.border, off_border_);
        return worst;
    }

    // Halves rows and columns of spans where samples are off, the worst ones alone where there is no room for more. False
    // if there is no room at all.
    bool refine(HeightPatch& patch, double worst) const {
        for (const double share : kWorthHalving) {
            std::vector<char> halve_x(patch.x.spans(), 0), halve_y(patch.y.spans(), 0);
            const auto mark = [&](const std::vector<HeightSample>& samples, const std::vector<double>& off) {
                for (std::size_t i = 0; i < samples.size(); ++i)
                    if (off[i] >= std::max(1.0, share * worst) * samples[i].tolerance)
                        halve_x[patch.x.span(samples[i].at.x)] = halve_y[patch.y.span(samples[i].at.y)] = 1;
            };
            mark(samples_.inside, off_inside_);
            mark(samples_.border, off_border_);
            keep_coarse_enough(patch.x, halve_x);
            keep_coarse_enough(patch.y, halve_y);
            const CubicKnots x = patch.x.refined(halve_x), y = patch.y.refined(halve_y);
            if (x.spans() == patch.x.spans() && y.spans() == patch.y.spans()) return false;
            if (x.functions() * y.functions() > options_.most_functions) continue;
            patch.x = x;
            patch.y = y;
            return true;
        }
        return false;
    }

    void keep_coarse_enough(const CubicKnots& knots, std::vector<char>& halve) const {
        for (std::size_t s = 0; s < knots.spans(); ++s)
            if (knots.breaks()[s + 1] - knots.breaks()[s] < options_.finest) halve[s] = 0;
    }

    const HeightSamples& samples_;
    const HeightFitOptions options_;
    double total_ = 0, mean_ = 0, loosest_ = 0;
    std::vector<double> off_inside_, off_border_, border_weights_;
};

double product(const HeightPatch& patch, const CubicKnots::Values& vx, const CubicKnots::Values& vy) {
    const std::size_t ny = patch.y.functions();
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const double* row = patch.coefficients.data() + (vx.first + i) * ny + vy.first;
        double along = 0;
        for (std::size_t j = 0; j < 4; ++j) along += vy.value[j] * row[j];
        sum += vx.value[i] * along;
    }
    return sum;
}

// To the coefficients of a span. Returns the largest that is added, 0 if all are negative.
template <typename Change>
double add(HeightPatch& patch, std::size_t first_x, std::size_t first_y, const Change& change) {
    double most = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            const double by = change(i, j);
            patch.coefficients[(first_x + i) * patch.y.functions() + first_y + j] += by;
            most = std::max(most, by);
        }
    return most;
}

}  // namespace

double HeightPatch::z(const Point2& p) const {
    return product(*this, x.values(p.x), y.values(p.y));
}

Point2 HeightPatch::gradient(const Point2& p) const {
    return {product(*this, x.values(p.x, 1), y.values(p.y)), product(*this, x.values(p.x), y.values(p.y, 1))};
}

double lower_at(HeightPatch& patch, const Point2& at, double by) {
    const auto vx = patch.x.values(at.x), vy = patch.y.values(at.y);
    double square_x = 0, square_y = 0;
    for (std::size_t i = 0; i < 4; ++i)
        square_x += vx.value[i] * vx.value[i], square_y += vy.value[i] * vy.value[i];
    return add(patch, vx.first, vy.first, [&](std::size_t i, std::size_t j) {
        return -by * vx.value[i] * vy.value[j] / (square_x * square_y);
    });
}

double tilt_at(HeightPatch& patch, const Point2& at, const Point2& direction, double by) {
    const auto vx = patch.x.values(at.x), vy = patch.y.values(at.y), dx = patch.x.values(at.x, 1),
               dy = patch.y.values(at.y, 1);
    const auto slope = [&](std::size_t i, std::size_t j) {
        return direction.x * dx.value[i] * vy.value[j] + direction.y * vx.value[i] * dy.value[j];
    };
    double square = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) square += slope(i, j) * slope(i, j);
    return add(patch, vx.first, vy.first,
               [&](std::size_t i, std::size_t j) { return by * slope(i, j) / square; });
}

HeightFit fit_height_patch(const HeightSamples& samples, const HeightFitOptions& options) {
    return HeightFitter(samples, options).fit();
}

HeightFit refit_height_patch(const HeightSamples& samples, const HeightFit& fit, const LimitMaker& limits) {
    return HeightFitter(samples, {.limits = limits}).refit(fit);
}

}  // namespace stratareeb
