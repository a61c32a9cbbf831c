// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace stratareeb {

//! Bytes as text for data URLs (RFC 4648, section 4, with padding).
std::string base64(std::string_view bytes);

}  // namespace stratareeb
