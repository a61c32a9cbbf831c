// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/plan_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace stratareeb {
namespace {

constexpr double kFar = 20;          // times the distance within which nine tenths of the holes lie
constexpr double kSamePlace = 1e-9;  // of the extent
constexpr double kCollinear = 1e-6;  // of the extent

double extent(const Survey& survey) {
    if (survey.holes.empty()) return 0;
    Point2 low = survey.holes[0].at, high = low;
    for (const Borehole& hole : survey.holes) {
        low = {std::min(low.x, hole.at.x), std::min(low.y, hole.at.y)};
        high = {std::max(high.x, hole.at.x), std::max(high.y, hole.at.y)};
    }
    return std::hypot(high.x - low.x, high.y - low.y);
}

double quantile(std::vector<double> values, double share) {
    const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
    return values[at];
}

Point2 median_place(const Survey& survey) {
    std::vector<double> x, y;
    for (const Borehole& hole : survey.holes) {
        x.push_back(hole.at.x);
        y.push_back(hole.at.y);
    }
    return {quantile(std::move(x), 0.5), quantile(std::move(y), 0.5)};
}

std::size_t known_layers(const Borehole& hole) {
    return static_cast<std::size_t>(
        std::count_if(hole.layers.begin(), hole.layers.end(),
                      [](const LayerFact& fact) { return fact.knowledge != Knowledge::Unknown; }));
}

double logged_thickness(const Borehole& hole) {
    double sum = 0;
    for (const LayerFact& fact : hole.layers) sum += fact.thickness;
    return sum;
}

bool says_more(const Borehole& a, const Borehole& b) {
    const auto known = [](const Borehole& hole) {
        const auto horizons = std::count_if(hole.horizons.begin(), hole.horizons.end(),
                                            [](const auto& z) { return z.has_value(); });
        return std::tuple(known_layers(hole), logged_thickness(hole), horizons);
    };
    return known(a) > known(b);
}

bool is_same_log(const Borehole& a, const Borehole& b) {
    const auto same_fact = [](const LayerFact& p, const LayerFact& q) {
        return p.knowledge == q.knowledge && p.thickness == q.thickness;
    };
    return a.horizons == b.horizons &&
           std::equal(a.layers.begin(), a.layers.end(), b.layers.begin(), b.layers.end(), same_fact);
}

std::string hole_name(const Borehole& hole) {
    const std::string row = fmt::format("row {}", hole.row);  // the id of a hole without one
    return hole.id == row ? row : fmt::format("hole {} ({})", hole.id, row);
}

//! Finds an earlier point within a tolerance, by cells of twice its size.
class PlaceIndex {
 public:
    explicit PlaceIndex(double tolerance) : tolerance_(tolerance), cell_(2 * tolerance) {}

    std::optional<std::size_t> find(const Point2& at) const {
        for (const std::int64_t column : {cell(at.x - tolerance_), cell(at.x + tolerance_)})
            for (const std::int64_t row : {cell(at.y - tolerance_), cell(at.y + tolerance_)})
                if (const auto found = cells_.find(key(column, row)); found != cells_.end())
                    for (const auto& [place, item] : found->second)
                        if (std::hypot(place.x - at.x, place.y - at.y) <= tolerance_) return item;
        return std::nullopt;
    }

    void add(const Point2& at, std::size_t item) {
        cells_[key(cell(at.x), cell(at.y))].emplace_back(at, item);
    }

 private:
    std::int64_t cell(double v) const { return static_cast<std::int64_t>(std::floor(v / cell_)); }
    static std::uint64_t key(std::int64_t column, std::int64_t row) {
        return static_cast<std::uint64_t>(column) * 0x9e3779b97f4a7c15ULL ^ static_cast<std::uint64_t>(row);
    }

    double tolerance_, cell_;
    std::unordered_map<std::uint64_t, std::vector<std::pair<Point2, std::size_t>>> cells_;
};

}  // namespace

void drop_far_holes(Survey& survey, const std::string& file, Audit& audit) {
    if (survey.holes.size() < 5) return;
    const Point2 middle = median_place(survey);
    std::vector<double> distances;
    for (const Borehole& hole : survey.holes)
        distances.push_back(std::hypot(hole.at.x - middle.x, hole.at.y - middle.y));
    const double far = kFar * quantile(distances, 0.9);
    if (far == 0) return;
    std::size_t i = 0;
    std::erase_if(survey.holes, [&](const Borehole& hole) {
        if (distances[i++] <= far) return false;
        audit.add_warning(
            file, hole.row, "",
            fmt::format("hole {}: x {}, y {} is {:.3g} away from the middle of the site, nine tenths of the "
                        "holes are within {:.3g}; left out: mend the coordinates, or keep far holes "
                        "(--keep-far-holes)",
                        hole.id, hole.at.x, hole.at.y, distances[i - 1], far / kFar));
        return true;
    });
}

void merge_same_place(Survey& survey, const std::string& file, Audit& audit) {
    const double size = extent(survey);
    PlaceIndex places(size > 0 ? kSamePlace * size : 1.0);
    std::vector<Borehole> kept;
    for (Borehole& hole : survey.holes) {
        const auto found = places.find(hole.at);
        if (!found) {
            places.add(hole.at, kept.size());
            kept.push_back(std::move(hole));
            continue;
        }
        Borehole& other = kept[*found];
        if (is_same_log(other, hole)) {
            audit.add_warning(file, hole.row, "",
                              fmt::format("{} repeats {} at the same place; taken once", hole_name(hole),
                                          hole_name(other)));
            continue;
        }
        const bool replace = says_more(hole, other);
        audit.add_warning(
            file, hole.row, "",
            fmt::format("{} and {} are at the same place with different logs; the more complete, {}, is kept",
                        hole_name(other), hole_name(hole), (replace ? hole : other).id));
        if (replace) other = std::move(hole);
    }
    survey.holes = std::move(kept);
}

void check_plan_layout(const Survey& survey, Audit& audit) {
    const auto& holes = survey.holes;
    if (holes.size() < 3) {
        audit.add_error(
            "", 0, "",
            fmt::format("{} hole{} can't span an area: at least 3 are needed, or a footprint from a file "
                        "(--footprint)",
                        holes.size(), holes.size() == 1 ? "" : "s"));
        return;
    }
    const Point2 a = holes[0].at;
    const auto far = std::max_element(holes.begin(), holes.end(), [&](const Borehole& p, const Borehole& q) {
        return std::hypot(p.at.x - a.x, p.at.y - a.y) < std::hypot(q.at.x - a.x, q.at.y - a.y);
    });
    const double dx = far->at.x - a.x, dy = far->at.y - a.y, length = std::hypot(dx, dy);
    for (const Borehole& hole : holes)
        if (std::abs(dx * (hole.at.y - a.y) - dy * (hole.at.x - a.x)) > kCollinear * length * length) return;
    audit.add_error(
        "", 0, "",
        fmt::format("all {} holes lie on one line: they span no area; give a footprint from a file "
                    "(--footprint)",
                    holes.size()));
}

}  // namespace stratareeb
