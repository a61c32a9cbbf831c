// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/horizon_sheets.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>

#include "subdivision/body_ends.h"
#include "subdivision/thickness_limits.h"

namespace stratareeb {
namespace {

constexpr std::uint32_t kNone = PlanCells::kNone;
constexpr double kLeastTolerance = 0.1;  // as a share of a sheet's own: else knots gather at thin places
constexpr double kBorderShare = 0.1;     // of a sheet's tolerance: what it may be off where its body ends
// Of samples where a body ends, in mean weights of others: where its base is to stay a hair below the sheet above, and where
// the two only are to meet.
constexpr double kGapWeight = 300, kMeetingWeight = 10;
constexpr int kSamplesAnEdge = 4;  // of the plan's triangles, along the end of a body
constexpr double kMargin = 0.02;   // of the longer side, around the plan
constexpr double kGroundShare =
    0.5;                            // of the functions that a sheet may have; the lowest horizon may have all
constexpr double kMuchOfTop = 0.3;  // of a body's area: the sheets above that much of it lend it their spans
constexpr std::size_t kMostOfTops =
    2;  // times the functions of a sheet, however much of the body lies under them
constexpr std::size_t kFewFunctions = 200;
constexpr double kHoleTolerance = 0.5;  // of the tolerance elsewhere, at boreholes
constexpr int kVolumeRounds = 3;
constexpr double kVolumeOff = 2e-4;  // what a body's volume may be off without being corrected
constexpr double kMostShrunk = 0.3;  // of the thickness, by a correction
constexpr double kRimShare = 0.05;   // of its area: what a sample between vertices of the rim weighs
constexpr double kFinestSpan = 0.5;  // of a mean edge of the plan's triangles: shorter spans are not halved
constexpr double kTrustedShare =
    0.02;  // where the sheets above are off by more than that share of the thickness, so is the base
constexpr double kUnusualShare = 1e-3;  // of the plan area
constexpr double kLeastShare = 0.2;     // of the thickness around a place, that a body keeps there
constexpr double kHighestShare = 0.1;   // of the thickness at a sample: less brings limits nearer
constexpr double kLeastGap = 0.5;       // of the gap at ends of bodies

class Fitter {
 public:
    Fitter(const LayerModel& model, const PlanCells& cells, const PlanCurves& curves, double size,
           const HorizonSheetsOptions& options)
        : model_(model),
          plan_(model.plan.surface),
          cells_(cells),
          curves_(curves),
          size_(size),
          options_(options) {}

    HorizonSheets fit() {
        for (const auto& cell : cells_.cells)
            result_.of_cell.push_back(cell.body_above == kNone ? 0 : cell.body_above + 1);
        const std::size_t sheets = cells_.bodies.size() + 1;
        result_.sheets.assign(sheets, {CubicKnots({0, 1}), CubicKnots({0, 1}), {}});
        result_.off.assign(sheets, 0);
        result_.usual_off.assign(sheets, 0);
        result_.least_thickness.assign(cells_.bodies.size(), INFINITY);
        result_.gaps.assign(cells_.bodies.size(), 0);
        result_.mean_thickness.assign(cells_.bodies.size(), 0);
        is_hole_.assign(plan_.n_vertices(), 0);
        for (const auto v : model_.plan.hole_vertex)
            if (v != PlanMesh::kNoVertex) is_hole_[v] = 1;
        lay_first_knots();
        ends_ = body_ends(cells_, result_.of_cell);
        fit_ground();
        report_sheet();
        for (std::uint32_t first = 0, last = 0; first < cells_.bodies.size(); first = last) {
            while (last < cells_.bodies.size() && cells_.bodies[last].layer == cells_.bodies[first].layer)
                ++last;  // bodies of one layer don't depend on each other
            tbb::parallel_for(first, last, [&](std::uint32_t b) {
                fit_base(b);
                report_sheet();
            });
        }
        return std::move(result_);
    }

 private:
    // Bodies of a layer come from several threads.
    void report_sheet() {
        if (!options_.progress) return;
        const std::scoped_lock lock(reports_);
        options_.progress(static_cast<double>(++fitted_) / static_cast<double>(result_.sheets.size()));
    }

    using Corners = std::array<std::uint32_t, 3>;

    Corners corners(std::uint32_t face) const {
        Corners result{};
        std::size_t n = 0;
        for (const auto v : plan_.fv_range(plan_.face_handle(face)))
            result[n++] = static_cast<std::uint32_t>(v.idx());
        return result;
    }

    Point2 point(std::uint32_t v) const {
        const auto& p = plan_.point(TriMesh::VertexHandle(static_cast<int>(v)));
        return {p[0], p[1]};
    }

    Point2 centre(const Corners& c) const {
        const Point2 p = point(c[0]), q = point(c[1]), r = point(c[2]);
        return {(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3};
    }

    double area(std::uint32_t face) const { return plan_.calc_face_area(plan_.face_handle(face)); }

    double finest(const std::vector<std::uint32_t>& faces) const {
        double in_plan = 0;
        for (const auto f : faces) in_plan += area(f);
        return kFinestSpan * std::sqrt(2 * in_plan / static_cast<double>(faces.size()));
    }

    void fit_ground() {
        std::vector<std::uint32_t> faces;
        for (const auto& cell : cells_.cells)
            if (cell.body_above == kNone) faces.insert(faces.end(), cell.faces.begin(), cell.faces.end());
        std::vector<double> share(plan_.n_vertices(), 0);
        const auto& ground = model_.horizons.front();
        HeightSamples samples;
        const double tolerance = options_.tolerance * size_;
        for (const auto f : faces) {
            const Corners c = corners(f);
            samples.covered.push_back(box_of(plan_, f));
            for (const auto v : c) share[v] += area(f) / 6;
            samples.inside.push_back(
                {centre(c), (ground[c[0]] + ground[c[1]] + ground[c[2]]) / 3, area(f) / 2, tolerance});
        }
        for (std::uint32_t v = 0; v < share.size(); ++v)
            if (share[v] > 0)
                samples.inside.push_back(
                    {point(v), ground[v], share[v], (is_hole_[v] ? kHoleTolerance : 1) * tolerance});
        result_.sheets[0] = fit_sheet(samples, faces, {}, kGroundShare).patch;
        measure_off(0, ground, share);
    }

    //! \param share [vertex] of the plan's area
    void measure_off(std::uint32_t sheet, const std::vector<double>& horizon,
                     const std::vector<double>& share) {
        std::vector<std::pair<double, double>> off;  // with the area
        double all = 0;
        for (std::uint32_t v = 0; v < share.size(); ++v) {
            if (!(share[v] > 0)) continue;
            off.emplace_back(std::abs(result_.sheets[sheet].z(point(v)) - horizon[v]), share[v]);
            all += share[v];
        }
        std::ranges::sort(off, std::greater{});
        result_.off[sheet] = off.front().first;
        double further = 0;
        for (const auto& [distance, area] : off) {
            result_.usual_off[sheet] = distance;
            if ((further += area) > kUnusualShare * all) break;
        }
    }

    // A sheet above a body, and what of the body lies under it.
    struct Top {
        std::uint32_t sheet;
        double share = 0;  // of the plan area
        PlanBox box = kEmptyPlanBox;
    };

    // Those over most of the body first.
    std::vector<Top> tops_of(const PlanCells::Body& body, double body_area) const {
        std::map<std::uint32_t, Top> by_sheet;
        for (const auto c : body.top) {
            Top& top = by_sheet.try_emplace(result_.of_cell[c], Top{result_.of_cell[c]}).first->second;
            for (const auto f : cells_.cells[c].faces) {
                top.share += area(f) / body_area;
                for (const auto v : corners(f)) top.box.include(point(v));
            }
        }
        std::vector<Top> tops;
        for (const auto& [sheet, top] : by_sheet) tops.push_back(top);
        std::ranges::stable_sort(tops, std::greater{}, &Top::share);
        return tops;
    }

    // Spans of the sheets above are kept, so that the base of a thin layer can follow its top in all detail: all are
    // halves of halves of the same.
    HeightFit fit_sheet(const HeightSamples& samples, const std::vector<std::uint32_t>& faces,
                        const std::vector<Top>& tops, double share, const LimitMaker& limits = {}) {
        const auto most =
            std::min(static_cast<std::size_t>(share * static_cast<double>(options_.most_functions)),
                     std::max(kFewFunctions, samples.inside.size()));
        CubicKnots x = first_x_, y = first_y_;
        for (const auto& top : tops) {
            const HeightPatch& sheet = result_.sheets[top.sheet];
            const CubicKnots more_x = joined(x, sheet.x.part(top.box.low.x, top.box.high.x)),
                             more_y = joined(y, sheet.y.part(top.box.low.y, top.box.high.y));
            const std::size_t functions = more_x.functions() * more_y.functions();
            if (functions > (top.share < kMuchOfTop ? most : kMostOfTops * options_.most_functions)) continue;
            x = more_x;
            y = more_y;
        }
        return fit_height_patch(samples, {.finest = finest(faces),
                                          .x = x,
                                          .y = y,
                                          .most_functions = most,
                                          .border_weight = options_.end_gap > 0 ? kGapWeight : kMeetingWeight,
                                          .limits = limits});
    }

    static CubicKnots joined(const CubicKnots& a, const CubicKnots& b) {
        std::vector<double> breaks;
        std::ranges::set_union(a.breaks(), b.breaks(), std::back_inserter(breaks));
        return CubicKnots(std::move(breaks));
    }

    void lay_first_knots() {
        double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
        for (const auto v : plan_.vertices()) {
            const Point2 p = point(static_cast<std::uint32_t>(v.idx()));
            x0 = std::min(x0, p.x), x1 = std::max(x1, p.x), y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
        }
        const double margin = kMargin * std::max(x1 - x0, y1 - y0), side = std::min(x1 - x0, y1 - y0);
        const auto knots = [&](double low, double high) {
            return CubicKnots::uniform(
                low - margin, high + margin,
                static_cast<std::size_t>(std::clamp(std::round((high - low) / side), 1.0, 32.0)));
        };
        first_x_ = knots(x0, x1);
        first_y_ = knots(y0, y1);
    }

    // What is known of a body at a vertex.
    struct Here {
        double share = 0;  // of the plan's area
        double top = 0;    // of the sheets above, by area
    };

    // What the base of a body is fitted to, and what it is measured against.
    struct BaseSamples {
        HeightSamples samples;
        std::vector<double> top, thick;  // [samples.inside] of the sheets above; of the model
        double volume = 0, area = 0;     // of the model
    };

    void fit_base(std::uint32_t b) {
        const auto& body = cells_.bodies[b];
        const auto here = look_up(body);
        BaseSamples base = base_samples(b, here);
        result_.gaps[b] =
            std::min(options_.end_gap * size_, options_.thin_end_gap * result_.mean_thickness[b]);
        for (const BodyEnd& end : ends_[b]) add_end(base.samples, end, body_tolerance(b), result_.gaps[b]);
        std::vector<ThicknessSample> thicknesses;
        for (const auto c : body.top)
            for (const auto f : cells_.cells[c].faces) {
                double thick = 0;
                for (const auto v : corners(f)) thick += thickness(body, v) / 3;
                thicknesses.push_back({f, thick, &result_.sheets[result_.of_cell[c]]});
            }
        const LimitMaker limits = [&](const CubicKnots& x, const CubicKnots& y) {
            return limits_below_top(x, y, plan_, thicknesses, base.samples.border, kLeastShare);
        };
        HeightFit fit = fit_sheet(
            base.samples, body.faces, tops_of(body, base.area),
            std::lerp(kGroundShare, 1, (body.layer + 1.0) / static_cast<double>(model_.units.size())),
            limits);
        result_.sheets[b + 1] = fit.patch;
        const double wanted =
            base.volume * (options_.volume_factors.empty() ? 1 : options_.volume_factors[b]);
        for (int round = 0; round < kVolumeRounds; ++round) {
            const double missing = wanted - volume_over(body, b + 1);
            if (std::abs(missing) <= kVolumeOff * base.volume) break;
            for (std::size_t i = 0; i < base.thick.size(); ++i)
                base.samples.inside[i].z -= std::max(missing / base.volume, -kMostShrunk) * base.thick[i];
            fit = refit_height_patch(base.samples, fit, limits);
            result_.sheets[b + 1] = fit.patch;
        }
        measure(b, base, here);
    }

    BaseSamples base_samples(std::uint32_t b, const std::vector<Here>& here) {
        const auto& body = cells_.bodies[b];
        BaseSamples base;
        for (const auto f : body.faces) {
            base.samples.covered.push_back(box_of(plan_, f));
            for (const auto v : corners(f)) base.volume += area(f) * thickness(body, v) / 3;
            base.area += area(f);
        }
        result_.mean_thickness[b] = base.volume / base.area;
        const double tolerance = body_tolerance(b);
        const double top_off = mean_off(body, here);
        const auto add = [&](const Point2& at, double z, double top, double thick, double share,
                             double exact) {
            const double wanted = kTrustedShare * thick;
            const double near_top = top_off * top_off / (top_off * top_off + wanted * wanted);
            base.samples.inside.push_back(
                {at, std::min(std::lerp(z, top - thick, near_top), top - thick / 2), share,
                 exact * std::clamp(options_.thin_tolerance * thick, kLeastTolerance * tolerance, tolerance),
                 top - kHighestShare * thick});
            base.top.push_back(top);
            base.thick.push_back(thick);
        };
        const auto& horizon = model_.horizons[body.layer + 1];
        // Between the vertices of the rim too, where no triangle beyond holds the sheet down. They count for the limit, hardly
        // for the fit.
        const auto add_rim = [&](TriMesh::HalfedgeHandle h) {
            const auto v = static_cast<std::uint32_t>(plan_.from_vertex_handle(h).idx()),
                       w = static_cast<std::uint32_t>(plan_.to_vertex_handle(h).idx());
            for (const double t : {0.25, 0.5, 0.75}) {
                const Point2 p = point(v), q = point(w);
                add({std::lerp(p.x, q.x, t), std::lerp(p.y, q.y, t)}, std::lerp(horizon[v], horizon[w], t),
                    std::lerp(here[v].top / here[v].share, here[w].top / here[w].share, t),
                    std::lerp(thickness(body, v), thickness(body, w), t),
                    kRimShare * (here[v].share + here[w].share), 1);
            }
        };
        for (const auto f : body.faces) {
            double z = 0, top = 0, thick = 0;
            for (const auto v : corners(f))
                z += horizon[v] / 3, top += here[v].top / here[v].share / 3, thick += thickness(body, v) / 3;
            add(centre(corners(f)), z, top, thick, area(f) / 2, 1);
            for (const auto h : plan_.fh_range(plan_.face_handle(f)))
                if (plan_.is_boundary(plan_.edge_handle(h))) add_rim(h);
        }
        for (std::uint32_t v = 0; v < here.size(); ++v)
            if (here[v].share > 0 && !model_.regions.zero_at[v][body.layer])
                add(point(v), horizon[v], here[v].top / here[v].share, thickness(body, v), here[v].share / 2,
                    is_hole_[v] ? kHoleTolerance : 1);
        return base;
    }

    double body_tolerance(std::uint32_t b) const {
        return std::min(options_.tolerance * size_, options_.thickness_tolerance * result_.mean_thickness[b]);
    }

    // Between the sheets, over the body's part of the plan.
    double volume_over(const PlanCells::Body& body, std::uint32_t base) const {
        double volume = 0;
        for (const auto c : body.top)
            for (const auto f : cells_.cells[c].faces)
                volume += area(f) * (mean_height(plan_, f, result_.sheets[result_.of_cell[c]]) -
                                     mean_height(plan_, f, result_.sheets[base]));
        return volume;
    }

    double thickness(const PlanCells::Body& body, std::uint32_t v) const {
        return model_.thickness(body.layer, v);
    }

    // Root mean square of what the sheets above are off the model.
    double mean_off(const PlanCells::Body& body, const std::vector<Here>& here) const {
        double sum = 0, shares = 0;
        for (std::uint32_t v = 0; v < here.size(); ++v) {
            if (!(here[v].share > 0)) continue;
            sum += here[v].share * std::pow(here[v].top / here[v].share - model_.horizons[body.layer][v], 2);
            shares += here[v].share;
        }
        return std::sqrt(sum / shares);
    }

    std::vector<Here> look_up(const PlanCells::Body& body) const {
        std::vector<Here> here(plan_.n_vertices());
        for (const auto c : body.top) {
            const HeightPatch& sheet = result_.sheets[result_.of_cell[c]];
            for (const auto f : cells_.cells[c].faces)
                for (const auto v : corners(f)) {
                    here[v].share += area(f) / 3;
                    here[v].top += area(f) / 3 * sheet.z(point(v));
                }
        }
        return here;
    }

    // Hardly below the sheet above, never through it: CAD programs would find a new edge where sheets cross.
    void add_end(HeightSamples& samples, const BodyEnd& end, double tolerance, double gap) const {
        const auto& line = curves_.lines[cells_.edges[end.edge].line];
        const auto& t = line.parameters;
        for (std::size_t i = 0; i + 1 < t.size(); ++i)
            for (int k = 0; k < kSamplesAnEdge + (i + 2 == t.size()); ++k) {
                const double at = std::lerp(t[i], t[i + 1], k / double(kSamplesAnEdge));
                const Point2 p{line.curve.at(0, at), line.curve.at(1, at)};
                const double top = result_.sheets[end.above].z(p);
                samples.border.push_back({p, top - gap, 1.0 / kSamplesAnEdge, kBorderShare * tolerance,
                                          gap > 0 ? top - kLeastGap * gap : INFINITY});
            }
    }

    void measure(std::uint32_t b, const BaseSamples& base, const std::vector<Here>& here) {
        const HeightPatch& sheet = result_.sheets[b + 1];
        const auto& body = cells_.bodies[b];
        for (std::size_t i = 0; i < base.thick.size(); ++i)
            result_.least_thickness[b] =
                std::min(result_.least_thickness[b], base.top[i] - sheet.z(base.samples.inside[i].at));
        std::vector<double> share;
        for (const Here& h : here) share.push_back(h.share);
        measure_off(b + 1, model_.horizons[body.layer + 1], share);
    }

    const LayerModel& model_;
    const TriMesh& plan_;
    const PlanCells& cells_;
    const PlanCurves& curves_;
    double size_;
    const HorizonSheetsOptions& options_;
    HorizonSheets result_;
    CubicKnots first_x_{{0, 1}}, first_y_{{0, 1}};
    std::vector<char> is_hole_;               // [vertex]
    std::vector<std::vector<BodyEnd>> ends_;  // [body]
    std::mutex reports_;
    std::size_t fitted_ = 0;  // sheets
};

}  // namespace

double mean_height(const TriMesh& plan, std::uint32_t face, const HeightPatch& sheet) {
    std::array<Point2, 3> p;
    std::size_t n = 0;
    for (const auto v : plan.fv_range(plan.face_handle(face))) p[n++] = {plan.point(v)[0], plan.point(v)[1]};
    double sum = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; i + j < 3; ++j)
            for (const int third : {1, 2}) {
                const double a = (i + third / 3.0) / 3, b = (j + third / 3.0) / 3;
                if (a + b > 1) continue;
                sum += sheet.z({p[0].x + a * (p[1].x - p[0].x) + b * (p[2].x - p[0].x),
                                p[0].y + a * (p[1].y - p[0].y) + b * (p[2].y - p[0].y)});
            }
    return sum / 9;
}

HorizonSheets fit_horizon_sheets(const LayerModel& model, const PlanCells& cells, const PlanCurves& curves,
                                 double size, const HorizonSheetsOptions& options) {
    return Fitter(model, cells, curves, size, options).fit();
}

}  // namespace stratareeb
