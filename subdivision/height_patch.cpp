// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/height_patch.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

constexpr double kMargin = 0.02;       // of the rectangle's longer side, around the samples
constexpr double kFairWave = 0.05;     // of a span: bending weighs as much as samples on such waves only
constexpr double kBorderWeight = 1e3;  // of a border sample, in mean weights of one inside
constexpr double kGuideWeight =
    3;  // of a guide, in weights of a sample inside: a triangle's centre against its corners
constexpr double kMostUrgent = 1e4;  // of the weight of a sample with the loosest tolerance
// Spans are halved where samples are off by more than this share of the worst: what is steep at a few places gets its rows
// and columns there and not everywhere.
constexpr double kWorthHalving = 0.3;

using Triplets = std::vector<Eigen::Triplet<double>>;
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
    const double margin = kMargin * std::max(r.x1 - r.x0, r.y1 - r.y0);
    return {r.x0 - margin, r.x1 + margin, r.y0 - margin, r.y1 + margin};
}

HeightPatch first_patch(const Rectangle& r) {
    const double width = r.x1 - r.x0, height = r.y1 - r.y0, side = std::min(width, height);
    const auto spans = [&](double length) {
        return static_cast<std::size_t>(std::clamp(std::round(length / side), 1.0, 32.0));
    };
    return {
        CubicKnots::uniform(r.x0, r.x1, spans(width)), CubicKnots::uniform(r.y0, r.y1, spans(height)), {}};
}

// Products of derivatives of two basis functions, integrated: piecewise of degree 6 at most.
Matrix gram(const CubicKnots& knots, int derivative) {
    static constexpr double at[] = {0.069431844202973712, 0.33000947820757187, 0.66999052179242813,
                                    0.93056815579702629};
    static constexpr double weight[] = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                        0.17392742256872693};
    Triplets entries;
    for (std::size_t s = 0; s < knots.spans(); ++s) {
        const double a = knots.breaks()[s], width = knots.breaks()[s + 1] - a;
        for (int g = 0; g < 4; ++g) {
            const auto v = knots.values(a + at[g] * width, derivative);
            for (int i = 0; i < 4; ++i)
                for (int j = 0; j < 4; ++j)
                    entries.emplace_back(static_cast<int>(v.first) + i, static_cast<int>(v.first) + j,
                                         weight[g] * width * v.value[i] * v.value[j]);
        }
    }
    const auto n = static_cast<Eigen::Index>(knots.functions());
    Matrix result(n, n);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

void add_product(Triplets& entries, const Matrix& in_x, const Matrix& in_y, double factor) {
    const auto ny = in_y.rows();
    for (Eigen::Index i = 0; i < in_x.outerSize(); ++i)
        for (Matrix::InnerIterator a(in_x, i); a; ++a)
            for (Eigen::Index j = 0; j < ny; ++j)
                for (Matrix::InnerIterator b(in_y, j); b; ++b)
                    entries.emplace_back(static_cast<int>(a.row() * ny + b.row()),
                                         static_cast<int>(a.col() * ny + b.col()),
                                         factor * a.value() * b.value());
}

// The integral of z_xx^2 + 2 z_xy^2 + z_yy^2 over the rectangle.
void add_bending(Triplets& entries, const HeightPatch& patch, double factor) {
    const Matrix x0 = gram(patch.x, 0), x1 = gram(patch.x, 1), x2 = gram(patch.x, 2);
    const Matrix y0 = gram(patch.y, 0), y1 = gram(patch.y, 1), y2 = gram(patch.y, 2);
    add_product(entries, x2, y0, factor);
    add_product(entries, x1, y1, 2 * factor);
    add_product(entries, x0, y2, factor);
}

// The normal equations, filled sample by sample into the pattern that bending leaves: all functions that share
// a span.
class Equations {
 public:
    explicit Equations(const HeightPatch& patch, double bending)
        : patch_(patch), ny_(static_cast<int>(patch.y.functions())) {
        const auto n = static_cast<Eigen::Index>(patch.x.functions() * patch.y.functions());
        Triplets entries;
        add_bending(entries, patch, bending);
        matrix_.resize(n, n);
        matrix_.setFromTriplets(entries.begin(), entries.end());
        b_ = Eigen::VectorXd::Zero(n);
    }

    void add(const HeightSample& sample, double weight) {
        const auto vx = patch_.x.values(sample.at.x), vy = patch_.y.values(sample.at.y);
        for (int i = 0; i < 16; ++i) {
            const int row = index(vx, vy, i);
            const double wi = weight * vx.value[i / 4] * vy.value[i % 4];
            b_[row] += wi * sample.z;
            for (int j = 0; j < 16; ++j)
                matrix_.coeffRef(row, index(vx, vy, j)) += wi * vx.value[j / 4] * vy.value[j % 4];
        }
    }

    std::vector<double> solve() const {
        const Eigen::SimplicialLDLT<Matrix> solver(matrix_);
        if (solver.info() != Eigen::Success)
            throw GeometryError("a smooth surface can't be fitted: its equations have no solution");
        const Eigen::VectorXd x = solver.solve(b_);
        return {x.begin(), x.end()};
    }

 private:
    int index(const CubicKnots::Values& vx, const CubicKnots::Values& vy, int k) const {
        return (static_cast<int>(vx.first) + k / 4) * ny_ + static_cast<int>(vy.first) + k % 4;
    }

    const HeightPatch& patch_;
    int ny_;
    Matrix matrix_;
    Eigen::VectorXd b_;
};

class HeightFitter {
 public:
    HeightFitter(const HeightSamples& samples, const HeightFitOptions& options)
        : samples_(samples), options_(options) {
        const auto &inside = samples.inside, &border = samples.border;
        for (const auto& s : inside) total_ += s.weight, loosest_ = std::max(loosest_, s.tolerance);
        for (const auto* part : {&inside, &border})
            for (const auto& s : *part) mean_ += s.z / static_cast<double>(inside.size() + border.size());
    }

    HeightFit fit() {
        HeightFit result{first_patch(around(samples_))};
        while (true) {
            solve(result.patch);
            if (!measure(result) || !refine(result.patch)) return result;
        }
    }

 private:
    void solve(HeightPatch& patch) const {
        const double width = patch.x.high() - patch.x.low(), height = patch.y.high() - patch.y.low();
        const double area = width * height;
        const double span = std::sqrt(area / static_cast<double>(patch.x.spans() * patch.y.spans()));
        Equations equations(patch, std::pow(kFairWave * span, 4) / area);
        // About the mean height, so that what is left to rounding is small.
        const auto lowered = [&](HeightSample s) { return s.z -= mean_, s; };
        for (const auto& s : samples_.inside) equations.add(lowered(s), s.weight / total_ * urgency(s));
        const double guide = kGuideWeight / std::max(total_, 1e-300);
        for (const auto& s : samples_.guides) equations.add(lowered(s), guide * s.weight);
        const double each =
            kBorderWeight / static_cast<double>(std::max<std::size_t>(samples_.inside.size(), 1));
        for (const auto& s : samples_.border) equations.add(lowered(s), each * s.weight);
        patch.coefficients = equations.solve();
        for (double& c : patch.coefficients) c += mean_;
    }

    // What has to be closer weighs more.
    double urgency(const HeightSample& s) const {
        return std::min(kMostUrgent, std::pow(loosest_ / s.tolerance, 2));
    }

    // Marks rows and columns of spans where samples are off by more than they may; false if none is.
    bool measure(HeightFit& fit) {
        halve_x_.assign(fit.patch.x.spans(), 0);
        halve_y_.assign(fit.patch.y.spans(), 0);
        const auto inside = distances(fit.patch, samples_.inside),
                   border = distances(fit.patch, samples_.border);
        fit.off_inside = inside.empty() ? 0 : std::ranges::max(inside);
        fit.off_border = border.empty() ? 0 : std::ranges::max(border);
        const double worst = std::max(worst_of(samples_.inside, inside), worst_of(samples_.border, border));
        if (!(worst > 1)) return false;
        const double least = std::max(1.0, kWorthHalving * worst);
        mark(fit.patch, samples_.inside, inside, least);
        mark(fit.patch, samples_.border, border, least);
        return true;
    }

    static std::vector<double> distances(const HeightPatch& patch, const std::vector<HeightSample>& samples) {
        std::vector<double> result;
        for (const auto& s : samples) result.push_back(std::abs(patch.z(s.at) - s.z));
        return result;
    }

    // In tolerances.
    static double worst_of(const std::vector<HeightSample>& samples, const std::vector<double>& off) {
        double worst = 0;
        for (std::size_t i = 0; i < samples.size(); ++i)
            worst = std::max(worst, off[i] / samples[i].tolerance);
        return worst;
    }

    void mark(const HeightPatch& patch, const std::vector<HeightSample>& samples,
              const std::vector<double>& off, double least) {
        for (std::size_t i = 0; i < samples.size(); ++i)
            if (off[i] >= least * samples[i].tolerance)
                halve_x_[patch.x.span(samples[i].at.x)] = halve_y_[patch.y.span(samples[i].at.y)] = 1;
    }

    bool refine(HeightPatch& patch) {
        keep_coarse_enough(patch.x, halve_x_);
        keep_coarse_enough(patch.y, halve_y_);
        const CubicKnots x = patch.x.refined(halve_x_), y = patch.y.refined(halve_y_);
        if (x.spans() == patch.x.spans() && y.spans() == patch.y.spans()) return false;
        if (x.functions() * y.functions() > options_.most_functions) return false;
        patch.x = x;
        patch.y = y;
        return true;
    }

    void keep_coarse_enough(const CubicKnots& knots, std::vector<char>& halve) const {
        for (std::size_t s = 0; s < knots.spans(); ++s)
            if (knots.breaks()[s + 1] - knots.breaks()[s] < options_.finest) halve[s] = 0;
    }

    const HeightSamples& samples_;
    const HeightFitOptions& options_;
    double total_ = 0, mean_ = 0, loosest_ = 0;
    std::vector<char> halve_x_, halve_y_;
};

}  // namespace

double HeightPatch::z(const Point2& p) const {
    const auto vx = x.values(p.x), vy = y.values(p.y);
    const std::size_t ny = y.functions();
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const double* row = coefficients.data() + (vx.first + i) * ny + vy.first;
        double along = 0;
        for (std::size_t j = 0; j < 4; ++j) along += vy.value[j] * row[j];
        sum += vx.value[i] * along;
    }
    return sum;
}

HeightFit fit_height_patch(const HeightSamples& samples, const HeightFitOptions& options) {
    return HeightFitter(samples, options).fit();
}

}  // namespace stratareeb
