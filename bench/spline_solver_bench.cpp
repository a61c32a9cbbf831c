// SPDX-License-Identifier: GPL-3.0-or-later
// Least squares of a bicubic spline: the band that sheets are solved with beside Eigen's sparse Cholesky factors, whose order
// is found once before. Arguments: functions along x and y.
#include <benchmark/benchmark.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <vector>

#include "subdivision/banded_cholesky.h"
#include "subdivision/cubic_knots.h"

namespace stratareeb {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr std::size_t kReach = 3;         // functions further apart along x or y share no span
constexpr std::size_t kSamplesASpan = 8;  // along x and along y

// Sums of products of functions along one direction.
std::vector<std::vector<double>> products(std::size_t functions) {
    const CubicKnots knots = CubicKnots::uniform(0, 1, functions - 3);
    std::vector<std::vector<double>> result(functions, std::vector<double>(functions, 0));
    const std::size_t samples = kSamplesASpan * knots.spans();
    for (std::size_t s = 0; s < samples; ++s) {
        const auto v = knots.values((static_cast<double>(s) + 0.5) / static_cast<double>(samples));
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) result[v.first + i][v.first + j] += v.value[i] * v.value[j];
    }
    return result;
}

struct Equations {
    explicit Equations(const benchmark::State& state)
        : nx(static_cast<std::size_t>(state.range(0))),
          ny(static_cast<std::size_t>(state.range(1))),
          in_x(products(nx)),
          in_y(products(ny)),
          right(nx * ny) {
        for (std::size_t f = 0; f < right.size(); ++f) right[f] = std::sin(static_cast<double>(f));
    }

    // On the diagonal and below.
    template <class Visit>
    void each(Visit visit) const {
        for (std::size_t i = 0; i < nx; ++i)
            for (std::size_t k = i; k < std::min(nx, i + kReach + 1); ++k)
                for (std::size_t j = 0; j < ny; ++j) {
                    const std::size_t first = k == i ? j : j - std::min(j, kReach);
                    for (std::size_t l = first; l < std::min(ny, j + kReach + 1); ++l)
                        visit(k * ny + l, i * ny + j, in_x[i][k] * in_y[j][l]);
                }
    }

    std::size_t nx, ny;
    std::vector<std::vector<double>> in_x, in_y;
    std::vector<double> right;
};

void count(benchmark::State& state, const Equations& equations) {
    state.counters["functions"] = static_cast<double>(equations.right.size());
}

void banded(benchmark::State& state) {
    const Equations equations(state);
    for (auto _ : state) {
        BandedCholesky matrix(equations.right.size(), kReach * equations.ny + kReach);
        equations.each([&](std::size_t row, std::size_t column, double v) { matrix.at(row, column) = v; });
        std::vector<double> x = equations.right;
        if (!matrix.factorize()) state.SkipWithError("not positive definite");
        matrix.solve_in_place(x);
        benchmark::DoNotOptimize(x.data());
    }
    count(state, equations);
}

void sparse(benchmark::State& state) {
    const Equations equations(state);
    const auto size = static_cast<Eigen::Index>(equations.right.size());
    const Eigen::Map<const Eigen::VectorXd> right(equations.right.data(), size);
    std::vector<Eigen::Triplet<double>> entries;
    equations.each([&](std::size_t row, std::size_t column, double v) {
        entries.emplace_back(static_cast<int>(row), static_cast<int>(column), v);
    });
    Sparse matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::SimplicialLLT<Sparse> solver;
    solver.analyzePattern(matrix);
    for (auto _ : state) {
        solver.factorize(matrix);
        if (solver.info() != Eigen::Success) state.SkipWithError("not positive definite");
        Eigen::VectorXd x = solver.solve(right);
        benchmark::DoNotOptimize(x.data());
    }
    count(state, equations);
}

void sizes(benchmark::internal::Benchmark* bench) {
    bench->ArgNames({"x", "y"})->Args({24, 24})->Args({48, 48})->Args({96, 96})->Args({400, 24});
    bench->Unit(benchmark::kMillisecond);
}

BENCHMARK(banded)->Apply(sizes);
BENCHMARK(sparse)->Apply(sizes);

}  // namespace
}  // namespace stratareeb
