// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/spline_equations.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "boreholes/errors.h"
#include "subdivision/banded_cholesky.h"

namespace stratareeb {
namespace {

constexpr int kFreeRounds = 10;  // of the active set; after them coefficients are only added to it
constexpr int kMostRounds = 20;

using SpanGram = std::array<std::array<double, 4>, 4>;

// Products of derivatives of the four basis functions of a span, integrated over it (of degree 6 at most).
SpanGram span_gram(const CubicKnots& knots, std::size_t span, int derivative) {
    static constexpr double at[] = {0.069431844202973712, 0.33000947820757187, 0.66999052179242813,
                                    0.93056815579702629};
    static constexpr double weight[] = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                        0.17392742256872693};
    SpanGram result{};
    const double a = knots.breaks()[span], width = knots.breaks()[span + 1] - a;
    for (int g = 0; g < 4; ++g) {
        const auto v = knots.values(a + at[g] * width, derivative);
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) result[i][j] += weight[g] * width * v.value[i] * v.value[j];
    }
    return result;
}

// The same over all spans: [function][0..3 further].
std::vector<std::array<double, 4>> gram(const CubicKnots& knots, int derivative) {
    std::vector<std::array<double, 4>> result(knots.functions());
    for (std::size_t s = 0; s < knots.spans(); ++s) {
        const SpanGram here = span_gram(knots, s, derivative);
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i; j < 4; ++j) result[s + i][j - i] += here[i][j];
    }
    return result;
}

}  // namespace

// Functions (i, j) and (i + di, j + dj) have a product where di is 0..3 and dj -3..3, so a row is 28 numbers, of which
// those with di = 0 and dj < 0 stay unused.
struct SplineEquations::Impl {
    Impl(const CubicKnots& along_x, const CubicKnots& along_y)
        : x(along_x), y(along_y), nx(x.functions()), ny(y.functions()) {}

    // The row's places in use, with the rows of the other functions, ascending.
    template <typename Visit>
    void each_product(std::size_t row, const Visit& visit) const {
        const std::size_t i = row / ny, j = row % ny;
        for (std::size_t di = 0; di < 4 && i + di < nx; ++di)
            for (std::size_t dj = di == 0 ? 3 : 0; dj < 7; ++dj)
                if (j + dj >= 3 && j + dj < ny + 3) visit(di * 7 + dj, (i + di) * ny + j + dj - 3);
    }

    // Row after row of functions along the shorter side: the band is narrowest so.
    std::size_t place_of(std::size_t function) const {
        return ny <= nx ? function : function % ny * nx + function / ny;
    }

    void add_product(const std::vector<std::array<double, 4>>& in_x,
                     const std::vector<std::array<double, 4>>& in_y, double factor) {
        for (std::size_t row = 0; row < rows.size(); ++row) {
            const std::size_t i = row / ny, j = row % ny;
            each_product(row, [&](std::size_t place, std::size_t) {
                const std::size_t di = place / 7, dj = place % 7;
                rows[row][place] +=
                    factor * in_x[i][di] * (dj >= 3 ? in_y[j][dj - 3] : in_y[j + dj - 3][3 - dj]);
            });
        }
    }

    // With coefficients that are held at limits taken out of the equations.
    Eigen::VectorXd solve(const std::vector<char>& held, const std::vector<double>& highest) const {
        Eigen::VectorXd right(b.size());
        const auto right_of = [&](std::size_t f) -> double& {
            return right[static_cast<Eigen::Index>(place_of(f))];
        };
        for (std::size_t f = 0; f < rows.size(); ++f) right_of(f) = b[static_cast<Eigen::Index>(f)];
        BandedCholesky matrix(rows.size(), 3 * std::min(nx, ny) + 3);
        for (std::size_t row = 0; row < rows.size(); ++row)
            each_product(row, [&](std::size_t place, std::size_t other) {
                const double product = rows[row][place];
                if (row == other || !(held[row] || held[other])) {
                    const auto [low, high] = std::minmax({place_of(row), place_of(other)});
                    matrix.at(high, low) = product;
                    return;
                }
                if (!held[row]) right_of(row) -= product * highest[other];
                if (!held[other]) right_of(other) -= product * highest[row];
            });
        for (std::size_t row = 0; row < rows.size(); ++row)
            if (held[row]) right_of(row) = rows[row][3] * highest[row];
        if (!matrix.factorize())
            throw GeometryError("a smooth surface can't be fitted: its equations have no solution");
        matrix.solve_in_place({right.data(), rows.size()});
        Eigen::VectorXd result(b.size());
        for (std::size_t f = 0; f < rows.size(); ++f) result[static_cast<Eigen::Index>(f)] = right_of(f);
        return result;
    }

    // Right sides less the equations' left ones: what pulls at each coefficient.
    Eigen::VectorXd pull(const Eigen::VectorXd& c) const {
        Eigen::VectorXd result = b;
        for (std::size_t row = 0; row < rows.size(); ++row)
            each_product(row, [&](std::size_t place, std::size_t other) {
                const auto r = static_cast<Eigen::Index>(row), o = static_cast<Eigen::Index>(other);
                result[r] -= rows[row][place] * c[o];
                if (r != o) result[o] -= rows[row][place] * c[r];
            });
        return result;
    }

    CubicKnots x, y;
    std::size_t nx, ny;
    std::vector<std::array<double, 28>> rows;
    Eigen::VectorXd b;
};

SplineEquations::SplineEquations(const CubicKnots& x, const CubicKnots& y)
    : impl_(std::make_unique<Impl>(x, y)) {}

SplineEquations::~SplineEquations() = default;

void SplineEquations::begin_with_bending(double factor) {
    auto& e = *impl_;
    e.rows.assign(e.nx * e.ny, {});
    e.b = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(e.nx * e.ny));
    e.add_product(gram(e.x, 2), gram(e.y, 0), factor);
    e.add_product(gram(e.x, 1), gram(e.y, 1), 2 * factor);
    e.add_product(gram(e.x, 0), gram(e.y, 2), factor);
}

void SplineEquations::add_bending_of_span(std::size_t along_x, std::size_t along_y, double factor) {
    auto& e = *impl_;
    const auto width = [](const CubicKnots& knots, std::size_t s) {
        return knots.breaks()[s + 1] - knots.breaks()[s];
    };
    const double hx = width(e.x, along_x), hy = width(e.y, along_y);
    const double xx = factor * hx * hx * hx * hx, xy = factor * 2 * hx * hx * hy * hy,
                 yy = factor * hy * hy * hy * hy;
    std::array<SpanGram, 3> x, y;
    for (int d = 0; d < 3; ++d) {
        x[static_cast<std::size_t>(d)] = span_gram(e.x, along_x, d);
        y[static_cast<std::size_t>(d)] = span_gram(e.y, along_y, d);
    }
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t k = i; k < 4; ++k)
                for (std::size_t l = 0; l < 4; ++l)
                    e.rows[(along_x + i) * e.ny + along_y + j][(k - i) * 7 + l + 3 - j] +=
                        xx * x[2][i][k] * y[0][j][l] + xy * x[1][i][k] * y[1][j][l] +
                        yy * x[0][i][k] * y[2][j][l];
}

void SplineEquations::add(const Point2& at, double z, double weight) {
    auto& e = *impl_;
    const auto vx = e.x.values(at.x), vy = e.y.values(at.y);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            const std::size_t row = (vx.first + i) * e.ny + vy.first + j;
            const double w = weight * vx.value[i] * vy.value[j];
            e.b[static_cast<Eigen::Index>(row)] += w * z;
            for (std::size_t k = i; k < 4; ++k)
                for (std::size_t l = 0; l < 4; ++l)
                    e.rows[row][(k - i) * 7 + l + 3 - j] += w * vx.value[k] * vy.value[l];
        }
}

std::vector<double> SplineEquations::solve() {
    const std::vector<char> none(impl_->rows.size(), 0);
    const Eigen::VectorXd c = impl_->solve(none, {});
    return {c.begin(), c.end()};
}

std::vector<double> SplineEquations::solve_below(const std::vector<double>& highest,
                                                 std::vector<char>& held) {
    held.resize(highest.size(), 0);
    Eigen::VectorXd c;
    for (int round = 0; round < kMostRounds; ++round) {
        c = impl_->solve(held, highest);
        const Eigen::VectorXd pull = impl_->pull(c);
        bool changed = false;
        for (std::size_t i = 0; i < highest.size(); ++i) {
            const auto k = static_cast<Eigen::Index>(i);
            const bool holds = held[i] ? round >= kFreeRounds || pull[k] >= 0 : c[k] > highest[i];
            changed = changed || holds != static_cast<bool>(held[i]);
            held[i] = holds;
        }
        if (!changed) break;
    }
    std::vector<double> result(c.begin(), c.end());
    for (std::size_t i = 0; i < highest.size(); ++i) result[i] = std::min(result[i], highest[i]);
    return result;
}

}  // namespace stratareeb
