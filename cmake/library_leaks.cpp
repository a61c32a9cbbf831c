// SPDX-License-Identifier: GPL-3.0-or-later
// Linked into the program and the tests where they are built with sanitizers: libraries below keep a little memory until the end, lib3mf and
// libzip of every archive, OpenCASCADE of its tables, fontconfig of its fonts. That is not ours to mend, so the leak sanitizer looks away.

// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming)
extern "C" __attribute__((used)) const char* __lsan_default_suppressions() {
    return "leak:lib3MF\nleak:libzip\nleak:libTK\nleak:libfontconfig\n";
}
