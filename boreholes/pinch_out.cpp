// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/pinch_out.h"

#include <string>

#include "boreholes/errors.h"

namespace stratareeb {

PinchOutRule pinch_out_rule(std::string_view name) {
    if (name == "at-hole") return {0.0};
    if (name == "quarter") return {0.25};
    if (name == "third") return {1.0 / 3};
    if (name == "half") return {0.5};
    throw InvalidInput("unknown pinch-out rule '" + std::string(name) +
                       "' (expected at-hole, quarter, third or half)");
}

}  // namespace stratareeb
