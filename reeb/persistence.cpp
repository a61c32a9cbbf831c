// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/persistence.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "reeb/link_cut_forest.h"
#include "reeb/loop_core.h"

namespace stratareeb {

namespace {

//! Pieces of a growing graph; each is known by its eldest node, the first one of the sweep.
class Pieces {
 public:
    explicit Pieces(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

    std::uint32_t eldest(std::uint32_t n) {
        while (parent_[n] != n) n = parent_[n] = parent_[parent_[n]];
        return n;
    }
    void absorb(std::uint32_t elder, std::uint32_t younger) { parent_[younger] = elder; }

 private:
    std::vector<std::uint32_t> parent_;
};

PersistencePair make_pair(const ReebGraph& graph, PairKind kind, std::uint32_t lower, std::uint32_t upper) {
    return {kind, lower, upper, graph.nodes[upper].value - graph.nodes[lower].value};
}

void sort_pairs(std::vector<PersistencePair>& pairs) {
    std::ranges::stable_sort(pairs, {}, [](const PersistencePair& p) {
        return std::tuple(-p.persistence, p.lower, p.upper, p.kind);
    });
}

//! Where two pieces meet, the younger one ends (elder rule). Places are node indices counted in the direction of the sweep.
//! \param meet called with the younger piece's eldest place and the place where it ends.
template <typename Meet>
Pieces sweep(std::size_t places, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& links,
             Meet meet) {
    Pieces pieces(places);
    for (const auto& [from, to] : links) {
        std::uint32_t a = pieces.eldest(from), b = pieces.eldest(to);
        if (a == b) continue;
        if (a > b) std::swap(a, b);
        pieces.absorb(a, b);
        if (b != to) meet(b, to);
    }
    return pieces;
}

using Links = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

//! Arcs by the place of their later end. Of one node's, those from elder pieces need not come first: whichever two pieces
//! meet, the younger one ends there.
Links links_by_later_end(const ReebGraph& graph, bool from_top) {
    const auto last = static_cast<std::uint32_t>(graph.nodes.size()) - 1;
    Links links;
    links.reserve(graph.arcs.size());
    for (const ReebArc& arc : graph.arcs)
        links.push_back(from_top ? std::pair(last - arc.upper, last - arc.lower)
                                 : std::pair(arc.lower, arc.upper));
    std::ranges::sort(links, {}, [](const auto& link) { return std::pair(link.second, link.first); });
    return links;
}

void add_joins_and_components(const ReebGraph& graph, std::vector<PersistencePair>& pairs) {
    const std::size_t count = graph.nodes.size();
    Pieces pieces =
        sweep(count, links_by_later_end(graph, false), [&](std::uint32_t lower, std::uint32_t upper) {
            pairs.push_back(make_pair(graph, PairKind::Join, lower, upper));
        });
    std::vector<std::uint32_t> top(count);
    for (std::uint32_t n = 0; n < count; ++n) top[pieces.eldest(n)] = n;
    for (std::uint32_t n = 0; n < count; ++n)
        if (pieces.eldest(n) == n) pairs.push_back(make_pair(graph, PairKind::Component, n, top[n]));
}

void add_splits(const ReebGraph& graph, std::vector<PersistencePair>& pairs) {
    const auto last = static_cast<std::uint32_t>(graph.nodes.size()) - 1;
    sweep(graph.nodes.size(), links_by_later_end(graph, true), [&](std::uint32_t younger, std::uint32_t end) {
        pairs.push_back(make_pair(graph, PairKind::Split, last - end, last - younger));
    });
}

//! Loops of the core, closed from bottom to top. The forest holds, of all spanning forests of what was met so far, one whose
//! arcs start highest. Then between any two nodes its way stays as high as any way can; the lowest arc of a cycle is left out.
class LoopSweep {
 public:
    explicit LoopSweep(const ReebGraph& graph)
        : graph_(graph), core_(loop_core(graph)), pieces_(core_.nodes.size()), forest_(keys()) {}

    //! \param found called with each pair and the arc that closes it, while the forest does not have that arc yet.
    template <typename Found>
    void run(Found found) {
        for (std::uint32_t a = 0; a < core_.arcs.size(); ++a) {
            const CoreArc& arc = core_.arcs[a];
            const std::uint32_t below = pieces_.eldest(arc.lower), above = pieces_.eldest(arc.upper);
            if (below != above) {
                pieces_.absorb(below, above);
                add(a);
                continue;
            }
            const std::uint32_t lowest = forest_.smallest_between(arc.lower, arc.upper) - first_arc();
            const std::uint32_t x = std::min(arc.lower, core_.arcs[lowest].lower);
            found(make_pair(graph_, PairKind::Loop, core_.nodes[x], core_.nodes[arc.upper]), a, x);
            if (x == arc.lower) continue;
            remove(lowest);
            add(a);
        }
    }

    //! The cycle that an arc closes, from its lowest node x up both sides.
    LoopCycle cycle(const PersistencePair& pair, std::uint32_t closing, std::uint32_t x) {
        const CoreArc& arc = core_.arcs[closing];
        const std::vector<std::uint32_t> way = forest_.path(arc.upper, arc.lower);
        const auto at_x = std::ranges::find(way, x);
        LoopCycle result{.pair = pair, .sides = {}};
        for (auto item = at_x; item != way.begin(); --item) append(*item, *std::prev(item), result.sides[0]);
        for (auto item = at_x; item != way.end(); ++item)
            if (std::next(item) != way.end()) append(*item, *std::next(item), result.sides[1]);
        result.sides[1].insert(result.sides[1].end(), arc.arcs.begin(), arc.arcs.end());
        return result;
    }

 private:
    std::uint32_t first_arc() const { return static_cast<std::uint32_t>(core_.nodes.size()); }

    std::vector<std::uint32_t> keys() const {
        std::vector<std::uint32_t> keys(core_.nodes.size(), ~0u);
        for (const CoreArc& arc : core_.arcs) keys.push_back(arc.lower);
        return keys;
    }

    void add(std::uint32_t a) {
        forest_.link(core_.arcs[a].lower, first_arc() + a);
        forest_.link(core_.arcs[a].upper, first_arc() + a);
    }
    void remove(std::uint32_t a) {
        forest_.cut(core_.arcs[a].lower, first_arc() + a);
        forest_.cut(core_.arcs[a].upper, first_arc() + a);
    }

    //! One step of a way through the forest: nothing from an arc to its end, the arc's arcs from a node to an arc.
    void append(std::uint32_t from, std::uint32_t to, std::vector<std::uint32_t>& side) const {
        if (to < first_arc()) return;
        const CoreArc& arc = core_.arcs[to - first_arc()];
        if (arc.lower == from)
            side.insert(side.end(), arc.arcs.begin(), arc.arcs.end());
        else
            side.insert(side.end(), arc.arcs.rbegin(), arc.arcs.rend());
    }

    const ReebGraph& graph_;
    LoopCore core_;
    Pieces pieces_;
    LinkCutForest forest_;  // of core nodes, then core arcs
};

}  // namespace

std::vector<PersistencePair> persistence_pairs(const ReebGraph& graph) {
    std::vector<PersistencePair> pairs;
    add_joins_and_components(graph, pairs);
    add_splits(graph, pairs);
    LoopSweep(graph).run([&](const PersistencePair& pair, auto...) { pairs.push_back(pair); });
    sort_pairs(pairs);
    return pairs;
}

std::vector<LoopCycle> loop_cycles(const ReebGraph& graph, double min_persistence) {
    std::vector<LoopCycle> cycles;
    LoopSweep sweep(graph);
    sweep.run([&](const PersistencePair& pair, std::uint32_t closing, std::uint32_t x) {
        if (pair.persistence >= min_persistence) cycles.push_back(sweep.cycle(pair, closing, x));
    });
    std::ranges::stable_sort(cycles, {}, [](const LoopCycle& c) {
        return std::tuple(-c.pair.persistence, c.pair.lower, c.pair.upper);
    });
    return cycles;
}

bool is_monotone(const LoopCycle& cycle, const ReebGraph& graph) {
    return std::ranges::all_of(cycle.sides, [&](const std::vector<std::uint32_t>& side) {
        std::uint32_t at = cycle.pair.lower;
        for (const std::uint32_t a : side) {
            if (graph.arcs[a].lower != at) return false;
            at = graph.arcs[a].upper;
        }
        return true;
    });
}

}  // namespace stratareeb
