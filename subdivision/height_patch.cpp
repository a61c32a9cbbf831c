// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/height_patch.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

constexpr double kFairWave = 0.05;     // of a span: bending weighs as much as samples on such waves only
constexpr double kBorderWeight = 1e3;  // of a border sample, in mean weights of one inside
constexpr double kMostUrgent = 1e4;    // of the weight of a sample with the loosest tolerance
// Spans are halved where samples are off by more than this share of the worst: what is steep at a few places gets its rows
// and columns there and not everywhere.
constexpr double kWorthHalving[] = {0.3, 0.6, 0.9, 0.99};
constexpr double kPress = 30;  // on a sample above its limit, a round
constexpr int kMostRounds = 6;

using Matrix = Eigen::SparseMatrix<double>;

struct Rectangle {
    double x0, x1, y0, y1;
};

Rectangle around(const HeightSamples& samples) {
    Rectangle r{INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (const auto* part : {&samples.inside, &samples.border})
        for (const auto& s : *part) {
            r.x0 = std::min(r.x0, s.at.x), r.x1 = std::max(r.x1, s.at.x);
            r.y0 = std::min(r.y0, s.at.y), r.y1 = std::max(r.y1, s.at.y);
        }
    return r;
}

// The spans that an interval reaches into.
CubicKnots over(const CubicKnots& knots, double low, double high) {
    const auto breaks = knots.breaks().begin();
    return CubicKnots({breaks + static_cast<std::ptrdiff_t>(knots.span(low)),
                       breaks + static_cast<std::ptrdiff_t>(knots.span(high)) + 2});
}

// Products of derivatives of two basis functions, integrated (piecewise of degree 6 at most): [function][0..3 further].
std::vector<std::array<double, 4>> gram(const CubicKnots& knots, int derivative) {
    static constexpr double at[] = {0.069431844202973712, 0.33000947820757187, 0.66999052179242813,
                                    0.93056815579702629};
    static constexpr double weight[] = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                        0.17392742256872693};
    std::vector<std::array<double, 4>> result(knots.functions());
    for (std::size_t s = 0; s < knots.spans(); ++s) {
        const double a = knots.breaks()[s], width = knots.breaks()[s + 1] - a;
        for (int g = 0; g < 4; ++g) {
            const auto v = knots.values(a + at[g] * width, derivative);
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = i; j < 4; ++j)
                    result[v.first + i][j - i] += weight[g] * width * v.value[i] * v.value[j];
        }
    }
    return result;
}

// The normal equations. Functions (i, j) and (i + di, j + dj) have a product where di is 0..3 and dj -3..3, so a row is
// 28 numbers, of which those with di = 0 and dj < 0 stay unused.
class Equations {
 public:
    explicit Equations(const HeightPatch& patch)
        : patch_(patch), nx_(patch.x.functions()), ny_(patch.y.functions()) {
        make_pattern();
        solver_.analyzePattern(matrix_);
    }

    // The integral of z_xx^2 + 2 z_xy^2 + z_yy^2 over the rectangle, times a factor.
    void begin_with_bending(double factor) {
        rows_.assign(nx_ * ny_, {});
        b_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(nx_ * ny_));
        const auto &x = patch_.x, &y = patch_.y;
        add_product(gram(x, 2), gram(y, 0), factor);
        add_product(gram(x, 1), gram(y, 1), 2 * factor);
        add_product(gram(x, 0), gram(y, 2), factor);
    }

    void add(const Point2& at, double z, double weight) {
        const auto vx = patch_.x.values(at.x), vy = patch_.y.values(at.y);
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) {
                const std::size_t row = (vx.first + i) * ny_ + vy.first + j;
                const double w = weight * vx.value[i] * vy.value[j];
                b_[static_cast<Eigen::Index>(row)] += w * z;
                for (std::size_t k = i; k < 4; ++k)
                    for (std::size_t l = 0; l < 4; ++l)
                        rows_[row][(k - i) * 7 + l + 3 - j] += w * vx.value[k] * vy.value[l];
            }
    }

    std::vector<double> solve() {
        double* value = matrix_.valuePtr();
        for (std::size_t row = 0; row < rows_.size(); ++row)
            each_product(row, [&](std::size_t place, std::size_t) { *value++ = rows_[row][place]; });
        solver_.factorize(matrix_);
        if (solver_.info() != Eigen::Success)
            throw GeometryError("a smooth surface can't be fitted: its equations have no solution");
        const Eigen::VectorXd x = solver_.solve(b_);
        return {x.begin(), x.end()};
    }

 private:
    // The row's places in use, with the rows of the other functions, ascending.
    template <typename Visit>
    void each_product(std::size_t row, const Visit& visit) const {
        const std::size_t i = row / ny_, j = row % ny_;
        for (std::size_t di = 0; di < 4 && i + di < nx_; ++di)
            for (std::size_t dj = di == 0 ? 3 : 0; dj < 7; ++dj)
                if (j + dj >= 3 && j + dj < ny_ + 3) visit(di * 7 + dj, (i + di) * ny_ + j + dj - 3);
    }

    void make_pattern() {
        const auto n = static_cast<Eigen::Index>(nx_ * ny_);
        matrix_.resize(n, n);
        matrix_.reserve(25 * n);
        for (std::size_t row = 0; row < nx_ * ny_; ++row) {
            matrix_.startVec(static_cast<Eigen::Index>(row));
            each_product(row, [&](std::size_t, std::size_t other) {
                matrix_.insertBack(static_cast<Eigen::Index>(other), static_cast<Eigen::Index>(row)) = 1;
            });
        }
        matrix_.finalize();
    }

    void add_product(const std::vector<std::array<double, 4>>& in_x,
                     const std::vector<std::array<double, 4>>& in_y, double factor) {
        for (std::size_t row = 0; row < rows_.size(); ++row) {
            const std::size_t i = row / ny_, j = row % ny_;
            each_product(row, [&](std::size_t place, std::size_t) {
                const std::size_t di = place / 7, dj = place % 7;
                rows_[row][place] +=
                    factor * in_x[i][di] * (dj >= 3 ? in_y[j][dj - 3] : in_y[j + dj - 3][3 - dj]);
            });
        }
    }

    const HeightPatch& patch_;
    std::size_t nx_, ny_;
    std::vector<std::array<double, 28>> rows_;
    Matrix matrix_;  // lower triangle, column by column
    Eigen::VectorXd b_;
    Eigen::SimplicialLDLT<Matrix> solver_;
};

class HeightFitter {
 public:
    HeightFitter(const HeightSamples& samples, const HeightFitOptions& options)
        : samples_(samples), options_(options) {
        const auto &inside = samples.inside, &border = samples.border;
        for (const auto& s : inside) total_ += s.weight, loosest_ = std::max(loosest_, s.tolerance);
        for (const auto* part : {&inside, &border})
            for (const auto& s : *part) mean_ += s.z / static_cast<double>(inside.size() + border.size());
        pressed_.assign(inside.size(), 1);
    }

    HeightFit fit() {
        const Rectangle r = around(samples_);
        HeightFit result{{over(options_.x, r.x0, r.x1), over(options_.y, r.y0, r.y1), {}}};
        while (true) {
            Equations equations(result.patch);
            solve(equations, result.patch);
            measure(result);
            const double worst = worst_to_refine(result.patch);
            if (!(worst > 1 && refine(result.patch, worst))) {
                press_down(equations, result);
                return result;
            }
        }
    }

 private:
    void solve(Equations& equations, HeightPatch& patch) const {
        const double width = patch.x.high() - patch.x.low(), height = patch.y.high() - patch.y.low();
        const double area = width * height;
        const double span = std::sqrt(area / static_cast<double>(patch.x.spans() * patch.y.spans()));
        equations.begin_with_bending(std::pow(kFairWave * span, 4) / area);
        // About the mean height, so that what is left to rounding is small.
        for (std::size_t i = 0; i < samples_.inside.size(); ++i) {
            const auto& s = samples_.inside[i];
            equations.add(s.at, s.z - mean_, s.weight / total_ * urgency(s) * pressed_[i]);
        }
        const double each =
            kBorderWeight / static_cast<double>(std::max<std::size_t>(samples_.inside.size(), 1));
        for (const auto& s : samples_.border) equations.add(s.at, s.z - mean_, each * s.weight);
        patch.coefficients = equations.solve();
        for (double& c : patch.coefficients) c += mean_;
    }

    // What has to be closer weighs more.
    double urgency(const HeightSample& s) const {
        return std::min(kMostUrgent, std::pow(loosest_ / s.tolerance, 2));
    }

    // Samples above their limit weigh more, round by round, until there are none.
    void press_down(Equations& equations, HeightFit& fit) {
        for (int round = 0; round < kMostRounds; ++round) {
            bool any = false;
            for (std::size_t i = 0; i < samples_.inside.size(); ++i) {
                const auto& s = samples_.inside[i];
                if (!(fit.patch.z(s.at) > s.highest)) continue;
                any = true;
                pressed_[i] *= kPress;
            }
            if (!any) return;
            solve(equations, fit.patch);
            measure(fit);
        }
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
    const HeightFitOptions& options_;
    double total_ = 0, mean_ = 0, loosest_ = 0;
    std::vector<double> pressed_;  // [inside]: factor of its weight
    std::vector<double> off_inside_, off_border_;
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

}  // namespace

double HeightPatch::z(const Point2& p) const {
    return product(*this, x.values(p.x), y.values(p.y));
}

Point2 HeightPatch::gradient(const Point2& p) const {
    return {product(*this, x.values(p.x, 1), y.values(p.y)), product(*this, x.values(p.x), y.values(p.y, 1))};
}

HeightFit fit_height_patch(const HeightSamples& samples, const HeightFitOptions& options) {
    return HeightFitter(samples, options).fit();
}

HeightPatch refit_height_patch(const HeightSamples& samples, const HeightPatch& patch) {
    return fit_height_patch(samples, {.x = patch.x, .y = patch.y, .most_functions = 0}).patch;
}

}  // namespace stratareeb
