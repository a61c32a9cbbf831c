// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "reeb/persistence.h"

namespace stratareeb::testing {

//! Extended persistence from the definition: the graph is built from bottom to top, then a cone over it from top to bottom (D.
//! Cohen-Steiner, H. Edelsbrunner, J. Harer 2009), and the boundary matrix of all that is reduced modulo 2. Cubic time.
class PersistenceOracle {
 public:
    explicit PersistenceOracle(const ReebGraph& graph) : graph_(graph) {
        add_graph();
        add_cone();
        reduce();
    }

    //! (kind, lower, upper), sorted.
    std::vector<std::tuple<PairKind, std::uint32_t, std::uint32_t>> pairs;

 private:
    using Column = std::vector<std::uint32_t>;  // cells of the boundary, rising

    std::uint32_t add(Column boundary, int dimension, std::uint32_t node, bool cone) {
        std::ranges::sort(boundary);
        columns_.push_back(std::move(boundary));
        cells_.push_back({dimension, node, cone});
        return static_cast<std::uint32_t>(columns_.size() - 1);
    }

    void add_graph() {
        apex_ = add({}, 0, 0, true);
        edge_.resize(graph_.arcs.size());
        for (std::uint32_t n = 0; n < graph_.nodes.size(); ++n) {
            vertex_.push_back(add({}, 0, n, false));
            for (std::uint32_t a = 0; a < graph_.arcs.size(); ++a)
                if (graph_.arcs[a].upper == n)
                    edge_[a] = add({vertex_[graph_.arcs[a].lower], vertex_[n]}, 1, n, false);
        }
    }

    void add_cone() {
        std::vector<std::uint32_t> spoke(graph_.nodes.size());
        for (auto n = static_cast<std::uint32_t>(graph_.nodes.size()); n-- > 0;) {
            spoke[n] = add({apex_, vertex_[n]}, 1, n, true);
            for (std::uint32_t a = 0; a < graph_.arcs.size(); ++a)
                if (graph_.arcs[a].lower == n)
                    add({edge_[a], spoke[n], spoke[graph_.arcs[a].upper]}, 2, n, true);
        }
    }

    void reduce() {
        std::map<std::uint32_t, std::uint32_t> column_of;  // by its last cell
        for (std::uint32_t c = 0; c < columns_.size(); ++c) {
            Column& column = columns_[c];
            while (!column.empty() && column_of.count(column.back())) {
                Column sum;
                std::ranges::set_symmetric_difference(column, columns_[column_of[column.back()]],
                                                      std::back_inserter(sum));
                column = std::move(sum);
            }
            if (column.empty()) continue;
            column_of[column.back()] = c;
            note(cells_[column.back()], cells_[c]);
        }
        std::ranges::sort(pairs);
    }

    struct Cell {
        int dimension;
        std::uint32_t node;
        bool cone;
    };

    void note(const Cell& born, const Cell& dead) {
        if (born.cone == dead.cone && born.node == dead.node) return;  // a node that changes nothing
        if (!dead.cone)
            pairs.emplace_back(PairKind::Join, born.node, dead.node);
        else if (born.cone)
            pairs.emplace_back(PairKind::Split, dead.node, born.node);
        else if (born.dimension == 0)
            pairs.emplace_back(PairKind::Component, born.node, dead.node);
        else
            pairs.emplace_back(PairKind::Loop, dead.node, born.node);
    }

    const ReebGraph& graph_;
    std::uint32_t apex_ = 0;
    std::vector<std::uint32_t> vertex_, edge_;
    std::vector<Column> columns_;
    std::vector<Cell> cells_;
};

}  // namespace stratareeb::testing
