// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace stratareeb {

//! A sum that carries the rounding errors of its additions along (Neumaier 1974): a million terms, one
//! rounding.
class CompensatedSum {
 public:
    void add(double term) {
        const double total = sum_ + term;
        error_ += std::abs(sum_) >= std::abs(term) ? (sum_ - total) + term : (term - total) + sum_;
        sum_ = total;
    }
    double value() const { return sum_ + error_; }

 private:
    double sum_ = 0, error_ = 0;
};

}  // namespace stratareeb
