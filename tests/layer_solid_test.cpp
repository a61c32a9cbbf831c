// SPDX-License-Identifier: GPL-3.0-or-later
// Layer models of known geometry: their solids against closed forms.
#include "mesh/layer_solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "boreholes/errors.h"
#include "boreholes/random_survey.h"
#include "mesh/analysis.h"
#include "mesh/layer_model.h"

namespace stratareeb {
namespace {

using Function = std::function<double(const Point2&)>;

Function even(double value) {
    return [value](const Point2&) { return value; };
}

Survey survey_of(const std::vector<Point2>& holes, const Function& ground,
                 const std::vector<Function>& layers) {
    Survey survey;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const std::string code = "L" + std::to_string(i + 1);
        survey.units.push_back({code, code, "#808080"});
    }
    for (const Point2& at : holes) {
        Borehole hole;
        hole.at = at;
        hole.horizons.push_back(ground(at));
        for (const Function& layer : layers) {
            hole.layers.push_back({Knowledge::Measured, layer(at)});
            hole.horizons.push_back(*hole.horizons.back() - layer(at));
        }
        survey.holes.push_back(hole);
    }
    return survey;
}

constexpr double kSide = 100;

//! The corners of a square and holes at random in it.
std::vector<Point2> scattered(std::size_t count, std::uint64_t seed, const Point2& corner = {}) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> anywhere(0, kSide);
    std::vector<Point2> holes{{0, 0}, {kSide, 0}, {kSide, kSide}, {0, kSide}};
    while (holes.size() < count) {
        const double x = std::round(anywhere(random) * 64) / 64, y = std::round(anywhere(random) * 64) / 64;
        holes.push_back({x, y});
    }
    for (Point2& p : holes) p = {p.x + corner.x, p.y + corner.y};
    return holes;
}

std::vector<Point2> grid(std::size_t side) {
    std::vector<Point2> holes;
    for (std::size_t j = 0; j < side; ++j)
        for (std::size_t i = 0; i < side; ++i) {
            const double step = kSide / static_cast<double>(side - 1);
            holes.push_back({static_cast<double>(i) * step, static_cast<double>(j) * step});
        }
    return holes;
}

MeshReport report(const LayerModel& model, std::size_t layer) {
    return analyze(build_layer_solid(model, layer).surface);
}

void expect_relative(double found, double exact) {
    EXPECT_NEAR(found, exact, 1e-9 * std::abs(exact));
}

struct Way {
    InterpolatorKind interpolator;
    std::optional<double> spacing;
};

//! Both interpolators, on the bare triangulation and on a fine one.
class ClosedForms : public ::testing::TestWithParam<Way> {
 protected:
    LayerModelOptions options() const {
        return {.interpolator = GetParam().interpolator, .spacing = GetParam().spacing};
    }
};
INSTANTIATE_TEST_SUITE_P(Ways, ClosedForms,
                         ::testing::Values(Way{InterpolatorKind::Linear, 0.0},
                                           Way{InterpolatorKind::Linear, 7.0},
                                           Way{InterpolatorKind::NaturalNeighbour, 0.0},
                                           Way{InterpolatorKind::NaturalNeighbour, 7.0}));

TEST_P(ClosedForms, slab) {
    const auto model =
        build_layer_model(survey_of(scattered(20, 1), even(10), {even(2), even(0.5)}), options());
    for (const auto& [layer, thickness] : {std::pair(0, 2.0), std::pair(1, 0.5)}) {
        const MeshReport found = report(model, static_cast<std::size_t>(layer));
        EXPECT_TRUE(found.watertight);
        expect_relative(found.volume, kSide * kSide * thickness);
        expect_relative(found.area, 2 * kSide * kSide + 4 * kSide * thickness);
    }
    expect_relative(envelope_volume(model), kSide * kSide * 2.5);
}

TEST_P(ClosedForms, dipping_plane) {
    constexpr double kDipX = 0.3, kDipY = -0.45, kThickness = 3;
    const auto ground = [](const Point2& p) { return 50 + kDipX * p.x + kDipY * p.y; };
    const auto model = build_layer_model(survey_of(scattered(25, 2), ground, {even(kThickness)}), options());
    const MeshReport found = report(model, 0);
    EXPECT_TRUE(found.watertight);
    expect_relative(found.volume, kSide * kSide * kThickness);
    const double tilt = std::sqrt(1 + kDipX * kDipX + kDipY * kDipY);
    expect_relative(found.area, 2 * kSide * kSide * tilt + 4 * kSide * kThickness);
    for (const auto v : model.plan.surface.vertices()) {
        const auto& p = model.plan.surface.point(v);
        EXPECT_NEAR(model.horizons[0][static_cast<std::size_t>(v.idx())], ground({p[0], p[1]}), 1e-9);
    }
}

// A thickness that grows from nothing in the west to 8 in the east, the holes standing on these two sides.
TEST_P(ClosedForms, wedge) {
    constexpr double kThickness = 8;
    std::vector<Point2> holes;
    for (const double x : {0.0, kSide})
        for (const double y : {0.0, 30.0, 55.0, kSide}) holes.push_back({x, y});
    LayerModelOptions way = options();
    way.pinch_out.fraction = 0;
    const auto wedge = [](const Point2& p) { return kThickness * p.x / kSide; };
    const auto model = build_layer_model(survey_of(holes, even(0), {wedge}), way);
    const MeshReport found = report(model, 0);
    EXPECT_TRUE(found.watertight);
    expect_relative(found.volume, kSide * kSide * kThickness / 2);
    const double slope = std::hypot(kSide, kThickness) * kSide;
    expect_relative(found.area, kSide * kSide + slope + kSide * kThickness + 2 * kSide * kThickness / 2);
    EXPECT_EQ(found.genus, 0u);
}

TEST_P(ClosedForms, layer_that_ends_half_way) {
    std::vector<Point2> holes;
    for (const double x : {0.0, kSide})
        for (const double y : {0.0, 20.0, 70.0, kSide}) holes.push_back({x, y});
    const auto model = build_layer_model(
        survey_of(holes, even(0), {even(1), [](const Point2& p) { return p.x > 0 ? 6.0 : 0.0; }}), options());
    const MeshReport found = report(model, 1);
    EXPECT_TRUE(found.watertight);
    expect_relative(found.volume, kSide * kSide / 2 * 6 / 2);
    EXPECT_NEAR(found.box_min.x, kSide / 2, 1e-9);
}

TEST_P(ClosedForms, far_from_the_origin) {
    const Point2 corner{5e6, 4.9e6};
    const auto ground = [&](const Point2& p) { return 20'000 + 0.1 * (p.x - corner.x); };
    const auto model = build_layer_model(survey_of(scattered(20, 3, corner), ground, {even(4)}), options());
    expect_relative(report(model, 0).volume, kSide * kSide * 4);
    EXPECT_GE(model.origin.x, 5e6 - 1000);
    EXPECT_GE(model.origin.y, 4.9e6 - 1000);
    EXPECT_GE(model.origin.z, 19'000);
    for (const auto v : model.plan.surface.vertices()) {
        EXPECT_LE(std::abs(model.plan.surface.point(v)[0]), 1000);
        EXPECT_LE(std::abs(model.plan.surface.point(v)[1]), 1000);
    }
}

TEST_P(ClosedForms, box_around_the_holes) {
    LayerModelOptions way = options();
    way.footprint = box_footprint(scattered(10, 4), 15);
    if (way.spacing == 0.0) way.spacing = 20;
    const auto model = build_layer_model(survey_of(scattered(10, 4), even(3), {even(2)}), way);
    const MeshReport found = report(model, 0);
    EXPECT_TRUE(found.watertight);
    expect_relative(found.volume, 130 * 130 * 2);
    expect_relative(found.area, 2 * 130 * 130 + 4 * 130 * 2);
}

TEST_P(ClosedForms, polygon_with_a_window) {
    LayerModelOptions way = options();
    way.footprint =
        Footprint{{{10, 10}, {90, 10}, {90, 90}, {10, 90}}, {{40, 40}, {60, 40}, {60, 60}, {40, 60}}};
    const auto model = build_layer_model(survey_of(scattered(30, 5), even(3), {even(2)}), way);
    const MeshReport found = report(model, 0);
    EXPECT_TRUE(found.watertight);
    expect_relative(found.volume, (80 * 80 - 20 * 20) * 2);
    expect_relative(found.area, 2 * (80 * 80 - 20 * 20) + (4 * 80 + 4 * 20) * 2);
    EXPECT_EQ(found.genus, 1u);
    EXPECT_EQ(model.plan.hole_vertex[0], PlanMesh::kNoVertex) << "the hole in the corner stands outside";
}

TEST_P(ClosedForms, ground_of_a_terrain_model) {
    LayerModelOptions way = options();
    const auto terrain = [](const Point2& p) { return 100 + std::sin(p.x / 9) * std::cos(p.y / 7); };
    way.terrain = [&](const Point2& p) { return std::optional(terrain(p)); };
    const auto holes = scattered(15, 6);
    // Holes say the ground is half a unit lower: the terrain is bent to pass through them.
    const auto model = build_layer_model(
        survey_of(holes, [&](const Point2& p) { return terrain(p) - 0.5; }, {even(2)}), way);
    for (const auto v : model.plan.surface.vertices()) {
        const auto& p = model.plan.surface.point(v);
        EXPECT_NEAR(model.horizons[0][static_cast<std::size_t>(v.idx())], terrain({p[0], p[1]}) - 0.5, 1e-9);
    }
    expect_relative(report(model, 0).volume, kSide * kSide * 2);
}

TEST(LayerSolid, cone_volume_converges_as_holes_get_denser) {
    constexpr double kRadius = 40, kHeight = 12;
    const auto cone = [](const Point2& p) {
        return std::max(0.0, kHeight * (1 - std::hypot(p.x - kSide / 2, p.y - kSide / 2) / kRadius));
    };
    const double exact = std::numbers::pi * kRadius * kRadius * kHeight / 3;
    for (const auto kind : {InterpolatorKind::Linear, InterpolatorKind::NaturalNeighbour}) {
        std::vector<double> error;
        for (const std::size_t side : {11, 21, 41}) {
            const auto model = build_layer_model(
                survey_of(grid(side), even(0), {even(5), cone, even(3)}),
                {.interpolator = kind, .pinch_out = {0.5}, .spacing = kSide / static_cast<double>(side)});
            const MeshReport found = report(model, 1);
            EXPECT_TRUE(found.watertight);
            EXPECT_EQ(found.components, 1u);
            EXPECT_EQ(found.genus, 0u);
            error.push_back(std::abs(found.volume - exact) / exact);
        }
        EXPECT_LT(error[1], error[0] / 2) << error[0] << " " << error[1] << " " << error[2];
        EXPECT_LT(error[2], error[1] / 2) << error[0] << " " << error[1] << " " << error[2];
        EXPECT_LT(error[2], 0.005);
    }
}

TEST(LayerSolid, random_surveys_of_a_lens_come_near_its_true_volume) {
    RandomSurveyOptions options{.holes = 2000, .layers = 3, .seed = 4, .truth = TruthKind::Lens};
    const AnalyticTruth truth = random_truth(options);
    const auto model = build_layer_model(random_survey(options), {.spacing = 8.0});
    for (std::size_t layer = 0; layer < 3; ++layer)
        EXPECT_NEAR(report(model, layer).volume, truth.volume(layer), 0.01 * truth.volume(layer)) << layer;
}

TEST(LayerSolid, smooth_layers_converge_with_natural_neighbours) {
    std::vector<double> error;
    for (const std::size_t side : {6, 11, 21}) {
        const auto dome = [](const Point2& p) { return 10 + 4 * std::sin(p.x / 30) * std::cos(p.y / 25); };
        const auto model = build_layer_model(survey_of(grid(side), even(0), {dome}), {.spacing = 2.0});
        double worst = 0;
        for (const auto v : model.plan.surface.vertices()) {
            const auto& p = model.plan.surface.point(v);
            const double t = model.thickness(0, static_cast<std::size_t>(v.idx()));
            worst = std::max(worst, std::abs(t - dome({p[0], p[1]})));
        }
        error.push_back(worst);
    }
    EXPECT_LT(error[1], error[0] / 2) << error[0] << " " << error[1] << " " << error[2];
    EXPECT_LT(error[2], error[1] / 2) << error[0] << " " << error[1] << " " << error[2];
}

TEST(LayerSolid, of_an_island_has_a_handle) {
    const auto ring = [](const Point2& p) { return p == Point2{50, 50} ? 0.0 : 4.0; };
    for (const double fraction : {0.0, 0.25, 1.0 / 3, 0.5})
        for (const double spacing : {0.0, 6.0}) {
            const auto model = build_layer_model(survey_of(grid(3), even(0), {even(1), ring, even(1)}),
                                                 {.pinch_out = {fraction}, .spacing = spacing});
            const MeshReport found = report(model, 1);
            EXPECT_TRUE(found.watertight) << fraction << " " << spacing;
            EXPECT_EQ(found.genus, 1u) << fraction << " " << spacing;
            EXPECT_EQ(found.components, 1u);
            EXPECT_EQ(report(model, 0).genus, 0u);
        }
}

TEST(LayerSolid, falls_apart_where_holes_between_lack_the_layer) {
    const auto sides = [](const Point2& p) { return p.x == 50 ? 0.0 : 4.0; };
    for (const double fraction : {0.25, 1.0 / 3, 0.5}) {
        const auto model = build_layer_model(
            survey_of(grid(3), even(0), {even(1), sides}),
            {.interpolator = InterpolatorKind::Linear, .pinch_out = {fraction}, .spacing = 0.0});
        const MeshReport found = report(model, 1);
        EXPECT_TRUE(found.watertight);
        EXPECT_EQ(found.components, 2u);
        expect_relative(found.volume, 2 * (50 * (1 - fraction)) * 4 / 2 * 100);
    }
}

TEST(LayerSolid, is_empty_where_the_layer_is_nowhere) {
    const auto model =
        build_layer_model(survey_of(grid(3), even(0), {even(1), even(0), even(2)}), {.spacing = 0.0});
    const LayerSolid solid = build_layer_solid(model, 1);
    EXPECT_EQ(solid.order, 2u);
    EXPECT_EQ(solid.unit.code, "L2");
    EXPECT_EQ(solid.surface.n_faces(), 0u);
    EXPECT_EQ(model.horizons[1], model.horizons[2]) << "to the last bit";
}

TEST(LayerSolid, normals_are_of_unit_length_and_point_out) {
    const auto model = build_layer_model(survey_of(scattered(9, 8), even(0), {even(2)}), {.spacing = 10.0});
    for (const auto weight : {NormalWeight::Uniform, NormalWeight::Area, NormalWeight::Angle}) {
        const TriMesh solid = build_layer_solid(model, 0, weight).surface;
        const OpenMesh::Vec3d middle{50, 50, -1};
        for (const auto v : solid.vertices()) {
            EXPECT_NEAR(solid.normal(v).norm(), 1, 1e-12);
            EXPECT_GT(solid.normal(v) | (solid.point(v) - middle), 0);
        }
    }
}

TEST(HorizonSurface, shares_the_plan_and_looks_up) {
    const auto model = build_layer_model(survey_of(scattered(9, 9), even(5), {even(2)}), {.spacing = 15.0});
    for (const std::size_t k : {0u, 1u}) {
        const TriMesh surface = horizon_surface(model, k);
        ASSERT_EQ(surface.n_faces(), model.plan.surface.n_faces());
        for (const auto v : surface.vertices()) {
            const auto& plan = model.plan.surface.point(v);
            EXPECT_EQ(surface.point(v), OpenMesh::Vec3d(plan[0], plan[1], k == 0 ? 5 : 3));
            EXPECT_NEAR(surface.normal(v)[2], 1, 1e-12);
        }
    }
}

TEST(LayerModel, is_the_same_each_time) {
    RandomSurveyOptions survey{.holes = 60, .layers = 5, .seed = 9, .pinch_outs = true, .unknown_share = 0.2};
    const auto one = build_layer_model(random_survey(survey)), two = build_layer_model(random_survey(survey));
    EXPECT_EQ(one.horizons, two.horizons);
    for (std::size_t layer = 0; layer < 5; ++layer) {
        const TriangleSoup a = triangle_soup(build_layer_solid(one, layer).surface),
                           b = triangle_soup(build_layer_solid(two, layer).surface);
        EXPECT_EQ(a.points, b.points);
        EXPECT_EQ(a.triangles, b.triangles);
    }
}

TEST(LayerModel, moved_by_whole_numbers_is_the_same_model) {
    const Function layer = [](const Point2& p) { return std::fmod(p.x, 7) > 3 ? 2.0 : 0.0; };
    auto near = survey_of(scattered(30, 10), even(1), {even(1), layer}), far = near;
    for (Borehole& hole : far.holes) hole.at = {hole.at.x + 5e6, hole.at.y + 4e6};
    const auto a = build_layer_model(near, {.spacing = 8.0}), b = build_layer_model(far, {.spacing = 8.0});
    EXPECT_EQ(b.origin, (Point3{5e6, 4e6, 0}));
    EXPECT_EQ(a.horizons, b.horizons);
}

TEST(LayerModel, tells_the_expected_triangles_before_it_makes_any) {
    double told = 0;
    LayerModelOptions options{.spacing = 3.0};
    options.before_meshing = [&](double triangles) { told = triangles; };
    const auto model = build_layer_model(survey_of(scattered(10, 11), even(0), {even(1)}), options);
    const auto made = static_cast<double>(model.plan.surface.n_faces());
    EXPECT_GT(told, made / 2);
    EXPECT_LT(told, made * 2);
    options.before_meshing = [](double) { throw InvalidInput("too many"); };
    EXPECT_THROW(build_layer_model(survey_of(scattered(10, 11), even(0), {even(1)}), options), InvalidInput);
}

TEST(LayerModel, refuses_what_can_carry_no_model) {
    const auto why = [](const Survey& survey, const LayerModelOptions& options = {}) -> std::string {
        try {
            build_layer_model(survey, options);
        } catch (const InvalidInput& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(why({}).find("no holes"), std::string::npos);
    EXPECT_NE(why(survey_of({{0, 0}, {1, 1}, {2, 2}}, even(0), {even(1)})).find("stand in a line"),
              std::string::npos);
    EXPECT_NE(why(survey_of({{0, 0}, {1, 0}, {0, 1}, {0, 0}}, even(0), {even(1)})).find("same place"),
              std::string::npos);
    Survey no_ground = survey_of(grid(2), even(0), {even(1)});
    for (auto& hole : no_ground.holes) hole.horizons = {std::nullopt, std::nullopt};
    EXPECT_NE(why(no_ground).find("no hole gives a ground elevation"), std::string::npos);
}

TEST(LayerModel, of_one_hole_or_a_line_of_holes_works_in_a_box) {
    for (const std::vector<Point2>& holes :
         {std::vector<Point2>{{5, 5}}, {{0, 0}, {10, 10}}, {{0, 0}, {4, 4}, {10, 10}}}) {
        LayerModelOptions options{.spacing = 3.0};
        options.footprint = box_footprint(holes, 5);
        const auto model = build_layer_model(survey_of(holes, even(0), {even(2)}), options);
        const MeshReport found = report(model, 0);
        EXPECT_TRUE(found.watertight);
        expect_relative(found.volume, area(*options.footprint) * 2);
    }
}

}  // namespace
}  // namespace stratareeb
