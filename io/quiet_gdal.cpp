// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/quiet_gdal.h"

#include <cpl_error.h>

namespace stratareeb {

QuietErrors::QuietErrors() {
    CPLErrorReset();
    CPLPushErrorHandler(CPLQuietErrorHandler);
}

QuietErrors::~QuietErrors() {
    CPLPopErrorHandler();
}

}  // namespace stratareeb
