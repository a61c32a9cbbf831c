// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace stratareeb {

//! Of Gauss and Legendre, on [0, 1]: exact for polynomials of degree 2 n - 1.
struct GaussRule {
    std::vector<double> places, weights;
};

//! \param points 1 to 61
const GaussRule& gauss_rule(std::size_t points);

}  // namespace stratareeb
