// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace stratareeb {

//! 1, 2 or 5 times a power of ten, not below a number > 0.
double round_step(double least);

//! A round factor not above a number: how much taller than true heights may be drawn.
double round_exaggeration(double most);

//! Round values between two, about nine of them or as many as said; `low` alone if there is nothing between.
std::vector<double> ticks(double low, double high, double about = 9);

//! A tick's text with as many decimals as the step between ticks needs.
std::string tick_text(double value, double step);

}  // namespace stratareeb
