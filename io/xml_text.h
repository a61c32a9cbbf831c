// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace stratareeb {

//! Text as it may stand in an XML attribute. Control characters, which XML does not know, become blanks.
inline std::string xml_attribute(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else
            result += static_cast<unsigned char>(c) < 32 ? ' ' : c;
    }
    return result;
}

}  // namespace stratareeb
