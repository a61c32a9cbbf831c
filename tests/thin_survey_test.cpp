// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/thin_survey.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "boreholes/complete_columns.h"
#include "boreholes/errors.h"
#include "boreholes/hole_triangulation.h"
#include "boreholes/random_survey.h"
#include "io/read_boreholes.h"
#include "tests/run_program.h"

namespace stratareeb {
namespace {

Survey survey_of(std::uint64_t seed, std::size_t holes) {
    return random_survey({.holes = holes,
                          .layers = 3,
                          .seed = seed,
                          .truth = seed % 2 ? TruthKind::Random : TruthKind::Lens,
                          .pinch_outs = true,
                          .resolution = 1e-6});
}

struct Missed {
    std::size_t hole = 0;
    double error = 0;
};

//! By definition: every hole that is not kept against the plane pieces of all that are, the worst first.
std::vector<Missed> missed_by(const Survey& survey, const std::vector<std::size_t>& kept) {
    const CompleteColumns columns = complete_columns(survey, {.interpolator = InterpolatorKind::Linear});
    std::vector<Point2> sites;
    for (const std::size_t h : kept) sites.push_back(survey.holes[h].at);
    const HoleTriangulation triangulation(sites, 0);
    std::vector<Missed> missed;
    for (std::size_t h = 0; h < survey.holes.size(); ++h) {
        if (std::ranges::find(kept, h) != kept.end()) continue;
        const PlanLocation at = triangulation.locate(std::vector{survey.holes[h].at})[0];
        double worst = 0;
        std::vector<double> actual{columns.ground[h]}, predicted{0};
        for (int i = 0; i < 3; ++i) predicted[0] += at.weight[i] * columns.ground[kept[at.site[i]]];
        for (const auto& thickness : columns.thickness) {
            actual.push_back(actual.back() - thickness[h]);
            predicted.push_back(predicted.back());
            for (int i = 0; i < 3; ++i) predicted.back() -= at.weight[i] * thickness[kept[at.site[i]]];
        }
        for (std::size_t k = 0; k < actual.size(); ++k)
            if (survey.holes[h].horizons[k]) worst = std::max(worst, std::abs(actual[k] - predicted[k]));
        missed.push_back({h, worst});
    }
    std::ranges::stable_sort(missed, std::ranges::greater{}, &Missed::error);
    return missed;
}

TEST(ThinSurvey, each_further_hole_is_the_one_that_was_missed_most) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        SCOPED_TRACE(seed);
        const Survey survey = survey_of(seed, 40);
        std::vector<std::size_t> before = thin_survey(survey, {.count = 3}).kept;  // the hull's
        const auto hull = HoleTriangulation(
                              [&] {
                                  std::vector<Point2> all;
                                  for (const Borehole& hole : survey.holes) all.push_back(hole.at);
                                  return all;
                              }(),
                              0)
                              .hull_edges();
        ASSERT_EQ(before.size(), hull.size());
        while (before.size() < survey.holes.size()) {
            const ThinnedSurvey next = thin_survey(survey, {.count = before.size() + 1});
            if (next.kept.size() == before.size()) break;  // nothing is missed any more
            const auto missed = missed_by(survey, before);
            std::vector<std::size_t> added;
            std::ranges::set_difference(next.kept, before, std::back_inserter(added));
            ASSERT_EQ(added.size(), 1U);
            EXPECT_NEAR(std::ranges::find(missed, added[0], &Missed::hole)->error, missed[0].error, 1e-9);
            before = next.kept;
        }
    }
}

TEST(ThinSurvey, no_hole_left_out_is_missed_by_more_than_was_allowed) {
    std::size_t last = 1000;
    for (const double error : {0.05, 0.5, 2.0, 8.0}) {
        const Survey survey = survey_of(3, 300);
        const ThinnedSurvey thinned = thin_survey(survey, {.error = error});
        EXPECT_LE(thinned.kept.size(), last);
        last = thinned.kept.size();
        const auto missed = missed_by(survey, thinned.kept);
        double sum = 0;
        for (const Missed& m : missed) sum += m.error * m.error;
        if (missed.empty()) continue;
        EXPECT_LE(missed[0].error, error);
        EXPECT_NEAR(thinned.largest_error, missed[0].error, 1e-9);
        EXPECT_NEAR(thinned.rms_error, std::sqrt(sum / static_cast<double>(missed.size())), 1e-9);
    }
    EXPECT_LT(last, 100U);
}

TEST(ThinSurvey, planes_need_their_hull_alone) {
    Survey survey{.units = {{"A", "A", "#808080"}}, .holes = {}};
    for (int i = 0; i < 9; ++i)
        for (int k = 0; k < 9; ++k) {
            Borehole hole{.id = std::to_string(9 * i + k), .at = {5e6 + 10.0 * i, 10.0 * k}};
            hole.layers = {{Knowledge::Measured, 4}};
            hole.horizons = {0.5 * i + 0.25 * k, 0.5 * i + 0.25 * k - 4};
            survey.holes.push_back(hole);
        }
    const ThinnedSurvey thinned = thin_survey(survey, {.error = 1e-9});
    EXPECT_EQ(thinned.kept, (std::vector<std::size_t>{0, 8, 72, 80}));
    EXPECT_LE(thinned.largest_error, 1e-9);
}

TEST(ThinSurvey, what_can_t_be_is_refused) {
    Survey line{.units = {{"A", "A", "#808080"}}, .holes = {}};
    for (int i = 0; i < 5; ++i) {
        Borehole hole{.id = std::to_string(i), .at = {1.0 * i, 2.0 * i}};
        hole.layers = {{Knowledge::Measured, 1}};
        hole.horizons = {0.0, -1.0};
        line.holes.push_back(hole);
    }
    EXPECT_THROW(thin_survey(line, {.error = 1}), InvalidInput);
    EXPECT_THROW(thin_survey(survey_of(1, 10), {.error = -1}), InvalidInput);
    EXPECT_THROW(thin_survey(survey_of(1, 10), {.error = NAN}), InvalidInput);
    EXPECT_THROW(thin_survey(survey_of(1, 10), {.count = 2}), InvalidInput);
}

TEST(ThinCommand, writes_a_table_that_reads_back) {
    const TemporaryFolder folder;
    ASSERT_EQ(run_program(folder, "sample -o all.csv --holes 200 --layers 3 --pinch-outs").exit_code, 0);
    const ProgramResult run = run_program(folder, "thin all.csv -o few.csv --error 3 --json");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto result = nlohmann::json::parse(run.out);
    EXPECT_EQ(result["boreholes"], 200);
    EXPECT_LE(result["largest_error"].get<double>(), 3);
    const Survey few = read_boreholes({(folder / "few.csv").string()}).survey;
    EXPECT_EQ(few.holes.size(), result["kept"].get<std::size_t>());
    EXPECT_EQ(run_program(folder, "thin all.csv -o few.csv --error 3").exit_code, 1);
    EXPECT_EQ(run_program(folder, "thin all.csv -o none.csv").exit_code, 2);
    EXPECT_EQ(run_program(folder, "thin all.csv -o few.csv --count 30 --overwrite").exit_code, 0);
    EXPECT_EQ(read_boreholes({(folder / "few.csv").string()}).survey.holes.size(), 30U);
}

}  // namespace
}  // namespace stratareeb
