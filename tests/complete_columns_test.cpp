// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/complete_columns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "boreholes/errors.h"
#include "boreholes/random_survey.h"

namespace stratareeb {
namespace {

constexpr LayerFact kUnknown{};

LayerFact measured(double thickness) {
    return {Knowledge::Measured, thickness};
}
LayerFact at_least(double thickness) {
    return {Knowledge::AtLeast, thickness};
}

struct HoleData {
    Point2 at;
    std::optional<double> ground;
    std::vector<LayerFact> layers;
};

//! Horizons known from the ground down as far as layers are measured.
Survey survey_of(const std::vector<HoleData>& holes) {
    Survey survey;
    for (std::size_t i = 0; i < holes[0].layers.size(); ++i) {
        const std::string code(1, static_cast<char>('A' + i));
        survey.units.push_back({code, code, "#000000"});
    }
    for (const HoleData& data : holes) {
        Borehole hole;
        hole.at = data.at;
        hole.layers = data.layers;
        hole.horizons.resize(data.layers.size() + 1);
        hole.horizons[0] = data.ground;
        for (std::size_t i = 0; i < data.layers.size(); ++i)
            if (hole.horizons[i] && data.layers[i].knowledge == Knowledge::Measured)
                hole.horizons[i + 1] = *hole.horizons[i] - data.layers[i].thickness;
        survey.holes.push_back(hole);
    }
    return survey;
}

//! One layer in the corners of a square and in its middle.
Survey square_of(const std::array<LayerFact, 4>& corners, const LayerFact& middle) {
    return survey_of({{{0, 0}, 10.0, {corners[0]}},
                      {{8, 0}, 10.0, {corners[1]}},
                      {{8, 8}, 10.0, {corners[2]}},
                      {{0, 8}, 10.0, {corners[3]}},
                      {{4, 4}, 10.0, {middle}}});
}

const std::array<LayerFact, 4> kEven{measured(3), measured(3), measured(3), measured(3)};

bool notes_say(const CompleteColumns& columns, const std::string& words) {
    return std::ranges::any_of(
        columns.notes, [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

std::string refusal(const Survey& survey, const CompletionOptions& options = {}) {
    try {
        complete_columns(survey, options);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "";
}

TEST(CompleteColumns, of_holes_that_know_all_are_what_they_know) {
    const Survey survey = survey_of({{{0, 0}, 0.1, {measured(1.0 / 3), measured(0)}},
                                     {{5, 0}, 0.2, {measured(2.0 / 3), measured(1e-12)}},
                                     {{0, 5}, 0.3, {measured(0), measured(7)}}});
    const CompleteColumns columns = complete_columns(survey);
    EXPECT_EQ(columns.sites, (std::vector<Point2>{{0, 0}, {5, 0}, {0, 5}}));
    EXPECT_EQ(columns.ground, (std::vector<double>{0.1, 0.2, 0.3}));
    EXPECT_EQ(columns.thickness, (std::vector<std::vector<double>>{{1.0 / 3, 2.0 / 3, 0}, {0, 1e-12, 7}}));
    EXPECT_TRUE(columns.notes.empty());
}

TEST(CompleteColumns, predict_an_unknown_thickness_from_the_measured_ones) {
    for (const auto kind : {InterpolatorKind::Linear, InterpolatorKind::NaturalNeighbour}) {
        const auto columns = complete_columns(square_of(kEven, kUnknown), {.interpolator = kind});
        EXPECT_NEAR(columns.thickness[0][4], 3, 1e-12);
    }
    const auto tilted =
        complete_columns(square_of({measured(2), measured(4), measured(4), measured(2)}, kUnknown));
    EXPECT_NEAR(tilted.thickness[0][4], 3, 1e-12);
}

TEST(CompleteColumns, do_not_take_unknown_for_absent_nor_absent_for_unknown) {
    const auto unknown =
        complete_columns(square_of({measured(3), measured(3), kUnknown, measured(3)}, measured(3)));
    EXPECT_NEAR(unknown.thickness[0][2], 3, 1e-12);
    const auto absent =
        complete_columns(square_of({measured(3), measured(3), measured(0), measured(3)}, measured(3)));
    EXPECT_EQ(absent.thickness[0][2], 0);
}

TEST(CompleteColumns, take_a_layer_for_absent_where_the_pinch_out_rule_says_so) {
    const std::array<LayerFact, 4> ramp{measured(0), measured(6), measured(6), measured(0)};
    EXPECT_EQ(complete_columns(square_of(ramp, kUnknown), {.pinch_out = {0.5}}).thickness[0][4], 0);
    EXPECT_NEAR(complete_columns(square_of(ramp, kUnknown),
                                 {.interpolator = InterpolatorKind::Linear, .pinch_out = {0}})
                    .thickness[0][4],
                3, 1e-12);
}

TEST(CompleteColumns, raise_at_least_to_the_prediction_and_never_lower_it) {
    EXPECT_NEAR(complete_columns(square_of(kEven, at_least(1))).thickness[0][4], 3, 1e-12);
    EXPECT_EQ(complete_columns(square_of(kEven, at_least(5))).thickness[0][4], 5);
}

TEST(CompleteColumns, count_an_at_least_above_the_prediction_as_knowledge_for_others) {
    Survey survey = square_of(kEven, at_least(9));
    HoleData near{{4.5, 4}, 10.0, {kUnknown}};
    Borehole hole;
    hole.at = near.at;
    hole.layers = near.layers;
    hole.horizons = {10.0, std::nullopt};
    survey.holes.push_back(hole);
    EXPECT_GT(complete_columns(survey).thickness[0][5], 6);
}

TEST(CompleteColumns, tell_what_is_found_from_what_is_predicted) {
    for (const auto kind : {InterpolatorKind::Kriging, InterpolatorKind::Spline, InterpolatorKind::Linear}) {
        const CompletionOptions options{.interpolator = kind};
        const auto known = [&](const LayerFact& fact) {
            return static_cast<int>(complete_columns(square_of(kEven, fact), options).known[0][4]);
        };
        EXPECT_EQ(known(measured(2)), 1);
        EXPECT_EQ(known(kUnknown), 0);
        EXPECT_EQ(known(at_least(1)), 0) << "a bound below what the others say";
        EXPECT_EQ(known(at_least(5)), 1) << "a bound in force";
    }
}

TEST(CompleteColumns, of_a_layer_that_no_hole_drills_through_end_where_the_holes_end) {
    const auto columns =
        complete_columns(square_of({at_least(1), at_least(2), at_least(3), measured(0)}, kUnknown),
                         {.interpolator = InterpolatorKind::Linear, .pinch_out = {0}});
    EXPECT_EQ(columns.thickness[0][0], 1);
    EXPECT_EQ(columns.thickness[0][1], 2);
    EXPECT_EQ(columns.thickness[0][2], 3);
    EXPECT_EQ(columns.thickness[0][3], 0);
    EXPECT_TRUE(notes_say(columns, "layer 'A': no hole drills through it"));
}

TEST(CompleteColumns, leave_out_a_layer_that_no_hole_knows) {
    const auto columns = complete_columns(square_of({kUnknown, kUnknown, kUnknown, kUnknown}, kUnknown));
    EXPECT_EQ(columns.thickness[0], std::vector<double>(5, 0.0));
    EXPECT_TRUE(notes_say(columns, "layer 'A': no hole knows it; left out"));
}

TEST(CompleteColumns, scale_unknown_layers_to_a_known_horizon_below) {
    std::vector<HoleData> holes;
    for (const Point2 at : {Point2{0, 0}, {8, 0}, {8, 8}, {0, 8}})
        holes.push_back({at, 20.0, {measured(2), measured(6), measured(1)}});
    holes.push_back({{4, 4}, 20.0, {kUnknown, kUnknown, measured(1)}});
    Survey survey = survey_of(holes);
    survey.holes[4].horizons[2] = 16.0;  // the base of B is known: A and B fill 4, not 8
    const auto columns = complete_columns(survey);
    EXPECT_NEAR(columns.thickness[0][4], 1, 1e-12);
    EXPECT_NEAR(columns.thickness[1][4], 3, 1e-12);
    EXPECT_EQ(columns.thickness[2][4], 1);
}

TEST(CompleteColumns, scale_around_measured_layers_and_leave_those) {
    std::vector<HoleData> holes;
    for (const Point2 at : {Point2{0, 0}, {8, 0}, {8, 8}, {0, 8}})
        holes.push_back({at, 20.0, {measured(2), measured(6), measured(2)}});
    holes.push_back({{4, 4}, 20.0, {kUnknown, measured(5), kUnknown}});
    Survey survey = survey_of(holes);
    survey.holes[4].horizons[3] = 5.0;  // 15 in all, 5 of them measured
    const auto columns = complete_columns(survey);
    EXPECT_NEAR(columns.thickness[0][4], 5, 1e-12);
    EXPECT_EQ(columns.thickness[1][4], 5);
    EXPECT_NEAR(columns.thickness[2][4], 5, 1e-12);
}

TEST(CompleteColumns, fill_a_gap_with_the_upper_layer_where_all_are_predicted_absent) {
    std::vector<HoleData> holes;
    for (const Point2 at : {Point2{0, 0}, {8, 0}, {8, 8}, {0, 8}})
        holes.push_back({at, 20.0, {measured(0), measured(0)}});
    holes.push_back({{4, 4}, 20.0, {kUnknown, kUnknown}});
    Survey survey = survey_of(holes);
    survey.holes[4].horizons[2] = 17.0;
    const auto columns = complete_columns(survey);
    EXPECT_EQ(columns.thickness[0][4], 3);
    EXPECT_EQ(columns.thickness[1][4], 0);
}

TEST(CompleteColumns, predict_missing_ground_from_the_other_holes_and_say_so) {
    Survey survey = square_of(kEven, measured(3));
    for (std::size_t h = 0; h < 4; ++h) survey.holes[h].horizons[0] = 10 + survey.holes[h].at.x;
    survey.holes[4].horizons = {std::nullopt, std::nullopt};
    const auto columns = complete_columns(survey);
    EXPECT_NEAR(columns.ground[4], 14, 1e-12);
    EXPECT_TRUE(notes_say(columns, "ground predicted from the other holes at 1 holes"));
}

TEST(CompleteColumns, take_missing_ground_from_the_terrain_and_known_ground_from_the_hole) {
    Survey survey = square_of(kEven, measured(3));
    survey.holes[4].horizons = {std::nullopt, std::nullopt};
    const auto columns =
        complete_columns(survey, {.terrain = [](const Point2& p) { return std::optional(100 + p.x); }});
    EXPECT_EQ(columns.ground[4], 104);
    EXPECT_EQ(columns.ground[0], 10);
    EXPECT_TRUE(columns.notes.empty());
}

TEST(CompleteColumns, refuse_surveys_without_ground_holes_or_layers) {
    Survey survey = square_of(kEven, measured(3));
    for (Borehole& hole : survey.holes) hole.horizons = {std::nullopt, std::nullopt};
    EXPECT_EQ(refusal(survey), "no hole gives a ground elevation (add a ground column or --ground RASTER)");
    EXPECT_EQ(refusal(survey, {.terrain = [](const Point2&) { return std::optional<double>(); }}),
              "no hole gives a ground elevation (add a ground column or --ground RASTER)");
    EXPECT_EQ(refusal({}), "the table has no holes to build from");
    survey.units.clear();
    EXPECT_EQ(refusal(survey), "the table has no layers to build");
}

//! Single contacts as holes: place, horizon (0 = top of the uppermost unit) and elevation.
struct Contact {
    Point2 at;
    std::size_t horizon;
    double z;
};

Survey contacts_of(const std::vector<Contact>& contacts, std::size_t units) {
    Survey survey;
    survey.contact_points = true;
    for (std::size_t i = 0; i < units; ++i)
        survey.units.push_back({std::string(1, static_cast<char>('A' + i)), "", ""});
    for (const Contact& contact : contacts) {
        Borehole hole;
        hole.at = contact.at;
        hole.layers.resize(units);
        hole.horizons.resize(units + 1);
        hole.horizons[contact.horizon] = contact.z;
        survey.holes.push_back(hole);
    }
    return survey;
}

double horizon(const CompleteColumns& columns, std::size_t k, std::size_t h) {
    double z = columns.ground[h];
    for (std::size_t i = 0; i < k; ++i) z -= columns.thickness[i][h];
    return z;
}

TEST(CompleteColumns, of_contact_points_predict_each_horizon_by_its_own_contacts) {
    std::vector<Contact> contacts;
    for (const Point2 at : {Point2{0, 0}, {10, 0}, {0, 10}, {10, 10}}) {
        contacts.push_back({at, 0, 50 + at.x});
        contacts.push_back({{at.x / 2 + 2, at.y / 2 + 2}, 1, 30.0});
    }
    const auto columns =
        complete_columns(contacts_of(contacts, 1), {.interpolator = InterpolatorKind::Linear});
    for (std::size_t h = 0; h < contacts.size(); ++h) {
        EXPECT_NEAR(columns.ground[h], 50 + contacts[h].at.x, 1e-12);
        EXPECT_NEAR(horizon(columns, 1, h), 30, 1e-12);
    }
}

TEST(CompleteColumns, of_contact_points_keep_contacts_and_order) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> share(0, 1);
        constexpr std::size_t kUnits = 3;
        std::vector<Contact> contacts;
        for (int n = 0; n < 40; ++n) {
            const std::size_t k = static_cast<std::size_t>(n) % (kUnits + 1);
            contacts.push_back({{100 * share(random), 100 * share(random)},
                                k,
                                -10.0 * static_cast<double>(k) + 25 * share(random)});
        }
        const auto columns = complete_columns(contacts_of(contacts, kUnits));
        for (std::size_t h = 0; h < contacts.size(); ++h) {
            EXPECT_NEAR(horizon(columns, contacts[h].horizon, h), contacts[h].z, 1e-11) << "seed " << seed;
            for (std::size_t i = 0; i < kUnits; ++i) EXPECT_GE(columns.thickness[i][h], 0) << "seed " << seed;
        }
    }
}

TEST(CompleteColumns, of_contact_points_refuse_a_horizon_without_any) {
    const Survey survey = contacts_of({{{0, 0}, 0, 5}, {{9, 0}, 0, 5}, {{0, 9}, 0, 5}}, 1);
    EXPECT_EQ(refusal(survey), "no contact of the base of 'A'");
}

TEST(CompleteColumns, of_random_surveys_keep_every_fact) {
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        RandomSurveyOptions options{.holes = 3 + seed % 50, .layers = 1 + seed % 5, .seed = seed};
        options.plan =
            std::array{HolePlan::Random, HolePlan::Clustered, HolePlan::Grid, HolePlan::Line}[seed % 4];
        options.pinch_outs = seed % 2;
        options.zero_share = 0.2;
        options.unknown_share = 0.1 * static_cast<double>(seed % 8);
        options.cut_off_share = 0.1 * static_cast<double>(seed % 9);
        Survey survey = random_survey(options);
        if (seed % 3 == 0) survey.holes[0].horizons.assign(survey.units.size() + 1, std::nullopt);
        const auto kind = seed % 2 ? InterpolatorKind::Linear : InterpolatorKind::NaturalNeighbour;
        const auto columns = complete_columns(survey, {.interpolator = kind});
        ASSERT_EQ(columns.sites.size(), survey.holes.size());
        for (std::size_t h = 0; h < survey.holes.size(); ++h) {
            EXPECT_EQ(columns.sites[h], survey.holes[h].at);
            if (survey.holes[h].horizons[0]) {
                EXPECT_EQ(columns.ground[h], *survey.holes[h].horizons[0]);
            }
            for (std::size_t i = 0; i < survey.units.size(); ++i) {
                const LayerFact& fact = survey.holes[h].layers[i];
                const double t = columns.thickness[i][h];
                ASSERT_TRUE(std::isfinite(t) && t >= 0);
                if (fact.knowledge == Knowledge::Measured) {
                    EXPECT_EQ(t, fact.thickness) << "to the last bit";
                }
                if (fact.knowledge == Knowledge::AtLeast) {
                    EXPECT_GE(t, fact.thickness);
                }
            }
        }
    }
}

// What is predicted comes from what is known: other holes' unknowns and their places change nothing.
TEST(CompleteColumns, predict_from_known_facts_only) {
    Survey survey = square_of({measured(2), measured(5), measured(3), measured(4)}, kUnknown);
    const double alone = complete_columns(survey).thickness[0][4];
    for (const Point2 at : {Point2{4.1, 4.2}, {3, 4}, {7, 1}}) {
        survey.holes.push_back(survey.holes[4]);
        survey.holes.back().at = at;
    }
    EXPECT_EQ(complete_columns(survey).thickness[0][4], alone);
}

}  // namespace
}  // namespace stratareeb
