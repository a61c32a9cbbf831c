// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/decimate_layers.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <sstream>

#include "boreholes/errors.h"
#include "boreholes/random_survey.h"
#include "io/read_boreholes.h"
#include "mesh/model_summary.h"
#include "tests/model_soundness.h"
#include "tests/overlay_deviation.h"

namespace stratareeb {
namespace {

using testing::expect_sound;
using testing::overlay_deviation;

constexpr double kExtent = 300;

std::size_t boundary_vertices(const TriMesh& mesh) {
    std::size_t count = 0;
    for (const auto v : mesh.vertices()) count += mesh.is_boundary(v);
    return count;
}

double region_area(const LayerModel& model, std::size_t layer) {
    double sum = 0;
    for (const auto f : model.plan.surface.faces())
        if (model.regions.in_face[static_cast<std::size_t>(f.idx())][layer])
            sum += model.plan.surface.calc_face_area(f);
    return sum;
}

double footprint_area(const LayerModel& model) {
    double sum = 0;
    for (const auto f : model.plan.surface.faces()) sum += model.plan.surface.calc_face_area(f);
    return sum;
}

double smallest_angle(const LayerModel& model) {
    return analyze(model.plan.surface, {.self_intersections = false}).min_angle_deg;
}

//! Everything of a model, to the last bit.
std::string bytes_of(const LayerModel& model) {
    std::ostringstream text;
    text.precision(17);
    for (const auto v : model.plan.surface.vertices()) text << model.plan.surface.point(v) << '\n';
    for (const auto f : model.plan.surface.faces())
        for (const auto v : model.plan.surface.fv_range(f)) text << v.idx() << ' ';
    for (const auto& horizon : model.horizons)
        for (const double z : horizon) text << z << ' ';
    for (const auto& set : model.regions.in_face) text << set.to_string();
    for (const auto& set : model.regions.zero_at) text << set.to_string();
    for (const auto v : model.plan.hole_vertex) text << v << ' ';
    return text.str();
}

TEST(DecimateLayers, planes_keep_holes_and_corners_alone) {
    for (const TruthKind truth : {TruthKind::Slab, TruthKind::Dipping})
        for (const std::size_t holes : {std::size_t{4}, std::size_t{5}, std::size_t{30}}) {
            RandomSurveyOptions survey{.holes = holes, .truth = truth, .resolution = 0};
            const LayerModel model = build_layer_model(
                random_survey(survey), {.interpolator = InterpolatorKind::Linear, .spacing = kExtent / 25});
            const auto result = decimate_layers(model, {.max_error = 1e-9 * kExtent, .min_angle_deg = 0});
            const TriMesh& plan = result.model.plan.surface;
            EXPECT_EQ(boundary_vertices(plan), 4u);
            EXPECT_EQ(plan.n_vertices(), holes);
            EXPECT_EQ(plan.n_faces(), 2 * (holes - 4) + 2);  // Euler
            EXPECT_LT(result.deviation, 1e-9 * kExtent);
        }
}

TEST(DecimateLayers, a_ridge_stays_a_ridge) {
    // Two planes that meet in x = y: the linear model of four corners, refined, is those two planes.
    Survey survey = random_survey({.holes = 4, .layers = 1, .truth = TruthKind::Slab});
    for (auto& hole : survey.holes)
        if (hole.at == Point2{0, 0})
            for (auto& z : hole.horizons) *z += 50;
    const LayerModel model =
        build_layer_model(survey, {.interpolator = InterpolatorKind::Linear, .spacing = kExtent / 25});
    const auto result = decimate_layers(model, {.max_error = 1e-9});
    EXPECT_LT(result.model.plan.surface.n_faces(), model.plan.surface.n_faces() / 4);
    EXPECT_LT(overlay_deviation(model, result.model), 2e-9);
}

struct Case {
    RandomSurveyOptions survey;
    LayerModelOptions model;
    DecimateLayersOptions decimation;
};

Case random_case(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto below = [&](std::uint64_t n) { return random() % n; };
    Case c;
    c.survey.seed = seed;
    c.survey.extent = kExtent;
    c.survey.holes = 4 + below(30);
    c.survey.layers = 1 + below(5);
    c.survey.plan = std::array{HolePlan::Random, HolePlan::Clustered, HolePlan::Grid}[below(3)];
    c.survey.truth = std::array{TruthKind::Random, TruthKind::Lens, TruthKind::Wedge, TruthKind::Dipping,
                                TruthKind::Dome}[below(5)];
    c.survey.pinch_outs = below(2);
    c.survey.corners = below(2);
    c.survey.zero_share = below(2) ? 0.1 * static_cast<double>(below(6)) : 0;
    c.survey.unknown_share = below(2) ? 0.2 : 0;
    c.survey.cut_off_share = below(2) ? 0.3 : 0;
    if (below(4) == 0) c.survey.thickness = 0.05;
    if (below(2)) c.survey.corner = {5e6, 4.9e6};
    c.model.interpolator = below(2) ? InterpolatorKind::Linear : InterpolatorKind::NaturalNeighbour;
    c.model.pinch_out.fraction = std::array{0.0, 0.25, 1.0 / 3, 0.5}[below(4)];
    c.model.spacing = below(5) ? kExtent / static_cast<double>(6 + below(12)) : 0;
    if (below(3)) c.decimation.max_error = std::array{0.0, 0.05, 0.5, 5.0, 100.0}[below(5)];
    if (!c.decimation.max_error || below(3) == 0) c.decimation.triangles = below(400);
    if (below(2)) c.decimation.line_tolerance = std::array{0.0, 2.0, 20.0}[below(3)];
    c.decimation.min_angle_deg = std::array{0.0, 5.0, 10.0, 25.0}[below(4)];
    return c;
}

void expect_volumes_close(const LayerModel& before, const LayerModel& after, double deviation) {
    for (std::size_t i = 0; i < before.units.size(); ++i)
        EXPECT_NEAR(volume(build_layer_solid(after, i).surface), volume(build_layer_solid(before, i).surface),
                    2 * deviation * footprint_area(before) * (1 + 1e-9) + 1e-6);
}

void expect_lines_kept(const LayerModel& before, const LayerModel& after, const Case& c) {
    EXPECT_NEAR(footprint_area(after), footprint_area(before), 1e-8 * footprint_area(before));
    for (std::size_t i = 0; i < before.units.size(); ++i) {
        EXPECT_EQ(region_area(before, i) > 0, region_area(after, i) > 0);
        if (c.decimation.line_tolerance == 0.0) {
            EXPECT_NEAR(region_area(after, i), region_area(before, i), 1e-8 * footprint_area(before));
        }
    }
}

class RandomModels : public ::testing::TestWithParam<int> {};

TEST_P(RandomModels, stay_sound_and_as_close_as_said) {
    constexpr int kSeedsPerTest = 20;
    for (int k = 0; k < kSeedsPerTest; ++k) {
        const auto seed = static_cast<std::uint64_t>(GetParam() * kSeedsPerTest + k + 1);
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Case c = random_case(seed);
        const Survey survey = random_survey(c.survey);
        const LayerModel before = build_layer_model(survey, c.model);
        const auto result = decimate_layers(before, c.decimation);
        const LayerModel& after = result.model;
        expect_sound(after, survey);
        EXPECT_NEAR(overlay_deviation(before, after), result.deviation, 1e-6);
        if (c.decimation.max_error) {
            EXPECT_LE(result.deviation, *c.decimation.max_error + 1e-9);
        }
        if (c.decimation.triangles) {
            EXPECT_EQ(result.target_reached, after.plan.surface.n_faces() <= *c.decimation.triangles);
        }
        EXPECT_GE(smallest_angle(after), std::min(smallest_angle(before), c.decimation.min_angle_deg) - 1e-6);
        expect_volumes_close(before, after, result.deviation);
        expect_lines_kept(before, after, c);
        if (HasFailure()) break;
    }
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomModels, ::testing::Range(0, 10));

//! Ends and corners of the lines where layers end, with the layers that do.
using LineEdge = std::pair<std::array<Point2, 2>, LayerSet>;
std::vector<LineEdge> line_edges(const LayerModel& model) {
    std::vector<LineEdge> lines;
    const TriMesh& mesh = model.plan.surface;
    for (const auto e : mesh.edges()) {
        if (mesh.is_boundary(e)) continue;
        const auto h = mesh.halfedge_handle(e, 0), o = mesh.halfedge_handle(e, 1);
        const LayerSet differ = model.regions.in_face[static_cast<std::size_t>(mesh.face_handle(h).idx())] ^
                                model.regions.in_face[static_cast<std::size_t>(mesh.face_handle(o).idx())];
        if (differ.none()) continue;
        const auto &a = mesh.point(mesh.from_vertex_handle(h)), &b = mesh.point(mesh.to_vertex_handle(h));
        lines.push_back({{Point2{a[0], a[1]}, Point2{b[0], b[1]}}, differ});
    }
    return lines;
}

double distance(const Point2& p, const Point2& a, const Point2& b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

double farthest(const std::vector<LineEdge>& from, const std::vector<LineEdge>& to) {
    double farthest = 0;
    for (const auto& [ends, layers] : from)
        for (const Point2& p : ends) {
            double nearest = 1e300;
            for (const auto& [other, others] : to)
                if (others == layers) nearest = std::min(nearest, distance(p, other[0], other[1]));
            farthest = std::max(farthest, nearest);
        }
    return farthest;
}

TEST(DecimateLayers, pinch_out_lines_stay_within_their_tolerance) {
    const Survey survey = random_survey({.holes = 60, .layers = 4, .zero_share = 0.4});
    const LayerModel model = build_layer_model(survey, {.spacing = kExtent / 40});
    std::size_t last = model.plan.surface.n_faces();
    for (const double tolerance : {0.0, 0.5, 2.0, 8.0}) {
        const auto result = decimate_layers(model, {.max_error = 100, .line_tolerance = tolerance});
        const auto before = line_edges(model), after = line_edges(result.model);
        ASSERT_FALSE(after.empty());
        EXPECT_LE(farthest(before, after), tolerance + 1e-6);
        EXPECT_LE(farthest(after, before), 1e-9) << "no vertex of a line moves";
        EXPECT_LT(result.model.plan.surface.n_faces(), last) << tolerance;
        last = result.model.plan.surface.n_faces();
    }
}

TEST(DecimateLayers, the_outline_of_a_polygon_keeps_its_corners) {
    const Survey survey = random_survey({.holes = 30, .layers = 3, .zero_share = 0.2});
    Footprint footprint{{}, {}};
    for (int i = 0; i < 40; ++i) {
        const double u = 2 * 3.14159265358979 * i / 40;
        footprint[0].push_back({150 + 140 * std::cos(u), 150 + 140 * std::sin(u)});
        footprint[1].push_back({150 + 30 * std::cos(u), 150 - 30 * std::sin(u)});
    }
    LayerModelOptions options{.spacing = 5};
    options.footprint = footprint;
    const LayerModel model = build_layer_model(survey, options);
    const auto result = decimate_layers(model, {.triangles = 0});
    EXPECT_FALSE(result.target_reached);
    EXPECT_NEAR(footprint_area(result.model), footprint_area(model), 1e-9 * footprint_area(model));
    EXPECT_LT(boundary_vertices(result.model.plan.surface), boundary_vertices(model.plan.surface) / 2);
    EXPECT_GE(boundary_vertices(result.model.plan.surface), 80u);
    EXPECT_EQ(analyze(result.model.plan.surface).euler, 0);
    expect_sound(result.model, survey);
}

TEST(DecimateLayers, reaches_a_number_of_triangles_or_says_why_not) {
    const Survey survey = random_survey({.holes = 40, .layers = 3, .pinch_outs = true});
    const LayerModel model = build_layer_model(survey, {.spacing = kExtent / 40});
    double last = 0;
    for (const std::size_t triangles : {std::size_t{4000}, std::size_t{2000}, std::size_t{800}}) {
        const auto result = decimate_layers(model, {.triangles = triangles});
        EXPECT_TRUE(result.target_reached);
        EXPECT_LE(result.model.plan.surface.n_faces(), triangles);
        EXPECT_GE(result.model.plan.surface.n_faces(), triangles - 1);
        EXPECT_GE(result.deviation, last) << "fewer triangles, farther off";
        last = result.deviation;
        for (const auto& check : check_model(result.model, survey, [&] {
                 std::vector<UnitSummary> units;
                 for (const auto& solid : testing::all_solids(result.model))
                     units.push_back(summarize_unit(result.model, solid, survey));
                 return units;
             }()))
            EXPECT_TRUE(check.ok) << check.name << ": " << check.detail;
        EXPECT_LE(misfit_of(result.model, survey).max, misfit_of(model, survey).max);
    }
    const auto both = decimate_layers(model, {.triangles = 10, .max_error = 0.1});
    EXPECT_FALSE(both.target_reached);
    EXPECT_LE(both.deviation, 0.1);
    EXPECT_NE(both.note.find("10 can't be reached: the error"), std::string::npos) << both.note;
}

TEST(DecimateLayers, is_the_same_every_time_and_reports_progress) {
    const LayerModel model =
        build_layer_model(random_survey({.holes = 40, .zero_share = 0.3}), {.spacing = kExtent / 50});
    std::vector<double> shares;
    const auto first = decimate_layers(
        model, {.max_error = 0.3, .progress = [&](double share) { shares.push_back(share); }});
    const auto second = decimate_layers(model, {.max_error = 0.3});
    EXPECT_TRUE(bytes_of(first.model) == bytes_of(second.model));
    EXPECT_GE(shares.size(), 3u);
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    EXPECT_GE(shares.front(), 0);
    EXPECT_EQ(shares.back(), 1);
}

TEST(DecimateLayers, again_changes_little_more_and_nothing_at_the_same_number) {
    const LayerModel model = build_layer_model(random_survey({.holes = 30}), {.spacing = kExtent / 30});
    const auto once = decimate_layers(model, {.triangles = 500});
    const auto again = decimate_layers(once.model, {.triangles = 500});
    EXPECT_TRUE(bytes_of(once.model) == bytes_of(again.model));
    EXPECT_EQ(again.deviation, 0);
}

TEST(DecimateLayers, refuses_options_without_a_meaning) {
    const LayerModel model = build_layer_model(random_survey(), {.spacing = kExtent / 10});
    EXPECT_THROW(decimate_layers(model, {}), InvalidInput);
    EXPECT_THROW(decimate_layers(model, {.max_error = -1}), InvalidInput);
    EXPECT_THROW(decimate_layers(model, {.max_error = NAN}), InvalidInput);
    EXPECT_THROW(decimate_layers(model, {.triangles = 9, .line_tolerance = -1}), InvalidInput);
    EXPECT_THROW(decimate_layers(model, {.triangles = 9, .min_angle_deg = 60}), InvalidInput);
}

void expect_sound_when_decimated(const BoreholeTable& table) {
    const LayerModel model = build_layer_model(table.survey);
    const auto result = decimate_layers(model, {.max_error = 0.5});
    EXPECT_LT(result.model.plan.surface.n_faces(), model.plan.surface.n_faces());
    EXPECT_LE(result.deviation, 0.5 + 1e-9);
    const auto problems = [&](const LayerModel& m) {
        std::string failed;
        std::vector<UnitSummary> units;
        for (const auto& solid : testing::all_solids(m))
            units.push_back(summarize_unit(m, solid, table.survey));
        for (const auto& check : check_model(m, table.survey, units))
            if (!check.ok) failed += check.name + " ";
        return failed;
    };
    EXPECT_EQ(problems(result.model), problems(model));
}

TEST(DecimateLayers, shipped_tables_stay_sound) {
    expect_sound_when_decimated(read_boreholes({STRATAREEB_SOURCE_DIR "/examples/thesis_sample3.csv"}));
}

TEST(DecimateLayers, real_tables_stay_sound) {
    const std::string data = STRATAREEB_SOURCE_DIR "/../shared/data/";
    if (!std::filesystem::exists(data + "README.md")) GTEST_SKIP() << "no data beside the source tree";
    for (const std::string folder : {"ags_uk/sighthill", "ags_uk/dlr_city_airport", "llobregat_delta"}) {
        SCOPED_TRACE(folder);
        expect_sound_when_decimated(
            read_boreholes({data + folder + "/intervals.csv"}, {.collars = data + folder + "/collars.csv"}));
    }
}

}  // namespace
}  // namespace stratareeb
