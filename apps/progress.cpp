// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace stratareeb {
namespace {

constexpr auto kRedrawTime = std::chrono::milliseconds(100);

//! 75 seconds as "1 min 15 s": people plan by minutes.
std::string duration(double seconds) {
    const long total = std::lround(std::ceil(seconds));
    if (total < 60) return fmt::format("{} s", total);
    if (total < 3600) return fmt::format("{} min {} s", total / 60, total % 60);
    return fmt::format("{} h {} min", total / 3600, total % 3600 / 60);
}

}  // namespace

std::string progress_line(std::string_view title, std::string_view what, double share,
                          double elapsed_seconds) {
    share = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0;
    std::string line = fmt::format("{}: {}, {} %", title, what, static_cast<int>(share * 100));
    if (share >= 0.03 && share < 1 && elapsed_seconds >= 1)
        line += fmt::format(", {} left", duration(elapsed_seconds * (1 - share) / share));
    return line;
}

Progress::Progress(std::string title, std::optional<bool> shown)
    : title_(std::move(title)),
      shown_(shown ? *shown : isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      last_(start_) {}

Progress::~Progress() {
    clear();
}

void Progress::step(std::string_view what, double share) {
    if (!shown_) return;
    const auto now = Clock::now();
    if (drawn_ && what == what_ && now - last_ < kRedrawTime) return;
    what_ = what;
    last_ = now;
    drawn_ = true;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    // Carriage return and "erase to the end of the line": the new text takes the place of the old.
    std::fprintf(stderr, "\r\033[K%s", progress_line(title_, what, share, elapsed).c_str());
    std::fflush(stderr);
}

void Progress::clear() {
    if (!drawn_) return;
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
    drawn_ = false;
}

}  // namespace stratareeb
