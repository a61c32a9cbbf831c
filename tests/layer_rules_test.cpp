// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/layer_rules.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "boreholes/errors.h"
#include "boreholes/predict_columns.h"
#include "boreholes/random_survey.h"
#include "io/read_layer_rules.h"
#include "mesh/layer_volumes.h"
#include "subdivision/refined_layers.h"
#include "tests/model_soundness.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

using testing::all_solids;
using testing::expect_sound;

constexpr double kExtent = 300;

//! z = at + dx x + dy y.
struct Plane {
    double at, dx, dy;

    double operator()(double x, double y) const { return at + dx * x + dy * y; }
    Plane operator-(const Plane& o) const { return {at - o.at, dx - o.dx, dy - o.dy}; }
    Plane operator+(double up) const { return {at + up, dx, dy}; }
};

//! Volume of a plane's positive part over the square of kExtent: the square is clipped, the rest is a polygon.
double positive_part(const Plane& d) {
    const std::vector<Point2> square{{0, 0}, {kExtent, 0}, {kExtent, kExtent}, {0, kExtent}};
    std::vector<Point2> kept;
    for (std::size_t i = 0; i < 4; ++i) {
        const Point2 a = square[i], b = square[(i + 1) % 4];
        const double at = d(a.x, a.y), to = d(b.x, b.y);
        if (at >= 0) kept.push_back(a);
        if ((at > 0 && to < 0) || (at < 0 && to > 0))
            kept.push_back({a.x + at / (at - to) * (b.x - a.x), a.y + at / (at - to) * (b.y - a.y)});
    }
    double volume = 0;
    for (std::size_t i = 1; i + 1 < kept.size(); ++i) {
        const Point2 a = kept[0], b = kept[i], c = kept[i + 1];
        const double area = ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
        volume += area * (d(a.x, a.y) + d(b.x, b.y) + d(c.x, c.y)) / 3;
    }
    return volume;
}

//! Between 0 and a plane, no more than `most`.
double clamped_part(const Plane& d, double most) {
    return positive_part(d) - positive_part(d + -most);
}

Survey survey_of(const std::vector<std::string>& codes, const std::vector<Point2>& places,
                 const std::function<std::vector<double>(double, double)>& horizons) {
    Survey survey;
    for (const auto& code : codes) survey.units.push_back({code, code, ""});
    for (const Point2& p : places) {
        Borehole hole{"h" + std::to_string(survey.holes.size() + 1), p, {}, {}, 0};
        const std::vector<double> z = horizons(p.x, p.y);
        for (std::size_t i = 0; i < codes.size(); ++i)
            hole.layers.push_back({Knowledge::Measured, z[i] - z[i + 1]});
        hole.horizons.assign(z.begin(), z.end());
        survey.holes.push_back(hole);
    }
    return survey;
}

std::vector<Point2> scattered(std::size_t count, std::uint64_t seed) {
    std::vector<Point2> places{{0, 0}, {kExtent, 0}, {kExtent, kExtent}, {0, kExtent}};
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> at(0, kExtent);
    while (places.size() < count) places.push_back({at(random), at(random)});
    return places;
}

LayerRules rules_of(std::vector<LayerRule> rules) {
    return {std::move(rules), {}};
}

const Plane kErosion{75, -0.06, -0.05}, kFloor{0, 0.1, 0.03};

//! Dipping beds of 20 under an inclined erosion surface, which reaches into the third.
std::vector<double> eroded_beds(double x, double y) {
    const double e = kErosion(x, y), l = kFloor(x, y);
    return {100, e, std::min(e, l + 40), std::min(e, l + 20), std::min(e, l)};
}

class EachInterpolator : public ::testing::TestWithParam<InterpolatorKind> {};

TEST_P(EachInterpolator, a_plane_erosion_surface_truncates_dipping_beds_to_closed_form_volumes) {
    const Survey survey = survey_of({"cover", "b", "c", "d"}, scattered(40, 7), eroded_beds);
    LayerModelOptions options{
        .interpolator = GetParam(), .rules = rules_of({LayerRule::Erode}), .spacing = 15};
    const LayerModel model = build_layer_model(survey, options);
    expect_sound(model, survey);
    const auto volumes = layer_volumes(model);
    const Plane top{100, 0, 0};
    EXPECT_NEAR(volumes[0], positive_part(top - kErosion), 1e-9 * volumes[0]);
    EXPECT_NEAR(volumes[1], positive_part(kErosion - (kFloor + 40)), 1e-7 * volumes[1]);
    EXPECT_NEAR(volumes[2], clamped_part(kErosion - (kFloor + 20), 20), 1e-7 * volumes[2]);
    EXPECT_NEAR(volumes[3], clamped_part(kErosion - kFloor, 20), 1e-7 * volumes[3]);
    const LayerModel plain = build_layer_model(survey, {.interpolator = GetParam(), .spacing = 15});
    EXPECT_GT(std::abs(layer_volumes(plain)[2] - volumes[2]), 1e-3 * volumes[2]) << "the rule does nothing";
}
INSTANTIATE_TEST_SUITE_P(LayerRules, EachInterpolator,
                         ::testing::Values(InterpolatorKind::Linear, InterpolatorKind::NaturalNeighbour,
                                           InterpolatorKind::Spline));

TEST(LayerRules, the_prediction_without_a_mesh_follows_the_same_rules) {
    const Survey survey = survey_of({"cover", "b", "c", "d"}, scattered(40, 7), eroded_beds);
    CompletionOptions options{.interpolator = InterpolatorKind::Linear,
                              .rules = rules_of({LayerRule::Erode})};
    const std::vector<Point2> where = scattered(200, 99);
    const PredictedColumns columns = ColumnPredictor(survey, options).at(where);
    for (std::size_t p = 0; p < where.size(); ++p) {
        const auto z = eroded_beds(where[p].x, where[p].y);
        for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(columns.thickness[i][p], z[i] - z[i + 1], 1e-9) << p;
    }
}

TEST(LayerRules, an_onlapping_unit_fills_the_relief_up_to_its_own_top) {
    const Plane water{60, 0, 0}, relief{30, 0.2, 0.02};
    const auto horizons = [&](double x, double y) {
        const double s = relief(x, y);
        return std::vector<double>{100, std::max(water(x, y), s), s, s - 15, s - 25};
    };
    const Survey survey = survey_of({"cover", "lake", "rock", "base"}, scattered(30, 5), horizons);
    LayerModelOptions options{.interpolator = InterpolatorKind::Linear,
                              .rules = rules_of({LayerRule::Conformable, LayerRule::Onlap}),
                              .spacing = 20};
    const LayerModel model = build_layer_model(survey, options);
    expect_sound(model, survey);
    const auto volumes = layer_volumes(model);
    const double lake = positive_part(water - relief), area = kExtent * kExtent;
    EXPECT_NEAR(volumes[1], lake, 1e-9 * lake);
    EXPECT_NEAR(volumes[0], positive_part(Plane{100, 0, 0} - relief) - lake, 1e-9 * volumes[0]);
    EXPECT_NEAR(volumes[2], 15 * area, 1e-9 * volumes[2]);
    EXPECT_NEAR(volumes[3], 10 * area, 1e-9 * volumes[3]);
}

TEST(LayerRules, beds_on_a_base_are_cut_by_the_ground_where_they_come_out) {
    const Plane ground{70, -0.1, -0.02}, floor{10, 0.05, 0};
    const auto horizons = [&](double x, double y) {
        const double g = ground(x, y), l = floor(x, y);
        return std::vector<double>{g, std::min(g, l + 25), std::min(g, l + 12), l};
    };
    const Survey survey = survey_of({"a", "b", "c"}, scattered(36, 11), horizons);
    LayerModelOptions options{
        .interpolator = InterpolatorKind::NaturalNeighbour,

        .rules = rules_of({LayerRule::Conformable, LayerRule::Conformable, LayerRule::Base}),
        .spacing = 20};
    const LayerModel model = build_layer_model(survey, options);
    expect_sound(model, survey);
    const auto volumes = layer_volumes(model);
    EXPECT_NEAR(volumes[0], positive_part(ground - (floor + 25)), 1e-9 * volumes[0]);
    EXPECT_NEAR(volumes[1], clamped_part(ground - (floor + 12), 13), 1e-9 * volumes[1]);
    EXPECT_NEAR(volumes[2], clamped_part(ground - floor, 12), 1e-9 * volumes[2]);
}

TEST(LayerRules, a_present_unit_is_no_thinner_than_its_minimum_between_holes) {
    Survey survey = random_survey({.holes = 40, .layers = 3, .seed = 3, .pinch_outs = true});
    LayerModelOptions options{.rules = {{}, {0, 12, 0}}, .spacing = 20};
    const LayerModel model = build_layer_model(survey, options),
                     plain = build_layer_model(survey, {.spacing = 20});
    expect_sound(model, survey);
    std::vector<char> is_hole(model.plan.surface.n_vertices(), 0);
    for (const auto v : model.plan.hole_vertex) is_hole[v] = 1;
    std::size_t raised = 0;
    for (std::size_t v = 0; v < is_hole.size(); ++v) {
        if (is_hole[v] || model.regions.zero_at[v][1]) continue;
        EXPECT_GE(model.thickness(1, v), 12 - 1e-9);
        raised += model.thickness(1, v) < 12 + 1e-9;
    }
    EXPECT_GT(raised, 20u) << "the survey has no thin places";
    EXPECT_GT(layer_volumes(model)[1], layer_volumes(plain)[1]);
    EXPECT_LT(layer_volumes(model)[2], layer_volumes(plain)[2]);
    for (std::size_t v = 0; v < is_hole.size(); ++v) {
        EXPECT_EQ(model.horizons[1][v], plain.horizons[1][v]) << "what lies above stays";
        EXPECT_LE(model.horizons[3][v], plain.horizons[3][v] + 1e-9)
            << "what lies below is pushed down or stays";
    }
}

TEST(LayerRules, words_that_fit_no_unit_or_no_rule_are_refused) {
    const std::vector<Unit> units{{"a", "", ""}, {"b", "", ""}};
    EXPECT_THROW(layer_rule("eroded"), InvalidInput);
    try {
        layer_rules(units, {{"c", LayerRule::Erode, {}}});
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("'c', which is no unit of the table; its units are a, b"),
                  std::string::npos);
    }
    EXPECT_THROW(layer_rules(units, {{"a", {}, -1.0}}), InvalidInput);
    const LayerRules rules = layer_rules(units, {{"b", {}, 2.0}, {"", {}, 1.0}, {"b", LayerRule::Base, {}}});
    EXPECT_EQ(rules.minimum(0), 1);
    EXPECT_EQ(rules.minimum(1), 2);
    EXPECT_EQ(rules.of(1), LayerRule::Base);
    EXPECT_FALSE(layer_rules(units, {{"b", LayerRule::Conformable, 0.0}}).any());
}

TEST(LayerRules, a_table_of_rules_is_read_by_its_header) {
    const TemporaryFolder folder;
    folder.file("units.csv", "name,min_thickness,Code,rule\nSand,0.5,7,Erode\nClay,,8,\n,-,9,onlap\n");
    const auto rules = read_layer_rules((folder / "units.csv").string());
    ASSERT_EQ(rules.size(), 3u);
    EXPECT_EQ(rules[0].code, "7");
    EXPECT_EQ(rules[0].rule, LayerRule::Erode);
    EXPECT_EQ(rules[0].min_thickness, 0.5);
    EXPECT_FALSE(rules[1].rule || rules[1].min_thickness);
    EXPECT_EQ(rules[2].rule, LayerRule::Onlap);
    folder.file("bad.csv", "code,rule\n1,erode\n2,eroded\n");
    try {
        read_layer_rules((folder / "bad.csv").string());
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("bad.csv:3: unknown layer rule 'eroded'"), std::string::npos)
            << error.what();
    }
    folder.file("none.csv", "unit,colour\n1,red\n");
    EXPECT_THROW(read_layer_rules((folder / "none.csv").string()), InvalidInput);
}

TEST(LayerRules, smooth_surfaces_keep_the_cuts) {
    const Survey survey = survey_of({"cover", "b", "c", "d"}, scattered(40, 7), eroded_beds);
    LayerModelOptions options{.interpolator = InterpolatorKind::NaturalNeighbour,
                              .rules = rules_of({LayerRule::Erode}),
                              .spacing_factor = 2,
                              .ring_holes = true};
    const LayerModel smooth = refine_layers(build_layer_model(survey, options), {.levels = 2}).model;
    expect_sound(smooth, survey);
    const auto volumes = layer_volumes(smooth);
    EXPECT_NEAR(volumes[1], positive_part(kErosion - (kFloor + 40)), 2e-3 * volumes[1]);
    EXPECT_NEAR(volumes[2], clamped_part(kErosion - (kFloor + 20), 20), 2e-3 * volumes[2]);
}

//! A random survey under random rules and options, from one number.
struct Case {
    RandomSurveyOptions survey;
    LayerModelOptions model;
};

Case random_case(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto below = [&](std::uint64_t n) { return random() % n; };
    Case c;
    c.survey.seed = seed;
    c.survey.holes = 4 + below(50);
    c.survey.layers = 1 + below(6);
    c.survey.plan = std::array{HolePlan::Random, HolePlan::Clustered, HolePlan::Grid}[below(3)];
    c.survey.truth = std::array{TruthKind::Random, TruthKind::Lens, TruthKind::Wedge, TruthKind::Dipping,
                                TruthKind::Dome}[below(5)];
    c.survey.pinch_outs = below(2);
    c.survey.corners = below(2);
    if (below(2)) c.survey.zero_share = 0.05 * static_cast<double>(below(10));
    if (below(2)) c.survey.unknown_share = 0.05 * static_cast<double>(below(8));
    if (below(2)) c.survey.cut_off_share = 0.05 * static_cast<double>(below(10));
    if (below(3) == 0) c.survey.corner = {5e6, 4.9e6};
    const auto kinds = interpolator_kinds();
    c.model.interpolator = below(2) ? InterpolatorKind::NaturalNeighbour : kinds[below(kinds.size())];
    c.model.pinch_out.fraction = std::array{0.0, 0.25, 1.0 / 3, 0.5}[below(4)];
    c.model.spacing = below(3) ? c.survey.extent / 14 : 0;
    for (std::size_t i = 0; i < c.survey.layers; ++i) {
        c.model.rules.rule.push_back(static_cast<LayerRule>(below(4)));
        c.model.rules.min_thickness.push_back(below(3) ? 0 : static_cast<double>(below(5)));
    }
    return c;
}

class RandomRules : public ::testing::TestWithParam<int> {};

TEST_P(RandomRules, make_sound_models_that_are_true_to_their_holes) {
    constexpr int kSeedsPerTest = 26;
    int refused = 0;  // no hole knows a surface that a rule asks for
    for (int k = 0; k < kSeedsPerTest; ++k) {
        const auto seed = static_cast<std::uint64_t>(GetParam() * kSeedsPerTest + k + 1);
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Case c = random_case(seed);
        const Survey survey = random_survey(c.survey);
        try {
            expect_sound(build_layer_model(survey, c.model), survey);
        } catch (const InvalidInput& error) {
            ASSERT_NE(std::string(error.what()).find("no hole knows"), std::string::npos) << error.what();
            ++refused;
        }
        if (HasFailure()) break;
    }
    EXPECT_LE(refused, 3);
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomRules, ::testing::Range(0, 8));

}  // namespace
}  // namespace stratareeb
