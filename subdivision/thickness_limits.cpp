// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/thickness_limits.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace stratareeb {
namespace {

// A B-spline's inner three knots, which its coefficient depends on.
std::array<double, 3> inner_knots(const CubicKnots& knots, std::size_t function) {
    const auto& breaks = knots.breaks();
    const auto knot = [&](std::size_t i) {
        return breaks[std::clamp<std::size_t>(i, 3, breaks.size() + 2) - 3];
    };
    return {knot(function + 1), knot(function + 2), knot(function + 3)};
}

// The polar form of the cubic through four values at a + width k / 3, at three places (L. Ramshaw, Blossoms are polar forms,
// 1989): the share of each value.
std::array<double, 4> polar_form(double a, double width, const std::array<double, 3>& at) {
    std::array<double, 4> result{};
    const double u[] = {(at[0] - a) / width * 3, (at[1] - a) / width * 3, (at[2] - a) / width * 3};
    const double sum = (u[0] + u[1] + u[2]) / 3, pairs = (u[0] * u[1] + u[0] * u[2] + u[1] * u[2]) / 3,
                 all = u[0] * u[1] * u[2];
    for (std::size_t k = 0; k < 4; ++k) {
        // Lagrange's polynomial prod (t - m) / (k - m) over the other three.
        double m[3], scale = 1;
        std::size_t n = 0;
        for (std::size_t other = 0; other < 4; ++other)
            if (other != k) {
                m[n++] = static_cast<double>(other);
                scale *= static_cast<double>(k) - static_cast<double>(other);
            }
        result[k] = (all - (m[0] + m[1] + m[2]) * pairs + (m[0] * m[1] + m[0] * m[2] + m[1] * m[2]) * sum -
                     m[0] * m[1] * m[2]) /
                    scale;
    }
    return result;
}

// [of the finer knots][of the others]: rows of one set of basis functions in another. Exact where the finer knots have the
// breaks of the others; each row depends on what is within its function's reach only.
Eigen::MatrixXd in_knots(const CubicKnots& knots, const CubicKnots& finer) {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(finer.functions()),
                                                   static_cast<Eigen::Index>(knots.functions()));
    const auto& breaks = finer.breaks();
    for (std::size_t i = 0; i < finer.functions(); ++i) {
        const std::size_t span =
            std::clamp<std::size_t>(i, 2, breaks.size()) - 2;  // in the middle of its reach
        const double a = breaks[span], width = breaks[span + 1] - a;
        const auto shares = polar_form(a, width, inner_knots(finer, i));
        for (std::size_t k = 0; k < 4; ++k) {
            const auto v = knots.values(a + width * static_cast<double>(k) / 3);
            for (std::size_t m = 0; m < 4; ++m)
                result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(v.first + m)) +=
                    shares[k] * v.value[m];
        }
    }
    return result;
}

// [function of the finer knots] whether the others reach as far as its inner knots and have no breaks between these that
// the finer ones have not: only then is its coefficient exact. Beyond their ends splines run off steeply.
std::vector<char> is_exact(const CubicKnots& knots, const CubicKnots& finer) {
    std::vector<char> result;
    for (std::size_t i = 0; i < finer.functions(); ++i) {
        const auto k = inner_knots(finer, i);
        result.push_back(k[0] >= knots.low() && k[2] <= knots.high() &&
                         std::ranges::none_of(knots.breaks(),
                                              [&](double t) { return t > k[0] && t < k[2] && t != k[1]; }));
    }
    return result;
}

using Heights = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// A sheet in the knots of another, with whether that is exact for a function.
struct Top {
    Top(const HeightPatch& patch, const CubicKnots& x, const CubicKnots& y)
        : exact_x(is_exact(patch.x, x)), exact_y(is_exact(patch.y, y)) {
        const Eigen::Map<const Heights> own(patch.coefficients.data(),
                                            static_cast<Eigen::Index>(patch.x.functions()),
                                            static_cast<Eigen::Index>(patch.y.functions()));
        coefficients = in_knots(patch.x, x) * own * in_knots(patch.y, y).transpose();
        lowest = Heights::Constant(coefficients.rows(), coefficients.cols(), INFINITY);
    }

    double at(std::size_t i, std::size_t j) const {
        return coefficients(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }

    Heights coefficients;
    Heights lowest;  // of the sheet over triangles in a function's reach
    std::vector<char> exact_x, exact_y;
};

class Limits {
 public:
    Limits(const CubicKnots& x, const CubicKnots& y)
        : x_(x), y_(y), functions_(x.functions() * y.functions()) {}

    void add(const TriMesh& plan, const ThicknessSample& sample) {
        const PlanBox box = box_of(plan, sample.face);
        auto it = tops_.find(sample.top);
        if (it == tops_.end()) it = tops_.emplace(sample.top, Top(*sample.top, x_, y_)).first;
        Top& top = it->second;
        double lowest = INFINITY;
        for (const auto v : plan.fv_range(plan.face_handle(sample.face)))
            lowest = std::min(lowest, sample.top->z({plan.point(v)[0], plan.point(v)[1]}));
        each_over(box, [&](Function& f, std::size_t i, std::size_t j) {
            double& so_far = top.lowest(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
            so_far = std::min(so_far, lowest);
            f.least = std::min(f.least, sample.thickness);
        });
    }

    void add_end(const Point2& p) {
        each_over({p, p}, [&](Function& f, std::size_t, std::size_t) { f.at_end = true; });
    }

    std::vector<double> limits(double share) const {
        std::vector<double> result;
        for (std::size_t i = 0; i < x_.functions(); ++i)
            for (std::size_t j = 0; j < y_.functions(); ++j) {
                const Function& f = functions_[i * y_.functions() + j];
                const double top = f.at_end ? INFINITY : lowest_top(i, j);
                result.push_back(top == INFINITY ? INFINITY : top - share * f.least);
            }
        return result;
    }

 private:
    // What a function reaches.
    struct Function {
        double least = INFINITY;  // thickness over the triangles
        bool at_end = false;
    };

    // Of the sheets in a function's reach. Where there are several, one that runs off steeply beyond the triangles under it
    // counts no deeper than it comes above these.
    double lowest_top(std::size_t i, std::size_t j) const {
        double deepest = INFINITY, above_own = INFINITY;
        int tops = 0;
        for (const auto& [sheet, top] : tops_) {
            const double lowest = top.lowest(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
            if (lowest == INFINITY) continue;
            ++tops;
            if (!top.exact_x[i] || !top.exact_y[j]) continue;
            deepest = std::min(deepest, top.at(i, j));
            above_own = std::min(above_own, std::max(lowest, top.at(i, j)));
        }
        return tops > 1 ? above_own : deepest;
    }

    template <typename Visit>
    void each_over(const PlanBox& box, const Visit& visit) {
        for (std::size_t i = x_.span(box.low.x); i <= x_.span(box.high.x) + 3; ++i)
            for (std::size_t j = y_.span(box.low.y); j <= y_.span(box.high.y) + 3; ++j)
                visit(functions_[i * y_.functions() + j], i, j);
    }

    const CubicKnots &x_, &y_;
    std::vector<Function> functions_;
    std::map<const HeightPatch*, Top> tops_;
};

}  // namespace

PlanBox box_of(const TriMesh& plan, std::uint32_t face) {
    PlanBox box = kEmptyPlanBox;
    for (const auto v : plan.fv_range(plan.face_handle(face)))
        box.include({plan.point(v)[0], plan.point(v)[1]});
    return box;
}

std::vector<double> limits_below_top(const CubicKnots& x, const CubicKnots& y, const TriMesh& plan,
                                     const std::vector<ThicknessSample>& samples,
                                     const std::vector<HeightSample>& ends, double share) {
    Limits limits(x, y);
    for (const auto& sample : samples) limits.add(plan, sample);
    for (const auto& end : ends) limits.add_end(end.at);
    return limits.limits(share);
}

}  // namespace stratareeb
