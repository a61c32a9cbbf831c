// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/minimum_curvature.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "boreholes/blended_surface.h"
#include "boreholes/closest_in_hull.h"
#include "boreholes/errors.h"
#include "boreholes/field_sites.h"
#include "boreholes/natural_neighbour.h"
#include "boreholes/site_gaps.h"

namespace stratareeb {

namespace {

constexpr double kPull = 1e5;           // of the values, against the grid's own curvature
constexpr double kLeastTension = 1e-9;  // keeps the grid level where the sites leave a tilt open
constexpr double kFewestNodes = 2500;
constexpr double kMostInARow = 300;  // of a narrow strip; longer rows lose too many digits
constexpr int kMargin = 2;           // nodes beyond the sites' box, so that every place has its 4 × 4 nodes

//! Four nodes in a row and their shares: Catmull and Rom's cubic (1974).
struct Cubic {
    int first;
    std::array<double, 4> share;
};

Cubic cubic_at(double u, int count) {
    const int cell = std::clamp(static_cast<int>(std::floor(u)), 1, count - 3);
    const double t = u - cell, t2 = t * t, t3 = t2 * t;
    return {cell - 1,
            {(-t + 2 * t2 - t3) / 2, 1 + (-5 * t2 + 3 * t3) / 2, (t + 4 * t2 - 3 * t3) / 2, (t3 - t2) / 2}};
}

class Grid {
 public:
    Grid(std::span<const Point2> at, std::size_t most_nodes) {
        Point2 low = at[0], high = low;
        for (const Point2& p : at) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
        const double a = high.x - low.x, b = high.y - low.y, gap = median_gap(at) / 2;
        const double wished = std::clamp((a / gap + 5) * (b / gap + 5), kFewestNodes,
                                         std::max(kFewestNodes, double(most_nodes)));
        step_ = std::max(std::sqrt(a * b / wished), std::max(a, b) / kMostInARow);
        nx_ = static_cast<int>(std::ceil(a / step_)) + 1 + 2 * kMargin;
        ny_ = static_cast<int>(std::ceil(b / step_)) + 1 + 2 * kMargin;
        corner_ = {low.x - kMargin * step_, low.y - kMargin * step_};
    }

    //! Fit to values at places.
    void fit(std::span<const Point2> at, std::span<const double> value, double tension) {
        std::vector<Eigen::Triplet<double>> entries;
        const auto add = [&](std::span<const int> node, std::span<const double> share, double weight) {
            for (std::size_t i = 0; i < node.size(); ++i)
                for (std::size_t j = 0; j < node.size(); ++j)
                    if (node[j] <= node[i])
                        entries.emplace_back(node[i], node[j], weight * share[i] * share[j]);
        };
        add_curvature(add, 1 - tension);
        add_slope(add, std::max(tension, kLeastTension));
        Eigen::VectorXd right = Eigen::VectorXd::Zero(nx_ * ny_);
        for (std::size_t k = 0; k < at.size(); ++k) {
            std::array<int, 16> node{};
            std::array<double, 16> share{};
            shares(at[k], node, share);
            add(node, share, kPull);
            for (std::size_t i = 0; i < 16; ++i) right[node[i]] += kPull * share[i] * value[k];
        }
        Eigen::SparseMatrix<double> system(nx_ * ny_, nx_ * ny_);
        system.setFromTriplets(entries.begin(), entries.end());
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(system);
        z_ = solver.solve(right);
        if (solver.info() != Eigen::Success || !z_.allFinite()) z_.setZero(nx_ * ny_);
    }

    double at(const Point2& p) const {
        std::array<int, 16> node{};
        std::array<double, 16> share{};
        shares(p, node, share);
        double sum = 0;
        for (std::size_t i = 0; i < 16; ++i) sum += share[i] * z_[node[i]];
        return sum;
    }

 private:
    int node(int i, int j) const { return j * nx_ + i; }

    void shares(const Point2& p, std::array<int, 16>& node_number, std::array<double, 16>& share) const {
        const Cubic x = cubic_at((p.x - corner_.x) / step_, nx_),
                    y = cubic_at((p.y - corner_.y) / step_, ny_);
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                const std::size_t k = 4 * static_cast<std::size_t>(j) + static_cast<std::size_t>(i);
                node_number[k] = node(x.first + i, y.first + j);
                share[k] = x.share[static_cast<std::size_t>(i)] * y.share[static_cast<std::size_t>(j)];
            }
    }

    template <class Add>
    void add_curvature(const Add& add, double weight) const {
        constexpr std::array bend{1.0, -2.0, 1.0};
        constexpr std::array twist{1.0, -1.0, -1.0, 1.0};
        for (int j = 0; j < ny_; ++j)
            for (int i = 0; i < nx_; ++i) {
                if (i > 0 && i + 1 < nx_)
                    add(std::array{node(i - 1, j), node(i, j), node(i + 1, j)}, bend, weight);
                if (j > 0 && j + 1 < ny_)
                    add(std::array{node(i, j - 1), node(i, j), node(i, j + 1)}, bend, weight);
                if (i + 1 < nx_ && j + 1 < ny_)
                    add(std::array{node(i, j), node(i + 1, j), node(i, j + 1), node(i + 1, j + 1)}, twist,
                        2 * weight);
            }
    }

    template <class Add>
    void add_slope(const Add& add, double weight) const {
        constexpr std::array rise{-1.0, 1.0};
        for (int j = 0; j < ny_; ++j)
            for (int i = 0; i < nx_; ++i) {
                if (i + 1 < nx_) add(std::array{node(i, j), node(i + 1, j)}, rise, weight);
                if (j + 1 < ny_) add(std::array{node(i, j), node(i, j + 1)}, rise, weight);
            }
    }

    Point2 corner_;
    double step_ = 1;
    int nx_ = 0, ny_ = 0;
    Eigen::VectorXd z_;
};

}  // namespace

MinimumCurvature::MinimumCurvature(std::shared_ptr<const HoleTriangulation> holes,
                                   const InterpolatorOptions& options)
    : holes_(std::move(holes)), tension_(options.curvature_tension), nodes_(options.curvature_nodes) {
    if (!(tension_ >= 0 && tension_ < 1))
        throw InvalidInput("minimum curvature needs a tension of at least 0 and below 1");
}

std::vector<std::vector<double>> MinimumCurvature::predict(std::span<const Point2> where,
                                                           std::span<const SiteField> fields) const {
    const auto inside = closest_in_hull(*holes_, where);
    const auto& all_sites = holes_->sites();
    // What the grids miss at the sites, and its own natural neighbour surfaces.
    std::vector<std::vector<double>> result, misfit;
    std::vector<std::vector<char>> use;
    for (const SiteField& field : fields) {
        auto& z = result.emplace_back(where.size(), 0.0);
        auto& missed = misfit.emplace_back(all_sites.size(), 0.0);
        auto& used = use.emplace_back(all_sites.size(), static_cast<char>(0));
        for (std::size_t i = 0; i < used.size(); ++i) used[i] = static_cast<char>(field.is_measured(i));
        const FieldSites sites = field_sites(all_sites, {field.value, used});
        if (sites.size() == 0) continue;
        const ValueScale scale = value_scale(sites);
        std::vector<double> scaled;
        for (const double v : sites.value) scaled.push_back((v - scale.mean) / scale.spread);
        if (sites.size() > 1) {
            Grid grid(sites.at, nodes_);
            grid.fit(sites.at, scaled, tension_);
            for (std::size_t k = 0; k < sites.size(); ++k) scaled[k] -= grid.at(sites.at[k]);
            for (std::size_t i = 0; i < where.size(); ++i) z[i] = grid.at(sites.frame.to_local(inside[i]));
        }
        for (std::size_t k = 0; k < sites.size(); ++k) missed[sites.site[k]] = scaled[k];
    }
    std::vector<SiteField> misfits;
    for (std::size_t f = 0; f < fields.size(); ++f) misfits.push_back({misfit[f], use[f]});
    const auto correction = NaturalNeighbour(holes_).predict(inside, misfits);
    for (std::size_t f = 0; f < fields.size(); ++f) {
        const FieldSites sites = field_sites(all_sites, {fields[f].value, use[f]});
        if (sites.size() == 0) continue;
        const ValueScale scale = value_scale(sites);
        const ValueLimits limits = value_limits(sites.value);
        const SiteLookup lookup(all_sites, sites);
        for (std::size_t i = 0; i < where.size(); ++i) {
            const double* value = lookup.value_at(inside[i]);
            result[f][i] =
                value ? *value : limits.clamp(scale.mean + scale.spread * (result[f][i] + correction[f][i]));
        }
    }
    return result;
}

}  // namespace stratareeb
