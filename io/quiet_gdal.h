// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace stratareeb {

//! While one lives, GDAL prints nothing; CPLGetLastErrorMsg() tells what it would have said.
class QuietErrors {
 public:
    QuietErrors();
    ~QuietErrors();
    QuietErrors(const QuietErrors&) = delete;
    QuietErrors& operator=(const QuietErrors&) = delete;
};

}  // namespace stratareeb
