// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/surface_fairing.h"

#include <algorithm>

#include "reeb/least_bending.h"
#include "reeb/link_signs.h"
#include "reeb/point_math.h"

namespace stratareeb {

namespace {

constexpr double kLeastShare = 0.05, kStep = 0.25;
constexpr std::size_t kRounds = 60;  // of going less far; then nothing moves

//! Free vertices and those around them.
std::vector<bool> with_neighbours(const TriangleSoup& soup, const std::vector<bool>& is_free) {
    std::vector<bool> result = is_free;
    for (const auto& t : soup.triangles)
        if (is_free[t[0]] || is_free[t[1]] || is_free[t[2]])
            for (const std::uint32_t v : t) result[v] = true;
    return result;
}

class Mover {
 public:
    Mover(TriangleSoup& soup, const std::vector<bool>& is_free)
        : soup_(soup),
          is_free_(is_free),
          is_watched_(with_neighbours(soup, is_free)),
          signs_(link_signs(soup, is_watched_)) {}

    void move_to(const std::vector<Point3>& target) {
        const std::vector<Point3> start = soup_.points;
        std::vector<double> share(start.size(), 0);
        for (std::size_t v = 0; v < share.size(); ++v) share[v] = is_free_[v] ? 1 : 0;
        for (std::size_t round = 0;; ++round) {
            for (std::size_t v = 0; v < start.size(); ++v)
                if (is_free_[v]) soup_.points[v] = between(start[v], target[v], share[v]);
            if (!hold_back(share, round < kRounds)) return;
        }
    }

 private:
    //! Less for what is beside a vertex that is something else than before, or nothing. \return whether there was one
    bool hold_back(std::vector<double>& share, bool in_part) const {
        const auto signs = link_signs(soup_, is_watched_);
        std::vector<bool> is_beside(share.size(), false);
        bool is_found = false;
        for (const auto& t : soup_.triangles) {
            const bool has_changed = std::ranges::any_of(
                t, [&](std::uint32_t v) { return is_watched_[v] && signs[v] != signs_[v]; });
            if (!has_changed) continue;
            is_found = true;
            for (const std::uint32_t v : t) is_beside[v] = true;
        }
        if (!is_found) return false;
        if (!in_part) {
            std::ranges::fill(share, 0);
            return true;
        }
        for (std::size_t v = 0; v < share.size(); ++v)
            if (is_beside[v]) share[v] = share[v] / 2 < kLeastShare ? 0 : share[v] / 2;
        even_out(share);
        return true;
    }

    //! No vertex goes much farther than one beside it.
    void even_out(std::vector<double>& share) const {
        std::vector<double> most = share;
        for (const auto& t : soup_.triangles)
            for (const std::uint32_t v : t)
                for (const std::uint32_t w : t)
                    if (is_free_[v] && is_free_[w]) most[v] = std::min(most[v], share[w] + kStep);
        share = std::move(most);
    }

    TriangleSoup& soup_;
    const std::vector<bool>& is_free_;
    std::vector<bool> is_watched_;
    std::vector<int> signs_;
};

void fair(TriangleSoup& soup, const FreeVertices& free, const std::set<std::uint32_t>& rigid, Freedom freedom,
          WeightSpace space) {
    std::vector<bool> is_free(soup.points.size());
    for (std::size_t v = 0; v < is_free.size(); ++v)
        is_free[v] = free.freedom[v] == freedom && !rigid.contains(free.group[v]);
    if (std::ranges::count(is_free, true) == 0) return;
    Mover(soup, is_free).move_to(least_bending(soup, is_free, space));
}

}  // namespace

void fair_surface(TriangleSoup& soup, const FreeVertices& free, const std::set<std::uint32_t>& rigid) {
    fair(soup, free, rigid, Freedom::Space, WeightSpace::Space);
    fair(soup, free, rigid, Freedom::Height, WeightSpace::Plan);
}

}  // namespace stratareeb
