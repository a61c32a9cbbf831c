// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// lib3mf and the libzip below it keep a little memory of every archive they read, more of damaged ones. That is not ours
// to mend: a test that reads 3MF includes this once, so that the leak sanitizer looks away.
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming)
extern "C" __attribute__((used)) inline const char* __lsan_default_suppressions() {
    return "leak:lib3MF\nleak:libzip\n";
}
