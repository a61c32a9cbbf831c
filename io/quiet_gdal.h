// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cpl_error.h>

namespace stratareeb {

//! While one lives, GDAL prints nothing; CPLGetLastErrorMsg() tells what it would have said. For .cpp files
//! only.
class QuietErrors {
 public:
    QuietErrors() {
        CPLErrorReset();
        CPLPushErrorHandler(CPLQuietErrorHandler);
    }
    ~QuietErrors() { CPLPopErrorHandler(); }
    QuietErrors(const QuietErrors&) = delete;
    QuietErrors& operator=(const QuietErrors&) = delete;
};

}  // namespace stratareeb
