// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace stratareeb {

//! The caller's mistake or bad data. The message names the thing, the place and the way out.
class InvalidInput : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

//! A file that can't be read or written.
class IoError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

//! Input that is fine but for which no sound geometry was found.
class GeometryError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace stratareeb
