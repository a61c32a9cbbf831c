// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace stratareeb {

//! The 3D page as viewer/ builds it (`npm ci && npm run build` there), with @@title@@ and @@model@@ where they are to stand.
std::string_view viewer_template();

}  // namespace stratareeb
