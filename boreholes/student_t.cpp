// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/student_t.h"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace stratareeb {

double quantile(MeanLaw law, double probability, double freedom) {
    if (law == MeanLaw::Normal) return boost::math::quantile(boost::math::normal(), probability);
    return boost::math::quantile(boost::math::students_t(freedom), probability);
}

double two_sided_p(MeanLaw law, double statistic, double freedom) {
    const double far = std::abs(statistic);
    if (std::isinf(far)) return 0;
    if (law == MeanLaw::Normal) return 2 * boost::math::cdf(complement(boost::math::normal(), far));
    return 2 * boost::math::cdf(complement(boost::math::students_t(freedom), far));
}

}  // namespace stratareeb
