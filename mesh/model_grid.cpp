// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/model_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "boreholes/errors.h"

namespace stratareeb {

namespace {

//! Cells whose middles lie in one triangle, border included.
class TriangleScan {
 public:
    TriangleScan(const PlanGrid& grid, const Point3& origin) : grid_(grid), origin_(origin) {}

    //! Calls visit(cell, weights) for each.
    template <class Visit>
    void scan(const std::array<Point2, 3>& corner, Visit visit) const {
        const auto [x0, x1] = std::minmax({corner[0].x, corner[1].x, corner[2].x});
        const auto [y0, y1] = std::minmax({corner[0].y, corner[1].y, corner[2].y});
        const double west = grid_.north_west.x - origin_.x, north = grid_.north_west.y - origin_.y;
        const auto columns = range((x0 - west) / grid_.cell, (x1 - west) / grid_.cell, grid_.columns);
        const auto rows = range((north - y1) / grid_.cell, (north - y0) / grid_.cell, grid_.rows);
        const double area = cross(corner[0], corner[1], corner[2]);
        const double slack = -1e-12 * area;  // middles on an edge belong to both sides
        for (std::size_t row = rows[0]; row < rows[1]; ++row)
            for (std::size_t column = columns[0]; column < columns[1]; ++column) {
                const Point2 p{west + (static_cast<double>(column) + 0.5) * grid_.cell,
                               north - (static_cast<double>(row) + 0.5) * grid_.cell};
                std::array<double, 3> weight{cross(p, corner[1], corner[2]), cross(p, corner[2], corner[0]),
                                             cross(p, corner[0], corner[1])};
                if (weight[0] < slack || weight[1] < slack || weight[2] < slack) continue;
                for (double& w : weight) w = std::clamp(w / area, 0.0, 1.0);
                visit(row * grid_.columns + column, weight);
            }
    }

 private:
    static double cross(const Point2& a, const Point2& b, const Point2& c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    }

    //! Cells with middles between two places, counted in cells from the edge.
    static std::array<std::size_t, 2> range(double from, double to, std::size_t count) {
        const double last = static_cast<double>(count);
        return {static_cast<std::size_t>(std::clamp(std::ceil(from - 0.5 - 1e-9), 0.0, last)),
                static_cast<std::size_t>(std::clamp(std::floor(to - 0.5 + 1e-9) + 1, 0.0, last))};
    }

    const PlanGrid& grid_;
    const Point3& origin_;
};

}  // namespace

PlanGrid grid_over(const LayerModel& model, double cell) {
    constexpr double kMostCells = 1e9;
    if (!(cell > 0) || !std::isfinite(cell))
        throw InvalidInput(fmt::format("a cell size of {}: give a length above 0", cell));
    double x0 = HUGE_VAL, y0 = HUGE_VAL, x1 = -HUGE_VAL, y1 = -HUGE_VAL;
    for (const auto v : model.plan.surface.vertices()) {
        const auto& p = model.plan.surface.point(v);
        x0 = std::min(x0, p[0] + model.origin.x);
        x1 = std::max(x1, p[0] + model.origin.x);
        y0 = std::min(y0, p[1] + model.origin.y);
        y1 = std::max(y1, p[1] + model.origin.y);
    }
    const double west = std::floor(x0 / cell), east = std::ceil(x1 / cell);
    const double south = std::floor(y0 / cell), north = std::ceil(y1 / cell);
    if (!((east - west) * (north - south) <= kMostCells))
        throw InvalidInput(fmt::format("cells of {} make {:.3g} of them; give a larger size", cell,
                                       (east - west) * (north - south)));
    return {.north_west = {west * cell, north * cell},
            .cell = cell,
            .columns = static_cast<std::size_t>(std::max(1.0, east - west)),
            .rows = static_cast<std::size_t>(std::max(1.0, north - south))};
}

std::vector<std::vector<double>> rasterized(const LayerModel& model, const PlanGrid& grid,
                                            const std::vector<const std::vector<double>*>& fields) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::vector<double>> result(fields.size(),
                                            std::vector<double>(grid.columns * grid.rows, kNone));
    const TriangleScan scan(grid, model.origin);
    for (const auto f : model.plan.surface.faces()) {
        std::array<Point2, 3> corner;
        std::array<std::size_t, 3> vertex{};
        std::size_t i = 0;
        for (const auto v : model.plan.surface.fv_range(f)) {
            const auto& p = model.plan.surface.point(v);
            vertex[i] = static_cast<std::size_t>(v.idx());
            corner[i++] = {p[0], p[1]};
        }
        scan.scan(corner, [&](std::size_t cell, const std::array<double, 3>& weight) {
            for (std::size_t k = 0; k < fields.size(); ++k) {
                const auto& field = *fields[k];
                result[k][cell] = weight[0] * field[vertex[0]] + weight[1] * field[vertex[1]] +
                                  weight[2] * field[vertex[2]];
            }
        });
    }
    return result;
}

}  // namespace stratareeb
