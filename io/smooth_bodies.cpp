// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/smooth_bodies.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <BRepCheck_Analyzer.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "boreholes/length_unit.h"
#include "io/coarse_facets.h"
#include "io/smooth_shapes.h"
#include "subdivision/integration_strips.h"
#include "subdivision/projection_strips.h"

namespace stratareeb {
namespace {

constexpr double kIntegrationShare =
    0.4;  // of the volume that a body may be off, for how CAD programs integrate
constexpr double kJoinedShare =
    1e-4;  // of two bodies' volumes: how far that of the two as one may differ from their sum for the same reason
constexpr double kCloseEdge = 1e-3;   // metres from a face: CAD programs open such edges quickly
constexpr double kFacetShare = 0.02;  // of the thinnest body's mean thickness: what facets may be off
constexpr double kFitShare = 0.7;     // of the time of an attempt, the rest being lines and checks
constexpr int kRetries = 3;           // of the fit, while bodies have faults
// Of all sheets together, so that a model of hundreds of bodies comes to an end; and of one sheet at least.
constexpr std::size_t kAllFunctions = 300'000, kLeastFunctions = 1'000;
constexpr std::size_t kManyBodies = 40;                     // that are fitted twice, to come to an end
constexpr double kEndGap = 1e-6;                            // of the size
constexpr std::size_t kManyFaces = 60;                      // of a body
constexpr double kMostCorrected = 0.3;                      // of a body's volume, a time
constexpr double kLeastResponse = 0.25, kMostResponse = 2;  // of a volume to its correction
constexpr double kProgress = 0.7;  // of what volumes are off: a fit that comes to less is worth keeping

class Maker {
 public:
    Maker(const LayerModel& model, const SmoothBodiesOptions& options)
        : model_(model), options_(options), fit_(options.fit) {
        fit_.sheets.progress = [this](double share) { report("fitting smooth faces", kFitShare * share); };
    }

    SmoothBodies make() {
        const std::size_t bodies = build_plan_cells(model_, fit_.cells).bodies.size();
        auto& most = fit_.sheets.most_functions;
        most = std::min(most, std::max(kLeastFunctions, kAllFunctions / std::max<std::size_t>(bodies, 1)));
        if (bodies > kManyBodies || !fit_apart()) {
            fit();
            const int retries = shapes_.size() > kManyBodies ? 1 : kRetries;
            bool with_more = false;
            for (int round = 0; round < retries && count_faults() > 0; ++round)
                if (try_again(with_more))
                    with_more = !are_only_volumes_wrong();
                else if (std::exchange(with_more, true))
                    break;  // more did not help either
        }
        make_facets();
        SmoothBodies result;
        std::map<std::uint32_t, std::size_t> bodies_of_layer;
        for (std::size_t b = 0; b < shapes_.size(); ++b) {
            const auto layer = brep_.cells.bodies[b].layer;
            const Unit& unit = model_.units[layer];
            CadBody body{.name = body_name(unit, bodies_of_layer[layer]++),
                         .color = rgb_from_text(unit.color),
                         .solid = shapes_[b]};
            const auto& quality = brep_.quality[b];
            const bool smooth = faults_[b].empty();
            const std::size_t faces = count_faces(*body.solid);
            if (!smooth)
                result.notes.push_back(
                    fmt::format("'{}' is made of facets ({}, up to {:.3g} off the model): {}", body.name,
                                faces, facets_off_, faults_[b]));
            else if (quality.off > options_.worth_telling * most_off_)
                result.notes.push_back(fmt::format(
                    "'{}': its smooth faces are up to {:.3g} off the triangles where these are steepest",
                    body.name, quality.off));
            result.reports.push_back({.name = body.name,
                                      .smooth = smooth,
                                      .faces = faces,
                                      .off = smooth ? quality.off : facets_off_,
                                      .edge_off = smooth ? quality.edge_off : 0,
                                      .volume = smooth ? volumes_[b] : cad_volume(*body.solid),
                                      .mesh_volume = quality.mesh_volume});
            result.bodies.push_back(std::move(body));
        }
        return result;
    }

 private:
    // From the highest to the lowest point of the model.
    double relief() const {
        return std::ranges::max(model_.horizons.front()) - std::ranges::min(model_.horizons.back());
    }

    // How often all is fitted is not known before: each time counts as half of what is left to do.
    void report(const char* step, double share_of_attempt) const {
        if (!options_.progress) return;
        const double left = std::pow(0.5, attempts_ - 1);
        const std::string name = attempts_ > 1 ? fmt::format("{}, attempt {}", step, attempts_) : step;
        options_.progress(name.c_str(), 1 - left * (1 - share_of_attempt / 2));
    }

    void fit() {
        ++attempts_;
        report("fitting smooth faces", 0);
        brep_ = build_smooth_brep(model_, fit_);
        most_off_ = std::min(options_.most_off * brep_.size, options_.most_of_relief * relief());
        report("checking smooth faces", kFitShare);
        cut_and_examine();
        hold_lines();
    }

    void cut_and_examine() {
        const auto cut = [&] {
            cut_for_integration(brep_, kIntegrationShare * options_.volume_tolerance, kJoinedShare);
        };
        cut();
        if (cut_for_projection(brep_, kCloseEdge / metres_per(model_.length_unit))) cut();
        examine_all();
    }

    // With sheets a hair apart where bodies end, which CAD programs join best. Asks more of the sheets: false if a body has
    // faults, or so many faces that it is better done without.
    bool fit_apart() {
        fit_.sheets.end_gap = kEndGap;
        fit();
        for (int round = 0; round < kRetries && count_faults() > 0; ++round)
            if (!(have_few_faces() && are_only_volumes_wrong() && try_again(false))) break;
        fit_.sheets.end_gap = 0;
        fit_.sheets.volume_factors.clear();  // they allow for the slits of these sheets
        corrected_ = {};
        return count_faults() == 0 && have_few_faces();
    }

    bool have_few_faces() const {
        return std::ranges::all_of(shapes_,
                                   [](const auto& shape) { return count_faces(*shape) <= kManyFaces; });
    }

    std::ptrdiff_t count_faults() const {
        return std::ranges::count_if(faults_, [](const auto& fault) { return !fault.empty(); });
    }

    std::ptrdiff_t count_other_faults() const {
        return count_faults() - std::ranges::count(is_volume_wrong_, 1);
    }

    // Bodies with wrong volumes, together, as shares of each.
    double off_in_volume() const {
        double sum = 0;
        for (std::size_t b = 0; b < shapes_.size(); ++b)
            if (is_volume_wrong_[b]) sum += off_in_volume(b);
        return sum;
    }

    double off_in_volume(std::size_t b) const {
        const double mesh_volume = brep_.quality[b].mesh_volume;
        return std::abs(volumes_[b] - mesh_volume) / mesh_volume;
    }

    bool are_only_volumes_wrong() const { return count_other_faults() == 0; }

    // Fits again for volumes as the lines that were moved left them, and with more functions.
    // \return false if that is no better: then all stays as it was
    bool try_again(bool with_more) {
        auto& factors = fit_.sheets.volume_factors;
        const auto factors_before = factors;
        if (with_more) fit_.sheets.most_functions *= 2;
        const auto before = count_faults(), others_before = count_other_faults();
        const double off_before = off_in_volume();
        auto kept =
            std::make_tuple(brep_, shapes_, is_valid_, is_volume_wrong_, faults_, volumes_, corrected_);
        correct_volumes();
        fit();
        if (count_faults() >= before && count_other_faults() < others_before) {
            correct_volumes();
            fit();
        }
        if (count_faults() < before || (count_faults() == before && count_other_faults() <= others_before &&
                                        off_in_volume() < kProgress * off_before))
            return true;
        std::tie(brep_, shapes_, is_valid_, is_volume_wrong_, faults_, volumes_, corrected_) =
            std::move(kept);
        factors = factors_before;
        return false;
    }

    // By what is missing, as volumes answered to the last correction.
    void correct_volumes() {
        auto& factors = fit_.sheets.volume_factors;
        factors.resize(shapes_.size(), 1);
        const auto before = std::exchange(corrected_, {factors, volumes_});
        for (std::size_t b = 0; b < shapes_.size(); ++b) {
            if (!(volumes_[b] > 0)) continue;
            double response = 1;
            if (before.volumes.size() == volumes_.size() && before.volumes[b] > 0 &&
                before.factors[b] != factors[b])
                response =
                    std::log(volumes_[b] / before.volumes[b]) / std::log(factors[b] / before.factors[b]);
            const double missing = std::pow(brep_.quality[b].mesh_volume / volumes_[b],
                                            1 / std::clamp(response, kLeastResponse, kMostResponse));
            factors[b] *= std::clamp(missing, 1 - kMostCorrected, 1 + kMostCorrected);
        }
    }

    // Lines that were moved may touch where many meet closely: then they stay where the model has them, if that is better.
    void hold_lines() {
        if (std::ranges::count(is_valid_, 0) == 0) return;
        const auto before = count_faults();
        SmoothBrepOptions steady = fit_;
        steady.snap_lines = false;
        SmoothBrep moved = std::exchange(brep_, rebuild_smooth_brep(model_, brep_.horizons, steady));
        cut_and_examine();
        if (count_faults() < before) return;
        brep_ = std::move(moved);
        examine_all();
    }

    void examine_all() {
        shapes_ = smooth_shapes(brep_);
        faults_.assign(shapes_.size(), {});
        is_valid_.assign(shapes_.size(), 1);
        is_volume_wrong_.assign(shapes_.size(), 0);
        volumes_.assign(shapes_.size(), NAN);
        tbb::parallel_for(std::size_t{0}, shapes_.size(), [&](std::size_t b) { examine(b, *shapes_[b]); });
    }

    void examine(std::size_t b, const TopoDS_Shape& shape) {
        const auto& quality = brep_.quality[b];
        faults_[b] = fault_of(quality);
        if (!faults_[b].empty()) return;
        try {
            volumes_[b] = cad_volume(shape);
            if (!BRepCheck_Analyzer(shape).IsValid()) {
                faults_[b] = "smooth faces make no valid solid of it";
                is_valid_[b] = 0;
            }
        } catch (const Standard_Failure& e) {
            faults_[b] = fmt::format("OpenCASCADE can't check its smooth faces ({})", e.GetMessageString());
        }
        if (!faults_[b].empty()) return;
        const double off = off_in_volume(b);
        if (off <= options_.volume_tolerance) return;
        faults_[b] = fmt::format("smooth faces would change its volume by {:.2g} %", 100 * off);
        is_volume_wrong_[b] = 1;
    }

    std::string fault_of(const SmoothBrep::BodyQuality& quality) const {
        if (!(quality.least_thickness > 0)) return "its smooth top and base would cross";
        if (!(quality.usual_off <= most_off_))
            return fmt::format("smooth faces would be {:.3g} off", quality.usual_off);
        if (!(quality.edge_off <= options_.most_edge_off * brep_.size))
            return fmt::format("smooth faces would meet only to {:.3g}", quality.edge_off);
        return {};
    }

    // Planar solids of bodies that can't be smooth.
    void make_facets() {
        std::vector<std::size_t> faulty;
        double least_mean = INFINITY;  // thickness
        for (std::size_t b = 0; b < shapes_.size(); ++b) {
            if (faults_[b].empty()) continue;
            faulty.push_back(b);
            least_mean = std::min(least_mean, brep_.horizons.mean_thickness[b]);
        }
        if (faulty.empty()) return;
        if (options_.progress) options_.progress("making facets", 1);
        const auto made =
            coarse_facets(model_, brep_.cells, faulty,
                          {.max_error = std::min(options_.facet_error * brep_.size, kFacetShare * least_mean),
                           .volume_tolerance = options_.volume_tolerance});
        facets_off_ = made.deviation;
        for (std::size_t i = 0; i < faulty.size(); ++i) shapes_[faulty[i]] = made.solids[i];
    }

    const LayerModel& model_;
    const SmoothBodiesOptions& options_;
    double most_off_ = 0;  // of faces from the model
    SmoothBrepOptions fit_;
    SmoothBrep brep_;
    std::vector<std::shared_ptr<const TopoDS_Shape>> shapes_;  // [body]
    std::vector<char> is_valid_, is_volume_wrong_;             // [body]
    std::vector<std::string> faults_;                          // [body]; empty = sound
    std::vector<double> volumes_;
    struct {
        std::vector<double> factors, volumes;  // [body]
    } corrected_;                              // what the last correction began with
    double facets_off_ = 0;
    int attempts_ = 0;
};

}  // namespace

SmoothBodies smooth_bodies(const LayerModel& model, const SmoothBodiesOptions& options) {
    return Maker(model, options).make();
}

}  // namespace stratareeb
