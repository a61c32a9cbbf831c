// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/plan_layout.h"

#include <gtest/gtest.h>

#include "tests/borehole_files.h"

namespace stratareeb {
namespace {

Borehole hole(double x, double y, std::vector<LayerFact> layers = {}) {
    static std::size_t row = 0;
    Borehole result{"H" + std::to_string(++row), {x, y}, std::move(layers), {}, row};
    result.horizons.resize(result.layers.size() + 1);
    return result;
}

Survey survey_of(std::vector<Borehole> holes) {
    Survey survey;
    survey.holes = std::move(holes);
    return survey;
}

TEST(PlanLayout, two_holes_or_a_line_span_no_area) {
    const auto errors = [](const Survey& survey) {
        Audit audit;
        check_plan_layout(survey, audit);
        return audit.error_count();
    };
    EXPECT_EQ(errors(survey_of({})), 1u);
    EXPECT_EQ(errors(survey_of({hole(0, 0), hole(1, 0)})), 1u);
    EXPECT_EQ(errors(survey_of({hole(0, 0), hole(1, 1), hole(2, 2), hole(-5, -5)})), 1u);
    EXPECT_EQ(errors(survey_of({hole(5e6, 5e6), hole(5e6 + 1, 5e6), hole(5e6 + 2, 5e6 + 1e-7)})), 1u);
    EXPECT_EQ(errors(survey_of({hole(5e6, 5e6), hole(5e6 + 1, 5e6), hole(5e6, 5e6 + 1)})), 0u);
}

TEST(PlanLayout, mistyped_place_is_dropped_but_a_wide_site_is_not) {
    Survey survey;
    for (int i = 0; i < 30; ++i) survey.holes.push_back(hole(359000 + 10 * (i % 6), 403000 + 10 * (i / 6)));
    Survey wide = survey;
    survey.holes.push_back(hole(35934, 403000));
    Audit audit;
    drop_far_holes(survey, "c.csv", audit);
    EXPECT_EQ(survey.holes.size(), 30u);
    EXPECT_EQ(count_warnings(audit, "x 35934, y 403000"), 1u);
    wide.holes.push_back(hole(359200, 403100));
    drop_far_holes(wide, "c.csv", audit);
    EXPECT_EQ(wide.holes.size(), 31u);
}

TEST(PlanLayout, one_hole_stays_at_each_place) {
    const LayerFact two{Knowledge::Measured, 2}, one{Knowledge::AtLeast, 1}, none;
    Survey survey = survey_of({hole(0, 0, {one, none}), hole(0, 0, {two, one}), hole(5, 5, {two, one}),
                               hole(5, 5, {two, one}), hole(9, 0, {two, two}), hole(9, 1e-12, {two, none})});
    const std::string deep = survey.holes[1].id;
    Audit audit;
    merge_same_place(survey, "c.csv", audit);
    ASSERT_EQ(survey.holes.size(), 3u);
    EXPECT_EQ(survey.holes[0].id, deep);
    EXPECT_EQ(told(survey.holes[2]), "2 2");
    EXPECT_EQ(count_warnings(audit, "taken once"), 1u);
    EXPECT_EQ(count_warnings(audit, "different logs"), 2u);
}

TEST(PlanLayout, all_holes_at_one_place_become_one) {
    Survey survey = survey_of({hole(7, 7), hole(7, 7), hole(7, 7)});
    Audit audit;
    merge_same_place(survey, "c.csv", audit);
    EXPECT_EQ(survey.holes.size(), 1u);
}

}  // namespace
}  // namespace stratareeb
