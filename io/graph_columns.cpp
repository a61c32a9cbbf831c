// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/graph_columns.h"

#include <algorithm>
#include <cstdint>
#include <ranges>
#include <utility>

namespace stratareeb {

namespace {

constexpr int kRounds = 60;  // of drawing columns towards their nodes; the picture hardly changes after

//! Arcs by node, and how far each one reaches.
class ArcsAtNodes {
 public:
    explicit ArcsAtNodes(const ReebGraph& graph) : down(graph.nodes.size()), up(graph.nodes.size()) {
        for (std::uint32_t a = 0; a < graph.arcs.size(); ++a) {
            up[graph.arcs[a].lower].push_back(a);
            down[graph.arcs[a].upper].push_back(a);
        }
        const auto span = [&](std::uint32_t a) {
            return graph.nodes[graph.arcs[a].upper].value - graph.nodes[graph.arcs[a].lower].value;
        };
        for (auto* lists : {&down, &up})
            for (auto& list : *lists) std::ranges::stable_sort(list, std::ranges::greater(), span);
    }
    std::vector<std::vector<std::uint32_t>> down, up;  // the longest first
};

//! The list of passing arcs, and who has ever stood directly left of whom. Entries are arcs; nodes without arcs follow them.
class Passing {
 public:
    explicit Passing(std::size_t entries) : end_(static_cast<std::uint32_t>(entries)) {
        left_.assign(entries + 1, end_);
        right_.assign(entries + 1, end_);
        right_of.resize(entries);
    }
    void insert_after(std::uint32_t place, std::uint32_t entry) {
        const std::uint32_t next = right_[place];
        link(place, entry);
        link(entry, next);
    }
    void insert_before(std::uint32_t place, std::uint32_t entry) { insert_after(left_[place], entry); }
    void append(std::uint32_t entry) { insert_before(end_, entry); }
    //! \return what stands left of it
    std::uint32_t remove(std::uint32_t entry) {
        link(left_[entry], right_[entry]);
        return left_[entry];
    }

    //! The first and last of those that stand in one row with the first in a list. \pre it is ascending, all of them pass
    std::uint32_t first_of(const std::vector<std::uint32_t>& group) const { return end_of(group, left_); }
    std::uint32_t last_of(const std::vector<std::uint32_t>& group) const { return end_of(group, right_); }

    std::vector<std::vector<std::uint32_t>> right_of;

 private:
    static std::uint32_t end_of(const std::vector<std::uint32_t>& group,
                                const std::vector<std::uint32_t>& next) {
        std::uint32_t at = group.front();
        while (std::ranges::binary_search(group, next[at])) at = next[at];
        return at;
    }

    void link(std::uint32_t a, std::uint32_t b) {
        right_[a] = b;
        left_[b] = a;
        if (a != end_ && b != end_) right_of[a].push_back(b);
    }
    std::uint32_t end_;  // before the first and behind the last
    std::vector<std::uint32_t> left_, right_;
};

class Columns {
 public:
    Columns(const ReebGraph& graph, std::span<const double> preferred)
        : graph_(graph),
          preferred_(preferred),
          at_(graph),
          passing_(graph.arcs.size() + graph.nodes.size()) {}

    GraphColumns run() {
        for (std::uint32_t n = 0; n < graph_.nodes.size(); ++n) visit(n);
        sort_entries();
        pack();
        for (int round = 0; round < kRounds; ++round) draw_together();
        return result();
    }

 private:
    std::uint32_t node_entry(std::uint32_t node) const {
        return static_cast<std::uint32_t>(graph_.arcs.size()) + node;
    }

    void visit(std::uint32_t node) {
        std::vector<std::uint32_t> up = at_.up[node];
        std::ranges::stable_sort(up, {}, [&](std::uint32_t a) { return preferred_[a]; });
        if (at_.down[node].empty() && up.empty()) {
            passing_.append(node_entry(node));
            passing_.remove(node_entry(node));
            return;
        }
        if (at_.down[node].empty()) return enter(node, up);
        // The place of the longest arc below goes to those above; the others end wherever they are.
        for (const std::uint32_t a : at_.down[node] | std::views::drop(1)) passing_.remove(a);
        std::uint32_t place = passing_.remove(at_.down[node].front());
        for (const std::uint32_t a : up) {
            passing_.insert_after(place, a);
            place = a;
        }
    }

    void enter(std::uint32_t node, const std::vector<std::uint32_t>& up) {
        const std::vector<std::uint32_t> group = arcs_to_meet(node);
        if (group.empty()) {
            for (const std::uint32_t a : up) passing_.append(a);
            return;
        }
        double middle = 0;
        for (const std::uint32_t a : group) middle += preferred_[a] / static_cast<double>(group.size());
        if (preferred_[up.front()] < middle) {
            const std::uint32_t place = passing_.first_of(group);
            for (const std::uint32_t a : up) passing_.insert_before(place, a);
        } else {
            std::uint32_t place = passing_.last_of(group);
            for (const std::uint32_t a : up) {
                passing_.insert_after(place, a);
                place = a;
            }
        }
    }

    //! The passing arcs that lead to the first node above a minimum at which something else arrives.
    std::vector<std::uint32_t> arcs_to_meet(std::uint32_t minimum) const {
        for (std::uint32_t node = minimum; !at_.up[node].empty();) {
            const std::uint32_t way = at_.up[node].front();
            node = graph_.arcs[way].upper;
            auto group = passing_below(node, minimum);
            if (!group.empty()) return group;
        }
        return {};
    }

    //! Arcs that lead up to a node and have begun below another one, ascending.
    std::vector<std::uint32_t> passing_below(std::uint32_t node, std::uint32_t begun) const {
        std::vector<std::uint32_t> group, waiting = at_.down[node];
        std::vector<bool> is_known(graph_.nodes.size(), false);
        while (!waiting.empty()) {
            const std::uint32_t a = waiting.back(), lower = graph_.arcs[a].lower;
            waiting.pop_back();
            if (lower < begun) {
                group.push_back(a);
            } else if (!is_known[lower]) {
                is_known[lower] = true;
                waiting.insert(waiting.end(), at_.down[lower].begin(), at_.down[lower].end());
            }
        }
        std::ranges::sort(group);
        return group;
    }

    //! Entries so that each comes before those to the right of it.
    void sort_entries() {
        std::vector<std::uint32_t> waits(passing_.right_of.size(), 0);
        for (auto& list : passing_.right_of) {
            std::ranges::sort(list);
            const auto repeated = std::ranges::unique(list);
            list.erase(repeated.begin(), repeated.end());
            for (const std::uint32_t b : list) ++waits[b];
        }
        left_of_.resize(waits.size());
        for (std::uint32_t e = 0; e < waits.size(); ++e)
            if (waits[e] == 0) sorted_.push_back(e);
        for (std::size_t i = 0; i < sorted_.size(); ++i)
            for (const std::uint32_t b : passing_.right_of[sorted_[i]]) {
                left_of_[b].push_back(sorted_[i]);
                if (--waits[b] == 0) sorted_.push_back(b);
            }
    }

    //! Half-way between as far left and as far right as can be.
    void pack() {
        std::vector<double> from_left(left_of_.size(), 0), from_right(left_of_.size(), 0);
        for (const std::uint32_t e : sorted_)
            for (const std::uint32_t b : passing_.right_of[e])
                from_left[b] = std::max(from_left[b], from_left[e] + 1);
        for (const std::uint32_t e : std::views::reverse(sorted_))
            for (const std::uint32_t b : passing_.right_of[e])
                from_right[e] = std::max(from_right[e], from_right[b] + 1);
        width_ = from_left.empty() ? 0 : *std::ranges::max_element(from_left);
        x_.resize(left_of_.size());
        for (std::size_t e = 0; e < x_.size(); ++e) x_[e] = (from_left[e] + width_ - from_right[e]) / 2;
    }

    double node_x(std::uint32_t node) const {
        double sum = 0;
        std::size_t count = 0;
        for (const auto* arcs : {&at_.down[node], &at_.up[node]})
            for (const std::uint32_t a : *arcs) {
                sum += x_[a];
                ++count;
            }
        return count ? sum / static_cast<double>(count) : x_[node_entry(node)];
    }

    //! Each column towards its two nodes, as far as its neighbours let it.
    void draw_together() {
        for (const std::uint32_t e : sorted_) {
            if (e >= graph_.arcs.size()) continue;
            double low = 0, high = width_;
            for (const std::uint32_t a : left_of_[e]) low = std::max(low, x_[a] + 1);
            for (const std::uint32_t b : passing_.right_of[e]) high = std::min(high, x_[b] - 1);
            const double wish = (node_x(graph_.arcs[e].lower) + node_x(graph_.arcs[e].upper)) / 2;
            if (low <= high) x_[e] = std::clamp(wish, low, high);
        }
    }

    GraphColumns result() const {
        GraphColumns columns{
            .arc_x = {x_.begin(), x_.begin() + static_cast<std::ptrdiff_t>(graph_.arcs.size())},
            .node_x = {},
            .width = width_};
        for (std::uint32_t n = 0; n < graph_.nodes.size(); ++n) columns.node_x.push_back(node_x(n));
        return columns;
    }

    const ReebGraph& graph_;
    std::span<const double> preferred_;
    ArcsAtNodes at_;
    Passing passing_;
    std::vector<std::vector<std::uint32_t>> left_of_;
    std::vector<std::uint32_t> sorted_;
    std::vector<double> x_;
    double width_ = 0;
};

}  // namespace

GraphColumns graph_columns(const ReebGraph& graph, std::span<const double> preferred) {
    return Columns(graph, preferred).run();
}

}  // namespace stratareeb
