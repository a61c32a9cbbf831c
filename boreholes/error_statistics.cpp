// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/error_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace stratareeb {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double mean_of(std::span<const double> values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

double sample_variance(std::span<const double> values) {
    if (values.size() < 2) return 0;
    const double mean = mean_of(values);
    double sum = 0;
    for (const double value : values) sum += (value - mean) * (value - mean);
    return sum / static_cast<double>(values.size() - 1);
}

double median_of(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

MeanTest finished(MeanTest test, double quantile, MeanLaw law) {
    const double reach = quantile * test.standard_error;
    test.low = test.mean - reach;
    test.high = test.mean + reach;
    if (test.mean != 0) test.statistic = test.mean / test.standard_error;
    test.p = two_sided_p(law, test.statistic, static_cast<double>(test.units) - 1);
    return test;
}

MeanTest plain(std::span<const double> errors) {
    MeanTest test;
    test.values = test.units = errors.size();
    test.mean = mean_of(errors);
    test.low = -kInfinity;
    test.high = kInfinity;
    if (test.units > 1)
        test.standard_error = std::sqrt(sample_variance(errors) / static_cast<double>(errors.size()));
    return test;
}

double central_quantile(MeanLaw law, double confidence, std::size_t units) {
    return quantile(law, 0.5 + confidence / 2, static_cast<double>(units) - 1);
}

}  // namespace

ErrorSummary summarize_errors(std::span<const double> errors) {
    ErrorSummary summary;
    summary.count = errors.size();
    if (errors.empty()) return summary;
    std::vector<double> sizes;
    double squares = 0;
    for (const double error : errors) {
        sizes.push_back(std::abs(error));
        squares += error * error;
    }
    summary.mean = mean_of(errors);
    summary.deviation = std::sqrt(sample_variance(errors));
    summary.rmse = std::sqrt(squares / static_cast<double>(errors.size()));
    summary.mae = mean_of(sizes);
    summary.median = median_of({errors.begin(), errors.end()});
    summary.largest = *std::max_element(sizes.begin(), sizes.end());
    summary.median_size = median_of(std::move(sizes));
    return summary;
}

ZTest z_test(std::span<const double> actual, std::span<const double> predicted) {
    const double first = sample_variance(actual), second = sample_variance(predicted);
    ZTest test{mean_of(actual), mean_of(predicted), std::sqrt(first), std::sqrt(second)};
    const double difference = test.mean_actual - test.mean_predicted;
    if (difference != 0)
        test.z = difference / std::sqrt(first / static_cast<double>(actual.size()) +
                                        second / static_cast<double>(predicted.size()));
    return test;
}

MeanTest mean_test(std::span<const double> errors, double confidence, MeanLaw law) {
    const MeanTest test = plain(errors);
    return test.units < 2 ? test : finished(test, central_quantile(law, confidence, test.units), law);
}

MeanTest mean_test_at(std::span<const double> errors, double quantile) {
    const MeanTest test = plain(errors);
    return test.units < 2 ? test : finished(test, quantile, MeanLaw::StudentT);
}

MeanTest grouped_mean_test(std::span<const double> errors, std::span<const std::size_t> group,
                           double confidence, MeanLaw law) {
    MeanTest test = plain(errors);
    std::map<std::size_t, double> deviation;  // per group, the sum of its errors' deviations from the mean
    for (std::size_t i = 0; i < errors.size(); ++i) deviation[group[i]] += errors[i] - test.mean;
    test.units = deviation.size();
    test.standard_error = 0;
    if (test.units < 2) return test;
    double squares = 0;
    for (const auto& [name, sum] : deviation) squares += sum * sum;
    const auto units = static_cast<double>(test.units), values = static_cast<double>(test.values);
    test.standard_error = std::sqrt(units / (units - 1) * squares) / values;
    return finished(test, central_quantile(law, confidence, test.units), law);
}

}  // namespace stratareeb
