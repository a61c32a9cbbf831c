// SPDX-License-Identifier: GPL-3.0-or-later
// Random enhanced Reeb graphs: discs in a row that appear, merge, divide and vanish at heights all different.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "reeb/enhanced_reeb_graph.h"

namespace stratareeb::testing {

class RandomGraph {
 public:
    explicit RandomGraph(std::uint64_t seed) : random_(seed) {}

    EnhancedReebGraph make() {
        const int events = 4 + static_cast<int>(random_() % 14);
        for (int k = 0; k < events; ++k) step();
        while (!discs_.empty()) {
            rise();
            end_at_top(random_() % discs_.size());
        }
        return std::move(graph_);
    }

 private:
    //! Cells first to last of the row, whose contours are on an edge that still rises.
    struct Disc {
        int first, last;
        std::uint32_t edge;
    };

    void step() {
        rise();
        const std::size_t at = discs_.empty() ? 0 : random_() % discs_.size();
        switch (random_() % 5) {
            case 0:
            case 1:
                return appear();
            case 2:
                return at + 1 < discs_.size() ? merge(at) : appear();
            case 3:
                return !discs_.empty() && discs_[at].last > discs_[at].first ? divide(at) : appear();
            default:
                return discs_.size() > 1 ? end_at_top(at) : appear();
        }
    }

    //! The next event is one higher; every disc has a contour on the way.
    void rise() {
        for (const Disc& disc : discs_)
            add_contour(disc, z_ + 0.4 + 0.01 * static_cast<double>(random_() % 10));
        z_ += 1;
    }

    void add_contour(const Disc& disc, double z) {
        const double x = 0.5 * (disc.first + disc.last), rx = 0.5 * (disc.last - disc.first) + 0.35 + noise(),
                     ry = 0.5 + noise(), turn = noise();
        Curve curve{.kind = random_() % 2 ? CurveKind::Polyline : CurveKind::Cardinal, .closed = true};
        const int corners = 8 + static_cast<int>(random_() % 24);
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * std::numbers::pi * k / corners + turn;
            curve.points.push_back({x + rx * std::cos(angle), ry * std::sin(angle), z});
        }
        graph_.edges[disc.edge].contours.push_back(static_cast<std::uint32_t>(graph_.contours.size()));
        EnhancedContour& contour = graph_.contours.emplace_back();
        contour.id = static_cast<std::int64_t>(graph_.contours.size() - 1);
        contour.curve = std::move(curve);
    }

    double noise() { return 0.1 * (static_cast<double>(random_() % 1000) / 1000 - 0.5); }

    std::uint32_t add_node(double x) {
        const std::size_t number = graph_.nodes.size();
        EnhancedNode& node = graph_.nodes.emplace_back();
        node.id = static_cast<std::int64_t>(number);
        node.position = {x, 0, z_};
        return static_cast<std::uint32_t>(number);
    }
    std::uint32_t add_edge(std::uint32_t from) {
        static constexpr HomotopyKind kKinds[] = {HomotopyKind::Linear, HomotopyKind::Cardinal,
                                                  HomotopyKind::CatmullRom, HomotopyKind::NaturalCubic};
        EnhancedEdge edge{.from = from, .to = 0, .curve = {}, .contours = {}, .homotopy = {}};
        edge.homotopy.kind = kKinds[random_() % 4];
        graph_.edges.push_back(std::move(edge));
        return static_cast<std::uint32_t>(graph_.edges.size() - 1);
    }
    double middle(const Disc& disc) const { return 0.5 * (disc.first + disc.last); }

    //! At the right end of the row, so that nothing is in between.
    void appear() {
        const int cell = discs_.empty() ? 0 : discs_.back().last + 1;
        const int last = cell + static_cast<int>(random_() % 4);
        discs_.push_back({cell, last, add_edge(add_node(0.5 * (cell + last)))});
    }

    void merge(std::size_t at) {
        const Disc left = discs_[at], right = discs_[at + 1];
        const std::uint32_t node = add_node(0.5 * (left.last + right.first));
        graph_.edges[left.edge].to = graph_.edges[right.edge].to = node;
        discs_[at] = {left.first, right.last, add_edge(node)};
        discs_.erase(discs_.begin() + static_cast<std::ptrdiff_t>(at) + 1);
    }

    void divide(std::size_t at) {
        const Disc disc = discs_[at];
        const int cut =
            disc.first + static_cast<int>(random_() % static_cast<std::uint64_t>(disc.last - disc.first));
        const std::uint32_t node = add_node(cut + 0.5);
        graph_.edges[disc.edge].to = node;
        discs_[at] = {disc.first, cut, add_edge(node)};
        discs_.insert(discs_.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                      {cut + 1, disc.last, add_edge(node)});
    }

    void end_at_top(std::size_t at) {
        graph_.edges[discs_[at].edge].to = add_node(middle(discs_[at]));
        discs_.erase(discs_.begin() + static_cast<std::ptrdiff_t>(at));
    }

    std::mt19937_64 random_;
    double z_ = 0;
    EnhancedReebGraph graph_;
    std::vector<Disc> discs_;  // from left to right
};

inline EnhancedReebGraph random_graph(std::uint64_t seed) {
    return RandomGraph(seed).make();
}

}  // namespace stratareeb::testing
