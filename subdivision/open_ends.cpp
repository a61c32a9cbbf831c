// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/open_ends.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "subdivision/bent_spans.h"
#include "subdivision/body_ends.h"

namespace stratareeb {
namespace {

constexpr double kStep = 0.1;         // of a curve's spans and of those of the base under it, along the curve
constexpr int kMostSweeps = 100;      // over all places of a body
constexpr int kPullSweeps = 20;       // the first of them: that also lift a base again where it ends
constexpr double kLeastGap = 0.5;     // of the gap
constexpr double kLeastShare = 0.05;  // of the model's thickness at a place
constexpr double kLeastOpening = 5e-4;  // slope of the thickness; what CAD programs tell apart is 4e-4
constexpr double kReach = 0.4;  // of a line's mean edge, and of the way to its end: how far into the body
constexpr double kInland =
    0.35;  // of a triangle at an end: how far from it places are inside wherever the line went
constexpr double kNear = 0.1;        // of the mean thickness: places that are open further need no look
constexpr double kValley = 0.01;     // the same for places between them
constexpr double kInReach = 0.9;     // of the way to the next places: lows further away are theirs
constexpr double kFurthest = 1.5;    // of the same way: as far as the search for lows looks
constexpr double kCornerStep = 0.3;  // radians, between ways into a corner
constexpr double kSteeper = 2;       // than here it may be on the way to a low that matters
constexpr int kValleyRounds = 50, kValleySteps = 16;                    // down to a low
constexpr double kPlacesASpan = 5, kLeastPlaces = 4, kMostPlaces = 64;  // along an edge, into a body

double width_at(const CubicKnots& knots, double at) {
    const std::size_t s = knots.span(at);
    return knots.breaks()[s + 1] - knots.breaks()[s];
}

double span_at(const HeightPatch& patch, const Point2& p) {
    return std::min(width_at(patch.x, p.x), width_at(patch.y, p.y));
}

// So many that places are a share of a span apart.
int places_along(double length, double span) {
    return static_cast<int>(std::ceil(std::clamp(kPlacesASpan * length / span, kLeastPlaces, kMostPlaces)));
}

double distance(const Point2& a, const Point2& b) {
    return std::hypot(b.x - a.x, b.y - a.y);
}

// Where a base is to be below the sheet above: by `least`, and where it is not, by `wanted`.
struct Place {
    Point2 at;
    double top, least, wanted;
    const HeightPatch* sheet = nullptr;  // above, to look for lows around
    double reach = 0;                    // as far as the next places
};

// Where a body is to open.
struct Mouth {
    Point2 at, inward;
    double top_slope;
};

// One body's base.
class Opener {
 public:
    Opener(HorizonSheets& sheets, const LayerModel& model, const PlanCells& cells, const PlanCurves& curves,
           std::uint32_t body, const std::vector<BodyEnd>& ends)
        : sheets_(sheets),
          model_(model),
          cells_(cells),
          curves_(curves),
          body_(cells.bodies[body]),
          base_(sheets.sheets[body + 1]),
          gap_(sheets.gaps[body]),
          mean_thickness_(sheets.mean_thickness[body]),
          bent_(base_) {
        for (const auto c : body_.top)
            for (const auto f : cells_.cells[c].faces) look_at(f, sheets_.sheets[sheets_.of_cell[c]]);
        for (const BodyEnd& end : ends) look_along(end);
        look_around_corners(ends);
        for (auto* places : {&inside_, &thin_, &ends_, &pulled_}) places->sort(bent_);
        mouths_.sort(bent_);
    }

    void run() {
        bend();
        for (int round = 0; round < kValleyRounds && find_valleys(); ++round) bend();
    }

    double least_thickness() const {
        double least = INFINITY;
        for (const Place& p : inside_.all()) least = std::min(least, open(p));
        return least;
    }

 private:
    void bend() {
        bool any = true;
        for (int sweep = 0; sweep < kMostSweeps && any; ++sweep) {
            any = false;
            if (sweep < kPullSweeps) pull();
            any |= lower(ends_);
            any |= tilt();
            any |= lower(inside_);
            any |= lower(thin_);
            any |= lower(valleys_);
        }
    }

    double open(const Place& p) const { return p.top - base_.z(p.at); }

    void lower(const Point2& at, double by) { bent_.bend(at, lower_at(base_, at, by)); }

    bool lower(PlacesBySpan<Place>& places) {
        bool any = false;
        places.each_risen(bent_, [&](const Place& p) {
            const double now = open(p);
            if (now >= p.least) return now - p.least;
            lower(p.at, p.wanted - now);
            any = true;
            return p.wanted - p.least;
        });
        return any;
    }

    // Between places, where the sheets come nearest to each other.
    bool find_valleys() {
        std::vector<Place> found;
        for (auto* places : {&thin_, &valleys_})
            places->each_bent_around(bent_, kFurthest, [&](const Place& p) {
                if (open(p) > kValley * mean_thickness_ + p.wanted) return;
                Place valley = p;
                valley.at = lowest(p);
                if (distance(valley.at, p.at) > kInReach * p.reach) return;  // it goes on from another place
                valley.top = p.sheet->z(valley.at);
                if (open(valley) < p.least) found.push_back(valley);
            });
        for (const Place& valley : found) valleys_.add(valley);
        valleys_.sort(bent_);
        return !found.empty();
    }

    // Down the slope of the thickness, in ever shorter steps.
    Point2 lowest(const Place& p) const {
        Point2 here = p.at;
        double best = open(p), step = p.reach / 2;
        for (int i = 0; i < kValleySteps; ++i) {
            const Point2 g = p.sheet->gradient(here), h = base_.gradient(here);
            const double slope = distance(g, h);
            if (!(slope > 0) || best - kSteeper * slope * 2 * step > p.least) break;
            const Point2 there{here.x - step * (g.x - h.x) / slope, here.y - step * (g.y - h.y) / slope};
            const double then = p.sheet->z(there) - base_.z(there);
            if (then < best)
                here = there, best = then;
            else
                step /= 2;
            if (distance(here, p.at) > p.reach) break;
        }
        return here;  // no further than kFurthest reaches
    }

    // Places at ends that were no further from the sheet above at first, if that can be.
    void pull() {
        pulled_.each_bent(bent_, [&](const Place& p) {
            const double now = open(p);
            if (now <= p.wanted) return;
            lower(p.at, p.wanted - now);
        });
    }

    bool tilt() {
        bool any = false;
        mouths_.each_bent(bent_, [&](const Mouth& m) {
            const Point2 g = base_.gradient(m.at);
            const double opening = m.top_slope - (g.x * m.inward.x + g.y * m.inward.y);
            if (opening >= kLeastOpening) return;
            bent_.bend(m.at, tilt_at(base_, m.at, m.inward, opening - 2 * kLeastOpening));
            any = true;
        });
        return any;
    }

    // Vertices where the body has thickness and the centre of a triangle; if it is at an end or thin, places all over it.
    void look_at(std::uint32_t face, const HeightPatch& top) {
        const TriMesh& plan = model_.plan.surface;
        std::array<Point2, 3> p;
        std::array<double, 3> zero{};
        double mean = 0, least = INFINITY;
        std::size_t n = 0;
        for (const auto v : plan.fv_range(plan.face_handle(face))) {
            const auto i = static_cast<std::size_t>(v.idx());
            const double thickness = model_.thickness(body_.layer, i);
            p[n] = {plan.point(v)[0], plan.point(v)[1]};
            zero[n] = model_.regions.zero_at[i][body_.layer] ? 1 : 0;
            mean += thickness / 3;
            const Place place = inside(p[n], top, thickness);
            least = std::min(least, open(place));
            if (zero[n] == 0) inside_.add(place);
            ++n;
        }
        inside_.add(inside({(p[0].x + p[1].x + p[2].x) / 3, (p[0].y + p[1].y + p[2].y) / 3}, top, mean));
        least = std::min(least, open(inside_.all().back()));
        if (zero[0] + zero[1] + zero[2] == 0 && least >= kNear * mean_thickness_) return;
        const double longest = std::max({distance(p[0], p[1]), distance(p[1], p[2]), distance(p[2], p[0])});
        const int places = places_along(
            longest, std::min({span_at(base_, p[0]), span_at(base_, p[1]), span_at(base_, p[2])}));
        for (int i = 0; i <= places; ++i)
            for (int j = 0; i + j <= places; ++j) {
                const double u = i / double(places), v = j / double(places), w = 1 - u - v;
                if (w * zero[0] + u * zero[1] + v * zero[2] > 1 - kInland) continue;
                add_thin({w * p[0].x + u * p[1].x + v * p[2].x, w * p[0].y + u * p[1].y + v * p[2].y}, top,
                         longest / places);
            }
    }

    static Place inside(const Point2& at, const HeightPatch& top, double thickness) {
        return {.at = at,
                .top = top.z(at),
                .least = kLeastShare * thickness,
                .wanted = 2 * kLeastShare * thickness};
    }

    void add_thin(const Point2& at, const HeightPatch& top, double reach) {
        const Place place{.at = at,
                          .top = top.z(at),
                          .least = kLeastGap * gap_,
                          .wanted = gap_,
                          .sheet = &top,
                          .reach = reach};
        if (open(place) < kNear * mean_thickness_) thin_.add(place);
    }

    // The sheet above the body beside an edge, and on which side of its line the body is: 1 = left, -1 = right, 0 = both.
    std::pair<const HeightPatch*, double> inside_of(const BodyEnd& end) const {
        const HeightPatch* top = nullptr;
        double side = 0;
        for (const auto c : body_.top)
            for (const auto& loop : cells_.cells[c].loops)
                for (const auto& use : loop)
                    if (use.edge == end.edge) {
                        side += use.forward ? 1 : -1;
                        top = &sheets_.sheets[sheets_.of_cell[c]];
                    }
        return {top, side};
    }

    void look_along(const BodyEnd& end) {
        const LineCurve& line = curves_.lines[cells_.edges[end.edge].line];
        const SplineCurve& curve = line.curve;
        const auto [top, side] = inside_of(end);
        const double first = curve.knots.low(), last = curve.knots.high();
        const double edge = (last - first) / static_cast<double>(line.parameters.size() - 1);
        for (double t = first;;) {
            const Point2 p{curve.at(0, t), curve.at(1, t)}, way{curve.at(0, t, 1), curve.at(1, t, 1)};
            Place place{
                .at = p, .top = sheets_.sheets[end.above].z(p), .least = kLeastGap * gap_, .wanted = gap_};
            ends_.add(place);
            place.wanted = std::max(open(place), gap_);
            pulled_.add(place);
            const double speed = std::hypot(way.x, way.y);
            if (side != 0 && speed > 0)
                look_inwards(p, {-side * way.y / speed, side * way.x / speed}, *top,
                             kReach * std::min({edge, t - first, last - t}));
            if (t == last) return;
            t = std::min(last, t + kStep * std::min(span_at(base_, p), width_at(curve.knots, t)));
        }
    }

    void look_inwards(const Point2& p, const Point2& inward, const HeightPatch& top, double reach) {
        const Point2 g = top.gradient(p);
        mouths_.add({.at = p, .inward = inward, .top_slope = g.x * inward.x + g.y * inward.y});
        if (!(reach > 0)) return;
        const int places = places_along(reach, span_at(base_, p));
        for (int k = 1; k <= places; ++k)
            add_thin({p.x + reach * k / places * inward.x, p.y + reach * k / places * inward.y}, top,
                     reach / places);
    }

    // Along lines, places reach no further inwards than it is to their ends: here is what lies around these.
    void look_around_corners(const std::vector<BodyEnd>& ends) {
        std::set<std::uint32_t> vertices;
        const auto vertex = [&](std::uint32_t corner) { return cells_.corners[corner].vertex; };
        for (const BodyEnd& end : ends) {
            vertices.insert(vertex(cells_.edges[end.edge].from));
            vertices.insert(vertex(cells_.edges[end.edge].to));
        }
        for (const auto c : body_.top)
            for (const auto& loop : cells_.cells[c].loops)
                for (std::size_t k = 0; k < loop.size(); ++k) {
                    const auto &in = loop[k], &out = loop[(k + 1) % loop.size()];
                    const auto& edge = cells_.edges[out.edge];
                    if (vertices.contains(vertex(out.forward ? edge.from : edge.to)))
                        look_into_corner(arm(out.edge, out.forward), arm(in.edge, !in.forward),
                                         sheets_.sheets[sheets_.of_cell[c]]);
                }
    }

    // A line as seen from one of its ends.
    struct Arm {
        Point2 corner;
        double angle, mean_edge;
    };

    Arm arm(std::uint32_t edge, bool forward) const {
        const LineCurve& line = curves_.lines[cells_.edges[edge].line];
        const SplineCurve& curve = line.curve;
        const double t = forward ? curve.knots.low() : curve.knots.high(), sign = forward ? 1 : -1;
        const Point2 p{curve.at(0, t), curve.at(1, t)};
        return {p, std::atan2(sign * curve.at(1, t, 1), sign * curve.at(0, t, 1)),
                (curve.knots.high() - curve.knots.low()) * std::hypot(curve.at(0, t, 1), curve.at(1, t, 1)) /
                    static_cast<double>(line.parameters.size() - 1)};
    }

    // From one arm to the left as far as the other.
    void look_into_corner(const Arm& from, const Arm& to, const HeightPatch& top) {
        double turn = to.angle - from.angle;
        if (turn <= 0) turn += 2 * std::numbers::pi;
        const double reach = kReach * std::min(from.mean_edge, to.mean_edge);
        const int ways = static_cast<int>(std::ceil(turn / kCornerStep)),
                  places = places_along(reach, span_at(base_, from.corner));
        for (int w = 1; w < ways; ++w) {
            const double angle = from.angle + turn * w / ways;
            for (int k = 1; k <= places; ++k)
                add_thin({from.corner.x + reach * k / places * std::cos(angle),
                          from.corner.y + reach * k / places * std::sin(angle)},
                         top, reach / places);
        }
    }

    const HorizonSheets& sheets_;
    const LayerModel& model_;
    const PlanCells& cells_;
    const PlanCurves& curves_;
    const PlanCells::Body& body_;
    HeightPatch& base_;
    double gap_;
    double mean_thickness_;
    BentSpans bent_;
    PlacesBySpan<Place> inside_, thin_, valleys_, ends_, pulled_;
    PlacesBySpan<Mouth> mouths_;
};

}  // namespace

void open_body_ends(HorizonSheets& sheets, const LayerModel& model, const PlanCells& cells,
                    const PlanCurves& curves) {
    const auto ends = body_ends(cells, sheets.of_cell);
    // Those above are lowered first.
    for (std::uint32_t first = 0, last = 0; first < ends.size(); first = last) {
        while (last < ends.size() && cells.bodies[last].layer == cells.bodies[first].layer) ++last;
        tbb::parallel_for(first, last, [&](std::uint32_t b) {
            Opener opener(sheets, model, cells, curves, b, ends[b]);
            opener.run();
            sheets.least_thickness[b] = opener.least_thickness();
        });
    }
}

}  // namespace stratareeb
