// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/dart_limit.h"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace stratareeb {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Row r: the next level's vertex r as weights of this level's. 0 is the vertex, 1 … n are its edges' ends.
MatrixXd loop_matrix(int n) {
    MatrixXd M = MatrixXd::Zero(n + 1, n + 1);
    const double c = 0.375 + std::cos(2 * std::numbers::pi / n) / 4, beta = (0.625 - c * c) / n;
    M(0, 0) = 1 - n * beta;
    for (int i = 0; i < n; ++i) {
        M(0, 1 + i) = beta;
        M(1 + i, 0) = M(1 + i, 1 + i) = 3.0 / 8;
        M(1 + i, 1 + (i + 1) % n) += 1.0 / 8;
        M(1 + i, 1 + (i + n - 1) % n) += 1.0 / 8;
    }
    M.row(1).setZero();
    M(1, 0) = M(1, 1) = 0.5;  // the crease
    return M;
}

// The same with the opposite corners of n quads behind.
MatrixXd catmull_clark_matrix(int n) {
    MatrixXd M = MatrixXd::Zero(2 * n + 1, 2 * n + 1);
    for (int i = 0; i < n; ++i) {
        const int edge = 1 + i, next_edge = 1 + (i + 1) % n, face = 1 + n + i,
                  face_before = 1 + n + (i + n - 1) % n;
        for (const int corner : {0, edge, next_edge, face}) M(face, corner) = 0.25;
        M(edge, 0) += 3.0 / 8;
        M(edge, edge) += 3.0 / 8;
        M(edge, face) += 1.0 / 16;
        M(edge, face_before) += 1.0 / 16;
        M(edge, next_edge) += 1.0 / 16;
        M(edge, 1 + (i + n - 1) % n) += 1.0 / 16;
    }
    M.row(1).setZero();
    M(1, 0) = M(1, 1) = 0.5;  // the crease
    const double squared = static_cast<double>(n) * n;
    M(0, 0) = (n - 2.0) / n;
    for (int i = 0; i < n; ++i) {
        M(0, 1 + i) += 1 / squared;
        M.row(0) += M.row(1 + n + i) / squared;
    }
    return M;
}

}  // namespace

DartLimit dart_limit(SubdivisionScheme scheme, int valence) {
    const MatrixXd M =
        scheme == SubdivisionScheme::Loop ? loop_matrix(valence) : catmull_clark_matrix(valence);
    // w M = w with weights that add up to one: one of the equations, which depend on each other, makes room for the sum.
    MatrixXd A = M.transpose() - MatrixXd::Identity(M.rows(), M.cols());
    A.row(0).setOnes();
    VectorXd b = VectorXd::Zero(M.rows());
    b(0) = 1;
    const VectorXd w = A.partialPivLu().solve(b);
    DartLimit limit{w(0), {}, {}};
    limit.edges.assign(w.data() + 1, w.data() + 1 + valence);
    limit.faces.assign(w.data() + 1 + valence, w.data() + w.size());
    return limit;
}

}  // namespace stratareeb
