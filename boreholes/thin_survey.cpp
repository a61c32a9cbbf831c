// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/thin_survey.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/convex_hull_2.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <queue>

#include "boreholes/complete_columns.h"
#include "boreholes/errors.h"

namespace stratareeb {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Faces = CGAL::Triangulation_face_base_with_info_2<std::vector<std::uint32_t>, Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertices, Faces>>;
using Face = Delaunay::Face_handle;

//! A hole that is not in yet and how far the surfaces miss it; the worst first, of equals the first in the table.
struct Candidate {
    double error = 0;
    std::uint32_t hole = 0;
    std::uint32_t version = 0;  // how often its error had been found by then

    bool operator<(const Candidate& other) const {
        return error != other.error ? error < other.error : hole > other.hole;
    }
};

class Thinning {
 public:
    Thinning(const Survey& survey, const ThinOptions& options) : survey_(survey), options_(options) {
        const CompleteColumns columns = complete_columns(survey, {.interpolator = InterpolatorKind::Linear});
        const std::size_t holes = survey.holes.size();
        horizons_.push_back(columns.ground);
        for (const auto& thickness : columns.thickness) {
            auto& below = horizons_.emplace_back(horizons_.back());
            for (std::size_t h = 0; h < holes; ++h) below[h] -= thickness[h];
        }
        error_.assign(holes, 0);
        version_.assign(holes, 0);
        is_in_.assign(holes, 0);
    }

    ThinnedSurvey run() {
        start();
        const std::size_t most = options_.count.value_or(survey_.holes.size());
        while (kept_ < most && !worst_.empty()) {
            const Candidate next = worst_.top();
            worst_.pop();
            if (is_in_[next.hole] || version_[next.hole] != next.version) continue;
            if (next.error <= options_.error) break;
            insert(next.hole);
            if (options_.progress) options_.progress(kept_);
        }
        return result();
    }

 private:
    Kernel::Point_2 place(std::uint32_t hole) const {
        const Point2 &at = survey_.holes[hole].at, &origin = survey_.holes[0].at;
        return {at.x - origin.x, at.y - origin.y};
    }

    //! The hull's holes; all others go to their triangles.
    void start() {
        std::vector<Kernel::Point_2> places, hull;
        for (std::uint32_t h = 0; h < survey_.holes.size(); ++h) places.push_back(place(h));
        CGAL::convex_hull_2(places.begin(), places.end(), std::back_inserter(hull));
        if (hull.size() < 3)
            throw InvalidInput(
                "the boreholes stand in a line; there are no surfaces between them to thin them by");
        std::sort(hull.begin(), hull.end());
        for (std::uint32_t h = 0; h < places.size(); ++h)
            if (std::binary_search(hull.begin(), hull.end(), places[h]) && !is_in_[h]) {
                const auto before = triangulation_.number_of_vertices();
                const auto vertex = triangulation_.insert(places[h]);
                is_in_[h] = 1;  // a second hole at the same place adds nothing
                if (triangulation_.number_of_vertices() == before) continue;
                vertex->info() = h;
                ++kept_;
                first_at_its_place_.push_back(h);
            }
        Face hint;
        for (std::uint32_t h = 0; h < places.size(); ++h)
            if (!is_in_[h]) hint = assign(h, hint);
    }

    //! Put a hole into its triangle, and find its error.
    Face assign(std::uint32_t hole, Face hint) {
        const Face face = triangulation_.locate(place(hole), hint);
        face->info().push_back(hole);
        error_[hole] = error_of(hole, face);
        worst_.push({error_[hole], hole, ++version_[hole]});
        return face;
    }

    //! The worst contact that the hole knows, against the plane through the triangle's corners.
    double error_of(std::uint32_t hole, Face face) const {
        const auto p = place(hole);
        std::array<double, 3> weight{};
        const auto &a = face->vertex(0)->point(), &b = face->vertex(1)->point(),
                   &c = face->vertex(2)->point();
        const double whole = cross(a, b, c);
        weight = {cross(p, b, c) / whole, cross(a, p, c) / whole, cross(a, b, p) / whole};
        const auto& known = survey_.holes[hole].horizons;
        double worst = 0;
        for (std::size_t k = 0; k < horizons_.size() && k < known.size(); ++k) {
            if (!known[k]) continue;
            double z = 0;
            for (int i = 0; i < 3; ++i)
                z += weight[static_cast<std::size_t>(i)] * horizons_[k][face->vertex(i)->info()];
            worst = std::max(worst, std::abs(z - *known[k]));
        }
        return worst;
    }

    static double cross(const Kernel::Point_2& o, const Kernel::Point_2& a, const Kernel::Point_2& b) {
        return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
    }

    void insert(std::uint32_t hole) {
        std::vector<Face> conflicts;
        triangulation_.get_conflicts(place(hole), std::back_inserter(conflicts));
        std::vector<std::uint32_t> moved;
        for (const Face face : conflicts) {
            moved.insert(moved.end(), face->info().begin(), face->info().end());
            face->info().clear();
        }
        const auto vertex = triangulation_.insert(place(hole));
        vertex->info() = hole;
        is_in_[hole] = 1;
        ++kept_;
        first_at_its_place_.push_back(hole);
        std::ranges::sort(moved);
        for (const std::uint32_t other : moved)
            if (other != hole) assign(other, vertex->face());
    }

    ThinnedSurvey result() {
        std::ranges::sort(first_at_its_place_);
        ThinnedSurvey thinned{.kept = std::move(first_at_its_place_)};
        double sum = 0;
        std::size_t count = 0;
        for (std::size_t h = 0; h < error_.size(); ++h) {
            if (is_in_[h]) continue;
            thinned.largest_error = std::max(thinned.largest_error, error_[h]);
            sum += error_[h] * error_[h];
            ++count;
        }
        if (count > 0) thinned.rms_error = std::sqrt(sum / static_cast<double>(count));
        return thinned;
    }

    const Survey& survey_;
    const ThinOptions& options_;
    std::vector<std::vector<double>> horizons_;  // [k][hole], complete
    Delaunay triangulation_;
    std::priority_queue<Candidate> worst_;
    std::vector<double> error_;
    std::vector<std::uint32_t> version_;
    std::vector<char> is_in_;
    std::vector<std::size_t> first_at_its_place_;
    std::size_t kept_ = 0;
};

}  // namespace

ThinnedSurvey thin_survey(const Survey& survey, const ThinOptions& options) {
    if (!(options.error >= 0) || !std::isfinite(options.error))
        throw InvalidInput(fmt::format("an error of {}: give 0 or more", options.error));
    if (options.count && *options.count < 3)
        throw InvalidInput(fmt::format("a count of {}: give 3 or more", *options.count));
    return Thinning(survey, options).run();
}

}  // namespace stratareeb
