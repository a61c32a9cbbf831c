// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "boreholes/student_t.h"

namespace stratareeb {

//! What a list of errors (predicted - actual) comes to. All 0 where there are none.
struct ErrorSummary {
    std::size_t count = 0;
    double mean = 0;
    double deviation = 0;  // standard deviation with count - 1; 0 for a single error
    double rmse = 0, mae = 0;
    double median = 0, median_size = 0;  // of the errors and of their absolute values
    double largest = 0;                  // absolute value
};
ErrorSummary summarize_errors(std::span<const double> errors);

//! Z-test of two means as if the samples were independent, with sample deviations (count - 1): the test of the thesis
//! (its section 4.1.4.1).
struct ZTest {
    double mean_actual = 0, mean_predicted = 0;
    double deviation_actual = 0, deviation_predicted = 0;
    double z = 0;  // (mean_actual - mean_predicted) / sqrt(S1²/n + S2²/n); 0 where the means agree
};
ZTest z_test(std::span<const double> actual, std::span<const double> predicted);

//! Is a mean 0? An interval for it, and how likely so large a mean is if it were.
struct MeanTest {
    std::size_t values = 0, units = 0;  // numbers averaged; independent units among them
    double mean = 0, standard_error = 0;
    double statistic = 0;  // mean / standard error
    double low = 0, high = 0;
    double p = 1;  // two-sided

    bool contains_zero() const { return low <= 0 && 0 <= high; }
};

//! mean ± quantile · S / sqrt(n). With fewer than two values nothing is known: an infinite interval, p = 1.
MeanTest mean_test(std::span<const double> errors, double confidence = 0.95, MeanLaw law = MeanLaw::StudentT);

//! The same with a quantile that is given, such as 1.96.
MeanTest mean_test_at(std::span<const double> errors, double quantile);

//! The mean of errors of which those of one group (a borehole) go together: they are summed first, and the groups are
//! what is independent. Linearised ratio estimator with count - 1 degrees of freedom (W. G. Cochran, "Sampling
//! Techniques", 1977, section 6.3), the cluster-robust variance. Errors of one hole are correlated, since a hole that is too deep
//! at one layer mostly is at the next; a test that takes them for independent rejects far too often.
//! \pre group.size() == errors.size()
MeanTest grouped_mean_test(std::span<const double> errors, std::span<const std::size_t> group,
                           double confidence = 0.95, MeanLaw law = MeanLaw::StudentT);

}  // namespace stratareeb
