// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/level_cuts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "boreholes/errors.h"
#include "mesh/triangle_soup.h"

namespace stratareeb {
namespace {

constexpr double kSameHeight = 1e-12;  // of the model's height: rounding

using Polygon = std::vector<std::uint32_t>;
using Triangle = std::array<std::uint32_t, 3>;

//! A place on an edge at which horizons `first` to `last` reach the level; several where layers between them are absent.
struct EdgeCut {
    double share = 0;  // of the way from the edge's lower-numbered vertex
    std::size_t first = 0, last = 0;
    std::uint32_t vertex = 0;
};

double cross_product(const Point2& o, const Point2& a, const Point2& b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

//! Smallest sine of an angle, negative for a triangle that runs clockwise.
double quality(const Point2& a, const Point2& b, const Point2& c) {
    const double area = cross_product(a, b, c);
    const double ab = std::hypot(b.x - a.x, b.y - a.y), bc = std::hypot(c.x - b.x, c.y - b.y),
                 ca = std::hypot(a.x - c.x, a.y - c.y);
    return area / std::max({ab * bc, bc * ca, ca * ab});
}

//! Cuts a model's plan at one level.
class LevelCut {
 public:
    LevelCut(TriangleSoup& plan, std::vector<std::vector<double>>& horizons, double level, double tolerance)
        : plan_(plan), horizons_(horizons), level_(level), tolerance_(tolerance) {}

    //! \param first_added number of the first vertex that is none of the model's own
    void run(std::uint32_t first_added) {
        snap(first_added);
        std::vector<Triangle> triangles;
        triangles.reserve(plan_.triangles.size() * 5 / 4);
        for (const Triangle& triangle : plan_.triangles) {
            if (!is_crossed(triangle)) {
                triangles.push_back(triangle);
                continue;
            }
            for (const Polygon& piece : pieces_of(triangle)) triangulate(piece, triangles);
        }
        plan_.triangles = std::move(triangles);
    }

 private:
    //! 1 above the level, -1 below, 0 on it.
    int side(std::size_t k, std::uint32_t v) const {
        return (horizons_[k][v] > level_) - (horizons_[k][v] < level_);
    }

    bool is_crossed(const Triangle& t, std::size_t k) const {
        const int a = side(k, t[0]), b = side(k, t[1]), c = side(k, t[2]);
        return std::min({a, b, c}) < 0 && std::max({a, b, c}) > 0;
    }
    bool is_crossed(const Triangle& t) const {
        for (std::size_t k = 0; k < horizons_.size(); ++k)
            if (is_crossed(t, k)) return true;
        return false;
    }

    //! Where a horizon runs beside another at the distance of two levels, both lines are one: vertices of the first are on the
    //! second but for rounding.
    void snap(std::uint32_t first_added) {
        for (auto& horizon : horizons_)
            for (std::size_t v = first_added; v < horizon.size(); ++v)
                if (std::abs(horizon[v] - level_) <= tolerance_) horizon[v] = level_;
    }

    //! The edge's cuts from its lower-numbered vertex to the other; made when first asked for.
    const std::vector<EdgeCut>& cuts_between(std::uint32_t a, std::uint32_t b) {
        const std::pair<std::uint32_t, std::uint32_t> key = std::minmax(a, b);
        const auto [place, is_new] = cuts_of_edge_.try_emplace(key);
        if (is_new) make_cuts(key.first, key.second, place->second);
        return place->second;
    }

    void make_cuts(std::uint32_t a, std::uint32_t b, std::vector<EdgeCut>& cuts) {
        for (std::size_t k = 0; k < horizons_.size(); ++k) {
            if (side(k, a) * side(k, b) >= 0) continue;
            const double from = horizons_[k][a], to = horizons_[k][b];
            const double share = (level_ - from) / (to - from);
            // Equal horizons give equal shares; those that rounding made equal become one place too.
            const auto same = std::ranges::find(cuts, share, &EdgeCut::share);
            if (same != cuts.end())
                same->last = k;
            else
                cuts.push_back({share, k, k});
        }
        std::ranges::sort(cuts, {}, &EdgeCut::share);
        for (EdgeCut& cut : cuts) cut.vertex = add_vertex(a, b, cut);
    }

    std::uint32_t add_vertex(std::uint32_t a, std::uint32_t b, const EdgeCut& cut) {
        const auto between = [&](double from, double to) { return from + cut.share * (to - from); };
        const Point3 &p = plan_.points[a], &q = plan_.points[b];
        plan_.points.push_back({between(p.x, q.x), between(p.y, q.y), 0});
        std::vector<double> column;
        for (const auto& horizon : horizons_) column.push_back(between(horizon[a], horizon[b]));
        for (std::size_t k = cut.first; k <= cut.last; ++k) column[k] = level_;
        // Rounding must not close a layer that is there, nor turn it over.
        for (std::size_t k = cut.first; k-- > 0;)
            column[k] = above(column[k], column[k + 1], is_between(k, a, b));
        for (std::size_t k = cut.last + 1; k < column.size(); ++k)
            column[k] = -above(-column[k], -column[k - 1], is_between(k - 1, a, b));
        for (std::size_t k = 0; k < column.size(); ++k) horizons_[k].push_back(column[k]);
        return static_cast<std::uint32_t>(plan_.points.size() - 1);
    }

    //! Does the layer below horizon k have thickness on the edge?
    bool is_between(std::size_t k, std::uint32_t a, std::uint32_t b) const {
        return horizons_[k][a] > horizons_[k + 1][a] || horizons_[k][b] > horizons_[k + 1][b];
    }

    //! The value, or the least that is above `floor` (where it may not be equal) or at it.
    static double above(double value, double floor, bool apart) {
        return apart ? std::max(value, std::nextafter(floor, HUGE_VAL)) : floor;
    }

    //! The triangle's outline with the cuts of its edges, parted along every horizon's line.
    std::vector<Polygon> pieces_of(const Triangle& triangle) {
        Polygon outline;
        std::vector<std::array<std::uint32_t, 2>> ends(horizons_.size(), {kNone, kNone});  // of each line
        const auto end_at = [&](std::size_t k, std::uint32_t v) { ends[k][ends[k][0] == kNone ? 0 : 1] = v; };
        for (std::size_t e = 0; e < 3; ++e) {
            const std::uint32_t a = triangle[e], b = triangle[(e + 1) % 3];
            outline.push_back(a);
            for (std::size_t k = 0; k < horizons_.size(); ++k)
                if (side(k, a) == 0 && is_crossed(triangle, k)) end_at(k, a);
            std::vector<EdgeCut> cuts = cuts_between(a, b);
            if (a > b) std::ranges::reverse(cuts);
            for (const EdgeCut& cut : cuts) {
                outline.push_back(cut.vertex);
                for (std::size_t k = cut.first; k <= cut.last; ++k)
                    if (side(k, a) * side(k, b) < 0) end_at(k, cut.vertex);
            }
        }
        std::vector<std::array<std::uint32_t, 2>> lines;
        for (const auto& line : ends)
            if (line[1] != kNone && std::ranges::find(lines, line) == lines.end()) lines.push_back(line);
        std::vector<Polygon> pieces{std::move(outline)};
        for (const auto& [from, to] : lines) part(pieces, from, to);
        return pieces;
    }

    static void part(std::vector<Polygon>& pieces, std::uint32_t from, std::uint32_t to) {
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            Polygon& piece = pieces[i];
            auto a = std::ranges::find(piece, from), b = std::ranges::find(piece, to);
            if (a == piece.end() || b == piece.end()) continue;
            if (a > b) std::swap(a, b);
            const auto size = static_cast<std::ptrdiff_t>(piece.size());
            if (b - a < 2 || b - a > size - 2) return;  // an edge of it already
            Polygon inner(a, b + 1);
            piece.erase(a + 1, b);
            pieces.push_back(std::move(inner));
            return;
        }
    }

    //! A convex polygon of a few corners: the best ear first.
    void triangulate(Polygon piece, std::vector<Triangle>& triangles) const {
        const auto at = [&](std::uint32_t v) { return Point2{plan_.points[v].x, plan_.points[v].y}; };
        while (piece.size() > 3) {
            std::size_t best = 0;
            double best_quality = -2;
            for (std::size_t i = 0; i < piece.size(); ++i) {
                const std::size_t n = piece.size();
                const std::uint32_t a = piece[(i + n - 1) % n], b = piece[i], c = piece[(i + 1) % n],
                                    d = piece[(i + 2) % n], z = piece[(i + n - 2) % n];
                // What stays must not be flat either: a cut corner leaves its neighbours as corners.
                const double here = std::min({quality(at(a), at(b), at(c)), quality(at(a), at(c), at(d)),
                                              quality(at(z), at(a), at(c))});
                if (here > best_quality) best = i, best_quality = here;
            }
            const std::size_t n = piece.size();
            triangles.push_back({piece[(best + n - 1) % n], piece[best], piece[(best + 1) % n]});
            piece.erase(piece.begin() + static_cast<std::ptrdiff_t>(best));
        }
        triangles.push_back({piece[0], piece[1], piece[2]});
    }

    static constexpr std::uint32_t kNone = ~0U;

    TriangleSoup& plan_;
    std::vector<std::vector<double>>& horizons_;
    double level_, tolerance_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<EdgeCut>> cuts_of_edge_;
};

}  // namespace

double clear_level(const std::vector<double>& values, double level, double clearance) {
    const auto is_clear = [&](double z) {
        const auto next = std::ranges::lower_bound(values, z - clearance);
        return next == values.end() || *next >= z + clearance;
    };
    if (is_clear(level)) return level;
    // The nearest clear level has a value exactly `clearance` away.
    double best = HUGE_VAL;
    constexpr double kOutward = 1 + 1e-6;  // so that rounding leaves the clearance whole
    const auto consider = [&](double value) {
        for (const double z : {value - kOutward * clearance, value + kOutward * clearance})
            if (std::abs(z - level) < std::abs(best - level) && is_clear(z)) best = z;
        return std::abs(value - level) - kOutward * clearance < std::abs(best - level);  // go on?
    };
    const auto start = std::ranges::lower_bound(values, level);
    for (auto up = start; up != values.end() && consider(*up);) ++up;
    for (auto down = start; down != values.begin() && consider(*(down - 1));) --down;
    return best == HUGE_VAL ? level : best;
}

LayerModel cut_at_levels(const LayerModel& model, const std::vector<double>& levels) {
    LayerModel cut = model;
    TriangleSoup plan = triangle_soup(model.plan.surface);
    const auto vertices = static_cast<std::uint32_t>(plan.points.size());
    const double height =
        *std::ranges::max_element(model.horizons.front()) - *std::ranges::min_element(model.horizons.back());
    for (const double level : levels) {
        for (const auto& horizon : model.horizons)
            if (const auto found = std::ranges::find(horizon, level); found != horizon.end())
                throw InvalidInput(fmt::format("the level {:.17g} passes through vertex {}; move it a little",
                                               level, found - horizon.begin()));
        LevelCut(plan, cut.horizons, level, kSameHeight * height).run(vertices);
    }
    cut.plan.surface = half_edge_mesh(plan);
    return cut;
}

}  // namespace stratareeb
