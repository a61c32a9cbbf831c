// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/error_statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include "tests/thesis_rows.h"

namespace stratareeb {
namespace {

TEST(ErrorStatistics, summary_of_known_numbers) {
    const std::vector<double> errors{3, -1, 0, 2};
    const ErrorSummary summary = summarize_errors(errors);
    EXPECT_EQ(summary.count, 4u);
    EXPECT_DOUBLE_EQ(summary.mean, 1);
    EXPECT_DOUBLE_EQ(summary.deviation, std::sqrt(10.0 / 3));
    EXPECT_DOUBLE_EQ(summary.rmse, std::sqrt(14.0 / 4));
    EXPECT_DOUBLE_EQ(summary.mae, 1.5);
    EXPECT_DOUBLE_EQ(summary.median, 1);
    EXPECT_DOUBLE_EQ(summary.median_size, 1.5);
    EXPECT_DOUBLE_EQ(summary.largest, 3);
    EXPECT_EQ(summarize_errors(std::vector<double>{5, 1, 9}).median, 5);
    EXPECT_EQ(summarize_errors({}).count, 0u);
    EXPECT_EQ(summarize_errors(std::vector<double>{7}).deviation, 0);
}

TEST(ErrorStatistics, rmse_is_mean_and_deviation_together) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> law(3, 2);
    std::vector<double> errors(1000);
    for (double& error : errors) error = law(random);
    const ErrorSummary summary = summarize_errors(errors);
    EXPECT_NEAR(summary.rmse * summary.rmse,
                summary.mean * summary.mean + summary.deviation * summary.deviation * 999 / 1000, 1e-10);
}

//! Student's t with 1 degree of freedom is Cauchy's law, with 2 it has a closed form too.
TEST(ErrorStatistics, quantiles_have_their_closed_forms) {
    for (const double p : {0.6, 0.9, 0.975, 0.999}) {
        EXPECT_NEAR(quantile(MeanLaw::StudentT, p, 1), std::tan(std::numbers::pi * (p - 0.5)), 1e-9);
        EXPECT_NEAR(quantile(MeanLaw::StudentT, p, 2), (2 * p - 1) / std::sqrt(2 * p * (1 - p)), 1e-10);
        const double z = quantile(MeanLaw::Normal, p, 0);
        EXPECT_NEAR(0.5 * std::erfc(-z / std::numbers::sqrt2), p, 1e-12);
        EXPECT_NEAR(two_sided_p(MeanLaw::Normal, -z, 0), 2 * (1 - p), 1e-12);
        EXPECT_NEAR(two_sided_p(MeanLaw::StudentT, quantile(MeanLaw::StudentT, p, 7), 7), 2 * (1 - p), 1e-10);
    }
    EXPECT_NEAR(quantile(MeanLaw::Normal, 0.975, 0), 1.959963985, 1e-9);
    EXPECT_NEAR(quantile(MeanLaw::StudentT, 0.975, 29), 2.045229642, 1e-8);  // the thesis rounds it to 2.04
    EXPECT_NEAR(quantile(MeanLaw::StudentT, 0.975, 1e9), quantile(MeanLaw::Normal, 0.975, 0), 1e-6);
}

TEST(ErrorStatistics, few_or_equal_values_give_no_nonsense) {
    const std::vector<double> one{2}, same{2, 2, 2}, zeros{0, 0};
    EXPECT_EQ(mean_test(one).low, -std::numeric_limits<double>::infinity());
    EXPECT_EQ(mean_test(one).p, 1);
    EXPECT_EQ(mean_test({}).units, 0u);
    EXPECT_EQ(mean_test(same).low, 2);
    EXPECT_EQ(mean_test(same).p, 0);
    EXPECT_EQ(mean_test(zeros).p, 1);
    EXPECT_TRUE(mean_test(zeros).contains_zero());
    EXPECT_EQ(z_test(zeros, zeros).z, 0);
    const std::vector<std::size_t> alone{0, 0};
    EXPECT_EQ(grouped_mean_test(zeros, alone).units, 1u);
    EXPECT_EQ(grouped_mean_test(zeros, alone).high, std::numeric_limits<double>::infinity());
}

TEST(ErrorStatistics, groups_of_one_are_no_groups) {
    const std::vector<double> errors{1, -2, 4, 0.5, 3};
    const std::vector<std::size_t> group{4, 3, 2, 1, 0};
    const MeanTest plain = mean_test(errors), grouped = grouped_mean_test(errors, group);
    EXPECT_NEAR(grouped.standard_error, plain.standard_error, 1e-14);
    EXPECT_NEAR(grouped.low, plain.low, 1e-13);
    EXPECT_NEAR(grouped.p, plain.p, 1e-13);
}

TEST(ErrorStatistics, equal_groups_are_tested_by_their_means) {
    const std::vector<double> errors{1, 3, -2, 0, 5, 7}, means{2, -1, 6};
    const std::vector<std::size_t> group{0, 0, 1, 1, 2, 2};
    const MeanTest grouped = grouped_mean_test(errors, group), of_means = mean_test(means);
    EXPECT_NEAR(grouped.mean, of_means.mean, 1e-14);
    EXPECT_NEAR(grouped.standard_error, of_means.standard_error, 1e-14);
    EXPECT_NEAR(grouped.high, of_means.high, 1e-13);
    EXPECT_EQ(grouped.units, 3u);
    EXPECT_EQ(grouped.values, 6u);
}

//! Shares of 2,000 surveys without any bias in which a 5 per cent test says that there is one.
struct Rejections {
    double naive = 0, grouped = 0;
};

Rejections rejections(std::size_t holes, std::size_t layers, double shared, bool uneven, std::uint64_t seed) {
    constexpr int kSurveys = 2000;
    std::mt19937_64 random(seed);
    std::normal_distribution<double> law;
    Rejections result;
    for (int survey = 0; survey < kSurveys; ++survey) {
        std::vector<double> errors;
        std::vector<std::size_t> group;
        for (std::size_t hole = 0; hole < holes; ++hole) {
            const double of_hole = std::sqrt(shared) * law(random);
            const std::size_t known = uneven ? 1 + hole % layers : layers;
            for (std::size_t layer = 0; layer < known; ++layer) {
                errors.push_back(of_hole + std::sqrt(1 - shared) * law(random));
                group.push_back(hole);
            }
        }
        result.naive += !mean_test(errors).contains_zero();
        result.grouped += !grouped_mean_test(errors, group).contains_zero();
    }
    result.naive /= kSurveys;
    result.grouped /= kSurveys;
    return result;
}

// 2,000 surveys: a rate of 5 per cent is found within 3.5 to 6.5 per cent (three standard deviations).
TEST(ErrorStatistics, pooling_layers_of_a_hole_as_independent_rejects_far_too_often) {
    const Rejections related = rejections(60, 7, 0.5, false, 1);
    EXPECT_GT(related.naive, 0.25);
    EXPECT_NEAR(related.grouped, 0.05, 0.015);
    const Rejections uneven = rejections(80, 6, 0.4, true, 2);
    EXPECT_GT(uneven.naive, 0.15);
    EXPECT_NEAR(uneven.grouped, 0.055, 0.02);
    const Rejections unrelated = rejections(60, 7, 0, false, 3);
    EXPECT_NEAR(unrelated.naive, 0.05, 0.015);
    EXPECT_NEAR(unrelated.grouped, 0.05, 0.015);
}

//! A bias that is there is found: the test has power.
TEST(ErrorStatistics, a_bias_is_found) {
    std::mt19937_64 random(9);
    std::normal_distribution<double> law;
    std::vector<double> errors;
    std::vector<std::size_t> group;
    for (std::size_t hole = 0; hole < 200; ++hole) {
        const double of_hole = law(random);
        for (int layer = 0; layer < 5; ++layer) {
            errors.push_back(0.5 + of_hole + law(random));
            group.push_back(hole);
        }
    }
    EXPECT_LT(grouped_mean_test(errors, group).p, 1e-4);
}

// ---- what the thesis printed ----

struct Printed {
    std::string table, quantity, figure;
    int sample = 0;
    std::size_t layer = 0;  // from 1; 0 = all

    std::string name() const {
        return "Table " + table + (layer ? ", layer " + std::to_string(layer) : "") + ", " + quantity;
    }
};

std::vector<Printed> printed_statistics() {
    const TextTable table = read_csv_table(STRATAREEB_SOURCE_DIR "/tests/thesis/printed_statistics.csv");
    std::vector<Printed> figures;
    for (std::size_t r = 1; r < table.row_count(); ++r)
        figures.push_back({std::string(table.cell(r, 0)), std::string(table.cell(r, 3)),
                           std::string(table.cell(r, 4)), static_cast<int>(thesis::number(table, r, 1)),
                           static_cast<std::size_t>(thesis::number(table, r, 2))});
    return figures;
}

//! Student's t as the thesis took it: 2.04 for 29 degrees of freedom (it is 2.045), otherwise the normal 1.96.
double thesis_quantile(const Printed& figure) {
    const bool few = figure.layer > 0 && figure.sample < 3;
    return few ? 2.04 : 1.96;
}

double recomputed(const Printed& figure) {
    std::vector<double> actual, estimated, difference;  // the thesis's D is depth 1 - depth 2
    for (const thesis::HeldOutRow& row : thesis::rows_of(figure.sample))
        for (std::size_t i = 0; i < row.actual.size(); ++i) {
            if (figure.layer != 0 && i + 1 != figure.layer) continue;
            actual.push_back(row.actual[i]);
            estimated.push_back(row.estimated[i]);
            difference.push_back(row.actual[i] - row.estimated[i]);
        }
    const ZTest z = z_test(actual, estimated);
    const ErrorSummary d = summarize_errors(difference);
    const auto n = static_cast<double>(d.count);
    const MeanTest mean = mean_test_at(difference, thesis_quantile(figure));
    const std::map<std::string, double> values{{"mean1", z.mean_actual},
                                               {"mean2", z.mean_predicted},
                                               {"sd1", z.deviation_actual},
                                               {"sd2", z.deviation_predicted},
                                               {"var1", z.deviation_actual * z.deviation_actual},
                                               {"var2", z.deviation_predicted * z.deviation_predicted},
                                               {"z", z.z},
                                               {"abs_z", std::abs(z.z)},
                                               {"sum_d", d.mean * n},
                                               {"sum_d2", d.rmse * d.rmse * n},
                                               {"sum_squared", d.mean * n * d.mean * n},
                                               {"mean_d", d.mean},
                                               {"var_d", d.deviation * d.deviation},
                                               {"sd_d", d.deviation},
                                               {"left", mean.low},
                                               {"right", mean.high}};
    return values.at(figure.quantity);
}

//! Equal to the last printed digit, or within 6e-5 (of figures above 1, as a share): the rows are printed with four decimals and the sums
//! were made from more.
bool agrees(const Printed& figure, double value) {
    if (figure.figure.empty()) return false;
    const double printed = std::strtod(figure.figure.c_str(), nullptr);
    const auto point = figure.figure.find('.');
    const auto decimals = point == std::string::npos ? 0 : figure.figure.size() - point - 1;
    const double last_digit = 0.5001 * std::pow(10.0, -static_cast<double>(decimals));
    return std::abs(value - printed) <= std::max(last_digit, 6e-5 * std::max(1.0, std::abs(printed)));
}

TEST(ThesisStatistics, all_printed_figures_come_out_but_two_misprints) {
    std::set<std::string> misprints;
    std::size_t checked = 0;
    for (const Printed& figure : printed_statistics()) {
        ++checked;
        if (!agrees(figure, recomputed(figure))) misprints.insert(figure.name());
    }
    EXPECT_EQ(checked, 499u);
    const std::set<std::string> expected{
        "Table 4.6, layer 6, left",  // -3.816 is a misprint: -3.616 stands in Table 4.12
        "Table 4.9, left"};          // blank; it is -4.067
    EXPECT_EQ(misprints, expected);
    EXPECT_NEAR(recomputed({"4.6", "left", "", 1, 6}), -3.616, 5e-4);
    EXPECT_NEAR(recomputed({"4.9", "left", "", 2, 0}), -4.067, 5e-4);
}

//! Table 4.10, row 13, layer 1 prints d = -1.9 and d² = 36.1; Table 4.11 has the same row rightly, -19.0 and 361.
TEST(ThesisStatistics, the_misprinted_row_of_table_4_10) {
    const auto row = thesis::rows_of(3)[12];
    EXPECT_EQ(row.at, (Point2{-220, -333}));
    const double d = row.actual[0] - row.estimated[0];
    EXPECT_NEAR(d, -19.0, 0.05);
    EXPECT_NEAR(d * d, 361, 0.5);
}

//! |Z| > 1.96 in layer 3 of Table 4.3 and layer 7 of Table 4.4 (the thesis's text says "borehole no. 5" of both), as its
//! section 4.3 says: 17 of 19 pairs are not significant.
TEST(ThesisStatistics, two_of_nineteen_pairs_are_significant) {
    std::vector<std::pair<int, std::size_t>> significant;
    for (int sample = 1; sample <= 3; ++sample)
        for (std::size_t layer = 1; layer <= thesis::rows_of(sample)[0].actual.size(); ++layer)
            if (std::abs(recomputed({"", "z", "", sample, layer})) > 1.96)
                significant.push_back({sample, layer});
    const std::vector<std::pair<int, std::size_t>> expected{{2, 3}, {3, 7}};
    EXPECT_EQ(significant, expected);
}

//! With the borehole as the unit, the pooled intervals of Tables 4.7, 4.9 and 4.11 are another size: repeated holes and
//! layers of one hole are no independent evidence.
TEST(ThesisStatistics, pooled_intervals_by_borehole) {
    for (int sample = 1; sample <= 3; ++sample) {
        std::vector<double> errors;
        std::vector<std::size_t> hole;
        std::map<std::pair<double, double>, std::size_t> holes;
        for (const thesis::HeldOutRow& row : thesis::rows_of(sample))
            for (std::size_t i = 0; i < row.actual.size(); ++i) {
                errors.push_back(row.actual[i] - row.estimated[i]);
                hole.push_back(holes.try_emplace({row.at.x, row.at.y}, holes.size()).first->second);
            }
        const MeanTest grouped = grouped_mean_test(errors, hole);
        EXPECT_EQ(grouped.units,
                  (std::vector<std::size_t>{22, 27, 56})[static_cast<std::size_t>(sample) - 1]);
        EXPECT_DOUBLE_EQ(grouped.mean, mean_test(errors).mean);
        EXPECT_EQ(grouped.contains_zero(), sample != 2) << grouped.low << ' ' << grouped.high;
    }
}

}  // namespace
}  // namespace stratareeb
