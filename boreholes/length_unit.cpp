// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/length_unit.h"

#include <fmt/format.h>

#include "boreholes/errors.h"

namespace stratareeb {

double metres_per(const std::string& unit) {
    if (unit == "m") return 1;
    if (unit == "ft") return 0.3048;
    if (unit == "us-ft") return 1200.0 / 3937.0;
    throw InvalidInput(fmt::format("unit of length \"{}\" is not known: m, ft or us-ft", unit));
}

}  // namespace stratareeb
