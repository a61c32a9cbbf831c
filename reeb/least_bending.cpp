// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/least_bending.h"

#include <Eigen/SparseCholesky>

#include <cmath>

#include "reeb/point_math.h"

namespace stratareeb {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;

constexpr std::uint32_t kNone = ~0u;

//! Vertices with one of these among themselves and their neighbours.
std::vector<bool> grown(const TriangleSoup& soup, const std::vector<bool>& vertices) {
    std::vector<bool> result = vertices;
    for (const auto& t : soup.triangles)
        if (vertices[t[0]] || vertices[t[1]] || vertices[t[2]])
            for (const std::uint32_t v : t) result[v] = true;
    return result;
}

std::vector<std::uint32_t> numbered(const std::vector<bool>& chosen, std::uint32_t& count) {
    std::vector<std::uint32_t> number(chosen.size(), kNone);
    count = 0;
    for (std::size_t v = 0; v < chosen.size(); ++v)
        if (chosen[v]) number[v] = count++;
    return number;
}

//! By row: the Laplacian over the root of the vertex's area, applied to the points as they are.
Columns laplacians(const TriangleSoup& soup, const CotangentWeights& weights,
                   const std::vector<std::uint32_t>& row, std::uint32_t rows) {
    Columns result = Columns::Zero(rows, 3);
    const auto add = [&](std::uint32_t v, std::uint32_t w, double weight) {
        if (row[v] == kNone) return;
        const Point3 way = weight / std::sqrt(weights.area[v]) * (soup.points[w] - soup.points[v]);
        result.row(row[v]) += Eigen::RowVector3d(way.x, way.y, way.z);
    };
    for (const auto& [a, b, weight] : weights.edges) {
        add(a, b, weight);
        add(b, a, weight);
    }
    return result;
}

Matrix laplacian_matrix(const CotangentWeights& weights, const std::vector<std::uint32_t>& row,
                        std::uint32_t rows, const std::vector<std::uint32_t>& column, std::uint32_t columns) {
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](std::uint32_t v, std::uint32_t w, double weight) {
        if (row[v] == kNone) return;
        const double share = weight / std::sqrt(weights.area[v]);
        if (column[w] != kNone) entries.emplace_back(row[v], column[w], share);
        if (column[v] != kNone) entries.emplace_back(row[v], column[v], -share);
    };
    for (const auto& [a, b, weight] : weights.edges) {
        add(a, b, weight);
        add(b, a, weight);
    }
    Matrix matrix(rows, columns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

void keep_regular(std::vector<bool>& rows, const CotangentWeights& weights) {
    for (std::size_t v = 0; v < rows.size(); ++v)
        if (!weights.is_regular[v] || !(weights.area[v] > 0)) rows[v] = false;
}

}  // namespace

std::vector<Point3> least_bending(const TriangleSoup& soup, const std::vector<bool>& is_free,
                                  WeightSpace space) {
    std::vector<bool> rows = grown(soup, is_free);
    const CotangentWeights weights = cotangent_weights(soup, space, rows);
    keep_regular(rows, weights);
    std::uint32_t row_count = 0, column_count = 0;
    const auto row = numbered(rows, row_count), column = numbered(is_free, column_count);
    if (row_count == 0 || column_count == 0) return soup.points;
    const Matrix L = laplacian_matrix(weights, row, row_count, column, column_count);
    const Columns here = laplacians(soup, weights, row, row_count);
    const Matrix A = L.transpose() * L;
    const Eigen::SimplicialLDLT<Matrix> solver(A);
    if (solver.info() != Eigen::Success) return soup.points;
    const Columns move = solver.solve(-(L.transpose() * here));
    if (solver.info() != Eigen::Success || !move.allFinite()) return soup.points;
    std::vector<Point3> points = soup.points;
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (column[v] == kNone) continue;
        const auto d = move.row(column[v]);
        points[v].z += d.z();
        if (space == WeightSpace::Plan) continue;
        points[v].x += d.x();
        points[v].y += d.y();
    }
    return points;
}

double bending_energy(const TriangleSoup& soup, const std::vector<bool>& is_asked, WeightSpace space) {
    std::vector<bool> rows = is_asked;
    const CotangentWeights weights = cotangent_weights(soup, space, rows);
    keep_regular(rows, weights);
    std::uint32_t count = 0;
    const auto row = numbered(rows, count);
    const Columns here = laplacians(soup, weights, row, count);
    return space == WeightSpace::Plan ? here.col(2).squaredNorm() : here.squaredNorm();
}

}  // namespace stratareeb
