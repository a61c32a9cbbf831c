// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/refined_contours.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "reeb/contours_between.h"

namespace stratareeb {

namespace {

using Contours = std::vector<LevelContour>;

constexpr std::size_t kCrossingHalvings = 4;  // of an interval
constexpr double kLeastGap = 1e-4;            // of an edge's height
constexpr double kLeastRise = 1e-12;          // of heights

class Refinement {
 public:
    Refinement(const HeightScale& scale, const std::function<LevelContour(double)>& at,
               const ContourRefinement& options)
        : scale_(scale), at_(at), options_(options) {}

    void run(Contours& contours) const {
        std::vector<bool> is_open(contours.size() - 1, true);  // intervals to look at
        for (std::size_t round = 0; std::ranges::find(is_open, true) != is_open.end(); ++round) {
            Contours finer;
            std::vector<std::size_t> added;  // places in `finer`
            std::size_t room = options_.most - std::min(options_.most, contours.size());
            for (std::size_t k = 0; k < is_open.size(); ++k) {
                auto middle = is_open[k] && room > 0 ? needed_between(contours, k, round) : std::nullopt;
                finer.push_back(contours[k]);
                if (!middle) continue;
                --room;
                added.push_back(finer.size());
                finer.push_back(std::move(*middle));
            }
            finer.push_back(std::move(contours.back()));
            contours = std::move(finer);
            is_open = intervals_around(added, contours.size() - 1);
        }
    }

 private:
    //! The four that a new contour is one of four contours for.
    static std::vector<bool> intervals_around(const std::vector<std::size_t>& added, std::size_t count) {
        std::vector<bool> around(count, false);
        for (const std::size_t k : added)
            for (std::size_t i = k < 2 ? 0 : k - 2; i < std::min(k + 2, count); ++i) around[i] = true;
        return around;
    }

    std::optional<LevelContour> needed_between(const Contours& contours, std::size_t k,
                                               std::size_t round) const {
        const double low = contours[k].z, high = contours[k + 1].z, z = low + 0.5 * (high - low);
        if (!(low < z && z < high) || !has_room(low, high, contours.front().z, contours.back().z))
            return std::nullopt;
        const bool crosses =
            round < kCrossingHalvings && crosses_between(contours, k, scale_, options_.homotopy);
        if (!crosses && options_.tolerance <= 0) return std::nullopt;
        LevelContour middle = at_(z);
        if (!make_sound(middle) || (!crosses && is_near(contours, k, middle))) return std::nullopt;
        return middle;
    }

    bool is_near(const Contours& contours, std::size_t k, const LevelContour& middle) const {
        const auto guess = contour_between(contours, k, middle.z, scale_, options_.homotopy);
        return plan_deviation(middle.points, guess) <= options_.tolerance;
    }

    const HeightScale& scale_;
    const std::function<LevelContour(double)>& at_;
    const ContourRefinement& options_;
};

}  // namespace

bool has_room(double low, double high, double bottom, double top) {
    return high - low > kLeastGap * (top - bottom) &&
           high - low > kLeastRise * std::max(std::abs(low), std::abs(high));
}

void refine_contours(Contours& contours, const HeightScale& scale,
                     const std::function<LevelContour(double)>& at, const ContourRefinement& options) {
    Refinement(scale, at, options).run(contours);
}

}  // namespace stratareeb
