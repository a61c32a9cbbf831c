// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/crease_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace stratareeb {

namespace {

constexpr std::uint8_t kCorner = 3;  // crease edges at a vertex from which on its value stays

//! Loop's weight of each neighbour of a smooth vertex; its own is 1 - valence * that.
double smooth_weight(std::uint32_t valence) {
    const double c = 0.375 + 0.25 * std::cos(2 * std::numbers::pi / valence);
    return (0.625 - c * c) / valence;
}

double smooth_limit_weight(std::uint32_t valence) {
    return 1 / (valence + 3 / (8 * smooth_weight(valence)));
}

template <double (*Weight)(std::uint32_t)>
double tabulated(std::uint32_t valence) {
    static const auto table = [] {
        std::array<double, 32> weights{};
        for (std::uint32_t n = 2; n < weights.size(); ++n) weights[n] = Weight(n);
        return weights;
    }();
    return valence < table.size() ? table[valence] : Weight(valence);
}

//! The creases of one level, rim included.
struct Sharp {
    std::vector<std::uint32_t> edges;
    std::vector<std::uint8_t> count;  // crease edges at each vertex; kCorner where the value stays
};

void count_creases(Sharp& sharp, const LoopLevel& level, const std::vector<std::uint32_t>& corners) {
    sharp.count.assign(level.vertices, 0);
    for (const std::uint32_t e : sharp.edges)
        for (const std::uint32_t v : level.ends[e])
            if (sharp.count[v] < kCorner) ++sharp.count[v];
    for (const std::uint32_t v : corners) sharp.count[v] = kCorner;
}

Sharp control_sharp(const LoopLevel& level, const FieldCreases& creases) {
    Sharp sharp;
    auto next = creases.edges.begin();
    for (std::uint32_t e = 0; e < level.ends.size(); ++e) {
        const bool named = next != creases.edges.end() && *next == e;
        if (named) ++next;
        if (named || level.is_rim(e)) sharp.edges.push_back(e);
    }
    count_creases(sharp, level, creases.corners);
    return sharp;
}

Sharp refined_sharp(const Sharp& coarse, const LoopLevel& fine, const FieldCreases& creases) {
    Sharp sharp;
    sharp.edges.reserve(2 * coarse.edges.size());
    for (const std::uint32_t e : coarse.edges) sharp.edges.insert(sharp.edges.end(), {2 * e, 2 * e + 1});
    count_creases(sharp, fine, creases.corners);
    return sharp;
}

constexpr double kLoopFar = 0.375;

std::uint32_t other_end(const LoopLevel& level, const LeaningEdge& e) {
    const auto [a, b] = level.ends[e.edge];
    return a == e.vertex ? b : a;
}

//! The halves at their vertices.
std::vector<LeaningEdge> refined_leaning(std::vector<LeaningEdge> leaning, const LoopLevel& fine) {
    for (LeaningEdge& e : leaning) {
        const auto [a, b] = fine.ends[2 * e.edge];
        e.edge = 2 * e.edge + (a == e.vertex || b == e.vertex ? 0 : 1);
    }
    return leaning;
}

//! What a leaning edge adds to the smooth limit of its other end. There its new vertex enters with the weight of a
//! neighbour, and from the next level on it is an edge like any other.
double leaning_limit_weight(const LoopLevel& level, const LeaningEdge& e, const Sharp& sharp) {
    const std::uint32_t u = other_end(level, e);
    return sharp.count[u] < 2 ? tabulated<smooth_limit_weight>(level.valence[u]) * (kLoopFar - e.far) : 0;
}

//! Vertices on a crease get `own` times their value and the rest from their two neighbours along it.
void set_crease_vertices(std::vector<double>& result, const std::vector<double>& x, const LoopLevel& level,
                         const Sharp& sharp, double own) {
    for (const std::uint32_t e : sharp.edges)
        for (const std::uint32_t v : level.ends[e])
            if (sharp.count[v] == 2)
                result[v] = own * x[v];
            else if (sharp.count[v] >= kCorner)
                result[v] = x[v];
    for (const std::uint32_t e : sharp.edges) {
        const auto [a, b] = level.ends[e];
        if (sharp.count[a] == 2) result[a] += 0.5 * (1 - own) * x[b];
        if (sharp.count[b] == 2) result[b] += 0.5 * (1 - own) * x[a];
    }
}

//! Sums over each vertex's neighbours.
std::vector<double> ring_sums(const LoopLevel& level, const std::vector<double>& x) {
    std::vector<double> sum(x.size(), 0.0);
    for (const auto& [a, b] : level.ends) sum[a] += x[b], sum[b] += x[a];
    return sum;
}

template <double (*Weight)(std::uint32_t)>
std::vector<double> averaged(const LoopLevel& level, const Sharp& sharp,
                             const std::vector<std::uint32_t>& corners, const std::vector<double>& x,
                             double crease_own) {
    std::vector<double> result = ring_sums(level, x);
    for (std::size_t v = 0; v < x.size(); ++v) {
        const std::uint32_t n = level.valence[v];
        const double w = tabulated<Weight>(n);
        result[v] = (1 - n * w) * x[v] + w * result[v];
    }
    set_crease_vertices(result, x, level, sharp, crease_own);
    for (const std::uint32_t v : corners) result[v] = x[v];
    return result;
}

std::vector<double> next_values(const LoopLevel& level, const Sharp& sharp,
                                const std::vector<std::uint32_t>& corners,
                                const std::vector<LeaningEdge>& leaning, const std::vector<double>& x) {
    std::vector<double> fine = averaged<smooth_weight>(level, sharp, corners, x, 0.75);
    fine.resize(x.size() + level.ends.size());
    double* middle = fine.data() + x.size();
    for (std::size_t e = 0; e < level.ends.size(); ++e) {
        const auto [a, b] = level.ends[e];
        const auto [c, d] = level.across[e];
        middle[e] =
            d == LoopLevel::kNone ? 0.5 * (x[a] + x[b]) : 0.375 * (x[a] + x[b]) + 0.125 * (x[c] + x[d]);
    }
    for (const LeaningEdge& e : leaning)
        middle[e.edge] += (kLoopFar - e.far) * (x[e.vertex] - x[other_end(level, e)]);
    for (const std::uint32_t e : sharp.edges) middle[e] = 0.5 * (x[level.ends[e][0]] + x[level.ends[e][1]]);
    return fine;
}

std::vector<double> evaluated(const LoopTopology& topology, const FieldCreases& creases,
                              std::vector<double> values, bool on_limit) {
    Sharp sharp = control_sharp(topology.level(0), creases);
    std::vector<LeaningEdge> leaning;
    for (int k = 0; k < topology.levels(); ++k) {
        values = next_values(topology.level(k), sharp, creases.corners, leaning, values);
        sharp = refined_sharp(sharp, topology.level(k + 1), creases);
        leaning = refined_leaning(k == 0 ? creases.leaning : leaning, topology.level(k + 1));
    }
    if (!on_limit) return values;
    const LoopLevel& finest = topology.finest();
    auto limit = averaged<smooth_limit_weight>(finest, sharp, creases.corners, values, 2.0 / 3);
    for (const LeaningEdge& e : leaning) {
        const std::uint32_t u = other_end(finest, e);
        limit[u] += leaning_limit_weight(finest, e, sharp) * (values[e.vertex] - values[u]);
    }
    return limit;
}

}  // namespace

std::vector<double> refined_values(const LoopTopology& topology, const FieldCreases& creases,
                                   const std::vector<double>& control) {
    return evaluated(topology, creases, control, false);
}

std::vector<double> limit_values(const LoopTopology& topology, const FieldCreases& creases,
                                 const std::vector<double>& control) {
    return evaluated(topology, creases, control, true);
}

SparseRows limit_rows(const LoopLevel& control, const FieldCreases& creases) {
    const Sharp sharp = control_sharp(control, creases);
    std::vector<std::vector<std::uint32_t>> columns(control.vertices);
    for (std::uint32_t v = 0; v < control.vertices; ++v) columns[v].push_back(v);
    std::vector<char> is_sharp(control.ends.size(), 0);
    for (const std::uint32_t e : sharp.edges) is_sharp[e] = 1;
    for (std::size_t e = 0; e < control.ends.size(); ++e)
        for (const int end : {0, 1}) {
            const std::uint32_t v = control.ends[e][end];
            if (sharp.count[v] < 2 || (sharp.count[v] == 2 && is_sharp[e]))
                columns[v].push_back(control.ends[e][1 - end]);
        }
    SparseRows rows;
    for (std::uint32_t v = 0; v < control.vertices; ++v) {
        std::ranges::sort(columns[v]);
        const auto others = static_cast<std::uint32_t>(columns[v].size() - 1);
        const double ring = sharp.count[v] == 2 ? 1.0 / 6 : tabulated<smooth_limit_weight>(others);
        for (const std::uint32_t u : columns[v]) {
            rows.column.push_back(u);
            rows.weight.push_back(others == 0 ? 1 : u == v ? 1 - others * ring : ring);
        }
        rows.first.push_back(static_cast<std::uint32_t>(rows.column.size()));
    }
    return rows;
}

}  // namespace stratareeb
