// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/projection_strips.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <vector>

#include "subdivision/edge_distance.h"
#include "subdivision/face_spans.h"
#include "subdivision/strip_cells.h"

namespace stratareeb {
namespace {

constexpr std::uint32_t kNone = PlanCells::kNone;
constexpr double kMostWork = 3e4;       // spans to look through, for all edges of a face
constexpr int kMostHalvings = 2;        // of a face
constexpr std::size_t kMostFaces = 50;  // of a body with such a face

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
        std::size_t far = 0;
        for (const auto& loop : brep_.cells.cells[c].loops)
            for (const auto& use : loop) {
                const auto& edge = brep_.edges[use.edge];
                const auto ends = cad_edge_ends(edge);
                for (std::size_t k = 0; k + 1 < ends.size(); ++k)
                    far += is_far(brep_.sheet(c), edge.curve, ends[k], ends[k + 1]);
            }
        const FaceSpans spans = face_spans(brep_, c);
        return static_cast<double>(far * (spans.end_x - spans.first_x) * (spans.end_y - spans.first_y));
    }

    bool is_far(const HeightPatch& sheet, const SplineCurve& curve, std::size_t first,
                std::size_t last) const {
        for (std::size_t s = first; s < last; ++s)
            if (distance_within_span(curve, s, sheet) > close_) return true;
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
