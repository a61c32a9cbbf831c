// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/close_loop.h"

#include <algorithm>
#include <queue>
#include <tuple>

namespace stratareeb {

bool LoopCloser::close(std::uint32_t lower, std::uint32_t upper) {
    if (!graph_.is_node(upper) || graph_.arcs(upper, Down).size() < 2) return false;
    std::vector<Run> runs = rising_sides(lower, upper);
    if (runs.empty()) runs = any_sides(lower, upper);
    if (runs.empty()) return false;
    touched_.assign(1, upper);
    while (runs.size() > 2) glue_lowest_rise(runs);
    glue(runs[0], runs[1]);
    for (const std::uint32_t node : touched_) graph_.tidy(node);
    return true;
}

//! Ways down from the upper node, the highest first, until two that left it by different arcs meet.
std::vector<LoopCloser::Run> LoopCloser::rising_sides(std::uint32_t lower, std::uint32_t upper) {
    ++search_;
    std::priority_queue<std::uint32_t> open;
    std::vector<Run> sides;
    const auto visit = [&](std::uint32_t arc, std::uint32_t start, std::uint32_t from) {
        const std::uint32_t node = graph_.end(arc, Down);
        if (node < lower) return false;
        Mark& mark = marks_[node];
        if (mark.search != search_) {
            mark = {search_, start, arc, from};
            open.push(node);
            return false;
        }
        if (mark.start == start) return false;
        sides = {way_from(upper, node), way_from(upper, from)};
        sides[1].push_back(arc);
        return true;
    };
    for (const std::uint32_t arc : graph_.arcs(upper, Down))
        if (visit(arc, arc, upper)) return sides;
    for (; !open.empty();) {
        const std::uint32_t node = open.top();
        open.pop();
        for (const std::uint32_t arc : graph_.arcs(node, Down))
            if (visit(arc, marks_[node].start, node)) return sides;
    }
    return {};
}

//! The same with ways that may rise as well, but stay below the upper node.
std::vector<LoopCloser::Run> LoopCloser::any_sides(std::uint32_t lower, std::uint32_t upper) {
    ++search_;
    std::priority_queue<std::uint32_t> open;
    const auto visit = [&](std::uint32_t node, std::uint32_t arc, std::uint32_t start, std::uint32_t from) {
        if (marks_[node].search == search_) return;
        marks_[node] = {search_, start, arc, from};
        open.push(node);
    };
    for (const std::uint32_t arc : graph_.arcs(upper, Down))
        if (graph_.end(arc, Down) >= lower) visit(graph_.end(arc, Down), arc, arc, upper);
    for (; !open.empty();) {
        const std::uint32_t node = open.top();
        open.pop();
        marks_[node].done = true;
        for (const Side side : {Down, Up})
            for (const std::uint32_t arc : graph_.arcs(node, side)) {
                const std::uint32_t next = graph_.end(arc, side);
                if (next < lower || next >= upper) continue;
                visit(next, arc, marks_[node].start, node);
                if (!marks_[next].done || marks_[next].start == marks_[node].start) continue;
                std::vector<std::uint32_t> cycle = way_from(upper, node), back = way_from(upper, next);
                cycle.push_back(arc);
                cycle.insert(cycle.end(), back.rbegin(), back.rend());
                return runs_of(upper, cycle);
            }
    }
    return {};
}

//! Arcs of the search's way from its first node.
std::vector<std::uint32_t> LoopCloser::way_from(std::uint32_t upper, std::uint32_t node) const {
    std::vector<std::uint32_t> way;
    for (; node != upper; node = marks_[node].from) way.push_back(marks_[node].arrival);
    std::ranges::reverse(way);
    return way;
}

//! A closed way that starts at its summit, as runs: 0 and 1 share a hollow, 1 and 2 a summit, 2 and 3 a hollow, and so on; the
//! last one and 0 share the first summit.
std::vector<LoopCloser::Run> LoopCloser::runs_of(std::uint32_t upper,
                                                 const std::vector<std::uint32_t>& cycle) const {
    std::vector<Run> runs(1);
    std::uint32_t at = upper;
    for (const std::uint32_t arc : cycle) {
        const bool falls = graph_.end(arc, Up) == at, fell = runs.size() % 2 == 1;
        if (falls != fell) runs.emplace_back();
        runs.back().push_back(arc);
        at = graph_.end(arc, falls ? Down : Up);
    }
    for (std::size_t r = 1; r < runs.size(); r += 2) std::ranges::reverse(runs[r]);
    return runs;
}

void LoopCloser::glue_lowest_rise(std::vector<Run>& runs) {
    const auto height = [&](const Run& run) {
        const std::uint32_t hollow = graph_.end(run.back(), Down);
        return std::tuple(graph_.persistence(graph_.end(run.front(), Up), hollow), ~hollow);
    };
    auto lowest = std::ranges::min_element(runs, {}, height) - runs.begin();
    if (lowest % 2 == 0) {  // make it one whose next run shares its summit
        std::ranges::reverse(runs);
        lowest = std::ssize(runs) - 1 - lowest;
    }
    std::ranges::rotate(runs, runs.begin() + lowest - 1);
    const Run rest = glue(runs[1], runs[2]);
    runs[0].insert(runs[0].end(), rest.begin(), rest.end());
    runs.erase(runs.begin() + 1, runs.begin() + 3);
}

//! Glue a run to another from their common summit down to its hollow.
//! \return what is left of the other one, from there on.
LoopCloser::Run LoopCloser::glue(const Run& shorter, const Run& other) {
    touched_.push_back(graph_.end(shorter.front(), Up));
    for (std::size_t i = 0, j = 0;;) {
        const auto fork = graph_.zip(shorter[i], other[j], Down);
        touched_.push_back(fork.node);
        if (fork.rest == FoldedGraph::kNone) return {};
        ++(fork.nearer == shorter[i] ? i : j);
        if (i == shorter.size()) return Run(other.begin() + static_cast<std::ptrdiff_t>(j), other.end());
    }
}

}  // namespace stratareeb
