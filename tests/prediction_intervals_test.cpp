// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/prediction_intervals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "boreholes/hold_out_draws.h"
#include "boreholes/nearest_sites.h"
#include "boreholes/next_boreholes.h"
#include "boreholes/predict_columns.h"
#include "boreholes/random_survey.h"
#include "boreholes/validation.h"

namespace stratareeb {
namespace {

//! Errors at random places, ten draws; `size_at` is their standard deviation.
template <class Law, class SizeAt>
std::vector<PlacedError> random_errors(std::size_t count, std::uint64_t seed, Law law, SizeAt size_at) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(0, 100);
    std::vector<PlacedError> errors;
    for (std::size_t i = 0; i < count; ++i) {
        const Point2 at{place(random), place(random)};
        errors.push_back({at, i % 10, size_at(at) * law(random)});
    }
    return errors;
}

double coverage(const LocalError& local, double confidence) {
    const auto widths = held_out_half_widths(local, confidence);
    std::size_t covered = 0;
    for (std::size_t i = 0; i < widths.size(); ++i) covered += std::abs(local.errors()[i].error) <= widths[i];
    return static_cast<double>(covered) / static_cast<double>(widths.size());
}

//! Mean size of errors of other draws by gap: classes of equal number, rising by the max-min formula, equal ones joined.
GapProfile plain_profile(const std::vector<PlacedError>& errors, std::size_t draw) {
    std::vector<PlacedError> sorted = errors;
    std::ranges::stable_sort(sorted, {}, &PlacedError::gap);
    const bool one = sorted.front().gap == sorted.back().gap;
    const std::size_t classes = one ? 1 : std::clamp<std::size_t>(errors.size() / 30, 1, 12);
    std::vector<double> gap(classes), size(classes), count(classes);
    for (std::size_t r = 0; r < sorted.size(); ++r) {
        if (sorted[r].draw == draw) continue;
        const std::size_t c = r * classes / sorted.size();
        gap[c] += sorted[r].gap, size[c] += std::abs(sorted[r].error), count[c] += 1;
    }
    const auto mean = [&](const std::vector<double>& of, std::size_t from, std::size_t to) {
        return std::accumulate(&of[from], &of[to] + 1, 0.0) /
               std::accumulate(&count[from], &count[to] + 1, 0.0);
    };
    const auto level = [&](std::size_t c) {
        double highest = 0;
        for (std::size_t from = 0; from <= c; ++from) {
            double lowest = std::numeric_limits<double>::infinity();
            for (std::size_t to = c; to < classes; ++to) lowest = std::min(lowest, mean(size, from, to));
            highest = std::max(highest, lowest);
        }
        return highest;
    };
    GapProfile profile;
    for (std::size_t from = 0, to = 0; from < classes; from = to + 1) {
        for (to = from; to + 1 < classes && level(to + 1) <= level(from) * (1 + 1e-12);) ++to;
        profile.gap.push_back(mean(gap, from, to)), profile.size.push_back(level(from));
    }
    return profile;
}

//! Brute force: the definition, without index and without shared sorting.
std::vector<double> plain_half_widths(const std::vector<PlacedError>& errors, double confidence) {
    const auto scale = [&](std::size_t i) {
        std::vector<std::pair<double, std::size_t>> others;
        for (std::size_t j = 0; j < errors.size(); ++j) {
            if (errors[j].draw == errors[i].draw) continue;
            const double dx = errors[j].at.x - errors[i].at.x, dy = errors[j].at.y - errors[i].at.y;
            others.push_back({dx * dx + dy * dy, j});
        }
        std::sort(others.begin(), others.end());
        const GapProfile profile = plain_profile(errors, errors[i].draw);
        const std::size_t near = std::min<std::size_t>(8, others.size());
        double ratios = 4;
        for (std::size_t k = 0; k < near; ++k) {
            const PlacedError& other = errors[others[k].second];
            ratios += std::abs(other.error) / profile.at(other.gap);
        }
        return profile.at(errors[i].gap) * ratios / (static_cast<double>(near) + 4);
    };
    std::vector<double> scales, widths;
    for (std::size_t i = 0; i < errors.size(); ++i) scales.push_back(scale(i));
    for (std::size_t i = 0; i < errors.size(); ++i) {
        std::vector<double> scores;
        double most = 0;
        for (std::size_t j = 0; j < errors.size(); ++j) {
            if (errors[j].draw == errors[i].draw) continue;
            scores.push_back(std::abs(errors[j].error) / scales[j]);
            most = std::max(most, std::abs(errors[j].error));
        }
        std::sort(scores.begin(), scores.end());
        const auto rank =
            static_cast<std::size_t>(std::ceil((static_cast<double>(scores.size()) + 1) * confidence));
        const double widest = most * (1 + 10 / static_cast<double>(scores.size()));
        widths.push_back(std::min(scores[std::min(rank, scores.size()) - 1] * scales[i], widest));
    }
    return widths;
}

TEST(PredictionIntervals, are_those_of_the_definition) {
    for (const std::size_t count : {std::size_t{12}, std::size_t{45}, std::size_t{200}, std::size_t{300}}) {
        auto errors =
            random_errors(count, count, std::normal_distribution<double>(), [](Point2 p) { return 1 + p.x; });
        std::mt19937_64 random(count);
        if (count != 45)
            for (PlacedError& error : errors) error.gap = static_cast<double>(random() % 100'000'000);
        const LocalError local(errors);
        for (const double confidence : {0.8, 0.95}) {
            const auto expected = plain_half_widths(errors, confidence),
                       found = held_out_half_widths(local, confidence);
            for (std::size_t i = 0; i < count; ++i)
                EXPECT_NEAR(found[i], expected[i], 1e-12 * (1 + expected[i]));
        }
    }
}

TEST(PredictionIntervals, cover_as_promised_whatever_the_law) {
    for (const double confidence : {0.8, 0.9, 0.95}) {
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            const auto even = [](Point2) { return 1.0; };
            const auto steep = [](Point2 p) { return std::exp(p.x / 20); };
            EXPECT_NEAR(
                coverage(LocalError(random_errors(1000, seed, std::normal_distribution<double>(), even)),
                         confidence),
                confidence, 0.012);
            EXPECT_NEAR(
                coverage(LocalError(random_errors(1000, seed, std::cauchy_distribution<double>(), even)),
                         confidence),
                confidence, 0.012);
            EXPECT_NEAR(
                coverage(LocalError(random_errors(1000, seed, std::normal_distribution<double>(), steep)),
                         confidence),
                confidence, 0.012);
        }
    }
}

//! Where errors are large in one half, intervals are wide there and narrow in the other.
TEST(PredictionIntervals, follow_the_size_of_errors_over_the_plan) {
    const auto is_calm = [](const Point2& p) { return p.x < 50; };
    const auto size = [&](Point2 p) { return is_calm(p) ? 1.0 : 4.0; };
    const LocalError local(random_errors(2000, 3, std::normal_distribution<double>(), size));
    const auto widths = held_out_half_widths(local, 0.95);
    double calm_width = 0, wild_width = 0, calm = 0, calm_covered = 0, wild_covered = 0;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const PlacedError& error = local.errors()[i];
        const bool covered = std::abs(error.error) <= widths[i];
        (is_calm(error.at) ? calm_width : wild_width) += widths[i];
        (is_calm(error.at) ? calm_covered : wild_covered) += covered;
        calm += is_calm(error.at);
    }
    const double wild = 2000 - calm;
    EXPECT_LT(calm_width / calm, 0.55 * wild_width / wild);
    EXPECT_LT(calm_covered / calm, 0.9995);
    EXPECT_GT(wild_covered / wild, 0.88);
    EXPECT_LT(2 * local.at({10, 50}, 0), local.at({90, 50}, 0));
}

//! Errors that grow with the distance of the nearest hole, as those of any interpolation do: so do the intervals, without losing
//! coverage near or far.
TEST(PredictionIntervals, follow_the_distance_of_the_nearest_hole) {
    double width[2]{}, covered[2]{}, count[2]{};
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        auto errors =
            random_errors(400, seed, std::normal_distribution<double>(), [](Point2) { return 1.0; });
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> gap(0, 10);
        for (PlacedError& error : errors) error.gap = gap(random), error.error *= 0.5 + error.gap;
        const auto widths = held_out_half_widths(LocalError(errors), 0.95);
        for (std::size_t i = 0; i < errors.size(); ++i) {
            const std::size_t far = errors[i].gap > 5;
            width[far] += widths[i], covered[far] += std::abs(errors[i].error) <= widths[i], ++count[far];
        }
    }
    EXPECT_GT(width[1] / count[1], 2 * width[0] / count[0]);  // the errors' are 8 : 3
    for (const int far : {0, 1}) {
        EXPECT_GT(covered[far] / count[far], 0.93) << far;
        EXPECT_LT(covered[far] / count[far], 0.97) << far;
    }
}

//! Surveys with dense clusters and lone holes between, by the default way of predicting: a draw at a time, whole boreholes.
TEST(PredictionIntervals, are_narrow_where_holes_are_dense_and_cover_on_random_surveys) {
    double width[2]{}, count[2]{}, covered = 0, all = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const Survey survey = random_survey(
            {.holes = 150, .layers = 2, .seed = seed, .plan = HolePlan::Clustered, .corners = false});
        const Validation validation =
            validate(survey, fold_draws(survey.holes.size(), 10, seed),
                     {.hold_out = {.prediction = {.interpolator = InterpolatorKind::Kriging}}});
        for (const ItemValidation& layer : validation.layers) {
            covered += static_cast<double>(layer.covered), all += static_cast<double>(layer.residuals.size());
            std::vector<Point2> at;
            std::vector<std::size_t> draw, asked;
            for (const Residual& r : layer.residuals) {
                asked.push_back(at.size());
                at.push_back(survey.holes[r.hole].at), draw.push_back(r.draw);
            }
            const std::vector<double> gap = gaps_to_other_draws(at, draw, asked);
            std::vector<double> sorted = gap;
            std::ranges::sort(sorted);
            for (std::size_t i = 0; i < gap.size(); ++i) {
                const std::size_t far = gap[i] > sorted[sorted.size() / 2];
                width[far] += layer.half_width[i] / layer.errors.rmse, ++count[far];
            }
        }
    }
    EXPECT_LT(width[0] / count[0], 0.8 * width[1] / count[1]);
    EXPECT_GT(covered / all, 0.93);
    EXPECT_LT(covered / all, 0.97);
}

TEST(ErrorByGap, rises_between_classes_and_is_level_outside) {
    std::vector<PlacedError> errors;
    for (std::size_t i = 0; i < 90; ++i) {
        const double gap =
            static_cast<double>(i % 3);  // errors 2, 1, 6: the first two become one class of 1.5
        errors.push_back({{static_cast<double>(i), 0}, i % 10, gap == 0 ? 2.0 : gap == 1 ? -1.0 : 6.0, gap});
    }
    const GapProfile profile = ErrorByGap(errors).profile();
    EXPECT_DOUBLE_EQ(profile.at(0), 1.5);
    EXPECT_DOUBLE_EQ(profile.at(0.5), 1.5);
    EXPECT_DOUBLE_EQ(profile.at(1.25), 3.75);  // half way from 0.5 to 2
    EXPECT_DOUBLE_EQ(profile.at(2), 6);
    EXPECT_DOUBLE_EQ(profile.at(99), 6);
    EXPECT_EQ(GapProfile{}.at(3), 0);
}

TEST(ErrorByGap, gaps_look_past_holes_of_the_same_draw) {
    const std::vector<Point2> at{{0, 0}, {1, 0}, {2, 0}, {7, 0}, {0, 0}};
    const std::vector<std::size_t> draw{1, 1, 1, 2, 3}, asked{0, 2, 3, 4};
    EXPECT_EQ(gaps_to_other_draws(at, draw, asked), (std::vector<double>{0, 2, 5, 0}));
    EXPECT_EQ(gaps_to_other_draws(std::vector<Point2>(3), std::vector<std::size_t>(3, 7),
                                  std::vector<std::size_t>{1}),
              std::vector<double>{0});
}

TEST(PredictionIntervals, right_predictions_get_no_width_and_few_errors_are_told) {
    std::vector<PlacedError> right;
    for (std::size_t i = 0; i < 50; ++i) right.push_back({{static_cast<double>(i), 0}, i % 10, 0});
    EXPECT_EQ(coverage(LocalError(right), 0.95), 1);
    EXPECT_EQ(held_out_half_widths(LocalError(right), 0.95)[7], 0);
    const auto few = random_errors(15, 1, std::normal_distribution<double>(), [](Point2) { return 1.0; });
    EXPECT_FALSE(prediction_reach(LocalError(few), 0.95).certain);  // 19 errors are the least
    EXPECT_TRUE(prediction_reach(LocalError(few), 0.8).certain);
    const auto nineteen =
        random_errors(19, 1, std::normal_distribution<double>(), [](Point2) { return 1.0; });
    EXPECT_TRUE(prediction_reach(LocalError(nineteen), 0.95).certain);
    EXPECT_FALSE(prediction_reach(LocalError({}), 0.95).certain);
    EXPECT_TRUE(held_out_half_widths(LocalError({}), 0.95).empty());
    EXPECT_EQ(held_out_half_widths(LocalError({{{0, 0}, 0, 3.0}}), 0.95),
              std::vector<double>{0});  // nothing to go by
    EXPECT_EQ(LocalError({}).at({1, 2}, 3), 0);
}

//! New holes, not those that were held out, fall into the intervals; rather more of them than promised, since they see the error
//! of their nearest hole and one that was held out does not see its own.
TEST(PredictionIntervals, cover_new_holes) {
    std::size_t covered = 0, checked = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const RandomSurveyOptions options{.holes = 250, .layers = 2, .seed = seed, .corners = false};
        Survey survey = random_survey(options), known = survey;
        known.holes.resize(150);
        const Validation validation = validate(known, fold_draws(150, 10, seed));
        std::vector<Point2> where;
        for (std::size_t h = 150; h < 250; ++h) where.push_back(survey.holes[h].at);
        const auto columns = ColumnPredictor(known).at(where);
        std::vector<Point2> holes;
        for (const Borehole& hole : known.holes) holes.push_back(hole.at);
        const NearestSites nearest(holes);
        std::vector<std::size_t> draw(150), asked(150);
        for (const Residual& r : validation.layers[0].residuals) draw[r.hole] = r.draw;
        std::iota(asked.begin(), asked.end(), std::size_t{0});
        const auto gaps = gaps_to_other_draws(holes, draw, asked);
        for (std::size_t i = 0; i < 2; ++i) {
            std::vector<PlacedError> errors;
            for (const Residual& residual : validation.layers[i].residuals)
                errors.push_back(
                    {known.holes[residual.hole].at, residual.draw, residual.error(), gaps[residual.hole]});
            const LocalError local(errors);
            const PredictionReach reach = prediction_reach(local, 0.95);
            for (std::size_t p = 0; p < 100; ++p) {
                const double error = columns.thickness[i][p] - survey.holes[150 + p].layers[i].thickness;
                const double gap = std::sqrt(nearest.nearest(where[p], 1).front().squared_distance);
                covered += std::abs(error) <= reach.half_width(local.at(where[p], gap));
                ++checked;
            }
        }
    }
    const double share = static_cast<double>(covered) / static_cast<double>(checked);
    EXPECT_GT(share, 0.94);
    EXPECT_LT(share, 0.995);
}

TEST(NextBoreholes, stand_in_the_largest_gaps) {
    std::vector<Point2> holes;
    for (int x = 0; x <= 10; ++x)
        for (int y = 0; y <= 10; ++y)
            if (std::hypot(x - 7, y - 3) > 2.5) holes.push_back({x * 10.0 + 0.01 * y, y * 10.0 + 0.013 * x});
    const auto same = [](const Point2&) { return 2.0; };
    const auto next = next_boreholes(holes, 1, same);
    ASSERT_EQ(next.size(), 1u);
    EXPECT_LT(std::hypot(next[0].at.x - 70, next[0].at.y - 30), 25);
    EXPECT_EQ(next[0].benefit(), 2 * next[0].area);
    // Ten times the error far away outweighs the gap.
    const auto elsewhere =
        next_boreholes(holes, 1, [](const Point2& p) { return p.x < 20 && p.y > 80 ? 30.0 : 1.0; });
    EXPECT_LT(elsewhere[0].at.x, 20);
    EXPECT_GT(elsewhere[0].at.y, 80);
    const auto five = next_boreholes(holes, 5, same);
    EXPECT_EQ(five.size(), 5u);
    for (std::size_t i = 1; i < 5; ++i) {
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(five[i].at == five[j].at);
    }
    for (const NextBorehole& gap : five) {
        double clearance = 1e9;
        for (const Point2& hole : holes)
            clearance = std::min(clearance, std::hypot(hole.x - gap.at.x, hole.y - gap.at.y));
        EXPECT_LE(gap.area, 3.1416 * clearance * clearance);
    }
    EXPECT_TRUE(next_boreholes({}, 3, same).empty());
    EXPECT_TRUE(next_boreholes(std::vector<Point2>{{0, 0}, {1, 0}}, 3, same).empty());
}

double mean_error(const Survey& known, const AnalyticTruth& truth) {
    std::vector<Point2> where;
    for (int x = 0; x < 25; ++x)
        for (int y = 0; y < 25; ++y)
            where.push_back({(x + 0.5) / 25 * truth.extent + truth.corner.x,
                             (y + 0.5) / 25 * truth.extent + truth.corner.y});
    const auto columns = ColumnPredictor(known).at(where);
    double sum = 0;
    for (std::size_t i = 0; i < truth.layers.size(); ++i)
        for (std::size_t p = 0; p < where.size(); ++p)
            sum += std::abs(columns.thickness[i][p] - truth.thickness(i, where[p]));
    return sum / static_cast<double>(where.size());
}

Survey drilled(Survey survey, const AnalyticTruth& truth, const std::vector<Point2>& places) {
    for (const Point2& at : places) {
        Borehole hole{.id = "new", .at = at};
        hole.horizons.push_back(truth.ground(at));
        for (std::size_t i = 0; i < truth.layers.size(); ++i) {
            hole.layers.push_back({Knowledge::Measured, truth.thickness(i, at)});
            hole.horizons.push_back(*hole.horizons.back() - hole.layers.back().thickness);
        }
        survey.holes.push_back(hole);
    }
    return survey;
}

//! Four holes where they are suggested make the model better than four at random, in most of many surveys and by much.
TEST(NextBoreholes, help_more_than_random_ones) {
    double suggested = 0, random_places = 0, before = 0;
    std::size_t better = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const RandomSurveyOptions options{
            .holes = 30, .layers = 3, .seed = seed, .plan = HolePlan::Clustered};
        const Survey survey = random_survey(options);
        const AnalyticTruth truth = random_truth(options);
        ValidationOptions validation;
        validation.suggestions = 4;
        std::vector<Point2> places, others;
        for (const NextBorehole& next : validate(survey, fold_draws(30, 10, 1), validation).next)
            places.push_back(next.at);
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> along(0, truth.extent);
        for (std::size_t i = 0; i < places.size(); ++i)
            others.push_back({truth.corner.x + along(random), truth.corner.y + along(random)});
        const double a = mean_error(drilled(survey, truth, places), truth),
                     b = mean_error(drilled(survey, truth, others), truth);
        before += mean_error(survey, truth);
        suggested += a;
        random_places += b;
        better += a < b;
    }
    EXPECT_LT(suggested, 0.9 * random_places) << before;
    EXPECT_GE(better, 14u);
}

}  // namespace
}  // namespace stratareeb
