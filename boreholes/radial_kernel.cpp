// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/radial_kernel.h"

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <numbers>

namespace stratareeb {

namespace {

using Values = Eigen::Map<const Eigen::ArrayXd>;
using Results = Eigen::Map<Eigen::ArrayXd>;

Values values(std::span<const double> s) {
    return {s.data(), static_cast<Eigen::Index>(s.size())};
}
Results results(std::span<double> s) {
    return {s.data(), static_cast<Eigen::Index>(s.size())};
}

class Covariance : public RadialKernel {
 public:
    Covariance(const Variogram& variogram, double micro_range)
        : v_(variogram), micro_(variogram.nugget > 0 ? micro_range : 0) {}

    void evaluate(std::span<const double> squared_distance, std::span<double> result) const override {
        structure(values(squared_distance), results(result));
        if (micro_ <= 0) return;
        for (std::size_t i = 0; i < result.size(); ++i) {
            const double t = std::sqrt(squared_distance[i]) / micro_;
            if (t < 1) result[i] += v_.nugget * std::pow(1 - t, 4) * (4 * t + 1);
        }
    }

 private:
    void structure(const Values& r2, Results out) const {
        const double inverse = 1 / v_.range, s3 = kPracticalMatern32 * inverse,
                     s5 = kPracticalMatern52 * inverse;
        switch (v_.model) {
            case VariogramModel::Spherical:
                out = (r2.sqrt() * inverse).min(1.0);
                out = v_.sill * (1 - 1.5 * out + 0.5 * out.cube());
                break;
            case VariogramModel::Exponential:
                out = v_.sill * (r2.sqrt() * (-kPracticalExponential * inverse)).exp();
                break;
            case VariogramModel::Gaussian:
                out = v_.sill * (r2 * (-kPracticalExponential * inverse * inverse)).exp();
                break;
            case VariogramModel::Matern32:
                out = r2.sqrt() * s3;
                out = v_.sill * (1 + out) * (-out).exp();
                break;
            case VariogramModel::Matern52:
                out = r2.sqrt() * s5;
                out = v_.sill * (1 + out + out.square() / 3) * (-out).exp();
                break;
        }
    }

    Variogram v_;
    double micro_;
};

class ThinPlate : public RadialKernel {
 public:
    void evaluate(std::span<const double> squared_distance, std::span<double> result) const override {
        for (std::size_t i = 0; i < result.size(); ++i) {
            const double r2 = squared_distance[i];
            result[i] = r2 > 0 ? r2 * std::log(r2) / 2 : 0;
        }
    }
};

// K0(x) + ln(x / 2) + γ for x <= 2, without cancellation: (1 − I0(x)) (ln(x/2) + γ) + Σ H_k (x²/4)^k / (k!)²
// (Abramowitz and Stegun 9.6.13).
double regular_k0_small(double x) {
    const double u = x * x / 4, log_part = std::log(x / 2) + std::numbers::egamma;
    double term = 1, harmonic = 0, sum = 0;
    for (int k = 1; k <= 14; ++k) {
        term *= u / (k * k);
        harmonic += 1.0 / k;
        sum += term * (harmonic - log_part);
    }
    return sum;
}

// For x > 2: K0 from a table of cubic Hermite pieces of K0(x) e^x √x, which is as good as a straight line.
class BesselTable {
 public:
    BesselTable() {
        for (int i = 0; i <= kPieces; ++i) {
            const double x = kFirst + i * kStep;
            const double k0 = std::cyl_bessel_k(0.0, x), k1 = std::cyl_bessel_k(1.0, x), up = std::exp(x),
                         root = std::sqrt(x);
            value_[i] = k0 * up * root;
            slope_[i] = up * root * (k0 - k1 + k0 / (2 * x)) * kStep;
        }
    }
    double k0(double x) const {
        if (x >= kFirst + kPieces * kStep) return 0;  // below 1e-17
        const double u = (x - kFirst) / kStep;
        const int i = static_cast<int>(u);
        const double t = u - i, s = 1 - t;
        const double h = value_[i] * s * s * (1 + 2 * t) + slope_[i] * t * s * s +
                         value_[i + 1] * t * t * (1 + 2 * s) - slope_[i + 1] * s * t * t;
        return h * std::exp(-x) / std::sqrt(x);
    }

 private:
    static constexpr int kPieces = 1152;
    static constexpr double kFirst = 2, kStep = 1.0 / 32;
    std::array<double, kPieces + 1> value_{}, slope_{};
};

class Tension : public RadialKernel {
 public:
    explicit Tension(double tension) : p_(tension) {}
    void evaluate(std::span<const double> squared_distance, std::span<double> result) const override {
        static const BesselTable table;
        const double scale = -4 / (p_ * p_);
        for (std::size_t i = 0; i < result.size(); ++i) {
            const double x = p_ * std::sqrt(squared_distance[i]);
            if (x <= 0)
                result[i] = 0;
            else if (x <= 2)
                result[i] = scale * regular_k0_small(x);
            else
                result[i] = scale * (table.k0(x) + std::log(x / 2) + std::numbers::egamma);
        }
    }

 private:
    double p_;
};

}  // namespace

std::unique_ptr<RadialKernel> covariance_kernel(const Variogram& variogram, double micro_range) {
    return std::make_unique<Covariance>(variogram, micro_range);
}

std::unique_ptr<RadialKernel> spline_kernel(double tension) {
    if (tension > 0) return std::make_unique<Tension>(tension);
    return std::make_unique<ThinPlate>();
}

}  // namespace stratareeb
