// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/hole_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace stratareeb {
namespace {

constexpr double kTouching = 1e-6;  // survey units: depths closer than this are the same depth

class Cleaner {
 public:
    Cleaner(const LogSet& logs, Audit& audit) : logs_(logs), audit_(audit) {}

    void clean(HoleLog& hole) {
        hole_ = &hole;
        std::erase_if(hole.intervals, [&](LogInterval& interval) { return !is_usable(interval); });
        std::sort(
            hole.intervals.begin(), hole.intervals.end(), [](const LogInterval& a, const LogInterval& b) {
                const bool a_blank = a.unit == LogInterval::kNoUnit, b_blank = b.unit == LogInterval::kNoUnit;
                return std::tie(a.from, a_blank, a.to, a.row) < std::tie(b.from, b_blank, b.to, b.row);
            });
        std::vector<LogInterval> column;
        for (const LogInterval& interval : hole.intervals) append(column, interval);
        hole.intervals = std::move(column);
    }

 private:
    template <typename... Args>
    void warn(const LogInterval& at, fmt::format_string<Args...> text, Args&&... args) {
        audit_.add_warning(
            logs_.files[at.file], at.row, "",
            fmt::format("hole {}: {}", hole_->id, fmt::format(text, std::forward<Args>(args)...)));
    }

    std::string name(const LogInterval& interval) const {
        return interval.unit == LogInterval::kNoUnit ? "no unit" : logs_.units[interval.unit];
    }

    bool is_usable(LogInterval& interval) {
        if (interval.from > interval.to) {
            warn(interval, "from {} is below to {}; the interval is left out", interval.from, interval.to);
            return false;
        }
        if (interval.from == interval.to) {
            warn(interval, "from and to are both {}; the interval is left out", interval.from);
            return false;
        }
        if (interval.from >= 0) return true;
        warn(interval, "from {} is above the ground; {}", interval.from,
             interval.to > 0 ? "cut at the ground" : "the interval is left out");
        interval.from = 0;
        return interval.to > 0;
    }

    void append(std::vector<LogInterval>& column, LogInterval next) {
        if (!column.empty() && !make_room(column.back(), next)) return;
        if (next.unit == LogInterval::kNoUnit)
            warn(next, "{} to {} has no unit; unknown there", next.from, next.to);
        else if (!column.empty() && next.from - column.back().to > kTouching)
            warn(next, "nothing is said of {} to {}; unknown there", column.back().to, next.from);
        if (!column.empty() && column.back().unit == next.unit && next.from - column.back().to <= kTouching)
            column.back().to = next.to;
        else
            column.push_back(next);
    }

    //! Cut `last` or `next` where they overlap. False if nothing is left of `next`.
    bool make_room(LogInterval& last, LogInterval& next) {
        const double overlap = last.to - next.from;
        if (overlap <= kTouching) {
            if (std::abs(overlap) <= kTouching) next.from = last.to;
            return next.to > next.from;
        }
        if (last.unit == next.unit) {
            warn(next, "{} to {} ({}) overlaps the same above it; taken as one", next.from, next.to,
                 name(next));
            last.to = std::max(last.to, next.to);
            return false;
        }
        if (next.from <= last.from + kTouching || next.unit == LogInterval::kNoUnit) {
            warn(next, "{} to {} ({}) overlaps {} above {}; it begins at {} here", next.from, next.to,
                 name(next), name(last), last.to, last.to);
            next.from = last.to;
            return next.to - next.from > kTouching;
        }
        warn(next, "{} to {} ({}) overlaps {} to {} ({}), which is cut at {}", next.from, next.to, name(next),
             last.from, last.to, name(last), next.from);
        last.to = next.from;
        return true;
    }

    const LogSet& logs_;
    Audit& audit_;
    const HoleLog* hole_ = nullptr;
};

}  // namespace

void clean_logs(LogSet& logs, Audit& audit) {
    Cleaner cleaner(logs, audit);
    for (HoleLog& hole : logs.holes) cleaner.clean(hole);
}

}  // namespace stratareeb
