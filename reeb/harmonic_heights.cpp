// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/harmonic_heights.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reeb/cotangent_weights.h"

namespace stratareeb {

namespace {
constexpr double kLeastWeight = 1e-3;  // a Delaunay triangulation's are not below 0 in sum
constexpr std::uint32_t kNone = ~0u;
using Matrix = Eigen::SparseMatrix<double>;

//! Both triangles' shares of an edge in one, lower number first, and not below the least.
std::vector<CotangentWeights::Edge> positive_weights(const TriangleSoup& plan) {
    std::vector<CotangentWeights::Edge> edges, result;
    for (auto edge :
         cotangent_weights(plan, WeightSpace::Plan, std::vector<bool>(plan.points.size(), true)).edges) {
        if (edge.a > edge.b) std::swap(edge.a, edge.b);
        edges.push_back(edge);
    }
    std::ranges::stable_sort(edges, {}, [](const auto& edge) { return std::pair(edge.a, edge.b); });
    for (const auto& edge : edges) {
        if (result.empty() || result.back().a != edge.a || result.back().b != edge.b)
            result.push_back(edge);
        else
            result.back().weight += edge.weight;
    }
    for (auto& edge : result) edge.weight = std::max(edge.weight, kLeastWeight);
    return result;
}

//! From 0 to 1/2; the identity from `stretched` on, and smooth there.
double stretch(double share, double stretched) {
    if (share >= stretched || share <= 0) return share;
    return stretched / (1 + std::log(stretched / share));
}

}  // namespace

std::optional<std::vector<double>> harmonic_heights(const TriangleSoup& plan,
                                                    const std::vector<std::optional<double>>& heights,
                                                    double stretched) {
    std::vector<std::uint32_t> unknown(heights.size(), kNone);
    std::uint32_t count = 0;
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    for (std::size_t v = 0; v < heights.size(); ++v) {
        if (!heights[v]) {
            unknown[v] = count++;
            continue;
        }
        low = std::min(low, *heights[v]);
        high = std::max(high, *heights[v]);
    }
    if (!(low < high)) return std::nullopt;
    // Shares from below and from above, each without the other's rounding where it is small.
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(count, 2);
    const auto share = [&](double z) {
        return Eigen::RowVector2d((z - low) / (high - low), (high - z) / (high - low));
    };
    const auto add = [&](std::uint32_t v, std::uint32_t w, double weight) {
        if (unknown[v] == kNone) return;
        entries.emplace_back(unknown[v], unknown[v], weight);
        if (unknown[w] != kNone)
            entries.emplace_back(unknown[v], unknown[w], -weight);
        else
            right.row(unknown[v]) += weight * share(*heights[w]);
    };
    for (const auto& [a, b, weight] : positive_weights(plan)) {
        add(a, b, weight);
        add(b, a, weight);
    }
    Eigen::MatrixX2d found = right;
    if (count > 0) {
        Matrix A(count, count);
        A.setFromTriplets(entries.begin(), entries.end());
        const Eigen::SimplicialLDLT<Matrix> solver(A);
        if (solver.info() != Eigen::Success) return std::nullopt;
        found = solver.solve(right);
        if (!found.allFinite()) return std::nullopt;
    }
    std::vector<double> result;
    for (std::size_t v = 0; v < heights.size(); ++v) {
        const Eigen::RowVector2d own =
            heights[v] ? share(*heights[v]) : Eigen::RowVector2d(found.row(unknown[v]));
        if (heights[v] && std::min(own[0], own[1]) >= stretched)
            result.push_back(*heights[v]);
        else if (own[0] < own[1])
            result.push_back(own[0] <= 0 ? low : low + stretch(own[0], stretched) * (high - low));
        else
            result.push_back(own[1] <= 0 ? high : high - stretch(own[1], stretched) * (high - low));
    }
    return result;
}

}  // namespace stratareeb
