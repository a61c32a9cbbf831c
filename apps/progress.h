// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace stratareeb {

//! One line on a terminal that says what is being done, how far it is and how long it still takes. Where
//! standard error is no terminal (a pipe, a file) it says nothing. The line is wiped when the object goes.
class Progress {
 public:
    //! `title` stands in front, as "build". `shown` is for tests; by default standard error is asked.
    explicit Progress(std::string title, std::optional<bool> shown = std::nullopt);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    //! Say what is being done; `share` is that of the whole job done so far, 0 … 1. Cheap enough for inner
    //! loops: draws at most ten times a second, or when `what` changes. Not for several threads at once.
    void step(std::string_view what, double share);

    //! Wipe the line, so that other output can be printed; the next step draws it again.
    void clear();

 private:
    using Clock = std::chrono::steady_clock;
    std::string title_, what_;
    bool shown_, drawn_ = false;
    Clock::time_point start_, last_;
};

//! The line itself: "build: plan mesh, 40 %, 12 s left". Time left is told from three per cent and one second
//! on, as before that it would be a guess.
std::string progress_line(std::string_view title, std::string_view what, double share,
                          double elapsed_seconds);

}  // namespace stratareeb
