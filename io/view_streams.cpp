// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/view_streams.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

namespace stratareeb {

namespace {

using nlohmann::json;

constexpr double kSteps = 1 << 20;  // over a side: more than a screen shows, less than the 24 bits of a float

struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    void take(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    double size() const { return high - low; }
};

//! Vertices count in the order in which triangles meet them, so that most corners are small numbers.
std::vector<std::uint32_t> corner_codes(const TriMesh& plan) {
    std::vector<std::uint32_t> codes;
    codes.reserve(3 * plan.n_faces());
    std::uint32_t met = 0;
    for (const auto f : plan.faces())
        for (const auto v : plan.fv_range(f)) {
            const auto i = static_cast<std::uint32_t>(v.idx());
            codes.push_back(i == met ? 0 : met - i);
            met = std::max(met, i + 1);
        }
    return codes;
}

std::int64_t steps_above(double value, double low, double step) {
    return std::llround((value - low) / step);
}

//! A horizon's steps below the one over it.
std::vector<std::int64_t> thickness_steps(const LayerModel& model, std::size_t layer, double low, double step,
                                          std::vector<std::int64_t>& horizon) {
    std::vector<std::int64_t> thickness(horizon.size());
    for (std::size_t v = 0; v < horizon.size(); ++v) {
        if (model.thickness(layer, v) == 0) continue;
        const std::int64_t below = steps_above(model.horizons[layer + 1][v], low, step);
        thickness[v] = std::max<std::int64_t>(horizon[v] - below, 1);
        horizon[v] -= thickness[v];
    }
    return thickness;
}

}  // namespace

void ViewStreams::put(std::uint64_t number) {
    for (; number >= 128; number >>= 7) bytes_ += static_cast<char>(number % 128 + 128);
    bytes_ += static_cast<char>(number);
}

json ViewStreams::listed(std::size_t start, std::size_t count) const {
    return {{"offset", start}, {"length", bytes_.size() - start}, {"count", count}};
}

json ViewStreams::add(std::span<const std::uint32_t> numbers) {
    const std::size_t start = bytes_.size();
    for (const std::uint32_t number : numbers) put(number);
    return listed(start, numbers.size());
}

json ViewStreams::add_differences(std::span<const std::int64_t> numbers) {
    const std::size_t start = bytes_.size();
    std::int64_t last = 0;
    for (const std::int64_t number : numbers) {
        const std::int64_t difference = number - last;
        const auto size = static_cast<std::uint64_t>(std::abs(difference));
        put(difference < 0 ? 2 * size - 1 : 2 * size);
        last = number;
    }
    return listed(start, numbers.size());
}

json view_surfaces(const LayerModel& model, ViewStreams& streams) {
    const TriMesh& plan = model.plan.surface;
    Range x, y, z;
    for (const auto v : plan.vertices()) {
        x.take(plan.point(v)[0]);
        y.take(plan.point(v)[1]);
    }
    for (const auto* horizon : {&model.horizons.front(), &model.horizons.back()})
        for (const double value : *horizon) z.take(value);
    const double plan_step = std::max(x.size(), y.size()) / kSteps;
    const double z_step = z.size() > 0 ? z.size() / kSteps : 1;
    std::vector<std::int64_t> east, north, horizon;
    for (const auto v : plan.vertices()) {
        east.push_back(steps_above(plan.point(v)[0], x.low, plan_step));
        north.push_back(steps_above(plan.point(v)[1], y.low, plan_step));
        horizon.push_back(steps_above(model.horizons[0][static_cast<std::size_t>(v.idx())], z.low, z_step));
    }
    json surfaces{{"low", {x.low, y.low, z.low}},
                  {"step", {plan_step, plan_step, z_step}},
                  {"vertices", plan.n_vertices()},
                  {"triangles", plan.n_faces()},
                  {"corner", streams.add(corner_codes(plan))},
                  {"x", streams.add_differences(east)},
                  {"y", streams.add_differences(north)},
                  {"ground", streams.add_differences(horizon)},
                  {"thickness", json::array()}};
    for (std::size_t i = 0; i < model.units.size(); ++i)
        surfaces["thickness"].push_back(
            streams.add_differences(thickness_steps(model, i, z.low, z_step, horizon)));
    return surfaces;
}

}  // namespace stratareeb
