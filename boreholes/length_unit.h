// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace stratareeb {

//! Metres in one "m", "ft" (international) or "us-ft".
//! \throw InvalidInput for any other unit
double metres_per(const std::string& unit);

}  // namespace stratareeb
