// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/viewer_template.h"

namespace stratareeb {

namespace {

// One raw string literal; an array, since its length is then known without counting.
constexpr char kPage[] =
#include <viewer/dist/page.inc>
    ;

}  // namespace

std::string_view viewer_template() {
    return {kPage, sizeof kPage - 1};
}

}  // namespace stratareeb
