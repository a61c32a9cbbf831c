// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/joint_parameters.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "reeb/point_math.h"

namespace stratareeb {

namespace {

constexpr double kShareOfChord = 0.005;
constexpr std::size_t kMostLookedAt =
    1024;  // points in a row; longer ones are halved, which keeps time linear

//! From the segment between a and b.
double distance_to_chord(const Point3& p, const Point3& a, const Point3& b) {
    const Point3 chord = b - a, way = p - a;
    const double square = dot_product(chord, chord);
    const double share = square > 0 ? std::clamp(dot_product(way, chord) / square, 0.0, 1.0) : 0;
    return magnitude(way - share * chord);
}

//! Of a line's points, those that it needs (Douglas and Peucker 1973, with a tolerance relative to each chord); its ends are taken as kept.
class NeededPoints {
 public:
    NeededPoints(const std::vector<Point3>& line, std::vector<bool>& is_needed)
        : line_(line), is_needed_(is_needed) {}

    void run() {
        std::vector<std::pair<std::size_t, std::size_t>> parts{{0, line_.size() - 1}};
        while (!parts.empty()) {
            const auto [first, last] = parts.back();
            parts.pop_back();
            if (last - first < 2) continue;
            const std::size_t at = split(first, last);
            if (at == first) continue;
            is_needed_[at] = true;
            parts.emplace_back(first, at);
            parts.emplace_back(at, last);
        }
    }

 private:
    //! \return `first` if none is needed in between
    std::size_t split(std::size_t first, std::size_t last) const {
        if (last - first > kMostLookedAt) return first + (last - first) / 2;
        double most = kShareOfChord * magnitude(line_[last] - line_[first]);
        std::size_t at = first;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double off = distance_to_chord(line_[i], line_[first], line_[last]);
            if (off > most) most = off, at = i;
        }
        return at;
    }

    const std::vector<Point3>& line_;
    std::vector<bool>& is_needed_;
};

}  // namespace

std::vector<double> joint_parameters(const SampledContour& own, const SampledContour& other) {
    std::vector<double> result = own.parameters;
    if (own.parameters.size() < 2 || other.parameters.size() < 2) return result;
    const std::vector<Point3> stops = points_at(other, own.parameters);
    const std::size_t n = own.parameters.size(), m = other.parameters.size();
    for (std::size_t i = 0; i < n; ++i) {
        const bool is_last = i + 1 == n;
        const double low = own.parameters[i], high = is_last ? own.parameters[0] + 1 : own.parameters[i + 1];
        const auto after = std::ranges::upper_bound(other.parameters, low);
        std::vector<Point3> line{stops[i]};
        std::vector<double> parameters{low};
        for (std::size_t k = 0; k < m; ++k) {
            const std::size_t at = (static_cast<std::size_t>(after - other.parameters.begin()) + k) % m;
            const double s = other.parameters[at];
            const double unrolled = s > low ? s : s + 1;
            if (!(unrolled < high)) break;
            line.push_back(other.points[at]);
            parameters.push_back(s);
        }
        line.push_back(stops[is_last ? 0 : i + 1]);
        std::vector<bool> is_needed(line.size(), false);
        NeededPoints(line, is_needed).run();
        for (std::size_t k = 1; k + 1 < line.size(); ++k)
            if (is_needed[k] && parameters[k] != result.back()) result.push_back(parameters[k]);
    }
    std::ranges::sort(result);
    return result;
}

}  // namespace stratareeb
