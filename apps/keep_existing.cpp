// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/keep_existing.h"

#include "boreholes/errors.h"

namespace stratareeb {

void keep_existing(const std::filesystem::path& file, bool overwrite) {
    if (!overwrite && std::filesystem::exists(file))
        throw IoError(file.string() + ": is there already; give another name or --overwrite");
}

}  // namespace stratareeb
