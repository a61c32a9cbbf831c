// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/projection_strips.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include "subdivision/strip_cells.h"

namespace stratareeb {
namespace {

constexpr std::uint32_t kNone = PlanCells::kNone;
constexpr double kMostWork = 3e4;       // spans to look through, for all edges of a face
constexpr int kMostHalvings = 2;        // of a face
constexpr std::size_t kMostFaces = 50;  // of a body with such a face
constexpr int kSamplesASpan = 10;

class Strips {
 public:
    Strips(SmoothBrep& brep, double close) : brep_(brep), close_(close) {}

    bool cut() {
        int round = 0;
        while (round < kMostHalvings && halve_cells(brep_, costly()) > 0) ++round;
        return round > 0;
    }

 private:
    // The costliest first, as long as their bodies have few faces.
    std::vector<char> costly() const {
        const auto cells = static_cast<std::uint32_t>(brep_.cells.cells.size());
        std::vector<double> works(cells);
        tbb::parallel_for(std::uint32_t{0}, cells, [&](std::uint32_t c) { works[c] = work(c); });
        std::vector<std::uint32_t> order(cells);
        std::iota(order.begin(), order.end(), 0u);
        std::ranges::stable_sort(order, std::greater{}, [&](std::uint32_t c) { return works[c]; });
        std::vector<std::size_t> faces;
        for (const auto& body : brep_.cells.bodies)
            faces.push_back(body.top.size() + body.base.size() + body.walls.size());
        std::vector<char> which(cells, 0);
        for (const auto c : order) {
            if (works[c] <= kMostWork) break;
            const auto& cell = brep_.cells.cells[c];
            const auto has_room = [&](std::uint32_t body) {
                return body == kNone || faces[body] < kMostFaces;
            };
            if (!has_room(cell.body_above) || !has_room(cell.body_below)) continue;
            which[c] = 1;
            for (const auto body : {cell.body_above, cell.body_below})
                if (body != kNone) ++faces[body];
        }
        return which;
    }

    double work(std::uint32_t c) const {
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, far = 0;
        for (const auto& loop : brep_.cells.cells[c].loops)
            for (const auto& use : loop) {
                const auto& edge = brep_.edges[use.edge];
                for (std::size_t k = 0; k < 2; ++k) {
                    const auto [l, h] = std::ranges::minmax(edge.curve.coefficients[k]);
                    low[k] = std::min(low[k], l), high[k] = std::max(high[k], h);
                }
                const auto ends = cad_edge_ends(edge);
                for (std::size_t k = 0; k + 1 < ends.size(); ++k)
                    far += is_far(brep_.sheet(c), edge.curve, ends[k], ends[k + 1]);
            }
        const HeightPatch& sheet = brep_.sheet(c);
        const auto spans = [](const CubicKnots& knots, double from, double to) {
            return static_cast<double>(knots.span(to) - knots.span(from) + 1);
        };
        return far * spans(sheet.x, low[0], high[0]) * spans(sheet.y, low[1], high[1]);
    }

    bool is_far(const HeightPatch& sheet, const SplineCurve& curve, std::size_t first,
                std::size_t last) const {
        const auto& breaks = curve.knots.breaks();
        for (std::size_t s = first; s < last; ++s)
            for (int k = 0; k <= kSamplesASpan; ++k) {
                const double t = std::lerp(breaks[s], breaks[s + 1], k / double(kSamplesASpan));
                if (std::abs(curve.at(2, t) - sheet.z({curve.at(0, t), curve.at(1, t)})) > close_)
                    return true;
            }
        return false;
    }

    SmoothBrep& brep_;
    double close_;
};

}  // namespace

bool cut_for_projection(SmoothBrep& brep, double close) {
    return Strips(brep, close).cut();
}

}  // namespace stratareeb
